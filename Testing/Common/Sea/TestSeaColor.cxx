// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The color of the sea: Fresnel's equations, and what the eye knows of foam, haze, crests and the sky.
#include "Numerics/Constants.h"
#include "Sea/SeaColor.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace littoral;

namespace
{

/// Reflectance of unpolarized light by Fresnel's equations, from air into water.
double Fresnel(double cosine)
{
  const double index = 1.333;
  const double sine = std::sqrt(1.0 - cosine * cosine) / index;
  const double inside = std::sqrt(1.0 - sine * sine);
  const double across = (cosine - index * inside) / (cosine + index * inside);
  const double along = (index * cosine - inside) / (index * cosine + inside);
  return 0.5 * (across * across + along * along);
}

int Sum(const Color& color)
{
  return color[0] + color[1] + color[2];
}

/// A place that is seen at an angle from straight above [degrees].
SeaPlace SeenAt(double degrees)
{
  SeaPlace place;
  place.ToEye = Vector3(std::sin(degrees * Pi / 180.0), 0.0, std::cos(degrees * Pi / 180.0));
  return place;
}

}

TEST(SeaColor, ReflectanceIsFresnelsButForAFewPercent)
{
  for (int degrees = 0; degrees <= 90; ++degrees)
  {
    const double cosine = std::cos(degrees * Pi / 180.0);
    // Schlick's own error for water, with its full factors, is 0.0093 at most up to 60 degrees and 0.059 at 84.
    EXPECT_NEAR(WaterReflectance(cosine), Fresnel(cosine), degrees <= 60 ? 0.01 : 0.06) << degrees;
  }
  EXPECT_NEAR(WaterReflectance(1.0), 0.0204, 0.001);
  EXPECT_EQ(WaterReflectance(0.0), 1.0);
  EXPECT_EQ(WaterReflectance(-0.5), 1.0); // as at the edge of what is seen
  EXPECT_EQ(WaterReflectance(1.5), WaterReflectance(1.0));
}

TEST(SeaColor, WaterSeenFromAboveIsDarkAndGrazedWaterIsSky)
{
  const Color above = SeaColor(SeenAt(0.0));
  const Color grazed = SeaColor(SeenAt(89.9));
  EXPECT_LT(Sum(above), 300);
  EXPECT_GT(above[2], above[0]);
  // Haze far away has the color of the sky at the horizon, and so has its image in the sea.
  SeaPlace far;
  far.Distance = 1e6;
  const Color haze = SeaColor(far);
  for (int channel = 0; channel < 3; ++channel)
  {
    EXPECT_NEAR(grazed[channel], haze[channel], 8);
  }
}

TEST(SeaColor, FoamIsWhiteWhereTheSurfaceNearlyFolds)
{
  SeaPlace place;
  const Color water = SeaColor(place);
  place.Jacobian = FoamBegins;
  EXPECT_EQ(SeaColor(place), water);
  int before = Sum(water);
  for (int step = 0; FoamBegins - 0.02 * step >= 0.1; ++step)
  {
    place.Jacobian = FoamBegins - 0.02 * step;
    EXPECT_GE(Sum(SeaColor(place)), before);
    before = Sum(SeaColor(place));
  }
  place.Jacobian = -1.0;
  const Color foam = SeaColor(place);
  EXPECT_GT(Sum(foam), 700);
  EXPECT_LT(foam[2] - foam[0], 10);
}

TEST(SeaColor, CrestsAreGreenerAndBrighterThanTroughs)
{
  SeaPlace crest;
  crest.Height = 2.0;
  SeaPlace trough;
  trough.Height = -2.0;
  const Color bright = SeaColor(crest);
  const Color dark = SeaColor(trough);
  EXPECT_GT(Sum(bright), Sum(dark) + 60);
  EXPECT_GT(bright[1] - bright[2], dark[1] - dark[2]);
}
