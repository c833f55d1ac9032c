// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/UtmZone.h"

#include <gtest/gtest.h>

#include <limits>

using littoral::UtmZone;
using littoral::UtmZoneOf;

TEST(UtmZone, IsThatOfThePlace)
{
  // Zones as maps of these towns name them.
  struct Town
  {
    double Longitude, Latitude;
    int Number;
    bool IsNorth;
  };
  const Town towns[] = { { -84.3, 36.4, 16, true }, { 13.4, 52.5, 33, true }, { -0.1, 51.5, 30, true },
    { 151.2, -33.9, 56, false }, { -70.7, -33.4, 19, false }, { 139.7, 35.7, 54, true }, { -155.5, 19.6, 5, true } };
  for (const Town& town : towns)
  {
    const UtmZone zone = UtmZoneOf(town.Longitude, town.Latitude);
    EXPECT_EQ(zone.Number, town.Number) << town.Longitude;
    EXPECT_EQ(zone.IsNorth, town.IsNorth) << town.Longitude;
  }
}

TEST(UtmZone, HasItsEdges)
{
  for (int number = 1; number <= 60; ++number)
  {
    const double west = -180.0 + 6.0 * (number - 1);
    EXPECT_EQ(UtmZoneOf(west, 10.0).Number, number);
    EXPECT_EQ(UtmZoneOf(west + 6.0 - 1e-9, -10.0).Number, number);
    EXPECT_EQ(UtmZoneOf(west + 363.0, 0.0).Number, number); // the same place, counted on
  }
  EXPECT_EQ(UtmZoneOf(180.0, 0.0).Number, 1);
}

TEST(UtmZone, KnowsNorwayAndSvalbard)
{
  EXPECT_EQ(UtmZoneOf(5.3, 60.4).Number, 32); // Bergen, which would be in 31
  EXPECT_EQ(UtmZoneOf(5.3, 55.9).Number, 31);
  EXPECT_EQ(UtmZoneOf(5.3, 64.0).Number, 31);
  EXPECT_EQ(UtmZoneOf(15.6, 78.2).Number, 33); // Longyearbyen
  EXPECT_EQ(UtmZoneOf(8.0, 78.0).Number, 31);
  EXPECT_EQ(UtmZoneOf(25.0, 80.0).Number, 35);
  EXPECT_EQ(UtmZoneOf(40.0, 80.0).Number, 37);
  EXPECT_EQ(UtmZoneOf(42.0, 80.0).Number, 38);
}

TEST(UtmZone, EndsNearThePoles)
{
  EXPECT_EQ(UtmZoneOf(0.0, 84.1).Number, 0);
  EXPECT_EQ(UtmZoneOf(0.0, -80.1).Number, 0);
  EXPECT_EQ(UtmZoneOf(3.0, 84.0).Number, 31);
  EXPECT_EQ(UtmZoneOf(std::numeric_limits<double>::quiet_NaN(), 0.0).Number, 0);
  EXPECT_EQ(UtmZoneOf(0.0, std::numeric_limits<double>::quiet_NaN()).Number, 0);
}
