// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/DriftHistory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <random>
#include <utility>
#include <vector>

using namespace littoral;

namespace
{

constexpr double Spin = 0.8; // [rad/s]

/// Water that turns about the vertical axis as a solid body.
class SolidRotation : public VelocityGrid
{
public:
  GridHeights Heights() const override { return {}; }
  bool IsLevelAt(double) const override { return true; }
  Vector3 Velocity(const Vector3& position) const override { return Spin * Vector3(-position.y, position.x, 0.0); }
};

std::shared_ptr<const CurrentSnapshot> SnapshotOf(std::shared_ptr<const VelocityGrid> grid)
{
  return std::make_shared<CurrentSnapshot>(
    std::vector<FlowPrimitive>(), std::vector<std::shared_ptr<const VelocityGrid>>{ std::move(grid) });
}

std::shared_ptr<const CurrentSnapshot> SnapshotOf(const FlowPrimitive& primitive)
{
  return std::make_shared<CurrentSnapshot>(
    std::vector<FlowPrimitive>{ primitive }, std::vector<std::shared_ptr<const VelocityGrid>>());
}

FlowPrimitive Uniform(double speed)
{
  FlowPrimitive primitive;
  primitive.Strength = speed;
  return primitive;
}

/// Whatever is asked for at a time.
using SnapshotAt = std::function<std::shared_ptr<const CurrentSnapshot>(double time)>;

/// Drifts to a time, with currents supplied as a pipeline does.
void DriftTo(DriftHistory& history, double time, const SnapshotAt& snapshotAt)
{
  history.SetGoal(time);
  for (int asked = 0; asked < 100000; ++asked)
  {
    while (!history.IsAtGoal() && history.IsNextKnown())
    {
      const StepCurrents currents = history.NextCurrents();
      const long long last = history.NextStop();
      const std::size_t half = history.Size() / 2;
      history.Carry(currents, last, half, history.Size());
      history.Carry(currents, last, 0, half);
      history.Reach(last);
    }
    if (history.IsAtGoal() && history.IsNextKnown())
    {
      return;
    }
    for (CurrentSeries& current : history.Currents.Series)
    {
      if (const auto missing = current.MissingTime(history.GetGrid(), history.NextMoments()))
      {
        current.Keep(*missing, snapshotAt(*missing));
      }
    }
  }
  ADD_FAILURE() << "no end";
}

/// All points at the goal.
Drifters PointsOf(const DriftHistory& history)
{
  Drifters points;
  const StepCurrents currents = history.NextCurrents();
  for (std::size_t id = 0; id < history.Size(); ++id)
  {
    points.Positions.emplace_back();
    points.Fates.emplace_back();
    history.At(currents, id, points.Positions.back(), points.Fates.back());
  }
  return points;
}

/// Points on a line; none of them still.
Drifters Line(int count)
{
  Drifters points;
  for (int n = 0; n < count; ++n)
  {
    points.Positions.emplace_back(0.5 + 0.3 * n, -0.2 * n, -1.0 - n);
    points.Fates.push_back(DriftFate::Free);
  }
  return points;
}

DriftHistory Begun(const TimeGrid& grid, const CurrentSeries& current, const Drifters& start)
{
  DriftHistory history(grid, { current });
  history.Begin(start);
  return history;
}

/// A current with snapshots at any time within a range.
CurrentSeries Continuous(double first, double last)
{
  CurrentSeries series;
  series.IsContinuous = true;
  series.Range[0] = first;
  series.Range[1] = last;
  return series;
}

bool operator==(const Drifters& a, const Drifters& b)
{
  return a.Positions == b.Positions && a.Fates == b.Fates;
}

}

TEST(DriftHistory, TurnsWithTheWaterAsRungeAndKuttaSay)
{
  const TimeGrid grid{ -1.0, 0.125 };
  const auto rotation = SnapshotOf(std::make_shared<SolidRotation>());
  DriftHistory history = Begun(grid, CurrentSeries(), Line(7));
  // A step of fourth order multiplies x + i y by the first five terms of exp(i Spin h).
  const auto factor = [](double h) {
    const std::complex<double> z(0.0, Spin * h);
    return 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
  };
  for (const double time : { 9.0, 20.3, -0.95, 3.04, -1.0, -7.0, 19.99 })
  {
    DriftTo(history, time, [&](double) { return rotation; });
    const double elapsed = std::max(0.0, time + 1.0);
    const double steps = std::floor(elapsed / 0.125);
    const std::complex<double> turn = std::pow(factor(0.125), steps) * factor(elapsed - 0.125 * steps);
    EXPECT_LT(std::abs(turn - std::polar(1.0, Spin * elapsed)), elapsed * std::pow(0.1, 5) / 100.0 / 0.125 + 1e-15);
    const Drifters start = Line(7);
    const Drifters points = PointsOf(history);
    for (std::size_t id = 0; id < points.Size(); ++id)
    {
      const Vector3 at = start.Positions[id];
      const std::complex<double> expected = turn * std::complex<double>(at.x, at.y);
      EXPECT_NEAR(points.Positions[id].x, expected.real(), 1e-12) << time;
      EXPECT_NEAR(points.Positions[id].y, expected.imag(), 1e-12) << time;
      EXPECT_EQ(points.Positions[id].z, at.z);
    }
  }
}

TEST(DriftHistory, IsTheSameToTheBitInAnyOrderOfTimes)
{
  // Steady, with time steps, and continuous.
  std::vector<CurrentSeries> kinds(2);
  kinds[1].Steps = { 0.4, 1.7, 3.0, 11.0 };
  kinds.push_back(Continuous(1.0, 9.0));
  const auto snapshotAt = [](double time) {
    FlowPrimitive vortex;
    vortex.Type = FlowType::Vortex;
    vortex.Axis = { 0.1, 0.2, 1.0 };
    vortex.Strength = 2.0 + std::sin(time);
    return SnapshotOf(vortex);
  };
  std::mt19937 random(3);
  for (const CurrentSeries& kind : kinds)
  {
    const TimeGrid grid{ 0.0, 0.1 };
    DriftHistory history = Begun(grid, kind, Line(5));
    for (int n = 0; n < 40; ++n)
    {
      const double time = -1.0 + 0.05 * static_cast<double>(random() % 300); // every other one on the grid
      DriftTo(history, time, snapshotAt);
      DriftHistory fresh = Begun(grid, kind, Line(5));
      DriftTo(fresh, time, snapshotAt);
      ASSERT_TRUE(PointsOf(history) == PointsOf(fresh)) << time;
    }
  }
}

TEST(DriftHistory, NeedsNoStepsInUniformCurrents)
{
  const auto snapshot = SnapshotOf(Uniform(0.3));
  DriftHistory history = Begun({ 2.0, 0.1 }, CurrentSeries(), Line(3));
  EXPECT_FALSE(history.IsClosed()); // before it is known
  for (const double time : { 5.0, 1e9, 2.0, -4.0 })
  {
    DriftTo(history, time, [&](double) { return snapshot; });
    EXPECT_TRUE(history.IsClosed());
    EXPECT_EQ(history.GetStep(), 0);
    const Drifters points = PointsOf(history);
    for (std::size_t id = 0; id < 3; ++id)
    {
      const double expected = Line(3).Positions[id].x + 0.3 * std::max(0.0, time - 2.0);
      EXPECT_NEAR(points.Positions[id].x, expected, 1e-15 * (1.0 + std::abs(expected)));
    }
  }
}

TEST(DriftHistory, IntegratesCurrentsThatGrow)
{
  // u = t from 1 s to 4 s, constant before and after: a parabola, which is exact where ends of the ramp are on steps.
  const auto snapshotAt = [](double time) { return SnapshotOf(Uniform(time)); };
  CurrentSeries stepped;
  stepped.Steps = { 1.0, 2.5, 4.0 };
  const auto integral = [](double t) {
    const double ramp = std::clamp(t, 1.0, 4.0);
    return std::min(t, 1.0) + 0.5 * (ramp * ramp - 1.0) + 4.0 * std::max(0.0, t - 4.0);
  };
  for (const CurrentSeries& kind : { stepped, Continuous(1.0, 4.0) })
  {
    DriftHistory history = Begun({ 0.0, 0.125 }, kind, Line(2));
    for (const double time : { 0.5, 6.3, 2.125, 2.2, 1.0, 4.06 })
    {
      DriftTo(history, time, snapshotAt);
      EXPECT_NEAR(PointsOf(history).Positions[1].x, Line(2).Positions[1].x + integral(time), 1e-12) << time;
    }
  }
}

TEST(DriftHistory, WhatIsStillOrCapturedIsNotCarried)
{
  FlowPrimitive sink;
  sink.Type = FlowType::Sink;
  sink.Strength = 5.0;
  sink.CoreRadius = 0.2;
  sink.Center = { 0.0, 0.0, -1.0 };
  const auto snapshot = SnapshotOf(sink);
  Drifters start;
  start.Positions = { { 1.0, 0.0, -1.0 }, { 1.0, 0.0, -1.0 }, { 0.0, 1.0, -1.0 } };
  start.Fates = { DriftFate::Free, DriftFate::Still, DriftFate::Captured };
  DriftHistory history = Begun({ 0.0, 0.1 }, CurrentSeries(), start);
  DriftTo(history, 100.0, [&](double) { return snapshot; });
  const Drifters points = PointsOf(history);
  EXPECT_EQ(points.Fates[0], DriftFate::Captured);
  EXPECT_LE(glm::distance(points.Positions[0], sink.Center), 0.2);
  EXPECT_EQ(points.Positions[1], start.Positions[1]);
  EXPECT_EQ(points.Fates[1], DriftFate::Still);
  EXPECT_EQ(points.Positions[2], start.Positions[2]);
  // Back to before it was captured.
  DriftTo(history, 0.1, [&](double) { return snapshot; });
  EXPECT_EQ(PointsOf(history).Fates[0], DriftFate::Free);
}

TEST(DriftHistory, WhatGoesBeyondAllNumbersStays)
{
  const auto rotation = SnapshotOf(std::make_shared<SolidRotation>());
  Drifters start;
  start.Positions = { { 1e300, 0.0, -1.0 }, { 1.0, 0.0, -1.0 } };
  start.Fates = { DriftFate::Free, DriftFate::Free };
  DriftHistory history = Begun({ 0.0, 1e9 }, CurrentSeries(), start);
  DriftTo(history, 3e9, [&](double) { return rotation; });
  const Drifters points = PointsOf(history);
  EXPECT_EQ(points.Fates[0], DriftFate::Still);
  EXPECT_EQ(points.Positions[0], start.Positions[0]);
  EXPECT_TRUE(IsFinite(points.Positions[1]));
}

TEST(DriftHistory, StaysInItsLayer)
{
  // A vertical jet against the surface: without walls points leave.
  FlowPrimitive jet = Uniform(1.0);
  jet.Axis = { 0.0, 0.0, 1.0 };
  jet.InfluenceRadius = 50.0;
  WaterLayer layer;
  layer.Surface = 0.0;
  layer.Bed = -10.0;
  for (const bool hasWalls : { false, true })
  {
    const WaterLayer own = hasWalls ? layer : WaterLayer();
    const auto snapshot = std::make_shared<CurrentSnapshot>(
      std::vector<FlowPrimitive>{ jet }, std::vector<std::shared_ptr<const VelocityGrid>>(), own);
    DriftHistory history = Begun({ 0.0, 0.5 }, CurrentSeries(), Line(4));
    history.Currents.Layer = own;
    DriftTo(history, 30.0, [&](double) { return snapshot; });
    for (const Vector3& position : PointsOf(history).Positions)
    {
      EXPECT_EQ(layer.Holds(position.z), hasWalls) << position.z;
    }
  }
}
