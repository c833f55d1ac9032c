// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Splines through samples that lie moved and stretched in space, and where they are known to be level.
#include "Currents/SplineVelocity.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

using namespace littoral;

namespace
{

/// Samples at 0, 1 ... 4 along each axis, whose positions are 2 m apart from 10 m on.
class Samples : public SampledVelocity
{
public:
  explicit Samples(double rise)
    : Rise(rise)
  {
  }

  /// The field at a place [m]: a polynomial of the third degree, level in the layer z = 10.
  Vector3 Field(const Vector3& place) const
  {
    const Vector3 p = place - Vector3(10.0);
    return { p.y * p.z - 1.0, 0.1 * p.x * p.x * p.y, this->Rise * p.z * p.z * p.x };
  }

  std::vector<double> Nodes(int axis) const override { return this->Axes[axis]; }
  Vector3 PositionOf(const Vector3& position) const override { return 0.5 * (position - Vector3(10.0)); }
  Vector3 Sample(std::size_t id) const override
  {
    const std::size_t row = id / 5;
    const std::size_t layer = row / 5;
    return this->Field(Vector3(10.0) +
      2.0 * Vector3(static_cast<double>(id % 5), static_cast<double>(row % 5), static_cast<double>(layer)));
  }
  bool IsWater(std::size_t id) const override { return id % 5 < this->FirstOfLand; }
  bool IsSingle() const override { return false; }
  GridHeights Heights() const override { return { 10.0, 18.0, 2.0, 2.0 }; }
  bool IsLevelAt(double height) const override { return height == 10.0; }
  Vector3 Velocity(const Vector3& position) const override { return this->Field(position); }

  std::vector<double> Axes[3] = { { 0.0, 1.0, 2.0, 3.0, 4.0 }, { 0.0, 1.0, 2.0, 3.0, 4.0 },
    { 0.0, 1.0, 2.0, 3.0, 4.0 } };
  std::size_t FirstOfLand = 5; ///< columns from here on are land

private:
  double Rise;
};

}

TEST(SplineVelocity, HasACubicFieldExactlyAndRestsOutside)
{
  const auto samples = std::make_shared<Samples>(0.3);
  const SplineVelocity spline(samples);
  for (const Vector3& place : { Vector3(10.0), Vector3(18.0), Vector3(11.3, 14.9, 17.2), Vector3(17.9, 10.1, 12.5) })
  {
    EXPECT_LT(glm::length(spline.Velocity(place) - samples->Field(place)), 1e-11);
  }
  EXPECT_EQ(spline.Velocity({ 9.9, 12.0, 12.0 }), Vector3(0.0));
  EXPECT_EQ(spline.Velocity({ 12.0, 12.0, 18.1 }), Vector3(0.0));
  EXPECT_EQ(spline.Heights().High, 18.0);
}

TEST(SplineVelocity, IsLevelInLevelLayersOfSamplesOnly)
{
  const SplineVelocity spline(std::make_shared<Samples>(0.3));
  EXPECT_TRUE(spline.IsLevelAt(10.0));
  EXPECT_FALSE(spline.IsLevelAt(11.0)); // between layers
  EXPECT_FALSE(spline.IsLevelAt(12.0)); // a layer that rises
}

TEST(SplineVelocity, IsLevelAnywhereWhereNoSampleRises)
{
  const SplineVelocity spline(std::make_shared<Samples>(0.0));
  for (const double height : { 10.0, 11.0, 12.0, 40.0 })
  {
    EXPECT_TRUE(spline.IsLevelAt(height)) << height;
  }
}

TEST(SplineVelocity, NeedsSamplesInOrderAlongEachAxis)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Samples samples(0.3);
    EXPECT_TRUE(SplineVelocity::CanBe(samples));
    samples.Axes[axis] = { 4.0, 3.0, 2.0, 1.0, 0.0 };
    EXPECT_TRUE(SplineVelocity::CanBe(samples));
    samples.Axes[axis] = { 0.0, 1.0, 1.0, 3.0, 4.0 };
    EXPECT_FALSE(SplineVelocity::CanBe(samples));
  }
}

/// A current along a coast, which is land from a column on.
class CoastalCurrent : public Samples
{
public:
  CoastalCurrent()
    : Samples(0.0)
  {
    this->FirstOfLand = 3;
  }
  Vector3 Sample(std::size_t id) const override { return this->IsWater(id) ? Vector3(0.0, 0.5, 0.0) : Vector3(0.0); }
};

TEST(SplineVelocity, LandDoesNotSwingTheWaterBesideIt)
{
  const SplineVelocity spline(std::make_shared<CoastalCurrent>());
  // Water up to the last column of it at x = 14; the cell of the coast slows down evenly; land rests.
  for (const double y : { 10.0, 12.3, 18.0 })
  {
    for (const double x : { 10.0, 11.7, 13.9, 14.0 })
    {
      EXPECT_LT(glm::length(spline.Velocity({ x, y, 13.1 }) - Vector3(0.0, 0.5, 0.0)), 1e-12) << x;
    }
    EXPECT_NEAR(spline.Velocity({ 14.5, y, 13.1 }).y, 0.375, 1e-12);
    EXPECT_NEAR(spline.Velocity({ 16.0, y, 13.1 }).y, 0.0, 1e-12);
    EXPECT_NEAR(spline.Velocity({ 17.2, y, 13.1 }).y, 0.0, 1e-12);
  }
}
