// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The sun's place against the worked example of NREL's algorithm, against almanacs' sunrises, and symmetries.
#include "Light/SunPosition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using littoral::SunAngles;
using littoral::SunAt;
using littoral::UniversalTime;

TEST(SunPosition, ExampleOfReda)
{
  // Reda and Andreas 2004: 2003-10-17, 19:30:30 UTC, 39.742476 N, 105.1786 W
  const SunAngles sun = SunAt({ 2003, 10, 17, 19.0 + 30.5 / 60.0 }, 39.742476, -105.1786);
  EXPECT_NEAR(90.0 - sun.Elevation, 50.11162, 0.01);
  EXPECT_NEAR(sun.Azimuth, 194.34024, 0.01);
}

TEST(SunPosition, SeasonsAndHours)
{
  // At solstices and equinoxes the sun culminates at 90 - latitude + declination.
  const auto highest = [](int month, int day, double latitude) {
    double most = -90.0;
    for (double hour = 0.0; hour < 24.0; hour += 0.01)
    {
      most = std::max(most, SunAt({ 2025, month, day, hour }, latitude, 20.0).Elevation);
    }
    return most;
  };
  EXPECT_NEAR(highest(6, 21, 50.0), 40.0 + 23.436, 0.02);
  EXPECT_NEAR(highest(12, 21, 50.0), 40.0 - 23.436 + 0.054, 0.02); // refraction lifts it by 3.3'
  EXPECT_NEAR(highest(3, 20, -35.0), 55.0, 0.2);
  // Places fifteen degrees apart see the same sun an hour apart, but for its way among the stars.
  const SunAngles east = SunAt({ 2024, 4, 4, 9.0 }, 10.0, 30.0);
  const SunAngles west = SunAt({ 2024, 4, 4, 10.0 }, 10.0, 15.0);
  EXPECT_NEAR(east.Elevation, west.Elevation, 0.02);
  EXPECT_NEAR(east.Azimuth, west.Azimuth, 0.06); // it goes 0.04 degrees an hour
  // A day before midnight is the day before; months and years go on.
  const SunAngles newYear = SunAt({ 2024, 12, 31, 25.0 }, 10.0, 30.0);
  EXPECT_NEAR(newYear.Elevation, SunAt({ 2025, 1, 1, 1.0 }, 10.0, 30.0).Elevation, 1e-9);
  EXPECT_NEAR(SunAt({ 2024, 2, 29, 24.0 }, 5.0, 0.0).Azimuth, SunAt({ 2024, 3, 1, 0.0 }, 5.0, 0.0).Azimuth, 1e-9);
}

TEST(SunPosition, SunriseOfTheAlmanac)
{
  // Greenwich, 2025-06-21: the upper limb rises at 03:43 and sets at 20:21 UTC (HM Nautical Almanac Office).
  EXPECT_NEAR(SunAt({ 2025, 6, 21, 3.0 + 43.0 / 60.0 }, 51.4769, 0.0).Elevation, -0.2666, 0.15);
  EXPECT_NEAR(SunAt({ 2025, 6, 21, 20.0 + 21.0 / 60.0 }, 51.4769, 0.0).Elevation, -0.2666, 0.15);
}

TEST(SunPosition, DirectionsAndAngles)
{
  const littoral::Vector3 east = DirectionOf(SunAngles{ 0.0, 90.0 });
  EXPECT_NEAR(east.x, 1.0, 1e-15);
  for (const SunAngles angles : { SunAngles{ 31.0, 12.0 }, SunAngles{ -31.0, 190.0 }, SunAngles{ 5.0, 359.0 } })
  {
    const SunAngles back = littoral::AnglesOf(3.0 * DirectionOf(angles));
    EXPECT_NEAR(back.Elevation, angles.Elevation, 1e-12);
    EXPECT_NEAR(back.Azimuth, angles.Azimuth, 1e-12);
  }
}

TEST(SunPosition, NamesBadTimes)
{
  EXPECT_EQ(littoral::WhyInvalid(UniversalTime{}), "");
  EXPECT_EQ(littoral::WhyInvalid(UniversalTime{ 2026, 13, 1, 0.0 }).rfind("Month", 0), 0U);
  EXPECT_EQ(littoral::WhyInvalid(UniversalTime{ 2026, 1, 0, 0.0 }).rfind("Day", 0), 0U);
  EXPECT_EQ(littoral::WhyInvalid(UniversalTime{ 2026, 1, 1, std::nan("") }).rfind("Hours", 0), 0U);
}

}
