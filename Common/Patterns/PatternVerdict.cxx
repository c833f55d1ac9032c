// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternVerdict.h"

#include "Numerics/ParameterCheck.h"
#include "Patterns/PatternLaw.h"
#include "Patterns/WindowSections.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace littoral
{

namespace
{

/// Quadrats of a window, of each axis as many as are given, or chosen.
QuadratGrid GridOf(const ObservationWindow& window, std::size_t points, const std::array<int, 2>& quadrats)
{
  QuadratGrid grid;
  grid.Origin = window.GetLow();
  grid.Size = { window.GetHigh()[0] - window.GetLow()[0], window.GetHigh()[1] - window.GetLow()[1] };
  ChooseQuadrats(grid, static_cast<double>(points));
  for (int axis = 0; axis < 2; ++axis)
  {
    grid.Count[axis] = quadrats[axis] > 0 ? quadrats[axis] : grid.Count[axis];
  }
  return grid;
}

std::vector<long long> FrequenciesIn(const QuadratGrid& grid, const std::vector<PlanePosition>& points)
{
  std::vector<int> counts(static_cast<std::size_t>(grid.NumberOfQuadrats()), 0);
  for (const PlanePosition& point : points)
  {
    const long long quadrat = QuadratOf(grid, point[0], point[1]);
    if (quadrat >= 0)
    {
      ++counts[static_cast<std::size_t>(quadrat)];
    }
  }
  return CountFrequencies(counts);
}

/// Judges laws one by one.
class Judge
{
public:
  // The kernel is that of the measured pattern in all (Stoyan's rule).
  Judge(const std::vector<PlanePosition>& points, const ObservationWindow& window, const VerdictOptions& options,
    const ParallelFor& parallel)
    : Window(window)
    , Options(options)
    , Pairs(PairsOf(points, window, options, parallel))
    , Measured(CurveOf(points, parallel))
  {
  }

  const std::vector<double>& GetMeasured() const { return this->Measured; }

  std::vector<double> GetDistances() const
  {
    std::vector<double> distances;
    for (int k = 1; k <= this->Pairs.Distances.Steps; ++k)
    {
      distances.push_back(this->Pairs.Distances[k]);
    }
    return distances;
  }

  CurveEnvelope Test(const PatternLaw& law, const Poll& poll, const ParallelFor& parallel, const WorkShare& share) const
  {
    const auto pattern = [&](int number, const ParallelFor& inner) {
      return DrawPattern(law, this->Window, SeedOfSimulation(this->Options.Seed, number), inner);
    };
    const auto curve = [&](const std::vector<PlanePosition>& points, const ParallelFor& inner) {
      return this->CurveOf(points, inner);
    };
    const NumberRows curves = SimulateCurves(pattern, curve, this->Options.Simulations, poll, parallel, share);
    return share.IsFirst() ? FindCurveEnvelope(this->Measured, curves, this->Options.Level) : CurveEnvelope();
  }

private:
  static PairOptions PairsOf(const std::vector<PlanePosition>& points, const ObservationWindow& window,
    const VerdictOptions& options, const ParallelFor& parallel)
  {
    PairOptions pairs;
    pairs.Distances = DefaultDistances(window, points.size(), options.Steps);
    pairs.Distances.Maximum =
      options.Contrast.MaximumDistance > 0.0 ? options.Contrast.MaximumDistance : pairs.Distances.Maximum;
    pairs.Correction = EdgeCorrection::Translation;
    pairs.WantsG = options.Function == VerdictFunction::PairCorrelation;
    pairs.WantsK = !pairs.WantsG;
    pairs.HalfWidth = 0.15 / std::sqrt(static_cast<double>(points.size()) / window.GetArea());
    pairs.Areas = std::make_shared<const CommonAreaTable>(window, pairs.Distances.Maximum + pairs.HalfWidth, parallel);
    return pairs;
  }

  /// g or L at all distances but 0; 0 of a pattern without a pair.
  std::vector<double> CurveOf(const std::vector<PlanePosition>& points, const ParallelFor& parallel) const
  {
    if (points.size() < 2)
    {
      return std::vector<double>(static_cast<std::size_t>(this->Pairs.Distances.Steps), 0.0);
    }
    const PairFunctions functions = FindPairFunctions(points, this->Window, this->Pairs, parallel);
    const std::vector<double> curve = this->Pairs.WantsG ? functions.PairCorrelation : BesagL(functions.K);
    return { curve.begin() + 1, curve.end() };
  }

  const ObservationWindow& Window;
  const VerdictOptions& Options;
  PairOptions Pairs;
  std::vector<double> Measured;
};

int ParametersOf(const JudgedLaw& law)
{
  const int trend = static_cast<int>(law.Process.Trend.Coefficients.size());
  return law.IsProcess ? TraitsOf(law.Process.Process.Process).Parameters.Size() + std::max(0, trend - 1)
                       : law.Law.Parameters;
}

/// The largest p first, then the fewest parameters; what does not exist last.
bool IsBetter(const JudgedLaw& a, const JudgedLaw& b)
{
  if (a.Exists() != b.Exists())
  {
    return a.Exists();
  }
  if (!a.Exists())
  {
    return false;
  }
  return a.Envelope.PValue != b.Envelope.PValue ? a.Envelope.PValue > b.Envelope.PValue
                                                : ParametersOf(a) < ParametersOf(b);
}

}

std::string WhyInvalid(const VerdictOptions& options)
{
  ParameterCheck check;
  check.Require(WhyInvalid(options.Contrast));
  check.Choice("Function", static_cast<int>(options.Function), { "g", "L" });
  check.Require(WhyNoEnvelope(options.Simulations, options.Level));
  check.Count("NumberOfSimulations", options.Simulations, 1, 100000);
  check.Count("Steps", options.Steps, 8, 4096);
  check.Require(
    options.Function != VerdictFunction::PairCorrelation || options.Contrast.Correction != EdgeCorrection::Border,
    "There is no g with the border correction; choose the isotropic or the translation correction.");
  for (int axis = 0; axis < 2; ++axis)
  {
    check.Count("Quadrats[" + std::to_string(axis) + "]", options.Quadrats[axis], 0, 1000);
  }
  return check.Reason();
}

const char* WordOf(PatternVerdict verdict)
{
  static constexpr const char* Words[] = { "best", "not distinguishable", "worse", "does not exist" };
  return Words[static_cast<int>(verdict)];
}

PatternVerdict VerdictOf(const QuadratFit& fit, const QuadratFit& best)
{
  return !fit.Exists                          ? PatternVerdict::DoesNotExist
    : &fit == &best                           ? PatternVerdict::Best
    : fit.AIC - best.AIC < DistinguishableAIC ? PatternVerdict::NotDistinguishable
                                              : PatternVerdict::Worse;
}

const char* JudgedLaw::Name() const
{
  return this->IsProcess ? PointProcessName(this->Process.Process.Process) : QuadratLawName(this->Law.Law.Law);
}

PatternJudgement JudgePattern(const std::vector<PlanePosition>& points, const ObservationWindow& window,
  const VerdictOptions& options, const Poll& poll, const ParallelFor& parallel, const WorkShare& share)
{
  const Judge judge(points, window, options, parallel);
  PatternJudgement judgement;
  judgement.Distances = judge.GetDistances();
  judgement.Measured = judge.GetMeasured();
  judgement.Grid = GridOf(window, points.size(), options.Quadrats);
  const IntensityTrend trend = TrendOf(points, window, options.Contrast);
  const IntensityRaster raster = trend.Exists() ? RasterOf(trend, window) : IntensityRaster();
  for (int id = 0; id < NumberOfPointProcesses; ++id)
  {
    JudgedLaw law;
    law.Process = FitProcess(static_cast<PointProcess>(id), points, window, options.Contrast, trend, parallel);
    PatternLaw drawn;
    drawn.Process = law.Process.Process;
    drawn.Trend = law.Process.Trend.Exists() ? raster : IntensityRaster();
    law.Process.Exists = law.Process.Exists && WhyInvalid(drawn, window).empty();
    if (law.Process.Exists)
    {
      law.Envelope = judge.Test(drawn, poll, parallel, share);
    }
    judgement.Laws.push_back(law);
  }
  if (window.IsRectangle())
  {
    for (const QuadratFit& fit : FitAllQuadratLaws(FrequenciesIn(judgement.Grid, points)))
    {
      JudgedLaw law;
      law.IsProcess = false;
      law.Law = fit;
      if (fit.Exists)
      {
        PatternLaw drawn;
        drawn.IsProcess = false;
        drawn.Counts = fit.Law;
        drawn.Grid = judgement.Grid;
        law.Envelope = judge.Test(drawn, poll, parallel, share);
      }
      judgement.Laws.push_back(law);
    }
  }
  std::stable_sort(judgement.Laws.begin(), judgement.Laws.end(), IsBetter);
  for (JudgedLaw& law : judgement.Laws)
  {
    law.Verdict = !law.Exists() ? PatternVerdict::DoesNotExist
      : law.Envelope.IsRejected ? PatternVerdict::Worse
                                : PatternVerdict::NotDistinguishable;
  }
  if (judgement.Laws.front().Verdict == PatternVerdict::NotDistinguishable)
  {
    judgement.Laws.front().Verdict = PatternVerdict::Best;
  }
  return judgement;
}

}
