// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Parallel.h"
#include "Numerics/TimeMarching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

using namespace littoral;

namespace
{

/// A state that tells all steps that made it, in their order: a hash by multiplication and addition.
using Trace = std::uint64_t;

Trace Stepped(Trace trace, long long step)
{
  return 6364136223846793005ull * trace + 2ull * static_cast<Trace>(step) + 1ull;
}

/// The trace at a step, from the start, without any checkpoint.
Trace MarchedFromStart(long long step)
{
  Trace trace = 17;
  for (long long now = 0; now < step; ++now)
  {
    trace = Stepped(trace, now);
  }
  return trace;
}

/// Marches to a goal; returns the number of steps.
long long March(TimeMarching<Trace>& marching, double time)
{
  marching.SetGoal(time);
  long long steps = 0;
  while (!marching.IsAtGoal())
  {
    marching.State() = Stepped(marching.State(), marching.GetStep());
    marching.Reach(marching.GetStep() + 1);
    ++steps;
  }
  return steps;
}

}

TEST(Checkpoints, HoldTheMaximalNumberAndAllMultiplesOfTheStride)
{
  for (const std::size_t maximum : { 1, 2, 3, 8, 16 })
  {
    Checkpoints<long long> kept(maximum);
    EXPECT_EQ(kept.Latest(1000), nullptr);
    for (long long step = 1; step <= 500; ++step)
    {
      kept.Keep(step, 3 * step);
      ASSERT_LE(kept.GetNumberOfStates(), maximum);
      // The smallest power of two of which there are no more multiples than the maximum.
      long long stride = 1;
      while (step / stride > static_cast<long long>(maximum))
      {
        stride *= 2;
      }
      ASSERT_EQ(kept.GetStride(), stride);
      ASSERT_EQ(kept.GetNumberOfStates(), static_cast<std::size_t>(step / stride));
      for (const long long goal : { 0ll, step / 3, step - 1, step, step + 7 })
      {
        const long long expected = std::min(goal, step) / stride * stride;
        const auto* latest = kept.Latest(goal);
        ASSERT_EQ(latest != nullptr, expected > 0);
        if (latest)
        {
          EXPECT_EQ(latest->first, expected);
          EXPECT_EQ(latest->second, 3 * expected);
        }
      }
    }
    kept.Clear();
    EXPECT_EQ(kept.GetNumberOfStates(), 0u);
    EXPECT_EQ(kept.GetStride(), 1);
  }
}

TEST(Checkpoints, TakeAgainWhatTheyHold)
{
  Checkpoints<int> kept(4);
  kept.Keep(2, 20);
  kept.Keep(1, 10);
  kept.Keep(2, 20);
  EXPECT_EQ(kept.GetNumberOfStates(), 2u);
  EXPECT_EQ(kept.Latest(1)->second, 10);
}

TEST(TimeGrid, SplitsATimeIntoWholeStepsAndARemainder)
{
  const TimeGrid grid{ -5.0, 0.25 }; // exact in binary
  const StepGoal goal = grid.GoalAt(1.1);
  EXPECT_EQ(goal.Step, 24);
  EXPECT_DOUBLE_EQ(goal.Remainder, 1.1 - 1.0);
  EXPECT_EQ(goal.Time, 1.1);
  EXPECT_EQ(grid.GoalAt(1.0).Step, 24);
  EXPECT_EQ(grid.GoalAt(1.0).Remainder, 0.0);
  EXPECT_EQ(grid.TimeOf(24), 1.0);
}

TEST(TimeGrid, TakesTimesThatPlayersSumUpForThoseOfItsSteps)
{
  for (const double step : { 0.1, 1.0 / 24.0, 1.0 / 48.0, 1.0 / 3.0, 0.7 })
  {
    const TimeGrid grid{ 0.0, step };
    double summed = 0.0;
    for (long long n = 0; n <= 5000; ++n)
    {
      const double time = static_cast<double>(n) * step;
      for (const double near : { time, summed, std::nextafter(time, -1.0), std::nextafter(time, 1e9) })
      {
        const StepGoal goal = grid.GoalAt(near);
        ASSERT_EQ(goal.Step, n) << near << " by " << step;
        ASSERT_EQ(goal.Remainder, 0.0) << near << " by " << step;
      }
      summed += step;
    }
  }
}

TEST(TimeGrid, KeepsTimesApartThatAreNotOnIt)
{
  const TimeGrid grid{ 0.0, 0.1 };
  EXPECT_EQ(grid.GoalAt(10.0 - 1e-9).Step, 99);
  EXPECT_NEAR(grid.GoalAt(10.0 - 1e-9).Remainder, 0.1, 2e-9);
  EXPECT_EQ(grid.GoalAt(10.0 + 1e-9).Step, 100);
  EXPECT_NEAR(grid.GoalAt(10.0 + 1e-9).Remainder, 1e-9, 1e-14);
  for (int n = 0; n < 2000; ++n)
  {
    const double time = 0.0137 * n;
    const StepGoal goal = grid.GoalAt(time);
    ASSERT_NEAR(grid.TimeOf(goal.Step) + goal.Remainder, time, 1e-12 * (1.0 + time));
    ASSERT_GE(goal.Remainder, 0.0);
    ASSERT_LT(goal.Remainder, grid.Step);
  }
}

TEST(TimeGrid, BeginsAtItsStart)
{
  const TimeGrid grid{ 3.0, 0.1 };
  for (const double time : { 3.0, 2.9999, 0.0, -1e9, -std::numeric_limits<double>::max() })
  {
    const StepGoal goal = grid.GoalAt(time);
    EXPECT_EQ(goal.Step, 0);
    EXPECT_EQ(goal.Remainder, 0.0);
    EXPECT_EQ(goal.Time, time);
  }
}

TEST(TimeGrid, SaysWhichTimeIsTooFar)
{
  const TimeGrid grid{ 1.0, 0.5 };
  EXPECT_EQ(WhyTooFar(grid, 1.0 + 0.5e7), "");
  EXPECT_NE(WhyTooFar(grid, 1.5 + 0.5e7).find("10 million"), std::string::npos);
  EXPECT_EQ(WhyTooFar(grid, -1e300), "");
  // Such goals are numbers all the same.
  EXPECT_EQ(grid.GoalAt(1e300).Step, 20000000);
  EXPECT_TRUE(std::isfinite(grid.GoalAt(1e300).Remainder));
}

TEST(TimeGrid, SharesAreLengthsInSteps)
{
  for (const double step : { 0.1, 1.0 / 48.0, 3.0 })
  {
    const TimeGrid grid{ 0.0, step };
    EXPECT_EQ(grid.ShareOf(step), 1.0);
    EXPECT_EQ(grid.ShareOf(0.0), 0.0);
    EXPECT_DOUBLE_EQ(grid.ShareOf(0.3 * step), 0.3);
  }
}

TEST(TimeMarching, StatesAreThoseFromTheStartWhateverTheOrderOfGoals)
{
  std::mt19937 random(5);
  for (const std::size_t maximum : { 1, 3, 8 })
  {
    TimeMarching<Trace> marching({ -2.0, 0.125 }, maximum);
    marching.Begin(17);
    for (int n = 0; n < 400; ++n)
    {
      const double time = -3.0 + 0.01 * static_cast<double>(random() % 5000);
      March(marching, time);
      const auto expected = static_cast<long long>(std::floor(std::max(0.0, time + 2.0) / 0.125 + 1e-9));
      ASSERT_EQ(marching.GetStep(), expected);
      ASSERT_EQ(marching.State(), MarchedFromStart(expected));
      ASSERT_EQ(marching.GetStart(), 17u);
    }
  }
}

TEST(TimeMarching, TakesNoMoreStepsBackThanFromTheCheckpointBefore)
{
  TimeMarching<Trace> marching({ 0.0, 1.0 }, 8);
  marching.Begin(17);
  EXPECT_EQ(March(marching, 100.0), 100); // by then the stride is 16
  EXPECT_EQ(March(marching, 100.5), 0);
  EXPECT_DOUBLE_EQ(marching.NextLength(), 0.5);
  EXPECT_EQ(March(marching, 101.0), 1);
  EXPECT_EQ(March(marching, 99.0), 3);
  EXPECT_EQ(March(marching, 95.0), 15);
  EXPECT_EQ(March(marching, 101.0), 5); // from 96, not from 95
  EXPECT_EQ(March(marching, 15.0), 15);
  EXPECT_EQ(March(marching, -1.0), 0);
  EXPECT_EQ(marching.State(), 17u);
}

TEST(TimeMarching, StopsAtEachCheckpoint)
{
  TimeMarching<Trace> marching({ 0.0, 1.0 }, 4);
  marching.Begin(17);
  marching.SetGoal(61.0);
  std::set<long long> stops;
  while (!marching.IsAtGoal())
  {
    EXPECT_EQ(marching.NextLength(), 1.0);
    const long long last = marching.NextStop();
    while (marching.GetStep() < last - 1) // steps between are no checkpoints
    {
      marching.State() = Stepped(marching.State(), marching.GetStep());
      marching.Reach(marching.GetStep() + 1);
    }
    marching.State() = Stepped(marching.State(), marching.GetStep());
    marching.Reach(last);
    stops.insert(last);
  }
  EXPECT_EQ(stops, (std::set<long long>{ 1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 40, 48, 61 }));
}

TEST(TimeMarching, KeepsItsGoalWhenItBeginsAnew)
{
  TimeMarching<Trace> marching({ 0.0, 1.0 }, 4);
  EXPECT_FALSE(marching.SetGoal(7.5));
  EXPECT_FALSE(marching.IsBegun());
  marching.Begin(17);
  EXPECT_EQ(marching.GetGoal().Step, 7);
  EXPECT_EQ(March(marching, 7.5), 7);
  marching.Begin(18); // other checkpoints are of no use
  EXPECT_EQ(marching.GetStep(), 0);
  EXPECT_EQ(March(marching, 7.5), 7);
  EXPECT_NE(marching.State(), MarchedFromStart(7));
}

TEST(ForRanges, CoversEachElementOnce)
{
  for (const std::size_t count : { 0, 1, 5, 8, 9, 16, 17 })
  {
    for (const std::size_t length : { 0, 1, 4, 8, 100 })
    {
      std::vector<int> times(count, 0);
      std::size_t cuts = 0;
      const ParallelFor oneByOne = [&](std::size_t pieces, const RangeTask& task) {
        for (std::size_t piece = pieces; piece-- > 0; ++cuts)
        {
          task(piece, piece + 1);
        }
      };
      ForRanges(oneByOne, count, length, [&](std::size_t begin, std::size_t end) {
        ASSERT_LE(end - begin, std::max<std::size_t>(1, length));
        for (std::size_t n = begin; n < end; ++n)
        {
          ++times[n];
        }
      });
      EXPECT_EQ(times, std::vector<int>(count, 1));
      EXPECT_EQ(cuts == 0, count <= std::max<std::size_t>(1, length));
    }
  }
}

TEST(ForPolled, CoversEachElementInOrderAndEndsByAPoll)
{
  for (const std::size_t count : { 0, 1, 1 << 16, 150000 })
  {
    std::size_t done = 0;
    std::size_t polls = 0;
    std::size_t ranges = 0;
    ForPolled(
      count, [&] { ++polls; },
      [&](std::size_t begin, std::size_t end) {
        ++ranges;
        ASSERT_EQ(polls, ranges);
        ASSERT_EQ(begin, done);
        ASSERT_LE(end, count);
        done = end;
      });
    EXPECT_EQ(done, count);
    EXPECT_GE(ranges, count / 100000);
  }
  std::size_t ranges = 0;
  const Poll second = [&] {
    if (ranges == 1)
    {
      throw std::runtime_error("aborted");
    }
  };
  EXPECT_THROW(ForPolled(1 << 20, second, [&](std::size_t, std::size_t) { ++ranges; }), std::runtime_error);
  EXPECT_EQ(ranges, 1u);
}

TEST(SteppedPoll, CallsAtEachOfSoManySteps)
{
  int polls = 0;
  const Poll poll = [&] { ++polls; };
  SteppedPoll steps(poll, 7);
  for (int step = 1; step <= 50; ++step)
  {
    steps.Step();
    ASSERT_EQ(polls, step / 7);
  }
}
