// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Rotated poles by what they must keep, lengths on WGS 84 by published ones, middles and jumps of longitudes.
#include "Geometry/EarthGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace littoral;

TEST(EarthGrid, RotatedPoleIsWhereItIsSaid)
{
  const RotatedPole pole{ -162.0, 39.25, 0.0 };
  EXPECT_LT(AngleBetween(pole.ToEarth({ 0.0, 90.0 }), { -162.0, 39.25 }), 1e-10);
  // the true pole lies on the grid's meridian 0, at the latitude of the grid's pole
  EXPECT_LT(AngleBetween(pole.ToEarth({ 0.0, 39.25 }), { 0.0, 90.0 }), 1e-10);
  // the grid's origin is opposite of its pole's meridian: the middle of the European domains with this pole
  EXPECT_LT(AngleBetween(pole.ToEarth({ 0.0, 0.0 }), { 18.0, 50.75 }), 1e-10);
  // east on the grid is east on earth there
  EXPECT_GT(pole.ToEarth({ 1.0, 0.0 })[0], 18.0);
  const RotatedPole turned{ -162.0, 39.25, 30.0 };
  EXPECT_LT(AngleBetween(turned.ToEarth({ 30.0, 0.0 }), { 18.0, 50.75 }), 1e-10);
}

TEST(EarthGrid, RotationKeepsAnglesAndTheOldPoleChangesNothing)
{
  const RotatedPole pole{ 100.0, -20.0, -40.0 };
  const RotatedPole same;
  const EarthPlace places[] = { { 10.0, 20.0 }, { -170.0, 60.0 }, { 90.0, -80.0 }, { 179.0, 0.0 } };
  for (const EarthPlace& a : places)
  {
    EXPECT_LT(AngleBetween(same.ToEarth(a), a), 1e-10);
    for (const EarthPlace& b : places)
    {
      EXPECT_NEAR(AngleBetween(pole.ToEarth(a), pole.ToEarth(b)), AngleBetween(a, b), 1e-9);
    }
  }
}

TEST(EarthGrid, LengthsAreThoseOfWgs84)
{
  // a degree at latitudes 0, 45 and 90: 111319.49, 78846.81, 0 m along the parallel, 110574.28, 111131.75 and
  // 111693.98 m along the meridian
  const double degree = std::acos(-1.0) / 180.0;
  const double along[] = { 111319.49, 78846.81, 0.0 };
  const double up[] = { 110574.28, 111131.75, 111693.98 };
  for (int n = 0; n < 3; ++n)
  {
    const auto metres = MetresPerRadian(45.0 * n);
    EXPECT_NEAR(metres[0] * degree, along[n], 0.1);
    EXPECT_NEAR(metres[1] * degree, up[n], 0.1);
  }
}

TEST(EarthGrid, LongitudesGoOnAcrossTheirJump)
{
  std::vector<double> longitudes{ 170.0, 175.0, 180.0, -175.0, -170.0 };
  Unwrap(longitudes);
  EXPECT_EQ(longitudes, (std::vector<double>{ 170.0, 175.0, 180.0, 185.0, 190.0 }));
  EXPECT_LT(AngleBetween(MiddleOf({ { 170.0, 10.0 }, { -170.0, 10.0 } }), { 180.0, 10.15 }), 0.01);
  EXPECT_LT(AngleBetween(MiddleOf({ { 5.0, 10.0 }, { -175.0, -10.0 } }), { 5.0, 10.0 }), 1e-9);
}
