// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Levels of ocean models: known heights, and what each transform keeps.
#include "Currents/OceanLevels.h"
#include "Numerics/InvalidInput.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace littoral;

namespace
{

OceanLevels LevelsOf(LevelKind kind, const LevelStretching& stretching, double critical, const std::vector<double>& s)
{
  OceanLevels levels{ kind, s, {}, critical };
  for (const double one : s)
  {
    levels.Stretching.push_back(stretching.At(one));
  }
  return levels;
}

}

TEST(OceanLevels, AreThoseOfRoms)
{
  // computed elsewhere for h 100 m, hc 20 m, theta_s 7, theta_b 2, zeta 0.5 m
  const OceanLevels levels =
    LevelsOf(LevelKind::SCoordinate2, { 4, 7.0, 2.0 }, 20.0, { -1.0, -0.75, -0.5, -0.02, 0.0 });
  const double heights[] = { -100.0, -40.2921, -13.2329, 0.1615, 0.5 };
  for (int k = 0; k < 5; ++k)
  {
    EXPECT_NEAR(levels.HeightOf(k, 100.0, 0.5), heights[k], 5e-5);
  }
}

TEST(OceanLevels, StretchingEndsAtBedAndSurfaceAndRises)
{
  for (int function = 1; function <= 5; ++function)
  {
    for (const double bottom : { 0.2, 0.9 })
    {
      const LevelStretching stretching{ function, 5.0, bottom };
      EXPECT_NEAR(stretching.At(-1.0), -1.0, 1e-14) << function;
      EXPECT_NEAR(stretching.At(0.0), 0.0, 1e-14) << function;
      double last = -1.0;
      for (double s = -0.99; s < 0.0; s += 0.01)
      {
        const double here = stretching.At(s);
        EXPECT_GT(here, last) << function;
        last = here;
      }
    }
  }
  EXPECT_THROW((LevelStretching{ 6, 5.0, 0.4 }.At(-0.5)), InvalidInput);
}

TEST(OceanLevels, StretchingHasItsClosedForms)
{
  // at s = -1/2: sinh(a/2)/sinh(a) = 1/(2 cosh(a/2)); (cosh(a/2) - 1)/(cosh(a) - 1) = 1/(4 cosh^2(a/4))
  const double a = 6.0;
  const double b = 1.5;
  const double above = -0.25 / std::pow(std::cosh(0.25 * a), 2);
  EXPECT_NEAR((LevelStretching{ 1, a, 0.4 }.At(-0.5)), -0.6 * 0.5 / std::cosh(0.5 * a) - 0.4 * 0.5, 1e-14);
  EXPECT_NEAR((LevelStretching{ 2, a, 0.0 }.At(-0.5)), above, 1e-14);
  EXPECT_NEAR((LevelStretching{ 2, a, b }.At(-0.5)), 0.75 * above + 0.25 * (0.5 / std::cosh(0.5 * b) - 1.0), 1e-14);
  EXPECT_NEAR((LevelStretching{ 4, a, 0.0 }.At(-0.5)), above, 1e-14);
  EXPECT_NEAR((LevelStretching{ 4, a, b }.At(-0.5)), (std::exp(b * above) - 1.0) / (1.0 - std::exp(-b)), 1e-14);
  EXPECT_NEAR((LevelStretching{ 4, 0.0, 0.0 }.At(-0.5)), -0.25, 1e-14);
  // log(cosh(3/2))/log(cosh(3)) with both powers 1, whose mean has the weights 1/2
  const double share = std::log(std::cosh(1.5)) / std::log(std::cosh(3.0));
  EXPECT_NEAR((LevelStretching{ 3, 1.0, 1.0 }.At(-0.5)), 0.5 * (share - 1.0) - 0.5 * share, 1e-14);
  EXPECT_NEAR((LevelStretching{ 3, 2.0, 1.0 }.At(-0.5)),
    0.5 * (share - 1.0) - 0.5 * std::log(std::cosh(0.75)) / std::log(std::cosh(3.0)), 1e-14);
}

TEST(OceanLevels, AllTransformsReachBedAndSurface)
{
  for (const LevelKind kind :
    { LevelKind::Sigma, LevelKind::SCoordinate1, LevelKind::SCoordinate2, LevelKind::SOfHaidvogel })
  {
    const OceanLevels levels = LevelsOf(kind, { 1, 5.0, 0.4 }, 10.0, { -1.0, -0.5, 0.0 });
    for (const double depth : { 12.0, 400.0 })
    {
      for (const double surface : { -1.0, 0.0, 2.0 })
      {
        EXPECT_NEAR(levels.HeightOf(0, depth, surface), -depth, 1e-12 * depth);
        EXPECT_NEAR(levels.HeightOf(2, depth, surface), surface, 1e-12 * depth);
      }
    }
  }
}

TEST(OceanLevels, DifferAsTheirFormulasDo)
{
  // still water: all but Sigma and SCoordinate2 have hc s + (h - hc) C; by hand for h 50, hc 10, s -0.4, C -0.2
  const OceanLevels first{ LevelKind::SCoordinate1, { -0.4 }, { -0.2 }, 10.0 };
  EXPECT_NEAR(first.HeightOf(0, 50.0, 0.0), -12.0, 1e-13);
  EXPECT_NEAR(first.HeightOf(0, 50.0, 2.0), -12.0 + 2.0 * (1.0 - 12.0 / 50.0), 1e-13);
  const OceanLevels bent{ LevelKind::SOfHaidvogel, { -0.4 }, { -0.2 }, 10.0 };
  EXPECT_NEAR(bent.HeightOf(0, 50.0, 2.0), -12.0 + 2.0 * 0.6, 1e-13);
  const OceanLevels second{ LevelKind::SCoordinate2, { -0.4 }, { -0.2 }, 10.0 };
  EXPECT_NEAR(second.HeightOf(0, 50.0, 2.0), 2.0 - 52.0 * 14.0 / 60.0, 1e-13);
  const OceanLevels sigma{ LevelKind::Sigma, { -0.4 }, {}, 0.0 };
  EXPECT_NEAR(sigma.HeightOf(0, 50.0, 2.0), 2.0 - 0.4 * 52.0, 1e-13);
}
