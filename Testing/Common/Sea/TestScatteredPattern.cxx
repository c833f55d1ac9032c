// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Patterns of light after a way through water, against rays that are followed one by one.
#include "Sea/ScatteredPattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace
{

using littoral::ContrastAfter;
using littoral::ScatteredPattern;
using littoral::ScatteringWay;

constexpr double Turn = 6.283185307179586;

struct Ray
{
  double X = 0.0; ///< slopes across the light
  double Y = 0.0;
};

/// Angle of a scattering by Henyey and Greenstein's law, of which a number from 0 to 1 is the part that goes further.
double AngleOf(double part, double g)
{
  const double s = (1.0 - g * g) / (1.0 - g + 2.0 * g * part);
  return std::acos(std::clamp((1.0 + g * g - s * s) / (2.0 * g), -1.0, 1.0));
}

/// Mean of cos(k x) over rays that begin at 0 and are scattered on their way.
double ContrastOfRays(double waveNumber, const ScatteringWay& way, int rays)
{
  std::mt19937 numbers(7);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::exponential_distribution<double> free(way.Scattering);
  double sum = 0.0;
  for (int ray = 0; ray < rays; ++ray)
  {
    Ray slope;
    double x = 0.0;
    double left = way.Length;
    for (double step = free(numbers); step < left; step = free(numbers))
    {
      x += slope.X * step;
      left -= step;
      const double angle = AngleOf(part(numbers), way.Forward);
      const double around = Turn * part(numbers);
      slope.X += angle * std::cos(around);
      slope.Y += angle * std::sin(around);
    }
    sum += std::cos(waveNumber * (x + slope.X * left));
  }
  return sum / rays;
}

TEST(ScatteredPattern, ContrastIsThatOfRays)
{
  for (const ScatteringWay& way :
    { ScatteringWay{ 5.0, 0.06, 0.9 }, ScatteringWay{ 5.0, 0.3, 0.9 }, ScatteringWay{ 2.0, 0.5, 0.95 } })
  {
    for (const double wave : { 0.2, 0.5, 1.0, 3.0 })
    {
      // Angles of up to pi are not small: the law in small angles has a part 1 - 2 g / (1 + g) of them beyond.
      const double k = Turn / wave;
      EXPECT_NEAR(ContrastAfter(k, way), ContrastOfRays(k, way, 60000), 0.035) << wave << " " << way.Length;
    }
  }
  EXPECT_DOUBLE_EQ(ContrastAfter(0.0, { 5.0, 1.0, 0.9 }), 1.0);
  // What is scattered is all lost for the smallest patterns.
  EXPECT_NEAR(ContrastAfter(1e6, { 5.0, 0.3, 0.9 }), std::exp(-1.5), 1e-4);
}

TEST(ScatteredPattern, WavesKeepTheirPlaceAndTheMeanStays)
{
  constexpr int places = 32;
  constexpr double side = 6.4;
  const ScatteringWay way{ 4.0, 0.2, 0.9 };
  std::vector<double> light(places * places);
  const auto wave = [](int place) {
    return std::cos(Turn * (3.0 * (place % places) - 2.0 * (place / places)) / places);
  };
  for (int place = 0; place < places * places; ++place)
  {
    light[place] = 1.0 + 0.5 * wave(place);
  }
  const std::vector<double> found = ScatteredPattern(light, places, side, way);
  const double contrast = ContrastAfter(Turn * std::sqrt(13.0) / side, way);
  EXPECT_LT(contrast, 0.9);
  for (int place = 0; place < places * places; ++place)
  {
    ASSERT_NEAR(found[place], 1.0 + 0.5 * contrast * wave(place), 1e-12);
  }
}

}
