// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/PlaceUnits.h"
#include "Numerics/InvalidInput.h"

#include <gtest/gtest.h>

#include <string>

using namespace littoral;

namespace
{

PlaceUnit ByUnits(const char* x, const char* y)
{
  return UnitOfPlaces({ "x", x, 0.0, 1e6 }, { "y", y, 0.0, 1e6 }, FarForFile);
}

PlaceKind ByNames(const char* x, const char* y)
{
  return UnitOfPlaces({ x, "", 0.0, 30.0 }, { y, "", 0.0, 20.0 }, FarForFile).Kind;
}

PlaceKind ByNumbers(double west, double east, double south, double north, double far = FarForFile)
{
  return UnitOfPlaces({ "", "", west, east }, { "", "", south, north }, far).Kind;
}

}

TEST(PlaceUnits, UnitsDecide)
{
  for (const char* unit : { "degrees_east", "Degrees_North", "degree", "deg", "radians" })
  {
    EXPECT_EQ(ByUnits(unit, unit).Kind, PlaceKind::Degrees) << unit;
  }
  EXPECT_EQ(ByUnits("km", "km").Metres, 1000.0);
  EXPECT_EQ(ByUnits("", "Meters").Metres, 1.0);
  EXPECT_EQ(ByUnits("US survey foot", "").Metres, 1200.0 / 3937.0);
  EXPECT_TRUE(ByUnits("km", "km").IsSaid);
  EXPECT_FALSE(ByUnits("", "").IsSaid);
  EXPECT_FALSE(ByUnits("1", "1").IsSaid);
  EXPECT_THROW(ByUnits("parsec", "parsec"), InvalidInput);
  // Lengths that are named as such are lengths, whatever their numbers.
  EXPECT_EQ(UnitOfPlaces({ "lon", "m", 5.0, 6.0 }, { "lat", "m", 41.0, 42.0 }, FarForFile).Kind, PlaceKind::Lengths);
}

TEST(PlaceUnits, NamesDecide)
{
  EXPECT_EQ(ByNames("lon", "lat"), PlaceKind::Degrees);
  EXPECT_EQ(ByNames("Longitude", "LATITUDE"), PlaceKind::Degrees);
  EXPECT_EQ(ByNames("rlon", "rlat"), PlaceKind::TurnedDegrees);
  EXPECT_EQ(ByNames("x", "y"), PlaceKind::Lengths);
  EXPECT_EQ(ByNames("lon", "height"), PlaceKind::Lengths);
  EXPECT_EQ(UnitOfPlaces({ "rlon", "degrees", 0.0, 9.0 }, { "rlat", "degrees", 0.0, 9.0 }, FarForFile).Kind,
    PlaceKind::TurnedDegrees);
}

TEST(PlaceUnits, NumbersDecide)
{
  EXPECT_EQ(ByNumbers(5.0, 14.0, 41.0, 50.0), PlaceKind::Degrees);
  EXPECT_EQ(ByNumbers(355.0, 362.0, 40.0, 45.0), PlaceKind::Degrees); // past the meridian
  EXPECT_EQ(ByNumbers(-180.0, 180.0, -90.0, 90.0), PlaceKind::Degrees);
  EXPECT_EQ(ByNumbers(0.0, 360.0, -90.0, 90.0, FarForPoints), PlaceKind::Degrees);
  EXPECT_EQ(ByNumbers(3.0, 7.0, 56.0, 60.0, FarForGrid), PlaceKind::Degrees);
  EXPECT_EQ(ByNumbers(11.5, 11.501, 48.1, 48.101, FarForPoints), PlaceKind::Degrees);
  // Plots begin at the origin, maps lie far beyond, and some points of a plot are no map.
  EXPECT_EQ(ByNumbers(0.0, 100.0, 0.0, 80.0), PlaceKind::Lengths);
  EXPECT_EQ(ByNumbers(-50.0, 50.0, -50.0, 50.0), PlaceKind::Lengths);
  EXPECT_EQ(ByNumbers(60.0, 90.0, 60.0, 80.0, FarForPoints), PlaceKind::Lengths);
  EXPECT_EQ(ByNumbers(0.0, 360.0, 0.0, 90.0), PlaceKind::Lengths);
  EXPECT_EQ(ByNumbers(5e5, 5.0001e5, 4e6, 4.0001e6), PlaceKind::Lengths);
  EXPECT_EQ(ByNumbers(500.0, 501.0, 40.0, 41.0, FarForFile), PlaceKind::Degrees);
  EXPECT_EQ(ByNumbers(541.0, 542.0, 40.0, 41.0, FarForFile), PlaceKind::Lengths);
  EXPECT_EQ(ByNumbers(5.0, 6.0, 91.0, 92.0, FarForFile), PlaceKind::Lengths);
}

TEST(PlaceUnits, UnitsOfLength)
{
  EXPECT_EQ(FindUnitOfLength("FEET")->Metres, 0.3048);
  EXPECT_EQ(std::string(FindUnitOfLength("dm")->Words), "decimetres");
  EXPECT_EQ(FindUnitOfLength("mm")->Metres, 0.001);
  EXPECT_EQ(FindUnitOfLength(""), nullptr);
  EXPECT_EQ(FindUnitOfLength("K"), nullptr);
  EXPECT_EQ(FindUnitOfLength("gpm"), nullptr);
  EXPECT_EQ(FindUnitOfHeight("ft")->Metres, 0.3048);
  EXPECT_EQ(FindUnitOfHeight("gpm")->Metres, 1.0);
  EXPECT_NEAR(FindUnitOfHeight("m**2 s**-2")->Metres, 1.0 / 9.80665, 1e-15);
  EXPECT_EQ(FindUnitOfHeight("K"), nullptr);
}
