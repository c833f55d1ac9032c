// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/CurrentSet.h"
#include "Currents/WalledVelocity.h"
#include "Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>
#include <vector>

using namespace littoral;

namespace
{

/// An ocean's current of a closed form: it grows and turns with the height and the time.
Vector3 ClosedForm(const Vector3& position, double time)
{
  return Vector3(1.0 + 0.5 * time, 0.1 * position.x * time, -0.2 * position.z);
}

/// A grid that knows the closed form of one time everywhere.
class FormGrid : public VelocityGrid
{
public:
  explicit FormGrid(double time)
    : Time(time)
  {
  }
  GridHeights Heights() const override { return {}; }
  bool IsLevelAt(double) const override { return false; }
  Vector3 Velocity(const Vector3& position) const override { return ClosedForm(position, this->Time); }

private:
  double Time;
};

/// A grid that ends a meter short of the walls of a layer, with the same velocity all over.
class ShortGrid : public VelocityGrid
{
public:
  GridHeights Heights() const override { return { -9.0, -1.0, 1.5, 1.5 }; }
  bool IsLevelAt(double) const override { return false; }
  Vector3 Velocity(const Vector3&) const override { return { 0.3, -0.2, 0.4 }; }
};

/// A grid of the same velocity from x = 0 on.
class HalfGrid : public VelocityGrid
{
public:
  GridHeights Heights() const override { return {}; }
  bool IsLevelAt(double) const override { return true; }
  Vector3 Velocity(const Vector3& position) const override { return { position.x < 0.0 ? 0.0 : 0.5, 0.0, 0.0 }; }
};

std::shared_ptr<const CurrentSnapshot> SnapshotOf(double time)
{
  return std::make_shared<CurrentSnapshot>(
    std::vector<FlowPrimitive>(), std::vector<std::shared_ptr<const VelocityGrid>>{ std::make_shared<FormGrid>(time) });
}

/// Supplies what is missing; returns the times asked for.
std::vector<double> Supply(CurrentSeries& series, const TimeGrid& grid, const StepMoment& moment)
{
  std::vector<double> asked;
  while (const auto time = series.MissingTime(grid, moment))
  {
    asked.push_back(*time);
    series.Keep(*time, SnapshotOf(*time));
    if (asked.size() > 2)
    {
      ADD_FAILURE() << "asks for ever";
      break;
    }
  }
  return asked;
}

void ExpectNear(const Vector3& a, const Vector3& b, double tolerance)
{
  EXPECT_LT(glm::length(a - b), tolerance)
    << a.x << " " << a.y << " " << a.z << " for " << b.x << " " << b.y << " " << b.z;
}

constexpr TimeGrid Grid{ 2.0, 0.25 };
const Vector3 Somewhere(3.0, -1.0, -4.0);

}

TEST(CurrentSeries, SteadyOnesAskOnce)
{
  CurrentSeries series;
  EXPECT_TRUE(series.IsSteady());
  ASSERT_TRUE(series.MissingTime(Grid, { 7, 0.5 }).has_value());
  series.Keep(123.0, SnapshotOf(9.0));
  for (const long long step : { 0, 1, 1000000 })
  {
    EXPECT_FALSE(series.MissingTime(Grid, { step, 0.3 }).has_value());
    ExpectNear(series.At(Grid, { step, 0.3 }).Velocity(Somewhere), ClosedForm(Somewhere, 9.0), 1e-15);
  }
  series.Keep(5.0, SnapshotOf(1.0));
  EXPECT_EQ(series.GetNumberOfSnapshots(), 1u);
}

TEST(CurrentSeries, AreLinearBetweenTimeSteps)
{
  CurrentSeries series;
  series.Steps = { 1.0, 2.1, 2.9, 7.0 };
  EXPECT_FALSE(series.IsSteady());
  // The form is linear in time, so that the interpolation is exact.
  for (long long step = 0; step < 18; ++step)
  {
    for (const double share : { 0.0, 0.5, 0.77, 1.0 })
    {
      const StepMoment moment{ step, share };
      const double time = 2.0 + 0.25 * (static_cast<double>(step) + share);
      for (const double asked : Supply(series, Grid, moment))
      {
        EXPECT_NE(std::find(series.Steps.begin(), series.Steps.end(), asked), series.Steps.end());
      }
      ExpectNear(series.At(Grid, moment).Velocity(Somewhere), ClosedForm(Somewhere, time), 1e-13);
    }
  }
  // All of them, each once.
  EXPECT_EQ(series.GetNumberOfSnapshots(), 4u);
}

TEST(CurrentSeries, AskForTheTimesAroundAMomentOnly)
{
  CurrentSeries series;
  series.Steps = { 1.0, 2.1, 2.9, 7.0 };
  EXPECT_EQ(Supply(series, Grid, { 1, 0.0 }), (std::vector<double>{ 2.1, 2.9 })); // 2.25 s
  EXPECT_EQ(Supply(series, Grid, { 2, 0.0 }), std::vector<double>());             // 2.5 s
  EXPECT_EQ(Supply(series, Grid, { 4, 0.0 }), std::vector<double>{ 7.0 });        // 3 s
  // On a time step that one is enough.
  CurrentSeries other;
  other.Steps = { 2.0, 2.25, 2.5 };
  EXPECT_EQ(Supply(other, Grid, { 1, 0.0 }), std::vector<double>{ 2.25 });
}

TEST(CurrentSeries, StayAsTheyAreAtTheirEnds)
{
  CurrentSeries series;
  series.Steps = { 3.0, 4.0 };
  EXPECT_EQ(Supply(series, Grid, { 0, 0.0 }), std::vector<double>{ 3.0 }); // 2 s
  ExpectNear(series.At(Grid, { 0, 0.0 }).Velocity(Somewhere), ClosedForm(Somewhere, 3.0), 1e-15);
  EXPECT_EQ(Supply(series, Grid, { 1000, 0.0 }), std::vector<double>{ 4.0 });
  ExpectNear(series.At(Grid, { 1000, 0.0 }).Velocity(Somewhere), ClosedForm(Somewhere, 4.0), 1e-15);

  CurrentSeries continuous;
  continuous.IsContinuous = true;
  continuous.Range[0] = 3.0;
  continuous.Range[1] = 4.0;
  for (const auto& [step, time] : { std::pair<long long, double>{ 0, 3.0 }, { 3, 3.0 }, { 8, 4.0 }, { 99, 4.0 } })
  {
    Supply(continuous, Grid, { step, 0.3 });
    ExpectNear(continuous.At(Grid, { step, 0.3 }).Velocity(Somewhere), ClosedForm(Somewhere, time), 1e-15);
  }
}

TEST(CurrentSeries, ContinuousOnesAreAskedForHalfStepsAlone)
{
  CurrentSeries series;
  series.IsContinuous = true;
  series.Range[0] = -1e3;
  series.Range[1] = 1e3;
  const TimeGrid grid{ 0.3, 0.1 };
  std::set<double> asked;
  for (long long step = 0; step < 50; ++step)
  {
    for (const double share : { 0.0, 0.21, 0.5, 0.63, 1.0 })
    {
      for (const double time : Supply(series, grid, { step, share }))
      {
        EXPECT_TRUE(asked.insert(time).second) << "twice: " << time;
      }
      const double time = 0.3 + 0.1 * (static_cast<double>(step) + share);
      ExpectNear(series.At(grid, { step, share }).Velocity(Somewhere), ClosedForm(Somewhere, time), 1e-12);
    }
  }
  EXPECT_EQ(asked.size(), 101u); // each half step, the end of one being the beginning of the next, to the bit
}

TEST(CurrentSeries, FramesAtHalfStepsAskForNothingLater)
{
  CurrentSeries series;
  series.IsContinuous = true;
  series.Range[0] = -1e3;
  series.Range[1] = 1e3;
  const double start = 7.3;
  const TimeGrid grid{ start - 1.0, 2.0 / 12.0 };
  for (int frame = 0; frame < 500; ++frame)
  {
    const double now = start + frame / 12.0; // rounded to either side of the half step
    const StepGoal goal = grid.GoalAt(now);
    for (const double time : Supply(series, grid, { goal.Step, grid.ShareOf(goal.Remainder) }))
    {
      EXPECT_LE(time, now + 1e-9) << frame;
    }
  }
}

TEST(CurrentSeries, DropThoseFarthestFromTheLastOne)
{
  CurrentSeries series;
  for (int n = 0; n < 100; ++n)
  {
    series.Steps.push_back(n);
  }
  for (int n = 0; n < 60; ++n)
  {
    series.Keep(n, SnapshotOf(n));
  }
  constexpr auto Most = static_cast<int>(CurrentSeries::MaximumSnapshots);
  EXPECT_EQ(series.GetNumberOfSnapshots(), CurrentSeries::MaximumSnapshots);
  const TimeGrid grid{ 0.0, 1.0 };
  for (int n = 0; n < 60; ++n)
  {
    EXPECT_EQ(series.MissingTime(grid, { n, 0.0 }).has_value(), n < 60 - Most) << n;
  }
  for (int n = 20; n >= 5; --n) // back again
  {
    series.Keep(n, SnapshotOf(n));
  }
  EXPECT_EQ(series.GetNumberOfSnapshots(), CurrentSeries::MaximumSnapshots);
  for (int n = 0; n < 60; ++n)
  {
    EXPECT_EQ(series.MissingTime(grid, { n, 0.0 }).has_value(), n < 5 || n >= 5 + Most) << n;
  }
}

TEST(CurrentSeries, TheNearerSnapshotCaptures)
{
  const auto first = SnapshotOf(0.0);
  const auto second = SnapshotOf(1.0);
  EXPECT_EQ((CurrentMixture{ first.get(), second.get(), 0.49 }).Nearest(), first.get());
  EXPECT_EQ((CurrentMixture{ first.get(), second.get(), 0.5 }).Nearest(), second.get());
}

TEST(CurrentSet, AddsSteadyAndChangingCurrents)
{
  FlowPrimitive uniform;
  uniform.Strength = 0.7;
  uniform.Axis = { 0.0, 2.0, 0.0 };
  CurrentSet currents;
  currents.Series.resize(3);
  currents.Series[2].Steps = { 0.0, 10.0 };
  const std::vector<StepMoment> moments{ { 3, 0.0 }, { 3, 0.5 }, { 3, 1.0 } };
  EXPECT_FALSE(currents.AreKnown(Grid, moments));
  EXPECT_FALSE(currents.AreSteady());
  EXPECT_FALSE(currents.AreUniform()); // nothing is known
  currents.Series[0].Keep(0.0,
    std::make_shared<CurrentSnapshot>(
      std::vector<FlowPrimitive>{ uniform }, std::vector<std::shared_ptr<const VelocityGrid>>()));
  currents.Series[1].Keep(0.0, SnapshotOf(4.0));
  currents.Series[2].Keep(0.0, SnapshotOf(0.0));
  EXPECT_FALSE(currents.AreKnown(Grid, moments));
  currents.Series[2].Keep(10.0, SnapshotOf(10.0));
  ASSERT_TRUE(currents.AreKnown(Grid, moments));
  EXPECT_FALSE(currents.AreUniform());
  const StepCurrents sum = currents.At(Grid, moments);
  for (std::size_t moment = 0; moment < 3; ++moment)
  {
    const double time = 2.0 + 0.25 * (3.0 + 0.5 * static_cast<double>(moment));
    const Vector3 expected = Vector3(0.0, 0.7, 0.0) + ClosedForm(Somewhere, 4.0) + ClosedForm(Somewhere, time);
    ExpectNear(sum.Velocity(Somewhere, moment), expected, 1e-13);
  }
  currents.Series.resize(1);
  EXPECT_TRUE(currents.AreSteady());
  EXPECT_TRUE(currents.AreUniform());
}

TEST(CurrentSet, WaterIsAcceleratedWhereAndWhenItsVelocityChanges)
{
  // In a steady vortex water falls towards its axis by v^2 / r, and hangs still where it does not move.
  FlowPrimitive vortex;
  vortex.Type = FlowType::Vortex;
  vortex.Axis = { 0.0, 0.0, 1.0 };
  vortex.Center = Vector3(0.0, 0.0, -4.0);
  CurrentSet currents;
  currents.Series.resize(1);
  currents.Series[0].Keep(0.0,
    std::make_shared<CurrentSnapshot>(
      std::vector<FlowPrimitive>{ vortex }, std::vector<std::shared_ptr<const VelocityGrid>>()));
  const TimeGrid grid{ 2.0, 0.01 };
  const std::vector<StepMoment> moments{ { 3, 0.5 }, { 3, 0.0 }, { 3, 1.0 } };
  const StepCurrents steady = currents.At(grid, moments);
  for (const double r : { 0.2, 0.7, 3.0 })
  {
    const Vector3 place(r, 0.0, -4.0);
    const double speed = 0.2 / (TwoPi * r) * (1.0 - std::exp(-r * r / 0.25));
    ExpectNear(steady.Velocity(place, 0), Vector3(0.0, speed, 0.0), 1e-15);
    ExpectNear(steady.Acceleration(place, Vector3(0.0, speed, 0.0)), Vector3(-speed * speed / r, 0.0, 0.0), 1e-7);
    ExpectNear(steady.Acceleration(place, Vector3(0.0)), Vector3(0.0), 1e-15);
  }
  // A grid of ClosedForm: du/dt + (v.grad) u, by hand.
  currents.Series[0] = CurrentSeries();
  currents.Series[0].Steps = { 0.0, 10.0 };
  currents.Series[0].Keep(0.0, SnapshotOf(0.0));
  currents.Series[0].Keep(10.0, SnapshotOf(10.0));
  const StepCurrents changing = currents.At(grid, moments);
  const double time = 2.035;
  const Vector3 v(0.7, -0.3, 0.4);
  ExpectNear(
    changing.Acceleration(Somewhere, v), Vector3(0.5, 0.1 * Somewhere.x + 0.1 * time * v.x, -0.2 * v.z), 1e-12);
  // Of a moment that is not in the middle: the same, as all is linear but in time and place together.
  const StepCurrents late = currents.At(grid, { { 3, 0.9 }, { 3, 0.0 }, { 3, 1.0 } });
  ExpectNear(late.Acceleration(Somewhere, v), changing.Acceleration(Somewhere, v), 1e-2);
  // A grid of the same velocity everywhere that ends at x = 0 accelerates no water at its end.
  currents.Series[0] = CurrentSeries();
  currents.Series[0].Keep(0.0,
    std::make_shared<CurrentSnapshot>(
      std::vector<FlowPrimitive>(), std::vector<std::shared_ptr<const VelocityGrid>>{ std::make_shared<HalfGrid>() }));
  ExpectNear(currents.At(grid, moments).Acceleration({ 0.001, 0.0, -4.0 }, { 0.5, 0.0, 0.0 }), Vector3(0.0), 1e-15);
}

TEST(CurrentSet, SinksCaptureAsAtTheLastMoment)
{
  FlowPrimitive sink;
  sink.Type = FlowType::Sink;
  sink.CoreRadius = 0.5;
  const auto with = std::make_shared<CurrentSnapshot>(
    std::vector<FlowPrimitive>{ sink }, std::vector<std::shared_ptr<const VelocityGrid>>());
  const auto without = std::make_shared<CurrentSnapshot>();
  CurrentSet currents;
  currents.Series.resize(1);
  currents.Series[0].Steps = { 0.0, 1.0 };
  currents.Series[0].Keep(0.0, with);
  currents.Series[0].Keep(1.0, without);
  const TimeGrid grid{ 0.0, 1.0 };
  for (const double last : { 0.2, 0.8 })
  {
    const StepCurrents sum = currents.At(grid, { { 0, 0.0 }, { 0, last } });
    Vector3 to(1.0, 0.1, 0.0);
    EXPECT_EQ(sum.Capture({ -1.0, 0.1, 0.0 }, to), last < 0.5);
  }
}

TEST(WalledVelocity, NothingFlowsThroughWalls)
{
  WaterLayer layer;
  layer.Bed = -10.0;
  layer.Surface = 0.0;
  const WalledVelocity walled(std::make_shared<FormGrid>(2.0), layer);
  for (const double z : { -10.0, 0.0 })
  {
    EXPECT_NEAR(walled.Velocity({ 3.0, 1.0, z }).z, 0.0, 1e-15);
    EXPECT_EQ(walled.Velocity({ 3.0, 1.0, z }).x, ClosedForm({ 3.0, 1.0, z }, 2.0).x);
  }
}

TEST(WalledVelocity, FallsToZeroEvenlyBetweenAGridAndAWall)
{
  WaterLayer layer;
  layer.Bed = -10.0;
  layer.Surface = 0.0;
  const WalledVelocity walled(std::make_shared<ShortGrid>(), layer);
  // Linear over the last meter: the water that is pushed out evenly leaves no gap.
  for (const double fromWall : { 0.0, 0.25, 0.5, 0.9, 1.0 })
  {
    for (const double z : { -10.0 + fromWall, -fromWall })
    {
      ExpectNear(walled.Velocity({ 3.0, 1.0, z }), { 0.3, -0.2, 0.4 * fromWall }, 1e-14);
    }
  }
  ExpectNear(walled.Velocity({ 3.0, 1.0, -5.0 }), { 0.3, -0.2, 0.4 }, 1e-14);
}
