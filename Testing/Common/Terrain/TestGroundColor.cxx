// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Terrain/GroundColor.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace littoral;

namespace
{

int Greenness(const Color& color)
{
  return color[1] - std::max(color[0], color[2]);
}

}

TEST(GroundColor, IsGreenBelowAndGreyWhereSteep)
{
  EXPECT_GT(Greenness(GroundColor({ 0.0, 0.0, 0.0 })), 15);
  const Color rock = GroundColor({ 60.0 * Pi / 180.0, 0.0, 0.0 });
  EXPECT_LE(Greenness(rock), 0);
  EXPECT_LT(std::max({ rock[0], rock[1], rock[2] }) - std::min({ rock[0], rock[1], rock[2] }), 20);
}

TEST(GroundColor, IsDrierWhereTheReflectanceIsHigh)
{
  int before = 256;
  for (double reflectance : { 0.0, 0.3, 0.6, 1.0 })
  {
    const int green = Greenness(GroundColor({ 0.1, 0.2, reflectance }));
    EXPECT_LT(green, before);
    before = green;
  }
}

TEST(GroundColor, IsDarkGreenBesideStreamsAndNotOnTheirRocks)
{
  const Color dry = GroundColor({ 0.1, 0.2, 0.8 });
  const Color wet = GroundColor({ 0.1, 0.2, 0.8, 12.0 });
  EXPECT_EQ(GroundColor({ 0.1, 0.2, 0.8, 3.0 }), dry);
  EXPECT_GT(Greenness(wet), Greenness(dry));
  EXPECT_LT(wet[1], dry[1]);
  EXPECT_EQ(GroundColor({ 60.0 * Pi / 180.0, 0.2, 0.8, 12.0 }), GroundColor({ 60.0 * Pi / 180.0, 0.2, 0.8 }));
}

TEST(GroundColor, ChangesWithoutSteps)
{
  Color before = GroundColor({ 0.0, 0.0, 0.0 });
  for (int k = 1; k <= 1000; ++k)
  {
    const double share = k / 1000.0;
    const Color now = GroundColor({ 1.2 * share, share, share, 12.0 * share });
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_LE(std::abs(now[c] - before[c]), 2) << "at " << share;
    }
    before = now;
  }
}
