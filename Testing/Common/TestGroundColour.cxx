// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Constants.h"
#include "GroundColour.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace littoral;

namespace
{

int Greenness(const Colour& colour)
{
  return colour[1] - std::max(colour[0], colour[2]);
}

}

TEST(GroundColour, IsGreenBelowAndGreyWhereSteep)
{
  EXPECT_GT(Greenness(GroundColour({ 0.0, 0.0, 0.0 })), 15);
  const Colour rock = GroundColour({ 60.0 * Pi / 180.0, 0.0, 0.0 });
  EXPECT_LE(Greenness(rock), 0);
  EXPECT_LT(std::max({ rock[0], rock[1], rock[2] }) - std::min({ rock[0], rock[1], rock[2] }), 20);
}

TEST(GroundColour, IsDrierWhereTheReflectanceIsHigh)
{
  int before = 256;
  for (double reflectance : { 0.0, 0.3, 0.6, 1.0 })
  {
    const int green = Greenness(GroundColour({ 0.1, 0.2, reflectance }));
    EXPECT_LT(green, before);
    before = green;
  }
}

TEST(GroundColour, ChangesWithoutSteps)
{
  Colour before = GroundColour({ 0.0, 0.0, 0.0 });
  for (int k = 1; k <= 1000; ++k)
  {
    const double share = k / 1000.0;
    const Colour now = GroundColour({ 1.2 * share, share, share });
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_LE(std::abs(now[c] - before[c]), 2) << "at " << share;
    }
    before = now;
  }
}
