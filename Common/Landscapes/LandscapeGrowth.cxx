// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/LandscapeGrowth.h"

#include "Drainage/DepressionBreaching.h"
#include "Drainage/GroundStatistics.h"
#include "Drainage/ValleySpreading.h"
#include "Landscapes/CourseWaves.h"
#include "Landscapes/GridCourses.h"
#include "Landscapes/GroundRoughness.h"
#include "Landscapes/HeightCorrection.h"
#include "Landscapes/LandscapeMeasures.h"
#include "Landscapes/LandscapeStep.h"
#include "Landscapes/LongWaves.h"
#include "Landscapes/MeshCourses.h"
#include "Landscapes/PlaceMatching.h"
#include "Landscapes/RockHardness.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"
#include "Terrain/GridHoles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace littoral
{

namespace
{

/// Margin about the terrain that is grown along and cut off [cells].
constexpr int Margin = 24;

/// Levels of resolution: cells of the terrain along a cell of theirs, and steps.
struct GrowthLevel
{
  int Factor;
  int Steps;
};
constexpr std::array<GrowthLevel, 3> Levels{ { { 4, 80 }, { 2, 40 }, { 1, 12 } } };
constexpr int StepsAnIteration = 8;
constexpr double TimeAnIteration = 3.0; ///< of each of its steps, over the relief

/// Area exponents of rivers, and the one where the place tells none.
constexpr double LeastExponent = 0.35;
constexpr double GreatestExponent = 0.75;
constexpr double UsualExponent = 0.45;
constexpr double ExponentStep = 0.4; ///< correction over what is missing

/// Diffusivity at the start: that under which ridges have ten times the place's curvature of one cell, some 1.8 times
/// that of two.
constexpr double CurvatureFactor = 18.0;

/// Threshold slope over the place's steep ones, a quantile in thousandths, and least slope of rivers over its mean.
constexpr double ThresholdFactor = 1.1;
constexpr std::size_t SteepQuantile = 999;
constexpr double LeastSlopeFactor = 0.002;

/// Smoothing of heights whose ranks tell the rock [cells], and the power by which slopes of the place become hardness.
constexpr double RockCells = 12.0;
constexpr double FirstContrast = 4.5;
constexpr double SmallestContrast = 0.1;
constexpr double LargestContrast = 8.0;

/// Uplift at the start, and the growth of its logarithm by that of the squared relief that is missing.
constexpr double FirstUplift = 0.25;
constexpr double UpliftGain = 0.1;

/// Tolerance of Kolmogorov's distance of slopes.
constexpr double SlopeTolerance = 0.04;

/// Height of the rim below the long waves, and the first roughness, over the deviation of short waves.
constexpr double RimDepth = 0.5;
constexpr double FirstRoughness = 0.1;

/// Larger terrain takes the law that was fitted on the middle part of it, and has few iterations of its own.
constexpr std::size_t MaximumCellsToFit = std::size_t{ 1 } << 18;
constexpr int LargestPart = 288;
constexpr int LargeIterations = 2;
constexpr double PartWork = 0.3;

/// Rounds of corrections to given heights and of breaching, and the deviation of the narrowest function that corrects
/// growing ground [cells].
constexpr int LastRounds = 4;
constexpr double GrowingCells = 2.0;
constexpr int GrowingPasses = 2;

/// Width of the valleys that given rivers have in the long waves, over the steering's smoothing.
constexpr double LinesFactor = 2.0;

/// Least factor of rock and uplift, and one over the greatest.
constexpr double LeastFactor = 1e-3;

/// Logarithm of factors below which they are the same everywhere.
constexpr double LeastLogFactor = 1e-9;

GridSamples MiddleOf(const GridSamples& terrain)
{
  const int width = std::min(LargestPart, terrain.Width);
  const int height = std::min(LargestPart, terrain.Height);
  return PartOf(terrain, (terrain.Width - width) / 2, (terrain.Height - height) / 2, width, height);
}

/// Values of the middle part of a terrain, if there are any.
std::vector<double> MiddleOf(const GridSamples& terrain, const std::vector<double>& values)
{
  GridSamples grid = terrain;
  grid.Values = values;
  return values.empty() ? values : MiddleOf(grid).Values;
}

/// Range of the middle three fifths of even quantiles.
double SpreadOf(const std::vector<double>& quantiles)
{
  const std::size_t fifth = (quantiles.size() - 1) / 5;
  return quantiles[4 * fifth] - quantiles[fifth];
}

/// Deviations over their tolerances: none is above Most. Squares sums their squares, as far as one that is out of
/// reach, as of rivers that a window lacks, counts.
struct Misfit
{
  double Most = 0.0;
  double Squares = 0.0;

  void Add(double deviation)
  {
    constexpr double most = 2.0;
    this->Most = std::isnan(deviation) ? this->Most : std::max(this->Most, deviation);
    const double counted = std::min(deviation, most);
    this->Squares += std::isnan(deviation) ? 0.0 : counted * counted;
  }
};

/// |z / wanted - 1|; 0 where nothing is wanted.
double RelativeError(double value, double wanted)
{
  return wanted > 0.0 ? std::abs(value / wanted - 1.0) : 0.0;
}

/// The steps of GrowLandscape(). Uplift is below 1, in any unit of time.
class Grower
{
public:
  Grower(const GridSamples& terrain, const GridSamples& place, const GrowthParameters& parameters,
    const ParallelFor& parallel, CarvingProgress progress)
    : Terrain(terrain)
    , Place(place)
    , Steering(parameters.Steering)
    , Iterations(parameters.MaximumIterations)
    , Seed(parameters.Seed)
    , Parallel(parallel)
    , Progress(std::move(progress))
    , Target(TargetOf(place, {}, parallel))
    , Wanted(MeasureLandscape(place, parallel))
    , Matching(place, this->Target)
    , SlopeProfile(SlopesByHeight(place, RockCells, parallel))
    , Roughness(RoughnessOf(place, parallel))
    , Waves(terrain, this->Target, this->ShortestWave(), parameters.Seed, parallel)
  {
    this->Target.Measures.Concavity = this->Wanted.Concavity;
    this->SetMargins();
    this->SetFactors(parameters.Rock);
    // rivers and creep make what is left of curvature without the roughness that is added
    this->Wanted.CurvatureDeviation *= this->HasRock() ? 1.0 : std::sqrt(1.0 - this->Roughness.CurvaturePart);
    this->SetGiven(parameters.Given);
    this->SetLaw();
    this->SetLongWaves();
    int steps = 0;
    for (const GrowthLevel& level : Levels)
    {
      steps += level.Steps;
    }
    this->AllSteps = steps + StepsAnIteration * this->Iterations;
  }

  GridSamples Grow()
  {
    for (const GrowthLevel& level : Levels)
    {
      this->BeginLevel(level.Factor);
      this->Evolve(level.Steps, this->Relief);
    }
    GridSamples best = this->Ground();
    Misfit least = this->MisfitOf(best, MeasureLandscape(best, this->Parallel));
    for (int iteration = 0; iteration < this->Iterations && least.Most > 1.0; ++iteration)
    {
      ++this->Done;
      this->Evolve(StepsAnIteration, TimeAnIteration * this->Relief);
      GridSamples ground = this->Ground();
      const LandscapeMeasures measures = MeasureLandscape(ground, this->Parallel);
      const Misfit misfit = this->MisfitOf(ground, measures);
      this->Correct(ground, measures);
      if (misfit.Most <= 1.0 || misfit.Squares < least.Squares)
      {
        least = misfit;
        best = std::move(ground);
      }
    }
    this->Breach(best);
    this->Roughen(best);
    const bool isGiven = this->Given.HasLines() || !this->GivenHeights.empty();
    for (int round = 0; round < LastRounds && isGiven; ++round)
    {
      CorrectHeights(best, this->GivenHeights, 1.0, this->Parallel);
      LeadGrid(best, this->GivenLines, this->Law.MinimumSlope);
      this->Breach(best);
    }
    return best;
  }

  /// Takes over what was fitted on another terrain of the same place.
  void TakeLaw(const Grower& other)
  {
    this->Law = other.Law;
    this->Contrast = other.Contrast;
    this->Uplift = other.Uplift;
  }

  int IterationsDone() const { return this->Done; }
  const GroundMeasures& TargetMeasures() const { return this->Target.Measures; }

private:
  /// Logarithms of factors by place, about their mean, with margins.
  void SetFactors(const GrowthRock& rock)
  {
    this->LogErodibility = this->LogFactors(rock.Erodibility);
    this->LogUplift = this->LogFactors(rock.UpliftFactor);
  }

  bool HasRock() const { return !this->LogErodibility.Values.empty() || !this->LogUplift.Values.empty(); }

  GridSamples LogFactors(const std::vector<double>& factors) const
  {
    if (factors.empty())
    {
      return {};
    }
    GridSamples logs = this->Terrain;
    for (std::size_t n = 0; n < factors.size(); ++n)
    {
      logs.Values[n] = std::log(factors[n]);
    }
    const double mean = Moments(logs).Mean;
    double most = 0.0;
    for (double& value : logs.Values)
    {
      value -= mean;
      most = std::max(most, std::abs(value));
    }
    if (most < LeastLogFactor)
    {
      return {};
    }
    return WithEdges(logs, this->Before, this->After[0], this->After[1]);
  }

  /// Lines and heights that are given, with origins of the terrain and of the grid with margins.
  void SetGiven(const GivenGround& given)
  {
    this->GivenHeights = HeightsOf(given, this->Terrain);
    this->GivenLines = given;
    this->Given = Shifted(WithMouths(given, this->Terrain, this->Before + Levels.front().Factor),
      { this->Before * this->Terrain.Spacing[0], this->Before * this->Terrain.Spacing[1] });
  }

  /// The same with the origin of a level's grid, whose first cell's middle is further in than a cell's of the terrain.
  void SetGivenOfLevel()
  {
    const double aside = -0.5 * (this->Factor - 1);
    this->GivenOfLevel = Shifted(this->Given, { aside * this->Terrain.Spacing[0], aside * this->Terrain.Spacing[1] });
    this->HeightsOfLevel = HeightsOf(this->GivenOfLevel, this->Guide);
  }

  /// Brings the heights of points to those that are given.
  void HoldHeights()
  {
    if (!this->HeightsOfLevel.empty())
    {
      GridSamples ground = this->Guide;
      ground.Values = this->Heights;
      CorrectHeights(ground, this->HeightsOfLevel, GrowingCells, this->Parallel, GrowingPasses);
      this->Heights = ground.Values;
    }
  }

  /// Factors and ln(f / e) at the points of a level.
  void SetFactorsOfLevel()
  {
    this->LogSteepness.assign(this->HasRock() ? this->Mesh.Count() : 0, 0.0);
    const auto factors = [&](const GridSamples& logs, double sign) {
      std::vector<double> values = logs.Values.empty() ? std::vector<double>() : BlockMeans(logs, this->Factor).Values;
      for (std::size_t n = 0; n < values.size(); ++n)
      {
        this->LogSteepness[n] += sign * values[n];
        values[n] = std::exp(values[n]);
      }
      return values;
    };
    this->Factors.Erodibility = factors(this->LogErodibility, -1.0);
    this->Factors.Uplift = factors(this->LogUplift, 1.0);
  }

  /// Wave number of the shortest waves that the steering reaches, of twice its filter's wavelength pi s.
  double ShortestWave() const
  {
    return 1.0 / (4.0 * this->Steering.Smoothing * std::max(this->Terrain.Spacing[0], this->Terrain.Spacing[1]));
  }

  /// Margins with which the grid has whole numbers of the coarsest cells.
  void SetMargins()
  {
    const int coarsest = Levels.front().Factor;
    this->Before = std::min({ Margin, this->Terrain.Width - 1, this->Terrain.Height - 1 });
    const auto after = [&](int count) {
      const int all = count + 2 * this->Before;
      return this->Before - all % coarsest;
    };
    this->After = { after(this->Terrain.Width), after(this->Terrain.Height) };
  }

  void SetLaw()
  {
    const double concavity = std::isnan(this->Wanted.Concavity) ? UsualExponent : this->Wanted.Concavity;
    this->Law.AreaExponent = std::clamp(concavity, LeastExponent, GreatestExponent);
    this->Law.Diffusivity = 1.0 / (CurvatureFactor * this->Wanted.CurvatureDeviation);
    this->Law.ThresholdSlope =
      ThresholdFactor * this->Wanted.Slopes[SteepQuantile * (this->Wanted.Slopes.size() - 1) / 1000];
    this->Law.MinimumSlope = LeastSlopeFactor * this->Wanted.MeanSlope;
    this->SetErodibility();
  }

  /// K A_ref^m = U / S_ref at the reference area of the place, U = 1.
  void SetErodibility()
  {
    const double slope = this->Wanted.ChannelSlope > 0.0 ? this->Wanted.ChannelSlope : 0.3 * this->Wanted.MeanSlope;
    const double area = LandscapeMeasures::ReferenceCells * this->Place.Spacing[0] * this->Place.Spacing[1];
    this->Law.Erodibility = std::pow(area, -this->Law.AreaExponent) / slope;
  }

  void SetLongWaves()
  {
    GridSamples field = WithMargins(this->Waves.Heights(this->Parallel), this->Before, this->After[0], this->After[1]);
    this->Wide = field;
    SmoothGrid(this->Wide.Values, field.Width, field.Height, this->Steering.Smoothing, this->Parallel);
    LeadWaves(this->Wide, this->Given, LinesFactor * this->Steering.Smoothing, this->Parallel);
    CorrectHeights(this->Wide, HeightsOf(this->Given, this->Wide), this->Steering.Smoothing, this->Parallel);
    this->Relief = std::sqrt(Moments(field).Variance);
    for (std::size_t n = 0; n < field.Values.size(); ++n)
    {
      field.Values[n] -= this->Wide.Values[n];
    }
    this->ShortWaves = std::sqrt(Moments(field).Variance);
  }

  /// Points of a level, with the heights and the uplift of the coarser one, or with some roughness.
  void BeginLevel(int factor)
  {
    const PointMesh coarse = std::move(this->Mesh);
    this->Factor = factor;
    this->Guide = BlockMeans(this->Wide, factor);
    this->SetGivenOfLevel();
    this->Mesh = JitteredMesh(this->Guide.Width, this->Guide.Height, this->Guide.Spacing, this->Seed, factor,
      PointsOnLines(this->GivenOfLevel, this->Guide.Width, this->Guide.Height, this->Guide.Spacing), this->Parallel);
    this->Courses = CoursesOn(this->Mesh, this->GivenOfLevel);
    this->SetRock();
    this->SetFactorsOfLevel();
    if (coarse.Points.empty())
    {
      this->Heights = this->RoughGuide();
      this->Hardness = this->Rock;
    }
    else
    {
      this->Heights = Refined(this->Heights, coarse.Width, coarse.Height);
      this->Hardness = Refined(this->Hardness, coarse.Width, coarse.Height);
    }
    for (CellIndex n = 0; n < this->Mesh.Count(); ++n)
    {
      this->Heights[n] = this->Mesh.IsRim(n) ? this->Guide.Values[n] - RimDepth * this->ShortWaves : this->Heights[n];
    }
  }

  std::vector<double> RoughGuide() const
  {
    const RandomStream random(this->Seed, RandomPurpose::LandscapeRoughness);
    std::vector<double> heights = this->Guide.Values;
    for (std::size_t n = 0; n < heights.size(); ++n)
    {
      heights[n] += FirstRoughness * this->ShortWaves * random.NormalPair(n, 0)[0];
    }
    return heights;
  }

  void Evolve(int steps, double time)
  {
    UpliftSteering steering = this->Steering;
    steering.Smoothing /= this->Factor;
    for (int step = 0; step < steps; ++step)
    {
      CarveCourses(this->Mesh, this->Courses, this->Law.MinimumSlope, this->Heights);
      const MeshDrainage drainage = DrainMesh(this->Mesh, this->Heights, this->Parallel, this->Courses);
      StepLandscape(this->Mesh, drainage, this->Law, this->Uplift, this->Hardness, time, this->Heights, this->Parallel,
        this->Factors);
      this->HoldHeights();
      SteerUplift(steering, this->Heights, this->Guide, this->Rock, this->Hardness, this->Parallel);
      if (!this->LogSteepness.empty())
      {
        KeepSteepness(this->LogSteepness, this->Hardness);
      }
      this->SteerRelief();
      this->Progress(static_cast<double>(this->Steps++) / this->AllSteps);
    }
  }

  /// Hardness of the rock by the height of the long waves, r = (S / S_mean)^c with the place's slopes at that rank.
  void SetRock()
  {
    this->Rock = ProfileByHeight(this->Guide, RockCells / this->Factor, this->SlopeProfile, this->Parallel);
    for (double& rock : this->Rock)
    {
      rock = std::pow(rock, this->Contrast);
    }
  }

  /// Uplift by the relief that is missing, U' = U (Var_wanted / Var)^g.
  void SteerRelief()
  {
    GridSamples ground = this->Guide;
    ground.Values = this->Heights;
    const double missing = this->Relief * this->Relief / Moments(ground).Variance;
    this->Uplift *= std::clamp(std::pow(missing, UpliftGain), 0.8, 1.25);
  }

  /// Heights on the terrain's grid, with the distribution and the semivariances of the place.
  GridSamples Ground() const
  {
    GridSamples ground =
      PartOf(GridOf(this->Mesh, this->Heights), this->Before, this->Before, this->Terrain.Width, this->Terrain.Height);
    this->MatchPlace(ground);
    CorrectHeights(ground, this->GivenHeights, 1.0, this->Parallel);
    return ground;
  }

  void MatchPlace(GridSamples& ground) const
  {
    // ranks of a place of other rocks would take the contrast of slopes back
    this->Matching.Match(ground, this->LogSteepness.empty() ? 1.0 : 0.0, this->Parallel);
  }

  /// A poll that reports no further progress.
  Poll PollNow() const
  {
    return [this] { this->Progress(std::min(1.0, static_cast<double>(this->Steps) / this->AllSteps)); };
  }

  void Breach(GridSamples& ground) const
  {
    BreachDepressions(ground, BorderOutlets(ground.Width, ground.Height), BreachPath::LeastCost, this->PollNow());
  }

  /// Adds the roughness that the ground lacks, and matches it again. How rough other rocks are the place does not tell.
  void Roughen(GridSamples& ground) const
  {
    if (!this->HasRock())
    {
      AddRoughness(ground, this->Roughness, this->Law.MinimumSlope, this->Seed, this->Parallel, this->PollNow());
      this->MatchPlace(ground);
      CorrectHeights(ground, this->GivenHeights, 1.0, this->Parallel);
      this->Breach(ground);
    }
  }

  /// Deviations from the place over their tolerances.
  Misfit MisfitOf(const GridSamples& ground, const LandscapeMeasures& is) const
  {
    const LandscapeMeasures& shall = this->Wanted;
    Misfit misfit;
    misfit.Add(RelativeError(is.MeanSlope, shall.MeanSlope) / 0.1);
    misfit.Add(RelativeError(is.CurvatureDeviation, shall.CurvatureDeviation) / 0.2);
    misfit.Add(RelativeError(is.BlockVariation, shall.BlockVariation) / 0.3);
    misfit.Add(std::abs(is.GentleFraction - shall.GentleFraction) / 0.05);
    misfit.Add(KolmogorovDistance(is.Slopes, shall.Slopes) / SlopeTolerance);
    misfit.Add(std::abs(is.Concavity - shall.Concavity) / 0.15);
    misfit.Add(this->Matching.SemivarianceError(ground, this->Parallel) / 0.1);
    return misfit;
  }

  /// Corrects the law, the contrast of rocks and the long waves by what is missing.
  void Correct(const GridSamples& ground, const LandscapeMeasures& is)
  {
    const LandscapeMeasures& shall = this->Wanted;
    // steeper and sharper ground than the place's needs more creep
    const double steep = is.MeanSlope / shall.MeanSlope;
    const double sharp = is.CurvatureDeviation / shall.CurvatureDeviation;
    this->Law.Diffusivity *= std::clamp(std::pow(steep * sharp, 0.8), 0.6, 1.5);
    const double missing = shall.Concavity - is.Concavity;
    if (!std::isnan(missing))
    {
      this->Law.AreaExponent = std::clamp(
        this->Law.AreaExponent + ExponentStep * std::clamp(missing, -0.15, 0.15), LeastExponent, GreatestExponent);
    }
    this->SetErodibility();
    // rock that differs more from place to place makes more gentle ground
    const double variation = shall.BlockVariation > 0.0 ? is.BlockVariation / shall.BlockVariation : 1.0;
    const double gentle = (is.GentleFraction + 0.02) / (shall.GentleFraction + 0.02);
    const double spread = SpreadOf(is.Slopes) / is.MeanSlope * shall.MeanSlope / SpreadOf(shall.Slopes);
    const double by = std::clamp(std::pow(variation * gentle, -0.1) / spread, 0.85, 1.18);
    this->Contrast = std::clamp(by * this->Contrast, SmallestContrast, LargestContrast);
    this->Waves.Correct(ground, this->Target.Measures, this->Parallel);
    this->SetLongWaves();
    this->Guide = this->Wide;
    this->SetRock();
  }

  const GridSamples& Terrain;
  const GridSamples& Place;
  UpliftSteering Steering;
  int Iterations;
  int Seed;
  const ParallelFor& Parallel;
  CarvingProgress Progress;
  CarvingTarget Target;
  LandscapeMeasures Wanted;
  PlaceMatching Matching;
  std::vector<double> SlopeProfile; ///< of the place, by height
  GroundRoughness Roughness;        ///< of the place
  LongWaves Waves;
  int Before = 0;
  std::array<int, 2> After{ 0, 0 };
  LandscapeLaw Law;
  GridSamples LogErodibility;            ///< ln e with margins, without a mean; none without rock
  GridSamples LogUplift;                 ///< ln f
  RockFactors Factors;                   ///< of the level
  std::vector<double> LogSteepness;      ///< ln(f / e) of the level
  std::vector<GivenHeight> GivenHeights; ///< of the terrain
  GivenGround GivenLines;                ///< of the terrain
  GivenGround Given;                     ///< of the grid with margins
  GivenGround GivenOfLevel;
  std::vector<GivenHeight> HeightsOfLevel;
  MeshCourses Courses;
  GridSamples Wide;        ///< long waves with margins
  double Relief = 0.0;     ///< standard deviation of the field [m]
  double ShortWaves = 0.0; ///< that of the field without its long waves [m]
  int Factor = 1;
  GridSamples Guide; ///< long waves at the resolution of the level
  PointMesh Mesh;
  std::vector<double> Heights;
  std::vector<double> Rock;     ///< hardness by height alone
  std::vector<double> Hardness; ///< of now
  double Uplift = FirstUplift;
  double Contrast = FirstContrast;
  int Done = 0; ///< iterations
  int Steps = 0;
  int AllSteps = 1;
};

}

namespace
{

/// Why values by place cannot be used: their number, or one where the terrain has a height; empty when they can.
std::string WhyUnusable(const GridSamples& terrain, const std::vector<double>& values, const char* name, bool isFactor)
{
  if (!values.empty() && values.size() != terrain.Values.size())
  {
    return std::string(name) + " has another number of values than the terrain has cells.";
  }
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    const bool isGood =
      std::isfinite(values[n]) && (!isFactor || (values[n] >= LeastFactor && values[n] <= 1.0 / LeastFactor));
    if (!isGood && !std::isnan(terrain.Values[n]))
    {
      return std::string(name) +
        (isFactor ? " has values that are not between 0.001 and 1000." : " has values that are not finite.");
    }
  }
  return "";
}

std::string WhyInvalid(const GridSamples& terrain, const GrowthRock& rock)
{
  ParameterCheck check;
  check.Require(WhyUnusable(terrain, rock.Erodibility, "Erodibility", true));
  check.Require(WhyUnusable(terrain, rock.UpliftFactor, "UpliftFactor", true));
  check.Require(WhyUnusable(terrain, rock.FaultThrow, "FaultThrow", false));
  return check.Reason();
}

/// Lifts ground by throws [m] and breaches what they dam.
void MoveFaults(GridSamples& ground, const GridSamples& given, const std::vector<double>& faultThrow)
{
  for (std::size_t n = 0; n < faultThrow.size(); ++n)
  {
    ground.Values[n] += std::isnan(given.Values[n]) ? 0.0 : faultThrow[n];
  }
  if (!faultThrow.empty())
  {
    BreachDepressions(ground, BorderOutlets(ground.Width, ground.Height), BreachPath::LeastCost);
  }
}

/// Factors that go on smoothly where the terrain has no heights.
std::vector<double> FilledOut(const GridSamples& terrain, const std::vector<double>& factors)
{
  if (factors.empty())
  {
    return factors;
  }
  GridSamples grid = terrain;
  grid.Values = factors;
  TakeHoles(terrain, grid);
  FillHoles(grid);
  return grid.Values;
}

}

std::string WhyInvalid(const GridSamples& terrain, const GrowthParameters& parameters)
{
  ParameterCheck check;
  check.Positive("Smoothing", parameters.Steering.Smoothing, "cells", 100.0);
  check.Positive("Gain", parameters.Steering.Gain, "", 100.0);
  check.Positive("Minimum", parameters.Steering.Minimum, "", 1.0);
  check.Range("Maximum", parameters.Steering.Maximum, 1.0, 1e3);
  check.Range("Range", parameters.Steering.Range, 1.001, 100.0);
  check.Positive("Rate", parameters.Steering.Rate, "", 1.0);
  check.Count("MaximumIterations", parameters.MaximumIterations, 0, 100);
  check.Require(WhyTooSmall(terrain, "The terrain"));
  check.Require(WhyInvalid(terrain, parameters.Rock));
  check.Require(WhyInvalid(terrain, parameters.Given));
  const auto isMissing = [](double height) { return std::isnan(height); };
  if (check.IsGood() && std::all_of(terrain.Values.begin(), terrain.Values.end(), isMissing))
  {
    check.Require("The terrain has no heights.");
  }
  return check.Reason();
}

std::string WhyNoPlace(const GridSamples& place)
{
  ParameterCheck check;
  check.Require(WhyTooSmall(place, "The target"));
  GridSamples field = place;
  const double range = RangeOf(place.Values)[1] - RangeOf(place.Values)[0];
  RemovePlane(field);
  check.Require(Moments(field).Variance > 1e-12 * range * range
      ? ""
      : "The target is a plane; there are no valleys to learn from.");
  if (check.IsGood())
  {
    GridSamples filled = place;
    FillHoles(filled);
    const std::vector<double> slopes = GradientsOf(filled);
    const bool hasSlopes = std::any_of(slopes.begin(), slopes.end(), [](double slope) { return slope > 0.0; });
    check.Require(hasSlopes ? "" : "The target goes up and down in turn from cell to cell; it has no slopes.");
  }
  return check.Reason();
}

double GrowthMemory(int width, int height)
{
  constexpr double bytesPerPoint = 900.0; // points, links, triangles and Boost's diagram
  return bytesPerPoint * (width + 2.0 * Margin) * (height + 2.0 * Margin);
}

CarvingReport GrowLandscape(GridSamples& terrain, const GridSamples& measured, const GrowthParameters& parameters,
  const ParallelFor& parallel, const CarvingProgress& progress)
{
  GridSamples place = measured;
  FillHoles(place);
  GrowthParameters whole = parameters;
  const bool isLarge = terrain.Values.size() > MaximumCellsToFit;
  whole.MaximumIterations = isLarge ? std::min(LargeIterations, whole.MaximumIterations) : whole.MaximumIterations;
  const GridSamples given = terrain;
  whole.Rock.Erodibility = FilledOut(given, whole.Rock.Erodibility);
  whole.Rock.UpliftFactor = FilledOut(given, whole.Rock.UpliftFactor);
  const OutletMask rim = RimOutlets(given);
  FillHoles(terrain);
  CarvingReport report;
  Grower grower(terrain, place, whole, parallel,
    [&](double part) { progress(isLarge ? PartWork + (1.0 - PartWork) * part : part); });
  if (isLarge)
  {
    const GridSamples part = MiddleOf(terrain);
    GrowthParameters ofPart = parameters;
    ofPart.Rock.Erodibility = MiddleOf(terrain, whole.Rock.Erodibility);
    ofPart.Rock.UpliftFactor = MiddleOf(terrain, whole.Rock.UpliftFactor);
    Grower fit(part, place, ofPart, parallel, [&](double done) { progress(PartWork * done); });
    fit.Grow();
    grower.TakeLaw(fit);
  }
  const GroundMeasures& target = grower.TargetMeasures();
  report.Before = MeasureGround(
    given, rim, parallel, [&] { progress(isLarge ? PartWork : 0.0); }, target.MaximumArea);
  terrain = grower.Grow();
  MoveFaults(terrain, given, whole.Rock.FaultThrow);
  TakeHoles(given, terrain);
  report.After = MeasureGround(
    terrain, rim, parallel, [&] { progress(1.0); }, target.MaximumArea);
  report.Iterations = grower.IterationsDone();
  report.UnmetTargets = UnmetTargets(report.After, target);
  report.HasConverged = report.UnmetTargets.empty();
  return report;
}

}
