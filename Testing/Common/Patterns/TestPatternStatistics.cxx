// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"
#include "Patterns/PatternStatistics.h"
#include "QuadratPosition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace littoral;
using littoral::testing::OnThreads;
using littoral::testing::QuadratPosition;

namespace
{

using Function = PatternFunction;

const ObservationWindow Window = ObservationWindow::Rectangle({ 0.0, 0.0 }, { 20.0, 10.0 });

/// A lattice of places a metre apart, in the middle of their square metres; species by turns, marks by columns.
MappedPattern Lattice()
{
  MappedPattern pattern;
  pattern.Window = Window;
  for (int n = 0; n < 200; ++n)
  {
    pattern.Points.push_back({ n % 20 + 0.5, n / 20 + 0.5 });
    pattern.Marks.push_back(n % 2 ? 3.0 : 1.0);
    pattern.Species.push_back((n % 20 + n / 20) % 2 ? "oak" : "birch");
  }
  pattern.Pair = { "birch", "oak" };
  return pattern;
}

MappedPattern Random(std::size_t points)
{
  MappedPattern pattern;
  pattern.Window = Window;
  pattern.Points = UniformPattern(Window, points, 17, 0);
  return pattern;
}

StatisticsOptions Options(Function function, int simulations = 39)
{
  StatisticsOptions options;
  options.Function = function;
  options.Steps = 64;
  options.Simulations = simulations;
  return options;
}

const std::vector<double>& CurveOf(const FunctionCurves& curves, Function function)
{
  return curves[static_cast<std::size_t>(function)];
}

}

TEST(PatternStatistics, FunctionsAreThoseOfTheirRooms)
{
  const MappedPattern pattern = Lattice();
  StatisticsOptions options = Options(Function::K);
  options.MaximumDistance = 2.5;
  const PatternStatistics statistics(pattern, options);
  const FunctionCurves curves = statistics.Measure();
  PairOptions pairs;
  pairs.Distances = { 2.5, 64 };
  const PairFunctions wanted = FindPairFunctions(pattern.Points, pattern.Marks, Window, pairs);
  EXPECT_EQ(CurveOf(curves, Function::K), wanted.K);
  EXPECT_EQ(CurveOf(curves, Function::L), BesagL(wanted.K));
  const std::vector<double>& marks = CurveOf(curves, Function::MarkCorrelation);
  EXPECT_TRUE(std::equal(marks.begin() + 20, marks.end(), wanted.MarkCorrelation.begin() + 20)); // no pair below
  const DistanceFunctions nearest =
    FindDistanceFunctions(pattern.Points, Window, pairs.Distances, DistanceCorrection::KaplanMeier);
  EXPECT_EQ(CurveOf(curves, Function::NearestNeighbor), nearest.G);
  EXPECT_EQ(CurveOf(curves, Function::EmptySpace), nearest.F);
  EXPECT_EQ(statistics.GetDistances().size(), 65u);
  EXPECT_EQ(statistics.GetDistances().back(), 2.5);
  // The nearest neighbour of a place of a lattice is a metre away.
  const std::vector<double>& g = CurveOf(curves, Function::NearestNeighbor);
  EXPECT_EQ(g[25], 0.0); // 0.98 m
  EXPECT_EQ(g[26], 1.0); // 1.02 m
  // Those of the other species too, four of them: K = 4 |W| / n2 between 1 m and sqrt(5) m, but for the edge.
  EXPECT_NEAR(CurveOf(curves, Function::CrossK)[40], 4.0 * 200.0 / 100.0, 0.8);
}

// K alone has a border correction; the others take the translation correction then.
TEST(PatternStatistics, BorderIsForK)
{
  const MappedPattern pattern = Random(60);
  StatisticsOptions options = Options(Function::K);
  options.Correction = EdgeCorrection::Border;
  const FunctionCurves border = PatternStatistics(pattern, options).Measure();
  options.Correction = EdgeCorrection::Translation;
  const FunctionCurves translation = PatternStatistics(pattern, options).Measure();
  EXPECT_NE(CurveOf(border, Function::K), CurveOf(translation, Function::K));
  EXPECT_EQ(CurveOf(border, Function::PairCorrelation).size(), 65u);
  const std::vector<double>& g = CurveOf(border, Function::PairCorrelation);
  EXPECT_TRUE(std::equal(g.begin() + 1, g.end(), CurveOf(translation, Function::PairCorrelation).begin() + 1));
}

TEST(PatternStatistics, RandomValues)
{
  EXPECT_NEAR(RandomValue(Function::K, 3.0, 7.0), Pi * 9.0, 1e-12);
  EXPECT_EQ(RandomValue(Function::L, 3.0, 7.0), 3.0);
  EXPECT_NEAR(RandomValue(Function::EmptySpace, 0.2, 7.0), 1.0 - std::exp(-7.0 * Pi * 0.04), 1e-12);
  EXPECT_EQ(RandomValue(Function::J, 0.2, 7.0), 1.0);
  EXPECT_STREQ(KindBeside(Function::L, true), "clustered");
  EXPECT_STREQ(KindBeside(Function::J, true), "regular");
  EXPECT_STREQ(NameOf(Function::CrossPairCorrelation), "CrossPairCorrelation");
}

// A lattice is no random pattern, and its species stand by turns; a random pattern is one.
TEST(PatternStatistics, Comparisons)
{
  const MappedPattern lattice = Lattice();
  for (const Function function : { Function::L, Function::J, Function::MarkCorrelation, Function::CrossK })
  {
    const PatternStatistics statistics(lattice, Options(function));
    const CurveEnvelope envelope = statistics.Compare(CurveOf(statistics.Measure(), function), nullptr);
    EXPECT_TRUE(envelope.IsRejected) << NameOf(function) << " p " << envelope.PValue;
  }
  const MappedPattern random = Random(80);
  const PatternStatistics statistics(random, Options(Function::L));
  const std::vector<double> measured = CurveOf(statistics.Measure(), Function::L);
  const CurveEnvelope envelope = statistics.Compare(measured, nullptr);
  EXPECT_FALSE(envelope.IsRejected);
  EXPECT_EQ(statistics.Compare(measured, nullptr, NoPoll, OnThreads(3)).GlobalHigh, envelope.GlobalHigh);
}

// The law that a pattern was drawn from is not rejected, one of other counts is.
TEST(PatternStatistics, ComparedWithALaw)
{
  PatternLaw clustered;
  clustered.Process.Process = PointProcess::Thomas;
  clustered.Process.Intensity = 1.0;
  clustered.Process.ClusterSize = 8.0;
  clustered.Process.ClusterScale = 0.3;
  MappedPattern pattern;
  pattern.Window = Window;
  pattern.Points = DrawPattern(clustered, Window, 5);
  const PatternStatistics statistics(pattern, Options(Function::L));
  const std::vector<double> measured = CurveOf(statistics.Measure(), Function::L);
  EXPECT_FALSE(statistics.Compare(measured, &clustered).IsRejected);
  EXPECT_TRUE(statistics.Compare(measured, nullptr).IsRejected);
}

// A law of counts in quadrats that reach beyond the window: what is outside is left out, what is inside is where
// QuadratPosition has it. A trend keeps points where it is.
TEST(PatternLaw, DrawsInTheWindow)
{
  PatternLaw law;
  law.IsProcess = false;
  law.Counts.Law = QuadratLaw::Poisson;
  law.Counts.Mean = 3.0;
  law.Grid = { { -10.0, -5.0 }, { 40.0, 20.0 }, { 8, 4 } };
  ASSERT_EQ(WhyInvalid(law, Window), "");
  EXPECT_EQ(ExpectedDraws(law, Window), 32.0 * 4.0);
  std::vector<PlanePosition> wanted;
  const std::vector<int> counts = QuadratCounts(law.Counts, 32, QuadratMode::Sampling, 6);
  for (std::size_t quadrat = 0; quadrat < counts.size(); ++quadrat)
  {
    for (int n = 0; n < counts[quadrat]; ++n)
    {
      const PlanePosition point = QuadratPosition(law.Grid, static_cast<long long>(quadrat), n, 6);
      if (Window.Contains(point))
      {
        wanted.push_back(point);
      }
    }
  }
  EXPECT_EQ(DrawPattern(law, Window, 6), wanted);
  EXPECT_GT(wanted.size(), 10u);

  PatternLaw process;
  process.Process.Process = PointProcess::Poisson;
  process.Process.Intensity = 2.0;
  process.Trend = { { 2.5, 5.0 }, { 5.0, 10.0 }, { 4, 1 }, { 0.0, 1.0, 1.0, 0.0 } };
  ASSERT_EQ(WhyInvalid(process, Window), "");
  const std::vector<PlanePosition> points = DrawPattern(process, Window, 3);
  EXPECT_GT(points.size(), 200u);
  EXPECT_TRUE(std::all_of(
    points.begin(), points.end(), [](const PlanePosition& point) { return point[0] >= 5.0 && point[0] <= 15.0; }));
  process.Process.Intensity = -1.0;
  EXPECT_NE(WhyInvalid(process, Window), "");
}

TEST(PatternStatistics, ChoosesThePair)
{
  MappedPattern pattern;
  pattern.Species = { "oak", "elm", "oak", "ash", "elm", "fir" };
  ChoosePair(pattern);
  EXPECT_EQ(pattern.Pair[0], "elm"); // as frequent as oak, before it by the alphabet
  EXPECT_EQ(pattern.Pair[1], "oak");
  pattern.Pair = { "", "elm" };
  ChoosePair(pattern);
  EXPECT_EQ(pattern.Pair[0], "oak");
  const auto why = [&] { return WhyRefused([&] { ChoosePair(pattern); }); };
  pattern.Pair = { "yew", "" };
  EXPECT_EQ(why(), "no point is of the species 'yew'.");
  pattern.Pair = { "oak", "oak" };
  EXPECT_EQ(why(), "cross functions need two different species.");
}

TEST(PatternStatistics, OneMessageEach)
{
  StatisticsOptions options = Options(Function::L);
  EXPECT_EQ(WhyInvalid(options), "");
  options.Steps = 7;
  EXPECT_NE(WhyInvalid(options).find("NumberOfSteps"), std::string::npos);
  options = Options(Function::L, 10);
  EXPECT_NE(WhyInvalid(options).find("NumberOfSimulations"), std::string::npos);
  options = Options(static_cast<Function>(9));
  EXPECT_NE(WhyInvalid(options).find("Function"), std::string::npos);
}
