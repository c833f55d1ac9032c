// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternStatistics.h"

#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"
#include "Patterns/WindowSections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

namespace littoral
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
/// Cells along each side of the window from which the empty space is measured.
constexpr int EmptyPlaces = 128;

constexpr std::size_t IndexOf(PatternFunction function)
{
  return static_cast<std::size_t>(function);
}

bool IsOfPairs(PatternFunction function)
{
  return function <= PatternFunction::PairCorrelation || function >= PatternFunction::MarkCorrelation;
}

}

const char* NameOf(PatternFunction function)
{
  static constexpr const char* Names[] = { "K", "L", "PairCorrelation", "NearestNeighbor", "EmptySpace", "J",
    "MarkCorrelation", "CrossK", "CrossPairCorrelation" };
  return Names[IndexOf(function)];
}

double RandomValue(PatternFunction function, double r, double intensity)
{
  switch (function)
  {
    case PatternFunction::K:
    case PatternFunction::CrossK:
      return Pi * r * r;
    case PatternFunction::L:
      return r;
    case PatternFunction::NearestNeighbor:
    case PatternFunction::EmptySpace:
      return 1.0 - std::exp(-intensity * Pi * r * r);
    default:
      return 1.0;
  }
}

const char* KindBeside(PatternFunction function, bool isAbove)
{
  const bool isRegularAbove = function == PatternFunction::EmptySpace || function == PatternFunction::J;
  return isAbove == isRegularAbove ? "regular" : "clustered";
}

bool IsCross(PatternFunction function)
{
  return function == PatternFunction::CrossK || function == PatternFunction::CrossPairCorrelation;
}

void ChoosePair(MappedPattern& pattern)
{
  std::map<std::string, int> counts;
  for (const std::string& species : pattern.Species)
  {
    ++counts[species];
  }
  for (int own = 0; own < 2; ++own)
  {
    std::string most;
    for (const auto& [species, count] : counts)
    {
      most = species != pattern.Pair[1 - own] && (most.empty() || count > counts[most]) ? species : most;
    }
    pattern.Pair[own] = pattern.Pair[own].empty() ? most : pattern.Pair[own];
  }
  for (const std::string& species : pattern.Pair)
  {
    Require(counts.find(species) == counts.end() ? "no point is of the species '" + species + "'." : "");
  }
  Require(pattern.Pair[0] == pattern.Pair[1] ? "cross functions need two different species." : "");
}

std::string WhyInvalid(const StatisticsOptions& options)
{
  ParameterCheck check;
  check.Choice("Function", static_cast<int>(options.Function), NumberOfPatternFunctions);
  check.Choice(
    "EdgeCorrection", static_cast<int>(options.Correction), { "none", "border", "isotropic", "translation" });
  check.Choice(
    "DistanceCorrection", static_cast<int>(options.Nearest), { "uncorrected", "reduced sample", "Kaplan-Meier" });
  check.NotNegative("MaximumDistance", options.MaximumDistance, "m");
  check.Count("NumberOfSteps", options.Steps, 8, 10000);
  check.NotNegative("Bandwidth", options.HalfWidth, "m");
  check.Count("NumberOfSimulations", options.Simulations, 0, 100000);
  check.Within("Level", options.Level, ValueInterval::Between(0.0, 1.0));
  if (options.Simulations > 0 && check.IsGood())
  {
    check.Require(WhyNoEnvelope(options.Simulations, options.Level));
  }
  return check.Reason();
}

PatternStatistics::PatternStatistics(
  const MappedPattern& pattern, const StatisticsOptions& options, const ParallelFor& parallel)
  : Pattern(pattern)
  , Options(options)
{
  const std::size_t points = pattern.Points.size();
  DistanceRange& distances = this->Pairs.Distances;
  distances = IsOfPairs(options.Function) ? DefaultDistances(pattern.Window, points, options.Steps)
                                          : DefaultNearestDistances(pattern.Window, points, options.Steps);
  distances.Maximum = options.MaximumDistance > 0.0 ? options.MaximumDistance : distances.Maximum;
  this->Pairs.Correction = options.Correction;
  this->Pairs.HalfWidth = options.HalfWidth;
  if (this->OtherPairs().Correction == EdgeCorrection::Translation)
  {
    const double h = 0.15 * std::sqrt(pattern.Window.GetArea() / static_cast<double>(points));
    const double reach = distances.Maximum + 4.0 * std::max(h, options.HalfWidth);
    this->Pairs.Areas = std::make_shared<const CommonAreaTable>(pattern.Window, reach, parallel);
  }
}

std::vector<double> PatternStatistics::GetDistances() const
{
  std::vector<double> r(this->Pairs.Distances.Count());
  for (std::size_t k = 0; k < r.size(); ++k)
  {
    r[k] = this->Pairs.Distances[static_cast<int>(k)];
  }
  return r;
}

/// Options of functions of pairs but K: Border is for K alone, they take the translation correction then.
PairOptions PatternStatistics::OtherPairs() const
{
  PairOptions options = this->Pairs;
  options.Correction = options.Correction == EdgeCorrection::Border ? EdgeCorrection::Translation : options.Correction;
  return options;
}

/// K and other functions of pairs by `find`, at once where they have the same correction.
template <typename FindOfOptions>
PairFunctions PatternStatistics::FindPairs(
  bool wantsK, bool wantsG, bool wantsMarks, const WorkShare& share, const FindOfOptions& find) const
{
  PairOptions others = this->OtherPairs();
  others.Share = share;
  const bool isOne = others.Correction == this->Pairs.Correction;
  others.WantsK = wantsK && isOne;
  others.WantsG = wantsG;
  const bool wantsOthers = others.WantsK || wantsG || wantsMarks;
  PairFunctions pairs = wantsOthers ? find(others) : PairFunctions();
  if (wantsK && !isOne)
  {
    PairOptions own = this->Pairs;
    own.Share = share;
    pairs.K = find(own).K;
  }
  return pairs;
}

/// One of the functions of points, or all of them, each pair and each nearest point being looked for once.
FunctionCurves PatternStatistics::Find(std::optional<PatternFunction> function, const Positions& points,
  const std::vector<double>& marks, const ParallelFor& parallel, const WorkShare& share) const
{
  using Function = PatternFunction;
  const auto wants = [&](Function one) { return function.value_or(one) == one; };
  const PairFunctions pairs = this->FindPairs(wants(Function::K) || wants(Function::L),
    wants(Function::PairCorrelation), wants(Function::MarkCorrelation), share, [&](const PairOptions& options) {
      return FindPairFunctions(points, marks, this->Pattern.Window, options, parallel);
    });
  FunctionCurves found;
  found[IndexOf(Function::K)] = pairs.K;
  found[IndexOf(Function::L)] = BesagL(pairs.K);
  found[IndexOf(Function::PairCorrelation)] = pairs.PairCorrelation;
  found[IndexOf(Function::MarkCorrelation)] = pairs.MarkCorrelation;
  if (wants(Function::NearestNeighbor) || wants(Function::EmptySpace) || wants(Function::J))
  {
    const DistanceFunctions nearest = FindDistanceFunctions(
      points, this->Pattern.Window, this->Pairs.Distances, this->Options.Nearest, EmptyPlaces, parallel);
    found[IndexOf(Function::NearestNeighbor)] = nearest.G;
    found[IndexOf(Function::EmptySpace)] = nearest.F;
    found[IndexOf(Function::J)] = nearest.J;
  }
  return found;
}

/// One of the functions of two species, or both.
FunctionCurves PatternStatistics::FindCross(std::optional<PatternFunction> function,
  const std::array<Positions, 2>& species, const ParallelFor& parallel, const WorkShare& share) const
{
  const PairFunctions pairs = this->FindPairs(function != PatternFunction::CrossPairCorrelation,
    function != PatternFunction::CrossK, false, share, [&](const PairOptions& options) {
      return FindCrossFunctions(species[0], species[1], this->Pattern.Window, options, parallel);
    });
  FunctionCurves found;
  found[IndexOf(PatternFunction::CrossK)] = pairs.K;
  found[IndexOf(PatternFunction::CrossPairCorrelation)] = pairs.PairCorrelation;
  return found;
}

/// The points of the first and the second species when place n has the species of place order[n].
std::array<std::vector<PlanePosition>, 2> PatternStatistics::Split(const std::vector<std::size_t>& order) const
{
  std::array<Positions, 2> both;
  const std::array<std::string, 2>& pair = this->Pattern.Pair;
  for (std::size_t n = 0; n < this->Pattern.Points.size(); ++n)
  {
    const std::string& species = this->Pattern.Species[order.empty() ? n : order[n]];
    if (species == pair[0] || species == pair[1])
    {
      both[species == pair[0] ? 0 : 1].push_back(this->Pattern.Points[n]);
    }
  }
  return both;
}

FunctionCurves PatternStatistics::Measure(const ParallelFor& parallel, const WorkShare& share) const
{
  FunctionCurves functions = this->Find(std::nullopt, this->Pattern.Points, this->Pattern.Marks, parallel, share);
  if (!this->Pattern.Species.empty())
  {
    FunctionCurves crossed = this->FindCross(std::nullopt, this->Split({}), parallel, share);
    for (const PatternFunction function : { PatternFunction::CrossK, PatternFunction::CrossPairCorrelation })
    {
      functions[IndexOf(function)] = crossed[IndexOf(function)];
    }
  }
  return functions;
}

/// The chosen function of a simulation.
std::vector<double> PatternStatistics::Simulate(const PatternLaw* law, int number, const ParallelFor& parallel) const
{
  const PatternFunction function = this->Options.Function;
  const int seed = this->Options.Seed;
  const std::size_t points = this->Pattern.Points.size();
  if (IsCross(function))
  {
    return this->FindCross(function, this->Split(RandomOrder(points, seed, number)), parallel)[IndexOf(function)];
  }
  if (function == PatternFunction::MarkCorrelation)
  {
    std::vector<double> marks;
    for (const std::size_t n : RandomOrder(points, seed, number))
    {
      marks.push_back(this->Pattern.Marks[n]);
    }
    return this->Find(function, this->Pattern.Points, marks, parallel)[IndexOf(function)];
  }
  const Positions simulated = law ? DrawPattern(*law, this->Pattern.Window, SeedOfSimulation(seed, number), parallel)
                                  : UniformPattern(this->Pattern.Window, points, seed, number);
  return simulated.size() < 2 ? std::vector<double>(this->Pairs.Distances.Count(), NaN)
                              : this->Find(function, simulated, {}, parallel)[IndexOf(function)];
}

CurveEnvelope PatternStatistics::Compare(const std::vector<double>& measured, const PatternLaw* law, const Poll& poll,
  const ParallelFor& parallel, const WorkShare& share) const
{
  const CurveOfNumber simulate = [&](
                                   int number, const ParallelFor& inner) { return this->Simulate(law, number, inner); };
  const NumberRows curves = SimulateCurves(simulate, this->Options.Simulations, poll, parallel, share);
  return share.IsFirst() ? FindCurveEnvelope(measured, curves, this->Options.Level) : CurveEnvelope();
}

}
