// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The envelope test: ranks by hand, its size on random patterns, its power on others, and what cannot be tested.
#include "../OnThreads.h"
#include "Patterns/CurveEnvelope.h"
#include "Patterns/PairFunctions.h"
#include "SyntheticPatterns.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <thread>

using namespace littoral;
using namespace littoral::testing;

namespace
{

const double NaN = std::numeric_limits<double>::quiet_NaN();

using Curves = std::vector<std::vector<double>>;

// Ranks at the three distances, by hand: the lowest and the highest of four curves have rank 1, the others rank 2.
TEST(CurveEnvelope, OrdersCurvesByTheirRanks)
{
  const Curves simulated{ { 1.0, 2.0, 3.0 }, { 2.0, 3.0, 2.0 }, { 3.0, 4.0, 4.0 } };
  // (1, 1, 2), (2, 2, 1), (2, 1, 1) and (1, 2, 2) for the measured one: it comes with the second one.
  CurveEnvelope envelope = FindCurveEnvelope({ 4.0, 2.5, 3.5 }, simulated, 0.25);
  EXPECT_DOUBLE_EQ(envelope.PValue, 1.0);
  EXPECT_FALSE(envelope.IsRejected);
  // The highest everywhere: (1, 1, 1) before (1, 1, 2), (1, 2, 2) ...
  envelope = FindCurveEnvelope({ 5.0, 6.0, 7.0 }, simulated, 0.25);
  EXPECT_DOUBLE_EQ(envelope.PValue, 0.25);
  EXPECT_TRUE(envelope.IsRejected);
  EXPECT_EQ(envelope.Outside, (std::vector<std::size_t>{ 0, 1, 2 }));
  EXPECT_EQ(envelope.GlobalLow, (std::vector<double>{ 1.0, 2.0, 2.0 }));
  EXPECT_EQ(envelope.GlobalHigh, (std::vector<double>{ 3.0, 4.0, 4.0 }));
  EXPECT_EQ(envelope.Low, (std::vector<double>{ 1.0, 2.0, 2.0 }));
  EXPECT_EQ(envelope.High, (std::vector<double>{ 3.0, 4.0, 4.0 }));
  EXPECT_EQ(envelope.Mean, (std::vector<double>{ 2.0, 3.0, 3.0 }));
}

TEST(CurveEnvelope, TakesPointwiseBandsAtTheLevel)
{
  Curves simulated;
  for (int n = 1; n <= 99; ++n)
  {
    simulated.push_back({ static_cast<double>(n) });
  }
  const CurveEnvelope wide = FindCurveEnvelope({ 50.5 }, simulated, 0.02);
  EXPECT_EQ(wide.Low[0], 1.0);
  EXPECT_EQ(wide.High[0], 99.0);
  const CurveEnvelope narrow = FindCurveEnvelope({ 50.5 }, simulated, 0.2);
  EXPECT_EQ(narrow.Low[0], 10.0);
  EXPECT_EQ(narrow.High[0], 90.0);
  // 10 of 100 curves beyond each side of the global band: ranks 1 ... 10 from below and from above.
  EXPECT_EQ(narrow.GlobalLow[0], 11.0);
  EXPECT_EQ(narrow.GlobalHigh[0], 89.0);
}

TEST(CurveEnvelope, LeavesOutDistancesWithoutAValue)
{
  const Curves simulated{ { NaN, 1.0, 0.0 }, { NaN, 2.0, 0.0 }, { 0.0, 3.0, 0.0 } };
  const CurveEnvelope envelope = FindCurveEnvelope({ 9.0, 9.0, 0.0 }, simulated, 0.5);
  EXPECT_TRUE(std::isnan(envelope.Low[0]) && std::isnan(envelope.GlobalHigh[0]));
  EXPECT_EQ(envelope.Outside, (std::vector<std::size_t>{ 1 }));
  const CurveEnvelope none = FindCurveEnvelope({ NaN }, { { 1.0 }, { 2.0 } }, 0.5);
  EXPECT_EQ(none.PValue, 1.0);
  EXPECT_FALSE(none.IsRejected);
  // Where all are equal nothing is extreme.
  const CurveEnvelope flat = FindCurveEnvelope({ 1.0 }, Curves(99, { 1.0 }), 0.05);
  EXPECT_EQ(flat.PValue, 1.0);
  EXPECT_TRUE(flat.Outside.empty());
}

TEST(CurveEnvelope, RefusesTooFewSimulations)
{
  EXPECT_EQ(WhyNoEnvelope(19, 0.05), "");
  EXPECT_EQ(WhyNoEnvelope(99, 0.01), "");
  EXPECT_NE(WhyNoEnvelope(18, 0.05).find("it must be at least 19"), std::string::npos);
  EXPECT_NE(WhyNoEnvelope(98, 0.01).find("it must be at least 99"), std::string::npos);
  EXPECT_NE(WhyNoEnvelope(0, 0.05), "");
  for (const double level : { 0.0, 1.0, -0.1, NaN })
  {
    EXPECT_NE(WhyNoEnvelope(99, level).find("Level"), std::string::npos);
  }
}

/// The test of L by 99 random patterns.
CurveEnvelope TestRandomness(const std::vector<PlanePosition>& points, const ObservationWindow& window, int seed)
{
  PairOptions options;
  options.Distances = DefaultDistances(window, points.size(), 64);
  options.WantsG = false;
  const auto curve = [&](const std::vector<PlanePosition>& pattern, const ParallelFor&) {
    return BesagL(FindPairFunctions(pattern, window, options).K);
  };
  const auto law = [&](int number, const ParallelFor&) { return UniformPattern(window, points.size(), seed, number); };
  return FindCurveEnvelope(curve(points, SerialFor), SimulateCurves(law, curve, 99));
}

// The test's size is its level: 4 to 6 % of 500 random patterns are rejected, and just those leave the global band.
TEST(CurveEnvelope, RejectsARandomPatternAsOftenAsItsLevel)
{
  int rejected = 0;
  int outside = 0;
  for (int seed = 1; seed <= 500; ++seed)
  {
    const std::vector<PlanePosition> points = UniformPattern(ObservationWindow(), 30, seed, 99);
    const CurveEnvelope envelope = TestRandomness(points, ObservationWindow(), seed);
    rejected += envelope.IsRejected;
    outside += !envelope.Outside.empty();
    EXPECT_EQ(envelope.IsRejected, !envelope.Outside.empty());
  }
  EXPECT_GE(rejected, 20);
  EXPECT_LE(rejected, 30);
  EXPECT_EQ(rejected, outside);
}

TEST(CurveEnvelope, RejectsClustersAndLattices)
{
  for (const SyntheticPattern& pattern : SyntheticPatterns())
  {
    if (pattern.Name != "scattered")
    {
      const CurveEnvelope envelope = TestRandomness(pattern.Points, pattern.Window, 1);
      EXPECT_TRUE(envelope.IsRejected) << pattern.Name;
      EXPECT_DOUBLE_EQ(envelope.PValue, 0.01) << pattern.Name;
    }
  }
  std::vector<PlanePosition> lattice;
  for (int n = 0; n < 100; ++n)
  {
    lattice.push_back({ 0.05 + 0.1 * (n % 10), 0.05 + 0.1 * (n / 10) });
  }
  EXPECT_TRUE(TestRandomness(lattice, ObservationWindow(), 1).IsRejected);
}

TEST(CurveEnvelope, SimulatesOnAnyThreads)
{
  const auto law = [](int number, const ParallelFor&) { return UniformPattern(ObservationWindow(), 20, 4, number); };
  const auto curve = [](const std::vector<PlanePosition>& points, const ParallelFor&) {
    return std::vector<double>{ points.front()[0], points.back()[1] };
  };
  const Curves serial = SimulateCurves(law, curve, 40);
  EXPECT_EQ(serial, SimulateCurves(law, curve, 40, NoPoll, OnThreads(7)));
  EXPECT_EQ(std::set<std::vector<double>>(serial.begin(), serial.end()).size(), 40u);
}

// Slow curves are made one by one, each with the loop, which can end them; the others side by side.
TEST(CurveEnvelope, HandsTheLoopToSlowCurves)
{
  for (const int milliseconds : { 0, 40 })
  {
    int withLoop = 0;
    int polls = 0;
    const ParallelFor loop = [](std::size_t count, const RangeTask& task) { task(0, count); };
    const auto curve = [&](int number, const ParallelFor& inner) {
      withLoop += inner.target_type() == loop.target_type();
      std::this_thread::sleep_for(std::chrono::milliseconds(number == 0 ? milliseconds : 0));
      return std::vector<double>{ static_cast<double>(number) };
    };
    const Curves curves = SimulateCurves(
      curve, 10, [&] { ++polls; }, loop);
    EXPECT_EQ(withLoop, milliseconds > 0 ? 10 : 1);
    EXPECT_EQ(polls, PollsOfCurves);
    EXPECT_EQ(curves[9], std::vector<double>{ 9.0 });
  }
}

TEST(RandomOrder, IsEachOneEquallyOften)
{
  std::map<std::vector<std::size_t>, int> orders;
  std::set<int> seeds;
  for (int number = 0; number < 6000; ++number)
  {
    ++orders[RandomOrder(3, 5, number)];
    seeds.insert(SeedOfSimulation(5, number));
  }
  ASSERT_EQ(orders.size(), 6u);
  for (const auto& [order, count] : orders)
  {
    EXPECT_NEAR(count, 1000, 116); // four standard deviations
  }
  EXPECT_GE(seeds.size(), 5999u);
  EXPECT_GE(*seeds.begin(), 0);
  EXPECT_NE(SeedOfSimulation(5, 1), SeedOfSimulation(6, 0));
}

TEST(UniformPattern, FillsAPolygonEvenly)
{
  const ObservationWindow window = SyntheticPatterns().back().Window;
  const std::vector<PlanePosition> points = UniformPattern(window, 20000, 7, 3);
  ASSERT_EQ(points.size(), 20000u);
  EXPECT_EQ(WhyInvalid(points, window), "");
  EXPECT_NE(points, UniformPattern(window, 20000, 8, 3));
  // As many in a disk of 15 m as its part of the area.
  double inside = 0.0;
  for (const PlanePosition& point : points)
  {
    inside += std::hypot(point[0] - 50.0, point[1] - 30.0) < 15.0;
  }
  const double part = 3.14159265358979 * 225.0 / window.GetArea();
  EXPECT_NEAR(inside, 20000.0 * part, 4.0 * std::sqrt(20000.0 * part * (1.0 - part)));
}

}
