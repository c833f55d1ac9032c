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
  const glm::dquat rotation = LeafRotation(Upright, { 0.0, 0.0, 0.0 }, { 0.3, -0.2 }, {});
  const glm::dquat identity{ 1.0, 0.0, 0.0, 0.0 };
  EXPECT_EQ(std::memcmp(&rotation, &identity, sizeof(identity)), 0);
}

TEST(LeafMotion, TurnsTowardsTheWind)
{
  LeafMotionOptions options;
  options.LargestAlignment = 1.0;
  for (const Vector3& wind : { Vector3(20.0, 0.0, 0.0), Vector3(-9.0, 12.0, 16.0), Vector3(0.0, 0.0, -20.0) })
  {
    const glm::dquat rotation = LeafRotation(Upright, wind, { 0.0, 0.0 }, options);
    EXPECT_NEAR(Angle(Turned(rotation, Upright.Main), wind), 0.0, 1e-9);
  }
  double last = -1.0;
  for (double speed = 0.0; speed <= 20.0; speed += 0.5)
  {
    const glm::dquat rotation = LeafRotation(Upright, { speed, 0.0, 0.0 }, { 0.0, 0.0 }, options);
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
    const glm::dquat q = LeafRotation(Upright, { 3.0 - 0.1 * leaf, 2.0, 1.0 }, flutter.At(leaf, 7.7), {});
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
