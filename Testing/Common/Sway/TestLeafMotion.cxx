// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Sway/LeafMotion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

using namespace littoral;

namespace
{

const LeafAxes Upright{ { 0.0, 0.0, 1.0 }, { 1.0, 0.0, 0.0 } };

Vector3 Turned(const glm::dquat& rotation, const Vector3& vector)
{
  return vector + RotationOffset(rotation, vector);
}

double Angle(const Vector3& a, const Vector3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}

TEST(LeafMotion, NoWindNoMotion)
{
  const glm::dquat rotation = LeafRotation(Upright, LeafWindOf(Vector3(0.0), {}), { 0.3, -0.2 });
  const glm::dquat identity{ 1.0, 0.0, 0.0, 0.0 };
  EXPECT_EQ(std::memcmp(&rotation, &identity, sizeof(identity)), 0);
}

TEST(LeafMotion, TurnsTowardsTheWind)
{
  LeafMotionOptions options;
  options.MaximumAlignment = 1.0;
  for (const Vector3& wind : { Vector3(20.0, 0.0, 0.0), Vector3(-9.0, 12.0, 16.0), Vector3(0.0, 0.0, -20.0) })
  {
    const glm::dquat rotation = LeafRotation(Upright, LeafWindOf(wind, options), { 0.0, 0.0 });
    EXPECT_NEAR(Angle(Turned(rotation, Upright.Main), wind), 0.0, 1e-9);
  }
  double last = -1.0;
  for (double speed = 0.0; speed <= 20.0; speed += 0.5)
  {
    const glm::dquat rotation = LeafRotation(Upright, LeafWindOf({ speed, 0.0, 0.0 }, options), { 0.0, 0.0 });
    const double angle = Angle(Turned(rotation, Upright.Main), Upright.Main);
    EXPECT_GE(angle, last - 1e-12);
    EXPECT_NEAR(angle, 0.5 * Pi * RiseBetween(speed, options.AligningSpeeds), 1e-12);
    last = angle;
  }
}

TEST(LeafMotion, AxesStayAtRightAngles)
{
  const LeafFlutter flutter({});
  for (int leaf = 0; leaf < 100; ++leaf)
  {
    const glm::dquat q = LeafRotation(Upright, LeafWindOf({ 3.0 - 0.1 * leaf, 2.0, 1.0 }, {}), flutter.At(leaf, 7.7));
    EXPECT_NEAR(glm::dot(Turned(q, Upright.Main), Turned(q, Upright.Facing)), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(Turned(q, Upright.Main)), 1.0, 1e-12);
  }
}

TEST(LeafMotion, FlutterIsUniformAndBounded)
{
  LeafMotionOptions options;
  const LeafFlutter flutter(options);
  double sum = 0.0;
  double squares = 0.0;
  double largest = 0.0;
  const int leaves = 20000;
  for (int leaf = 0; leaf < leaves; ++leaf)
  {
    for (const double angle : flutter.At(leaf, 12.34))
    {
      sum += angle;
      squares += angle * angle;
      largest = std::max(largest, std::abs(angle));
    }
  }
  EXPECT_LE(largest, 0.5);
  EXPECT_NEAR(sum / (2 * leaves), 0.0, 0.01);
  // Uniform angles at the cells' ends, variance 1/12, blended with weights p and 1 - p of a leaf's random phase: the
  // mean of p^2 + (1 - p)^2 over the fifth-order step is 1 - 2 (1/2 - 181/462) = 181/231.
  EXPECT_NEAR(squares / (2 * leaves), 181.0 / 231.0 / 12.0, 0.002);
}

TEST(LeafMotion, FlutterIsSmoothInTime)
{
  LeafMotionOptions options;
  const LeafFlutter flutter(options);
  const double step = 1e-4;
  double fastest = 0.0;
  double sharpest = 0.0;
  double before = flutter.At(3, 0.0)[0];
  double speed = 0.0;
  for (int k = 1; k < 50000; ++k)
  {
    const double angle = flutter.At(3, k * step)[0];
    const double now = (angle - before) / step;
    fastest = std::max(fastest, std::abs(now));
    sharpest = std::max(sharpest, k > 1 ? std::abs(now - speed) / step : 0.0);
    before = angle;
    speed = now;
  }
  std::printf("flutter: at most %.3g ranges a second, acceleration %.3g\n", fastest, sharpest);
  EXPECT_GT(fastest, 1.0);
  EXPECT_LT(fastest, 1.875 * options.FlutterRate * 1.01); // the steepest slope of the step
  EXPECT_LT(sharpest, 5.774 * options.FlutterRate * options.FlutterRate * 1.01);
}

TEST(LeafMotion, AnyTimeWithoutHistory)
{
  LeafMotionOptions options;
  const LeafFlutter one(options);
  std::vector<std::array<double, 2>> forward;
  for (int k = 0; k < 100; ++k)
  {
    forward.push_back(one.At(5, -3.0 + 0.07 * k));
  }
  const LeafFlutter other(options);
  for (int k = 99; k >= 0; --k)
  {
    EXPECT_EQ(other.At(5, -3.0 + 0.07 * k), forward[k]);
  }
  EXPECT_NE(one.At(6, 0.0), one.At(5, 0.0));
  options.Seed = 2;
  EXPECT_NE(LeafFlutter(options).At(5, 0.0), one.At(5, 0.0));
}

TEST(LeafMotion, AnyTimeAndPeriodThatIsFinite)
{
  LeafMotionOptions options;
  for (const double period : { 0.0, 7.0, 4.8e32, 1e308 })
  {
    options.Period = period;
    const LeafFlutter flutter(options);
    for (const double time : { 0.0, 1e9, -1e9, 1e17, -1e17, 1e300, -1e300, 1.7e308 })
    {
      const LeafFlutter::Moment moment = flutter.MomentOf(time);
      EXPECT_LE(std::abs(static_cast<double>(moment.Cell)), 0x1p53) << time << " of " << period;
      EXPECT_TRUE(moment.Part >= 0.0 && moment.Part <= 1.0) << time << " of " << period;
      for (const double angle : flutter.At(5, time))
      {
        EXPECT_LE(std::abs(angle), 0.5) << time << " of " << period;
      }
    }
  }
  // A period beyond all that time can tell is none.
  options.Period = 0.0;
  const LeafFlutter endless(options);
  options.Period = 4.8e32;
  EXPECT_EQ(LeafFlutter(options).At(5, 12.34), endless.At(5, 12.34));
}

TEST(LeafMotion, RepeatsAfterThePeriod)
{
  LeafMotionOptions options;
  options.Period = 8.0;
  const LeafFlutter flutter(options);
  for (int k = 0; k < 64; ++k)
  {
    EXPECT_EQ(flutter.At(9, 0.125 * k), flutter.At(9, 0.125 * k + 8.0));
    EXPECT_EQ(flutter.At(9, 0.125 * k), flutter.At(9, 0.125 * k - 80.0));
  }
}

TEST(LeafMotion, GoesOnWhereThePeriodEnds)
{
  LeafMotionOptions options;
  options.FlutterRate = 2.3; // 11.5 changes of angle in the period, of which 12 fit
  options.Period = 5.0;
  const LeafFlutter flutter(options);
  for (int leaf = 0; leaf < 50; ++leaf)
  {
    const auto before = flutter.At(leaf, options.Period - 1e-6);
    const auto after = flutter.At(leaf, options.Period + 1e-6);
    EXPECT_NEAR(before[0], after[0], 2e-5); // at most 1.875 ranges a change, 12 changes in 5 s
    EXPECT_NEAR(before[1], after[1], 2e-5);
  }
}

TEST(LeafMotion, LeavesOfAShortPeriodKeepOneAngleEach)
{
  LeafMotionOptions options;
  options.FlutterRate = 2.0;
  options.Period = 0.1;
  const LeafFlutter flutter(options);
  double squares = 0.0;
  const int leaves = 20000;
  for (int leaf = 0; leaf < leaves; ++leaf)
  {
    const auto angles = flutter.At(leaf, 0.03);
    EXPECT_EQ(angles, flutter.At(leaf, 0.07));
    squares += 0.5 * (angles[0] * angles[0] + angles[1] * angles[1]) / leaves;
  }
  EXPECT_NEAR(squares, 1.0 / 12.0, 0.001); // of uniform angles
}

// Leaves one by one, by their definition; nothing that a leaf keeps shows, whatever times were asked for before.
TEST(LeafMotion, LeavesTurnAsEachDoesAlone)
{
  LeafMotionOptions options;
  options.Period = 60.0;
  const LeafFlutter flutter(options);
  const std::array<LeafWind, 3> winds{ LeafWindOf({ 9.0, -3.0, 1.0 }, options), LeafWindOf(Vector3(0.0), options),
    LeafWindOf({ 0.0, 2.0, 0.5 }, options) };
  const int count = 42;
  const RandomStream random(3, RandomPurpose::QuadratPositions);
  std::vector<FlutteringLeaf> leaves;
  std::vector<float> rest;
  std::vector<float> restNormals;
  for (int leaf = 0; leaf < count; ++leaf)
  {
    leaves.push_back(flutter.Leaf({ 4 * leaf + 2, 4 * leaf, 4 * leaf + 1, 4 * leaf + 3 }, leaf % 3, 1000 + leaf));
    for (int corner = 0; corner < 12; ++corner)
    {
      const auto draw = random.NormalPair(leaf, corner);
      rest.push_back(static_cast<float>(3.0 + 0.1 * draw[0]));
      restNormals.push_back(static_cast<float>(draw[1]));
    }
  }
  double worst = 0.0;
  for (const double time : { 0.1, 0.12, 0.5, 59.99, 60.01, 7.3, 0.12, -400.0 })
  {
    std::vector<float> points = rest;
    std::vector<float> normals = restNormals;
    TurnLeaves(flutter, flutter.MomentOf(time), winds.data(), 0, count, leaves.data(), points.data(), normals.data());
    for (int leaf = 0; leaf < count; ++leaf)
    {
      const FlutteringLeaf& own = leaves[leaf];
      const auto at = [&](const std::vector<float>& vectors, int corner) {
        const float* v = &vectors[3 * own.Corners[corner]];
        return Vector3(v[0], v[1], v[2]);
      };
      const Vector3 foot = at(rest, 0);
      const LeafAxes axes{ Normalised(at(rest, 2) - foot),
        Normalised(glm::cross(at(rest, 2) - foot, at(rest, 3) - at(rest, 1))) };
      const glm::dquat turn = LeafRotation(axes, winds[own.Plant], flutter.At(own.Identity, time));
      for (int corner = 0; corner < 4; ++corner)
      {
        const Vector3 point = foot + Turned(turn, at(rest, corner) - foot);
        worst = std::max(worst, glm::distance(at(points, corner), point));
        worst = std::max(worst, glm::distance(at(normals, corner), Turned(turn, at(restNormals, corner))));
      }
      if (own.Plant == 1) // calm
      {
        EXPECT_EQ(at(points, 2), at(rest, 2));
        EXPECT_EQ(at(normals, 2), at(restNormals, 2));
      }
    }
  }
  std::printf("leaves four at a time: %.2g\n", worst);
  EXPECT_LT(worst, 1e-6);
}

TEST(LeafMotion, FollowingTimeGivesTheBytesOfAnyOrder)
{
  LeafMotionOptions options;
  options.Period = 3.0;
  const LeafFlutter flutter(options);
  const LeafWind wind = LeafWindOf({ 6.0, 1.0, 0.0 }, options);
  const auto turned = [&](std::vector<FlutteringLeaf>& leaves, double time) {
    std::vector<float> points;
    for (int leaf = 0; leaf < 9; ++leaf)
    {
      const float x = static_cast<float>(leaf);
      points.insert(points.end(), { x, 0.0f, 0.0f, x, -0.1f, 0.1f, x, 0.0f, 0.2f, x, 0.1f, 0.1f });
    }
    TurnLeaves(flutter, flutter.MomentOf(time), &wind, 0, leaves.size(), leaves.data(), points.data(), nullptr);
    return points;
  };
  std::vector<FlutteringLeaf> fresh;
  for (int leaf = 0; leaf < 9; ++leaf)
  {
    fresh.push_back(flutter.Leaf({ 4 * leaf, 4 * leaf + 1, 4 * leaf + 2, 4 * leaf + 3 }, 0, leaf));
  }
  std::vector<FlutteringLeaf> following = fresh;
  for (double time = -1.0; time < 7.0; time += 0.07)
  {
    std::vector<FlutteringLeaf> own = fresh;
    EXPECT_EQ(turned(following, time), turned(own, time)) << time;
  }
}
