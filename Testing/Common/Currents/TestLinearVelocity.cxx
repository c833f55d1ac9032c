// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Interpolation of fields that are linear along each axis, which is exact.
#include "Currents/LinearVelocity.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace littoral;

namespace
{

/// Unequal spacings, rising, falling and rising.
const std::array<std::vector<double>, 3> Nodes{ { { -1.0, 0.5, 4.0 }, { 9.0, 5.0, 4.5, 1.0 }, { 2.0, 8.0 } } };
constexpr std::array<int, 3> Samples{ 3, 4, 2 };

/// Linear along each axis, level at z = 5.
Vector3 Field(double x, double y, double z)
{
  return { 1.0 + x * y * z, 2.0 * x - 3.0 * y + 0.5 * y * z, (z - 5.0) * (1.0 + 0.1 * x) };
}

Vector3 ValueAt(long long number)
{
  return Field(Nodes[0][number % 3], Nodes[1][number / 3 % 4], Nodes[2][number / 12]);
}

/// The interpolated field; not a number outside.
Vector3 Interpolated(double x, double y, double z)
{
  std::array<AxisPlace, 3> place;
  const bool isInside =
    FindPlace(Nodes[0], x, place[0]) && FindPlace(Nodes[1], y, place[1]) && FindPlace(Nodes[2], z, place[2]);
  return isInside ? Trilinear(ValueAt, Samples, place) : Vector3(std::numeric_limits<double>::quiet_NaN());
}

}

TEST(LinearVelocity, IsExactBetweenUnequalNodes)
{
  for (const double x : { -1.0, -0.3, 0.5, 2.9, 4.0 })
  {
    for (const double y : { 9.0, 6.1, 4.5, 4.6, 1.7, 1.0 })
    {
      for (const double z : { 2.0, 3.3, 8.0 })
      {
        EXPECT_LT(glm::distance(Interpolated(x, y, z), Field(x, y, z)), 1e-12) << x << " " << y << " " << z;
      }
    }
  }
  EXPECT_TRUE(std::isnan(Interpolated(4.01, 4.0, 5.0).x));
  EXPECT_TRUE(std::isnan(Interpolated(0.0, 0.99, 5.0).x));
  EXPECT_TRUE(std::isnan(Interpolated(0.0, 9.01, 5.0).x));
  EXPECT_TRUE(std::isnan(Interpolated(0.0, 4.0, std::numeric_limits<double>::quiet_NaN()).x));
}

TEST(LinearVelocity, PlacesAmongEvenSamples)
{
  AxisPlace place;
  for (const double position : { 0.0, 0.7, 1.0, 2.6, 3.0 })
  {
    ASSERT_TRUE(FindPlace(4, position, place));
    EXPECT_DOUBLE_EQ(place.Index + place.Share, position);
    EXPECT_LE(place.Index, 2);
    EXPECT_LE(place.Share, 1.0);
    EXPECT_GE(place.Share, 0.0);
  }
  EXPECT_FALSE(FindPlace(4, -0.01, place));
  EXPECT_FALSE(FindPlace(4, 3.01, place));
}

// A single layer holds at any position.
TEST(LinearVelocity, OneLayerHoldsEverywhere)
{
  const std::array<Vector3, 2> values{ Vector3(1.0, 0.0, 0.0), Vector3(3.0, 0.0, 0.0) };
  std::array<AxisPlace, 3> place;
  ASSERT_TRUE(FindPlace(2, 0.25, place[0]));
  ASSERT_TRUE(FindPlace(1, -7.0, place[1]));
  ASSERT_TRUE(FindPlace(std::vector<double>{ 2.0 }, 1e9, place[2]));
  EXPECT_DOUBLE_EQ(Trilinear([&](long long n) { return values[n]; }, { 2, 1, 1 }, place).x, 1.5);
}

TEST(LinearVelocity, IsLevelWhereNoSampleRises)
{
  AxisPlace height;
  ASSERT_TRUE(FindPlace(Nodes[2], 5.0, height));
  EXPECT_TRUE(IsLevel(ValueAt, Samples, height));
  ASSERT_TRUE(FindPlace(Nodes[2], 5.1, height));
  EXPECT_FALSE(IsLevel(ValueAt, Samples, height));
}
