// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "Numerics/FourierGrid.h"
#include "Numerics/RandomStream.h"
#include "Terrain/GridSamples.h"
#include "Terrain/Variogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace littoral;
using littoral::testing::OnThreads;

namespace
{

GridSamples Noise(int width, int height, double missing = 0.0)
{
  const RandomStream random(5, RandomPurpose::ElevationLines);
  GridSamples samples;
  samples.Width = width;
  samples.Height = height;
  samples.Spacing = { 2.0, 3.0 };
  for (int n = 0; n < width * height; ++n)
  {
    const bool isMissing = random.UniformPair(n, 1)[0] < missing;
    samples.Values.push_back(isMissing ? std::numeric_limits<double>::quiet_NaN() : 100.0 + random.NormalPair(n, 0)[0]);
  }
  return samples;
}

}

TEST(FourierGrid, GivesBackWhatWentIn)
{
  FourierGrid grid(30, 18);
  for (int j = 0; j < 18; ++j)
  {
    for (int i = 0; i < 30; ++i)
    {
      grid.At(i, j) = { std::sin(1.0 + i * j), i - 0.5 * j };
    }
  }
  const FourierGrid before = grid;
  grid.Forward();
  std::complex<double> sum = 0.0;
  for (int n = 0; n < 30 * 18; ++n)
  {
    sum += before.At(n % 30, n / 30);
  }
  EXPECT_NEAR(std::abs(grid.At(0, 0) - sum), 0.0, 1e-9);
  grid.Backward(OnThreads(2));
  for (int n = 0; n < 30 * 18; ++n)
  {
    EXPECT_NEAR(std::abs(grid.At(n % 30, n / 30) / (30.0 * 18.0) - before.At(n % 30, n / 30)), 0.0, 1e-12);
  }
}

TEST(FourierGrid, FastLengthsAreProductsOfSmallPrimes)
{
  EXPECT_EQ(NextFastLength(1), 1);
  EXPECT_EQ(NextFastLength(7), 8);
  EXPECT_EQ(NextFastLength(121), 125);
  EXPECT_EQ(NextFastLength(1024), 1024);
}

TEST(Variogram, AgreesWithCountingAllPairs)
{
  const GridSamples samples = Noise(23, 17, 0.2);
  const VariogramMap map = ComputeVariogramMap(samples, 30.0);
  ASSERT_EQ(map.LagWidth, 15);
  ASSERT_EQ(map.LagHeight, 10);
  for (int j = 0; j <= map.LagHeight; ++j)
  {
    for (int i = -map.LagWidth; i <= map.LagWidth; ++i)
    {
      double sum = 0.0;
      int pairs = 0;
      for (int y = 0; y + j < 17; ++y)
      {
        for (int x = std::max(0, -i); x + std::max(0, i) < 23; ++x)
        {
          const double difference = samples.At(x, y) - samples.At(x + i, y + j);
          if (!std::isnan(difference))
          {
            sum += 0.5 * difference * difference;
            ++pairs;
          }
        }
      }
      ASSERT_EQ(map.Pairs[map.Index(i, j)], pairs) << i << ", " << j;
      if (pairs > 0)
      {
        ASSERT_NEAR(map.Semivariance[map.Index(i, j)], sum / pairs, 1e-9) << i << ", " << j;
      }
    }
  }
}

TEST(Variogram, DoesNotDependOnThreads)
{
  const GridSamples samples = Noise(64, 50);
  const VariogramMap one = ComputeVariogramMap(samples, 40.0);
  const VariogramMap two = ComputeVariogramMap(samples, 40.0, OnThreads(2));
  EXPECT_EQ(one.Semivariance, two.Semivariance);
  EXPECT_EQ(one.Pairs, two.Pairs);
  const std::vector<LagBin> bins = BinVariogram(one, 90.0, 8, 5);
  const std::vector<LagBin> again = BinVariogram(one, 90.0, 8, 5, OnThreads(3));
  ASSERT_EQ(bins.size(), again.size());
  for (std::size_t n = 0; n < bins.size(); ++n)
  {
    EXPECT_EQ(bins[n].Semivariance, again[n].Semivariance) << n;
    EXPECT_EQ(bins[n].Separation, again[n].Separation) << n;
  }
}

TEST(Variogram, BinsKeepAllPairsOnce)
{
  const GridSamples samples = Noise(40, 31, 0.1);
  const VariogramMap map = ComputeVariogramMap(samples, 1e9);
  const double count = static_cast<double>(Moments(samples).Count);
  for (int directions : { 1, 4, 12 })
  {
    double pairs = 0.0;
    for (const LagBin& bin : BinVariogram(map, 1000.0, 20, directions))
    {
      pairs += bin.Pairs;
      EXPECT_NEAR(std::hypot(bin.Separation[0], bin.Separation[1]), bin.Lag, 1e-9);
    }
    EXPECT_EQ(pairs, 0.5 * count * (count - 1.0)) << directions;
  }
}

TEST(Variogram, SectorsPointTheirWay)
{
  const VariogramMap map = ComputeVariogramMap(Noise(60, 60), 60.0);
  for (const LagBin& bin : BinVariogram(map, 60.0, 5, 6))
  {
    const double angle = std::atan2(bin.Separation[1], bin.Separation[0]) * 180.0 / 3.14159265358979;
    const double off = std::remainder(angle - 30.0 * bin.Direction, 180.0);
    EXPECT_LT(std::abs(off), 15.0) << bin.Direction << " at " << bin.Lag;
  }
}

TEST(Variogram, RingsAreAsWideAsSaid)
{
  const VariogramMap map = ComputeVariogramMap(Noise(60, 60), 60.0);
  for (int rings : { 4, 15 })
  {
    int last = -1;
    for (const LagBin& bin : BinVariogram(map, 60.0, rings, 1))
    {
      // Ring k ends at ((k + 1) / rings)^2 of the longest lag.
      EXPECT_GE(bin.Lag, 60.0 * std::pow(double(bin.Ring) / rings, 2));
      EXPECT_LE(bin.Lag, 60.0 * std::pow((bin.Ring + 1.0) / rings, 2));
      EXPECT_GT(bin.Ring, last);
      last = bin.Ring;
    }
    EXPECT_EQ(last, rings - 1);
  }
}

TEST(GridSamples, MomentsByHand)
{
  GridSamples samples;
  samples.Width = 2;
  samples.Height = 2;
  samples.Values = { 1.0, std::numeric_limits<double>::quiet_NaN(), 2.0, 6.0 };
  const SampleMoments moments = Moments(samples);
  EXPECT_EQ(moments.Count, 3u);
  EXPECT_DOUBLE_EQ(moments.Mean, 3.0);
  EXPECT_DOUBLE_EQ(moments.Variance, 14.0 / 3.0); // (4 + 1 + 9) / 3
}

TEST(GridSamples, SlopesOfALongGridAreItsOwn)
{
  GridSamples samples = Noise(45, 8); // 90 m by 24 m
  for (int j = 0; j < 8; ++j)
  {
    for (int i = 0; i < 45; ++i)
    {
      samples.At(i, j) = 3.0 - 0.25 * (i - 22.0) * 2.0 + 0.75 * (j - 3.5) * 3.0;
    }
  }
  const PlaneTrend trend = RemovePlane(samples);
  EXPECT_NEAR(trend.Slope[0], -0.25, 1e-12);
  EXPECT_NEAR(trend.Slope[1], 0.75, 1e-12);
  EXPECT_NEAR(Moments(samples).Variance, 0.0, 1e-20);
}

TEST(GridSamples, APlaneIsFoundAndRemovedAroundHoles)
{
  GridSamples samples = Noise(30, 20, 0.3);
  for (int j = 0; j < 20; ++j)
  {
    for (int i = 0; i < 30; ++i)
    {
      double& value = samples.At(i, j);
      value = std::isnan(value) ? value : 7.0 + 0.02 * (i - 14.5) * 2.0 - 0.5 * (j - 9.5) * 3.0;
    }
  }
  const PlaneTrend trend = RemovePlane(samples);
  EXPECT_NEAR(trend.Mean, 7.0, 1e-10);
  EXPECT_NEAR(trend.Slope[0], 0.02, 1e-12);
  EXPECT_NEAR(trend.Slope[1], -0.5, 1e-12);
  EXPECT_NEAR(Moments(samples).Variance, 0.0, 1e-20);
}

TEST(GridSamples, APlaneThatIsRemovedCanBeAdded)
{
  const GridSamples samples = Noise(30, 20);
  GridSamples changed = samples;
  AddPlane(changed, { 4.0, { 0.3, -0.7 } }, OnThreads(3));
  EXPECT_NEAR(changed.At(0, 0) - samples.At(0, 0), 4.0 - 0.3 * 29.0 + 0.7 * 28.5, 1e-12);
  EXPECT_NEAR(changed.At(29, 0) - samples.At(29, 0), 4.0 + 0.3 * 29.0 + 0.7 * 28.5, 1e-12);
  AddPlane(changed, RemovePlane(changed));
  AddPlane(changed, { -4.0, { -0.3, 0.7 } });
  for (std::size_t n = 0; n < samples.Values.size(); ++n)
  {
    EXPECT_NEAR(changed.Values[n], samples.Values[n], 1e-11);
  }
}
