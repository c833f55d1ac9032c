// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../Drainage/RandomGround.h"
#include "../OnThreads.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/DrainageOutlets.h"
#include "Drainage/ValleySpreading.h"
#include "Landscapes/LandscapeQuilting.h"
#include "Landscapes/StreamLikeness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace littoral;
using namespace littoral::testing;

namespace
{

/// Measures of streams S = k A^-c of so many cells at most, with relief and heights.
StreamMeasures Streams(double concavity, double steepness, double most)
{
  StreamMeasures measures;
  measures.Filled.Concavity = concavity;
  for (double cells = 100.0; cells < most; cells *= 1.5)
  {
    measures.Filled.SlopeArea.push_back({ cells, steepness * std::pow(cells, -concavity), 10.0 });
  }
  measures.Density = 1e-3;
  measures.Hack = 0.55;
  measures.Trunks = 0.6;
  measures.Relief = { { 10.0, 5.0, 100.0 }, { 20.0, 9.0, 90.0 } };
  measures.Heights.StandardDeviation = 50.0;
  measures.Heights.HypsometricIntegral = 0.4;
  measures.Heights.ElevationSkewness = 0.2;
  measures.Heights.DepressionFraction = 0.01;
  return measures;
}

}

TEST(StreamLikeness, MisfitsAreOfToleranceLength)
{
  const StreamMeasures place = Streams(0.4, 0.8, 2000.0);
  StreamMeasures ground = place;
  ground.Heights.DepressionFraction = 0.0;
  for (const double misfit : StreamMisfits(ground, place))
  {
    EXPECT_NEAR(misfit, 0.0, 1e-12);
  }
  // 0.1 of concavity, half as steep again, a tenth more channels, relief twice as high, and so on
  ground = Streams(0.4, 1.2, 9000.0);
  ground.Filled.Concavity = 0.5;
  ground.Density = 1.1e-3;
  ground.Hack = 0.5;
  ground.Trunks = 0.3;
  ground.Relief[1].Height = 18.0;
  ground.Heights.HypsometricIntegral = 0.46;
  ground.Heights.ElevationSkewness = 0.05;
  ground.Heights.DepressionFraction = 0.05;
  const std::vector<double> misfits = StreamMisfits(ground, place);
  const std::vector<double> expected{ 1.0, 0.5 / 0.15, 0.5, 5.0, 1.0, 2.0, 2.0, 1.0, 1.0 };
  ASSERT_EQ(misfits.size(), expected.size());
  for (std::size_t n = 0; n < expected.size(); ++n)
  {
    EXPECT_NEAR(misfits[n], expected[n], 1e-9);
  }
  // a small map's trunk valley is a short one
  StreamMeasures flat = place;
  flat.Trunks = 0.1;
  ground.Trunks = 0.3;
  EXPECT_NEAR(StreamMisfits(ground, flat)[5], 2.0, 1e-9);
  // relief is over the deviation of heights
  ground.Relief = place.Relief;
  ground.Heights.StandardDeviation = 25.0;
  EXPECT_NEAR(StreamMisfits(ground, place)[3], 5.0, 1e-9);
}

TEST(StreamLikeness, WhatThePlaceDoesNotTellIsLeftOut)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  StreamMeasures place = Streams(0.4, 0.8, 2000.0);
  StreamMeasures ground = place;
  ground.Density = none;
  EXPECT_TRUE(std::isinf(StreamMisfits(ground, place)[2]));
  place.Density = none;
  EXPECT_EQ(StreamMisfits(ground, place).size(), 8U);
  EXPECT_NEAR(SumOfMisfits({ 0.0, 1.0, 2.0, std::numeric_limits<double>::infinity() }), 0.5 + 0.8 + 1.0, 1e-12);
}

TEST(StreamLikeness, SmallQuiltsAreTheLikestOfSomeDraws)
{
  const auto hills = [](int seed) {
    GridSamples ground = RandomGround(90, 80, { 10.0, 10.0 }, seed);
    const std::vector<double> rough = ground.Values;
    SmoothGrid(ground.Values, 90, 80, 6.0);
    for (std::size_t n = 0; n < rough.size(); ++n)
    {
      ground.Values[n] = 60.0 * ground.Values[n] + 0.2 * rough[n];
    }
    return ground;
  };
  GridSamples place = hills(1);
  place.Values = FloodDepressions(place, BorderOutlets(90, 80)).SpillElevation;
  const StreamMeasures streams = MeasureStreams(place, 100);
  // 1.45; of the first draws alone 1.84
  double sum = 0.0;
  for (const int seed : { 2, 3, 4, 5 })
  {
    GridSamples twin = hills(seed);
    QuiltLandscape(twin, place, seed, OnThreads(2));
    if (seed == 2)
    {
      GridSamples serial = hills(seed);
      QuiltLandscape(serial, place, seed);
      EXPECT_EQ(serial.Values, twin.Values);
    }
    sum += SumOfMisfits(StreamMisfits(MeasureStreams(twin, 100), streams)) / 4.0;
  }
  EXPECT_LT(sum, 1.65);
}
