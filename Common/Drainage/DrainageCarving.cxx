// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/DrainageCarving.h"

#include "Drainage/CellLattice.h"
#include "Drainage/ChannelGrading.h"
#include "Drainage/CoarseGround.h"
#include "Drainage/FlowRouting.h"
#include "Drainage/MissingWaves.h"
#include "Drainage/SemivarianceBands.h"
#include "Drainage/StreamPower.h"
#include "Drainage/ValleySpreading.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace littoral
{

namespace
{

/// Slope of the channel law over the target's in small channels: at the start, and at most.
constexpr double MinimumSlopeFraction = 0.2;
constexpr double MaximumSlopeFraction = 0.5;

/// Fraction of cut in grading, against fill: at the start, and at most.
constexpr double CutFraction = 0.3;
constexpr double MaximumCutFraction = 0.6;

/// Maximum standard deviation of the change by grading over that of the heights; beyond it the slopes of the law are
/// multiplied by FlatteningFactor, some times.
constexpr double MaximumChange = 0.4;
constexpr double FlatteningFactor = 0.7;
constexpr int MaximumFlattenings = 8;

/// Drainage area to which Incision belongs [cells], and area exponent m of the stream power law.
constexpr double IncisionCells = 100.0;
constexpr double ErosionExponent = 0.3;

/// Part of the work at which the iterations begin.
constexpr double ErosionPart = 0.4;

/// Gains of rings in one iteration.
constexpr double MinimumGain = 0.3;
constexpr double MaximumGain = 3.0;

/// Slope of the plane over the target's.
constexpr double MinimumPlaneGain = 0.8;
constexpr double MaximumPlaneGain = 1.25;

/// Terrain of more cells is first carved on half as many along each axis; then fewer erosion steps and iterations are
/// left to do.
constexpr std::size_t MaximumCellsAtOnce = std::size_t{ 1 } << 18;
constexpr int FineErosionSteps = 3;
constexpr double CoarsePart = 0.2; ///< of the work

/// Iterations on the coarse grid: statistics depend on the size of cells, so the target would mislead the law there.
constexpr int CoarseIterations = 1;

/// Iterations without improvement after which carving ends; fewer where the coarse grid has set the law.
constexpr int MaximumStalledIterations = 12;
constexpr int MaximumStalledFineIterations = 3;

/// Deviation of a statistic from the target's, 1 at its tolerance.
struct Deviation
{
  const char* Name;
  double Size;
};

double Relative(double difference, double tolerance)
{
  return std::isnan(difference) ? 0.0 : std::abs(difference) / tolerance;
}

double SemivarianceMisfit(const GroundMeasures& measures, const GroundMeasures& target)
{
  double most = 0.0;
  for (std::size_t n = 0; n < measures.Lags.size(); ++n)
  {
    const double wanted = target.SemivarianceAt(measures.Lags[n]);
    most = wanted > 0.0 ? std::max(most, std::abs(measures.Semivariance[n] / wanted - 1.0)) : most;
  }
  return most;
}

std::vector<Deviation> DeviationsOf(
  const GroundMeasures& measures, const GroundMeasures& target, const CarvingTolerances& tolerances)
{
  return {
    { "depression fraction", measures.DepressionFraction / tolerances.DepressionFraction },
    { "hypsometric integral",
      Relative(measures.HypsometricIntegral - target.HypsometricIntegral, tolerances.HypsometricIntegral) },
    { "skewness of elevation",
      Relative(measures.ElevationSkewness - target.ElevationSkewness, tolerances.ElevationSkewness) },
    { "semivariance", SemivarianceMisfit(measures, target) / tolerances.Semivariance },
    { "concavity", Relative(measures.Concavity - target.Concavity, tolerances.Concavity) },
    { "skewness of curvature", Relative(measures.CurvatureSkewness, tolerances.CurvatureSkewness) },
  };
}

/// The steps of CarveDrainage().
class Carver
{
public:
  Carver(GridSamples& terrain, const CarvingTarget& target, const CarvingParameters& parameters,
    const ParallelFor& parallel, const CarvingProgress& progress)
    : Terrain(terrain)
    , Target(target)
    , Parameters(parameters)
    , Parallel(parallel)
    , Progress(progress)
  {
    this->Law.Concavity = target.Measures.Concavity;
    if (std::isnan(this->Law.Concavity))
    {
      this->Law.Concavity = TargetStatistics().Concavity;
    }
    this->Law.Concavity = std::clamp(this->Law.Concavity, 0.0, 1.0);
    this->Steepness = (target.Measures.ChannelSlope > 0.0 ? target.Measures.ChannelSlope : this->MeanSlope());
  }

  CarvingReport Carve()
  {
    CarvingReport report;
    report.Before = this->Measure(this->Terrain);
    if (report.Before.DepressionFraction > CarvingTolerances().DepressionFraction)
    {
      AddMissingWaves(this->Terrain, this->Target.Spectrum, this->Parameters.Seed, this->Parallel);
      const bool isLarge = this->Terrain.Values.size() > MaximumCellsAtOnce;
      if (isLarge)
      {
        this->CarveCoarse();
      }
      this->Erode(isLarge ? std::min(FineErosionSteps, this->Parameters.ErosionSteps) : this->Parameters.ErosionSteps);
    }
    std::vector<double> best;
    double least = std::numeric_limits<double>::infinity();
    int stalled = 0;
    const int rounds = this->Parameters.MaximumIterations;
    const int maximumStalled = this->CoarseWork > 0.0 ? MaximumStalledFineIterations : MaximumStalledIterations;
    for (int round = 0; round < rounds && stalled < maximumStalled && !report.HasConverged; ++round)
    {
      this->AdvanceRound(round);
      this->RestoreStatistics();
      this->AdvanceRound(round + 0.2);
      this->SpreadGrading();
      this->AdvanceRound(round + 0.6);
      GridSamples graded = this->Terrain;
      graded.Values = this->Grade().Heights;
      MapQuantiles(graded.Values, this->Target.Heights, this->Parallel);
      this->AdvanceRound(round + 0.9);
      const GroundMeasures measures = this->Measure(graded);
      const double misfit = Misfit(measures, this->Target);
      ++stalled;
      if (misfit < least)
      {
        stalled = 0;
        least = misfit;
        best = std::move(graded.Values);
        report.After = measures;
      }
      report.Iterations = round + 1;
      report.HasConverged = misfit <= 1.0;
      this->Correct(measures);
    }
    this->Terrain.Values = std::move(best);
    report.UnmetTargets = ::littoral::UnmetTargets(report.After, this->Target.Measures);
    this->Done = 1.0;
    this->Progress(1.0);
    return report;
  }

private:
  /// Parameters of grading, corrected from iteration to iteration.
  struct GradingLaw
  {
    double Concavity = 0.0;
    double SlopeFraction = MinimumSlopeFraction;
    double Cut = CutFraction;
  };

  struct GradedGround
  {
    std::vector<double> Heights;
    std::vector<CellIndex> Accumulation;
  };

  void Poll() const { this->Progress(this->Done); }

  /// A step of a series between two parts of the work.
  void Advance(double from, double to, double step, int steps)
  {
    this->Done = from + (to - from) * step / steps;
    this->Poll();
  }
  void AdvanceRound(double step) { this->Advance(ErosionPart, 1.0, step, this->Parameters.MaximumIterations); }

  /// Carves the terrain on a coarse grid first, and takes over its long waves, gains and law.
  void CarveCoarse()
  {
    GridSamples coarse = CoarseGround(this->Terrain, this->Parallel);
    CarvingParameters parameters = this->Parameters;
    parameters.Outlets = CoarseOutlets(this->Parameters.Outlets, this->Terrain);
    parameters.MaximumIterations = CoarseIterations;
    const CarvingProgress progress = [this](double part) {
      this->Done = CoarsePart * part;
      this->Poll();
    };
    Carver carver(coarse, this->Target, parameters, this->Parallel, progress);
    carver.Carve();
    this->Law = carver.Law;
    this->Gains = carver.Gains;
    TakeLongWaves(this->Terrain, coarse, this->Parallel);
    this->CoarseWork = CoarsePart;
  }

  double CellArea() const { return this->Terrain.Spacing[0] * this->Terrain.Spacing[1]; }

  /// Erodes by the stream power law; statistics are restored before each step.
  void Erode(int steps)
  {
    const CellLattice lattice(this->Terrain);
    StreamPowerLaw law;
    law.Uplift = 0.0; // restoring the statistics takes its place
    law.AreaExponent = ErosionExponent;
    law.Erodibility = this->Parameters.Incision * std::sqrt(lattice.CellArea()) *
      std::pow(IncisionCells * lattice.CellArea(), -ErosionExponent);
    const littoral::Poll poll = [this] { this->Poll(); };
    for (int step = 0; step < steps; ++step)
    {
      this->Advance(this->CoarseWork, ErosionPart, step, steps);
      this->RestoreStatistics();
      const OutletMask outlets = this->Parameters.Outlets.Of(this->Terrain);
      // The coarse grid has set where rivers run; breaches that are left are short.
      BreachDepressions(
        this->Terrain, outlets, this->CoarseWork > 0.0 ? BreachPath::LeastCost : BreachPath::FloodOrder, poll);
      const FlowRouting routing = RouteFlow(this->Terrain, outlets, this->Parallel, poll);
      StepStreamPower(this->Terrain, routing, DrainageArea(routing, lattice), law, 1.0);
      this->LowerRim();
    }
  }

  /// Lowers the border, which is not eroded, to the cells beside it: else it would be left standing as a wall.
  void LowerRim()
  {
    GridSamples& terrain = this->Terrain;
    const auto lower = [&](int i, int j) {
      const double beside = terrain.At(std::clamp(i, 1, terrain.Width - 2), std::clamp(j, 1, terrain.Height - 2));
      terrain.At(i, j) = std::min(terrain.At(i, j), beside);
    };
    for (int i = 0; i < terrain.Width; ++i)
    {
      lower(i, 0);
      lower(i, terrain.Height - 1);
    }
    for (int j = 0; j < terrain.Height; ++j)
    {
      lower(0, j);
      lower(terrain.Width - 1, j);
    }
  }

  void RestoreStatistics()
  {
    this->RestoreSpectrum();
    MapQuantiles(this->Terrain.Values, this->Target.Heights, this->Parallel);
  }

  GroundMeasures Measure(const GridSamples& ground) const
  {
    const littoral::Poll poll = [this] { this->Poll(); };
    return MeasureGround(
      ground, this->Parameters.Outlets.Of(ground), this->Parallel, poll, this->Target.Measures.MaximumArea);
  }

  /// Root mean square of the slopes to the next cells along x and y [m/m].
  double MeanSlope() const
  {
    const std::vector<double> semivariance = SemivarianceAlongAxes(this->Terrain, { 1 }, this->Parallel);
    return std::sqrt(2.0 * semivariance[0]) / std::max(this->Terrain.Spacing[0], this->Terrain.Spacing[1]);
  }

  void RestoreSpectrum()
  {
    GridSamples& field = this->Terrain;
    // The plane is no part of the field: it is replaced by the target's.
    PlaneTrend plane = RemovePlane(field);
    CosineTransform(field, this->Parallel);
    const RingSpectrum spectrum = SpectrumOfCoefficients(field, this->Parallel);
    this->Gains.Rings.resize(spectrum.Power.size(), 1.0);
    std::vector<double> gains(spectrum.Power.size(), 1.0);
    for (std::size_t ring = 1; ring < gains.size(); ++ring)
    {
      const double wanted = this->Target.Spectrum.At(static_cast<double>(ring) * spectrum.Step);
      const double ratio = spectrum.Power[ring] > 0.0 ? std::sqrt(wanted / spectrum.Power[ring]) : 1.0;
      gains[ring] = this->Gains.Rings[ring] * std::clamp(ratio, MinimumGain, MaximumGain);
    }
    gains[0] = gains.size() > 1 ? gains[1] : 1.0;
    MultiplyRings(field, spectrum.Step, gains, this->Parallel);
    const std::array<int, 2> count{ field.Width, field.Height };
    for (int axis = 0; axis < 2; ++axis)
    {
      plane.Slope[axis] = this->Gains.Plane * this->Target.Plane.Slope[axis] *
        std::min(1.0, this->Target.Sides[axis] / (count[axis] * field.Spacing[axis]));
    }
    for (int wave = 0; wave < 9; ++wave)
    {
      field.At(wave % 3, wave / 3) *= this->Gains.LongWaves[wave];
    }
    this->Bands.emplace(field, spectrum.Step, gains.size(), plane, this->Parallel);
    InverseCosineTransform(field, this->Parallel);
    AddPlane(field, plane, this->Parallel);
  }

  /// Breaches, and grades along the flow paths. Where long rivers would change heights by more than MaximumChange, the
  /// law is made flatter.
  GradedGround Grade()
  {
    const littoral::Poll poll = [this] { this->Poll(); };
    GridSamples breached = this->Terrain;
    const OutletMask outlets = this->Parameters.Outlets.Of(breached);
    BreachDepressions(breached, outlets, this->Parameters.Path, poll);
    const FlowRouting routing = RouteFlow(breached, outlets, this->Parallel, poll);
    GradedGround graded;
    graded.Accumulation = FlowAccumulation(routing);
    for (int flatter = 0; flatter <= MaximumFlattenings; ++flatter)
    {
      ChannelLaw law;
      law.Steepness = this->Law.SlopeFraction * this->Steepness;
      law.Concavity = this->Law.Concavity;
      law.ReferenceCells *= this->Target.CellArea / this->CellArea();
      law.MaximumCells = this->MaximumCellsOfLaw();
      law.ChannelThreshold = this->Parameters.ChannelThreshold;
      graded.Heights = GradeAlong(this->Terrain, routing, graded.Accumulation, law, this->Law.Cut, this->Parallel);
      if (this->ChangeOf(graded.Heights) <= MaximumChange * this->Target.Measures.StandardDeviation)
      {
        break;
      }
      this->Law.SlopeFraction *= FlatteningFactor;
    }
    return graded;
  }

  /// Largest drainage area of the target's slope-area relation [cells]; infinite unless the terrain has much larger
  /// ones.
  double MaximumCellsOfLaw() const
  {
    const double known = this->Target.Measures.MaximumArea / this->CellArea();
    const double tenth = 0.1 * static_cast<double>(this->Terrain.Values.size());
    return known * (1.0 + 1e-9) < tenth ? known : std::numeric_limits<double>::infinity();
  }

  /// Standard deviation of the change by grading [m].
  double ChangeOf(const std::vector<double>& graded) const
  {
    const auto count = static_cast<double>(graded.size());
    double mean = 0.0;
    double squares = 0.0;
    for (std::size_t n = 0; n < graded.size(); ++n)
    {
      const double change = graded[n] - this->Terrain.Values[n];
      mean += change / count;
      squares += change * change / count;
    }
    return std::sqrt(std::max(0.0, squares - mean * mean));
  }

  /// Adds the change by grading, spread over the valleys.
  void SpreadGrading()
  {
    GradedGround graded = this->Grade();
    std::vector<double>& changes = graded.Heights;
    std::vector<double> weights(changes.size());
    const double least = 1e-9 * this->Target.Measures.StandardDeviation;
    this->Parallel(changes.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        changes[n] -= this->Terrain.Values[n];
        const bool isChannel = graded.Accumulation[n] >= this->Parameters.ChannelThreshold;
        weights[n] = isChannel || std::abs(changes[n]) > least ? 1.0 : 0.0;
      }
    });
    SpreadChanges(
      changes, weights, this->Terrain.Width, this->Terrain.Height, this->Parameters.ValleyWidth, this->Parallel);
    this->Parallel(changes.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        this->Terrain.Values[n] += changes[n];
      }
    });
  }

  /// Corrects the channel law, the fraction of cut and the gains of the rings by the deviations of the last iteration.
  void Correct(const GroundMeasures& measures)
  {
    const double missing = this->Target.Measures.Concavity - measures.Concavity;
    if (!std::isnan(missing))
    {
      this->Law.Concavity = std::clamp(this->Law.Concavity + std::clamp(0.7 * missing, -0.15, 0.15), -0.3, 1.2);
      const double steeper = std::exp(-2.0 * std::clamp(missing, -0.15, 0.15));
      this->Law.SlopeFraction =
        std::clamp(this->Law.SlopeFraction * steeper, 0.5 * MinimumSlopeFraction, MaximumSlopeFraction);
    }
    // Cut raises the skewness of curvature, fill lowers it.
    this->Law.Cut =
      std::clamp(this->Law.Cut - 0.1 * std::clamp(measures.CurvatureSkewness, -1.0, 1.0), 0.0, MaximumCutFraction);
    const std::vector<int> lags = SemivarianceLags(this->Terrain.Width, this->Terrain.Height);
    std::vector<double> wanted;
    for (std::size_t n = 0; n < lags.size(); ++n)
    {
      wanted.push_back(this->Target.Measures.SemivarianceAt(measures.Lags[n]) / measures.Semivariance[n]);
    }
    const BandGains gains = this->Bands->GainsFor(lags, wanted);
    this->Gains.Plane = std::clamp(this->Gains.Plane * gains.Plane, MinimumPlaneGain, MaximumPlaneGain);
    for (std::size_t wave = 0; wave < 9; ++wave)
    {
      this->Gains.LongWaves[wave] =
        std::clamp(this->Gains.LongWaves[wave] * gains.LongWaves[wave], MinimumGain, MaximumGain);
    }
    for (std::size_t ring = 1; ring < this->Gains.Rings.size(); ++ring)
    {
      double& correction = this->Gains.Rings[ring];
      correction = std::clamp(correction * gains.Rings[ring], MinimumGain, MaximumGain);
    }
  }

  GridSamples& Terrain;
  const CarvingTarget& Target;
  const CarvingParameters& Parameters;
  const ParallelFor& Parallel;
  const CarvingProgress& Progress;
  double Steepness; ///< the target's slope at the law's reference area
  GradingLaw Law;
  BandGains Gains{ {}, { 1, 1, 1, 1, 1, 1, 1, 1, 1 }, 1.0 }; ///< gains beside those to the target's spectrum
  std::optional<SemivarianceBands> Bands;                    ///< bands of the field whose spectrum was restored last
  double CoarseWork = 0.0;                                   ///< part of the work that was done on the coarse grid
  double Done = 0.0;
};

std::string WhyNoRelief(const GridSamples& ground, const char* name)
{
  const auto [low, high] = RangeOf(ground.Values);
  return low < high ? "" : std::string(name) + " has one height everywhere; there is nothing to carve.";
}

}

double Misfit(const GroundMeasures& measures, const CarvingTarget& target, const CarvingTolerances& tolerances)
{
  double most = 0.0;
  for (const Deviation& deviation : DeviationsOf(measures, target.Measures, tolerances))
  {
    most = std::max(most, deviation.Size);
  }
  return most;
}

std::string UnmetTargets(const GroundMeasures& measures, const GroundMeasures& target)
{
  std::string missed;
  for (const Deviation& deviation : DeviationsOf(measures, target, {}))
  {
    missed += deviation.Size <= 1.0 ? "" : (missed.empty() ? "" : ", ") + std::string(deviation.Name);
  }
  return missed;
}

std::string WhyNoTarget(const GridSamples& place)
{
  ParameterCheck check;
  check.Require(WhyUndrainable(place, OutletMask(place.Values.size(), 1)));
  if (check.IsGood())
  {
    check.Require(WhyNoRelief(place, "The target"));
  }
  return check.Reason();
}

std::string WhyInvalid(const TargetStatistics& numbers)
{
  ParameterCheck check;
  check.Range("Concavity", numbers.Concavity, 0.0, 1.0);
  if (!numbers.KeepsHypsometry)
  {
    check.Range("ElevationSkewness", numbers.ElevationSkewness, -2.0, 2.0);
    check.Range("HypsometricIntegral", numbers.HypsometricIntegral, 0.0, 1.0);
    if (check.IsGood())
    {
      const std::array<double, 2> integrals = HypsometricIntegralRange(numbers.ElevationSkewness);
      const auto rounded = [](double value) { return TextOf(std::round(1000.0 * value) / 1000.0); };
      check.Require(numbers.HypsometricIntegral >= integrals[0] && numbers.HypsometricIntegral <= integrals[1],
        "HypsometricIntegral", numbers.HypsometricIntegral, "",
        "from " + rounded(integrals[0]) + " to " + rounded(integrals[1]) + " with an ElevationSkewness of " +
          TextOf(numbers.ElevationSkewness));
    }
  }
  return check.Reason();
}

std::string WhyInvalid(const GridSamples& terrain, const CarvingParameters& parameters)
{
  ParameterCheck check;
  check.Count("ErosionSteps", parameters.ErosionSteps, 0, 100);
  check.Positive("Incision", parameters.Incision, "", 100.0);
  check.Count("MaximumIterations", parameters.MaximumIterations, 1, 100);
  check.Range("ChannelThreshold", parameters.ChannelThreshold, 1.0, 1e6);
  check.Range("ValleyWidth", parameters.ValleyWidth, 0.5, 50.0);
  check.Choice("Path", static_cast<int>(parameters.Path), 2);
  check.Choice("Outlets", static_cast<int>(parameters.Outlets.Choice), 3);
  check.Finite("SeaLevel", parameters.Outlets.SeaLevel, "m");
  if (check.IsGood())
  {
    const OutletMask all(terrain.Values.size(), 1);
    check.Require(
      WhyUndrainable(terrain, parameters.Outlets.Choice == OutletChoice::Chosen ? parameters.Outlets.Cells : all));
  }
  if (check.IsGood())
  {
    check.Require(WhyNoRelief(terrain, "The terrain"));
  }
  return check.Reason();
}

double CarvingMemory(int width, int height)
{
  // measured: see Documentation/design/drainage.md
  constexpr double bytesPerCell = 120.0;
  return bytesPerCell * width * height;
}

CarvingTarget TargetOf(const GridSamples& place, const DrainageOutlets& outlets, const ParallelFor& parallel)
{
  CarvingTarget target;
  GridSamples field = place;
  FillHoles(field);
  target.Plane = RemovePlane(field);
  target.CellArea = place.Spacing[0] * place.Spacing[1];
  target.Sides = { place.Width * place.Spacing[0], place.Height * place.Spacing[1] };
  CosineTransform(field, parallel);
  target.Spectrum = SpectrumOfCoefficients(field, parallel);
  target.Heights = QuantilesOf(PresentValues(place.Values));
  target.Measures = MeasureGround(place, outlets.Of(place), parallel);
  return target;
}

CarvingTarget TargetOf(const GridSamples& terrain, const TargetStatistics& numbers, const DrainageOutlets& outlets,
  const ParallelFor& parallel)
{
  CarvingTarget target = TargetOf(terrain, outlets, parallel);
  target.Measures.Concavity = numbers.Concavity;
  if (!numbers.KeepsHypsometry)
  {
    const GroundMeasures& own = target.Measures;
    const double mean = own.Lowest + own.HypsometricIntegral * (own.Highest - own.Lowest);
    target.Heights =
      LognormalQuantiles(mean, own.StandardDeviation, numbers.HypsometricIntegral, numbers.ElevationSkewness);
    target.Measures.HypsometricIntegral = numbers.HypsometricIntegral;
    target.Measures.ElevationSkewness = numbers.ElevationSkewness;
  }
  return target;
}

CarvingReport CarveDrainage(GridSamples& terrain, const CarvingTarget& target, const CarvingParameters& parameters,
  const ParallelFor& parallel, const CarvingProgress& progress)
{
  return Carver(terrain, target, parameters, parallel, progress).Carve();
}

CarvingReport CarveAround(GridSamples& terrain, const CarvingTarget& target, const CarvingParameters& parameters,
  const ParallelFor& parallel, const CarvingProgress& progress)
{
  const OutletMask outside = OutsideOf(terrain);
  if (std::none_of(outside.begin(), outside.end(), [](std::uint8_t is) { return is != 0; }))
  {
    return CarveDrainage(terrain, target, parameters, parallel, progress);
  }
  const auto measure = [&] {
    return MeasureGround(
      terrain, parameters.Outlets.Of(terrain), parallel, [&] { progress(0.0); }, target.Measures.MaximumArea);
  };
  const GroundMeasures before = measure();
  CarvingParameters around = parameters;
  around.Outlets.Outside = outside;
  FillHoles(terrain);
  CarvingReport report = CarveDrainage(terrain, target, around, parallel, progress);
  for (std::size_t cell = 0; cell < outside.size(); ++cell)
  {
    terrain.Values[cell] = outside[cell] ? std::numeric_limits<double>::quiet_NaN() : terrain.Values[cell];
  }
  report.Before = before;
  report.After = measure();
  return report;
}

}
