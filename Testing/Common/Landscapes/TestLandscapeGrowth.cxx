// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../Drainage/RandomGround.h"
#include "../Drainage/RiverGround.h"
#include "../OnThreads.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/ValleySpreading.h"
#include "Landscapes/LandscapeGrowth.h"
#include "Landscapes/LandscapeMeasures.h"
#include "Landscapes/LongWaves.h"
#include "Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace littoral;
using namespace littoral::testing;

namespace
{

/// Rough ground that rises under rivers, smoothed a little as hillslopes are.
GridSamples PlaceWithRivers(int width, int height)
{
  GridSamples place = RandomGround(width, height, { 50.0, 50.0 }, 2);
  StreamPowerLaw law;
  law.AreaExponent = 0.5;
  law.Erodibility = 1e-4;
  GrowByStreamPower(place, BorderOutlets(width, height), law, 2e6, 200);
  SmoothGrid(place.Values, width, height, 1.0);
  return place;
}

/// Heights along x with so many of the others along y.
GridSamples Turned(const GridSamples& ground)
{
  GridSamples turned = ground;
  std::swap(turned.Width, turned.Height);
  for (int j = 0; j < ground.Height; ++j)
  {
    for (int i = 0; i < ground.Width; ++i)
    {
      turned.At(ground.Height - 1 - j, i) = ground.At(i, j);
    }
  }
  return turned;
}

}

TEST(LandscapeMeasures, KnowTheAspectsOfWaves)
{
  // waves along x alone look to the east and to the west: all folds that are even are whole
  const GridSamples waves = Ground(40, 30, { 1.0, 1.0 }, [](double x, double) { return std::sin(0.7 * x); });
  EXPECT_NEAR(AspectShare(waves, 4), 1.0, 1e-12);
  EXPECT_NEAR(AspectShare(waves, 8), 1.0, 1e-12);
  // a hill that looks all ways has none
  const GridSamples hill = Ground(81, 81, { 1.0, 1.0 },
    [](double x, double y) { return std::exp(-0.01 * ((x - 40.0) * (x - 40.0) + (y - 40.0) * (y - 40.0))); });
  EXPECT_LT(AspectShare(hill, 4), 0.01);
  EXPECT_LT(AspectShare(hill, 8), 0.01);
}

TEST(LandscapeMeasures, KolmogorovsDistanceIsThatOfShares)
{
  // even numbers from 0 to 1 and from 0.25 to 1.25: a quarter of each has no like
  std::vector<double> one;
  std::vector<double> other;
  for (int n = 0; n <= 100; ++n)
  {
    one.push_back(0.01 * n);
    other.push_back(0.01 * n + 0.25);
  }
  EXPECT_NEAR(KolmogorovDistance(one, other), 0.25, 0.011);
  EXPECT_NEAR(KolmogorovDistance(other, one), 0.25, 0.011);
  EXPECT_NEAR(KolmogorovDistance(one, one), 0.0, 0.011);
}

TEST(LandscapeMeasures, FollowClosedForms)
{
  // z = a sin kx over whole waves: mean slope 2 a k / pi but for differences, curvature a k^2 e^(-k^2 s^2 / 2) / sqrt 2
  const double k = 2.0 * Pi / 37.3;
  const GridSamples waves = Ground(402, 42, { 1.0, 1.0 }, [&](double x, double) { return 3.0 * std::sin(k * x); });
  const LandscapeMeasures measures = MeasureLandscape(waves);
  EXPECT_NEAR(measures.MeanSlope, 2.0 * 3.0 * k / Pi * std::sin(k) / k, 0.01 * measures.MeanSlope);
  EXPECT_NEAR(measures.CurvatureDeviation, 3.0 * k * k * std::exp(-2.0 * k * k) / std::sqrt(2.0),
    0.02 * measures.CurvatureDeviation);
  // |cos| under 1/4 of its mean 2/pi
  EXPECT_NEAR(measures.GentleFraction, 2.0 / Pi * std::asin(0.5 / Pi), 0.02);
  const LandscapeMeasures turned = MeasureLandscape(Turned(waves));
  EXPECT_NEAR(turned.MeanSlope, measures.MeanSlope, 1e-12);
  EXPECT_NEAR(turned.CurvatureDeviation, measures.CurvatureDeviation, 1e-12);
}

TEST(LandscapeGrowth, HasThePlacesMeasuresAndNoGrain)
{
  const GridSamples place = PlaceWithRivers(120, 100);
  const LandscapeMeasures wanted = MeasureLandscape(place);
  const GroundMeasures heights = MeasureGround(place, BorderOutlets(120, 100));
  GridSamples ground = RandomGround(130, 110, { 50.0, 50.0 }, 5);
  const CarvingReport report = GrowLandscape(ground, place, {});
  EXPECT_GT(AspectShare(place, 8), 0.2); // ground shaped along a grid
  const LandscapeMeasures is = MeasureLandscape(ground);
  EXPECT_EQ(FloodDepressions(ground, BorderOutlets(130, 110)).DepressionCells, 0u);
  EXPECT_NEAR(is.MeanSlope / wanted.MeanSlope, 1.0, 0.2);
  EXPECT_NEAR(is.CurvatureDeviation / wanted.CurvatureDeviation, 1.0, 0.25);
  EXPECT_NEAR(is.GentleFraction, wanted.GentleFraction, 0.07);
  EXPECT_NEAR(report.After.HypsometricIntegral, heights.HypsometricIntegral, 0.03);
  EXPECT_NEAR(report.After.ElevationSkewness, heights.ElevationSkewness, 0.15);
  EXPECT_LT(AspectShare(ground, 8), 0.03);
  EXPECT_LT(AspectShare(ground, 4), 0.1);
}

TEST(LandscapeGrowth, SameBytesOnAnyThreads)
{
  const GridSamples place = PlaceWithRivers(60, 50);
  GridSamples one = RandomGround(53, 66, { 50.0, 50.0 }, 5);
  GridSamples three = one;
  GridSamples other = one;
  GrowthParameters parameters;
  parameters.MaximumIterations = 2;
  GrowLandscape(one, place, parameters);
  GrowLandscape(three, place, parameters, OnThreads(3));
  EXPECT_EQ(one.Values, three.Values);
  parameters.Seed = 2;
  GrowLandscape(other, place, parameters);
  EXPECT_NE(one.Values, other.Values);
}

TEST(LandscapeGrowth, TwinOfTwoRocksHasTwo)
{
  const GridSamples place = PlaceWithRivers(60, 50);
  const GridSamples terrain = RandomGround(90, 50, { 50.0, 50.0 }, 5);
  GrowthParameters parameters;
  parameters.MaximumIterations = 0;
  // mean slope of the west over that of the east, of the landscape of such rock
  const auto contrast = [&](const GrowthRock& rock, const ParallelFor& parallel = SerialFor) {
    GridSamples ground = terrain;
    parameters.Rock = rock;
    EXPECT_EQ(WhyInvalid(terrain, parameters), "");
    GrowLandscape(ground, place, parameters, parallel);
    return MeasureLandscape(PartOf(ground, 0, 0, 45, 50)).MeanSlope /
      MeasureLandscape(PartOf(ground, 45, 0, 45, 50)).MeanSlope;
  };
  const auto west = [&](double factor) {
    std::vector<double> factors;
    for (std::size_t n = 0; n < terrain.Values.size(); ++n)
    {
      factors.push_back(n % 90 < 45 ? factor : 1.0);
    }
    return factors;
  };
  const double soft = contrast({ west(3.0), {}, {} });
  EXPECT_EQ(contrast({ west(3.0), {}, {} }, OnThreads(3)), soft);
  const double softer = soft / contrast({ west(1.0 / 3.0), {}, {} });
  const double higher = contrast({ {}, west(3.0), {} }) / contrast({ {}, west(1.0 / 3.0), {} });
  // nine times the factor, less what hillslopes and thresholds take
  EXPECT_LT(softer, 0.25);
  EXPECT_GT(higher, 4.5);
  // only ratios count
  EXPECT_NEAR(contrast({ west(1.0), std::vector<double>(90 * 50, 5.0), {} }), contrast({}), 1e-9);
}

TEST(LandscapeGrowth, FaultsLiftTheGroundByTheirThrow)
{
  const GridSamples place = PlaceWithRivers(60, 50);
  GridSamples whole = RandomGround(60, 50, { 50.0, 50.0 }, 5);
  GridSamples faulted = whole;
  GrowthParameters parameters;
  parameters.MaximumIterations = 1;
  GrowLandscape(whole, place, parameters);
  for (int n = 0; n < 60 * 50; ++n)
  {
    parameters.Rock.FaultThrow.push_back(n % 60 < 25 + n / 60 / 5 ? 40.0 : 0.0);
  }
  GrowLandscape(faulted, place, parameters);
  // rivers that the fault would dam cut through it, and nothing else changes
  int cut = 0;
  for (std::size_t n = 0; n < faulted.Values.size(); ++n)
  {
    const double lift = faulted.Values[n] - whole.Values[n];
    cut += lift < parameters.Rock.FaultThrow[n] - 1e-9 ? 1 : 0;
    EXPECT_LT(lift, parameters.Rock.FaultThrow[n] + 1e-9);
  }
  EXPECT_LT(cut, 90);
  EXPECT_EQ(FloodDepressions(faulted, BorderOutlets(60, 50)).DepressionCells, 0u);
}

TEST(LandscapeGrowth, LeavesHolesAndDrainsIntoThem)
{
  const GridSamples place = PlaceWithRivers(60, 50);
  GridSamples ground = RandomGround(60, 50, { 50.0, 50.0 }, 5);
  const auto isHole = [](int i, int j) { return (i - 25) * (i - 25) + (j - 20) * (j - 20) < 64 || i + j < 20; };
  for (int j = 0; j < 50; ++j)
  {
    for (int i = 0; i < 60; ++i)
    {
      ground.At(i, j) = isHole(i, j) ? std::numeric_limits<double>::quiet_NaN() : ground.At(i, j);
    }
  }
  GrowthParameters parameters;
  parameters.MaximumIterations = 1;
  ASSERT_EQ(WhyInvalid(ground, parameters), "");
  const CarvingReport report = GrowLandscape(ground, place, parameters);
  for (int j = 0; j < 50; ++j)
  {
    for (int i = 0; i < 60; ++i)
    {
      EXPECT_EQ(std::isnan(ground.At(i, j)), isHole(i, j));
    }
  }
  EXPECT_EQ(FloodDepressions(ground, RimOutlets(ground)).DepressionCells, 0u);
  EXPECT_EQ(report.After.DepressionFraction, 0.0);
  EXPECT_GT(report.Before.DepressionFraction, 0.0);
}

TEST(LandscapeGrowth, RefusesWhatCannotGrow)
{
  GridSamples ground = RandomGround(40, 30, { 50.0, 50.0 }, 5);
  EXPECT_EQ(WhyInvalid(ground, GrowthParameters{}), "");
  ground.Values.assign(ground.Values.size(), std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(WhyInvalid(ground, GrowthParameters{}), "The terrain has no heights.");
  EXPECT_EQ(WhyInvalid(RandomGround(40, 15, { 50.0, 50.0 }, 5), GrowthParameters{}),
    "The terrain has fewer than 16 rows or columns; no landscape can be made of it.");
  GrowthParameters parameters;
  const GridSamples good = RandomGround(40, 30, { 50.0, 50.0 }, 5);
  parameters.Rock.Erodibility = { 1.0, 2.0 };
  EXPECT_EQ(WhyInvalid(good, parameters), "Erodibility has another number of values than the terrain has cells.");
  parameters.Rock.Erodibility.assign(1200, 1.0);
  parameters.Rock.Erodibility[7] = 0.0;
  EXPECT_EQ(WhyInvalid(good, parameters), "Erodibility has values that are not between 0.001 and 1000.");
  parameters.Rock.Erodibility.clear();
  parameters.Rock.UpliftFactor.assign(1200, -1.0);
  EXPECT_EQ(WhyInvalid(good, parameters), "UpliftFactor has values that are not between 0.001 and 1000.");
  parameters.Rock.UpliftFactor.clear();
  parameters.Rock.FaultThrow.assign(1200, std::numeric_limits<double>::infinity());
  EXPECT_EQ(WhyInvalid(good, parameters), "FaultThrow has values that are not finite.");
  parameters.Rock = {};
  parameters.Steering.Smoothing = 0.0;
  EXPECT_EQ(WhyInvalid(RandomGround(40, 30, { 50.0, 50.0 }, 5), parameters),
    "Smoothing is 0 cells; it must be positive and at most 100 cells.");
}

TEST(LandscapeGrowth, RefusesPlacesWithoutSlopes)
{
  const auto place = [](double period) {
    return Ground(20, 16, { 10.0, 10.0 },
      [=](double x, double y) { return std::fmod(x / 10.0, period) + std::fmod(y / 10.0, 2.0); });
  };
  EXPECT_EQ(WhyNoPlace(place(2.0)), "The target goes up and down in turn from cell to cell; it has no slopes.");
  EXPECT_EQ(WhyNoPlace(place(3.0)), "");
}
