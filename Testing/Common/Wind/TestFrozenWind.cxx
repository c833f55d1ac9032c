// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../WindAlong.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

using namespace littoral;
using littoral::testing::WindAlong;

TEST(FrozenWind, CarriesGustsAlongAnyDirection)
{
  for (const double degrees : { 0.0, 90.0, 217.0 })
  {
    WindAlong wind;
    wind.Direction = degrees * Pi / 180.0;
    const FrozenWind field = wind.Field();
    double error = 0.0;
    for (const Vector3& place : { Vector3(0.0, 0.0, 5.0), Vector3(31.7, -22.2, 12.0), Vector3(-700.0, 400.0, 39.0) })
    {
      for (const double first : { 0.0, 17.25, -1003.5 })
      {
        Vector3 exact[40];
        Vector3 sampled[40];
        wind.Formula()(place, first, 40, exact);
        field.Sample(place, first, 40, sampled);
        for (int step = 0; step < 40; ++step)
        {
          error = std::max(error, glm::distance(sampled[step], exact[step]));
        }
      }
    }
    std::printf("wind towards %3.0f degrees: %.2g m/s from its formula\n", degrees, error);
    EXPECT_LT(error, 1e-5);
  }
}

TEST(FrozenWind, ArrivalIsDistanceAlongTheWindOverMeanSpeed)
{
  for (const double degrees : { 0.0, 90.0, 217.0 })
  {
    WindAlong wind;
    wind.Direction = degrees * Pi / 180.0;
    const FrozenWind field = wind.Field();
    for (const double distance : { -40.0, 0.0, 12.0, 900.0 })
    {
      for (const double aside : { -80.0, 0.0, 9.0 })
      {
        const Vector3 place = distance * wind.Along() + aside * wind.Across() + Vector3(0.0, 0.0, 7.0);
        EXPECT_NEAR(field.Arrival(place), distance / wind.Speed, 1e-9);
      }
    }
  }
}

TEST(FrozenWind, RepeatsAfterItsPeriod)
{
  const WindAlong wind;
  const FrozenWind field = wind.Field();
  EXPECT_NEAR(field.GetTimes().Period(), wind.Samples * wind.Spacing / wind.Speed, 1e-9);
  Vector3 once[5];
  Vector3 again[5];
  field.Sample({ 3.0, 2.0, 1.0 }, 7.0, 5, once);
  field.Sample({ 3.0, 2.0, 1.0 }, 7.0 + 4.0 * wind.Samples, 5, again);
  EXPECT_EQ(std::memcmp(once, again, sizeof(once)), 0);
}

TEST(FrozenWind, ReachesAcrossItsLinesAndUpToItsTop)
{
  WindAlong wind;
  wind.Direction = 1.0;
  const FrozenWind field = wind.Field();
  const auto at = [&](double along, double across, double height) {
    return field.Reaches(along * wind.Along() + across * wind.Across() + Vector3(0.0, 0.0, height));
  };
  EXPECT_TRUE(at(0.0, 0.0, 10.0));
  EXPECT_TRUE(at(1e4, 59.9, 39.9)); // it has no end along the wind
  EXPECT_TRUE(at(-1e4, -59.9, 0.0));
  EXPECT_FALSE(at(0.0, 60.1, 10.0));
  EXPECT_FALSE(at(0.0, -60.1, 10.0));
  EXPECT_FALSE(at(0.0, 0.0, 40.1));
}

TEST(FrozenWind, HeightsOverGround)
{
  // Two layers: 2 m/s at 0 m, 10 m/s at 10 m.
  FrozenWindGrid grid;
  grid.Size = { 8, 1, 2 };
  grid.ToIndex[2] = { 0.0, 0.0, 0.1, 0.0 };
  grid.LayerSpacing = 10.0;
  std::vector<float> velocities(8 * 2 * 3, 0.0f);
  for (int sample = 0; sample < 16; ++sample)
  {
    velocities[3 * sample] = sample < 8 ? 2.0f : 10.0f;
  }
  const FrozenWind field(grid, { 0.1, 8 }, velocities.data());
  Vector3 velocity;
  field.Over(100.0)({ 0.0, 0.0, 110.0 }, 0.0, 1, &velocity);
  EXPECT_NEAR(velocity.x, 10.0, 1e-6);
  field.Over(100.0)({ 0.0, 0.0, 102.5 }, 0.0, 1, &velocity);
  EXPECT_NEAR(velocity.x, 4.0, 1e-6);
  field.Over(-3.0)({ 0.0, 0.0, -3.0 }, 0.0, 1, &velocity);
  EXPECT_NEAR(velocity.x, 2.0, 1e-6);
  EXPECT_NEAR(glm::length(velocity), 2.0, 1e-6);
}

TEST(FrozenWind, EdgesAreWithinInAnyDirection)
{
  for (int degrees = 0; degrees < 360; degrees += 3)
  {
    WindAlong wind;
    wind.Direction = degrees * Pi / 180.0;
    wind.Samples = 30;
    const FrozenWind field = wind.Field();
    for (const double side : { -1.0, 1.0 })
    {
      const auto at = [&](double across, double height) {
        return field.Reaches(731.0 * wind.Along() + side * across * wind.Across() + Vector3(0.0, 0.0, height));
      };
      EXPECT_TRUE(at(60.0, 40.0)) << degrees; // but for rounding
      EXPECT_FALSE(at(60.01, 40.0)) << degrees;
      EXPECT_FALSE(at(60.0, 40.01)) << degrees;
    }
  }
}
