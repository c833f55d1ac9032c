// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "Drainage/CoarseGround.h"
#include "Drainage/DrainageCarving.h"
#include "Numerics/Constants.h"
#include "RandomGround.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace littoral;
using littoral::testing::Ground;
using littoral::testing::OnThreads;
using littoral::testing::RandomGround;

namespace
{

/// A wave of whole half lengths over a grid of these sides, from the middles of its cells.
double Wave(double x, double y, double width, double height)
{
  return 3.0 * std::cos(Pi * 2.0 * x / width) * std::cos(Pi * 4.0 * y / height);
}

/// The wave on so many cells of an area of 90 m x 66 m.
GridSamples Waves(int width, int height)
{
  const std::array<double, 2> spacing{ 90.0 / width, 66.0 / height };
  return Ground(width, height, spacing,
    [&](double x, double y) { return 5.0 + Wave(x + 0.5 * spacing[0], y + 0.5 * spacing[1], 90.0, 66.0); });
}

}

TEST(CoarseGround, HasTheSameLongWaves)
{
  for (const auto& size : { std::array<int, 2>{ 30, 22 }, { 31, 23 } })
  {
    const GridSamples coarse = CoarseGround(Waves(size[0], size[1]));
    EXPECT_EQ(coarse.Width, (size[0] + 1) / 2);
    EXPECT_EQ(coarse.Height, (size[1] + 1) / 2);
    EXPECT_NEAR(coarse.Spacing[0] * coarse.Width, 90.0, 1e-9);
    const GridSamples same = Waves(coarse.Width, coarse.Height);
    for (std::size_t n = 0; n < coarse.Values.size(); ++n)
    {
      EXPECT_NEAR(coarse.Values[n], same.Values[n], 1e-10);
    }
  }
}

TEST(CoarseGround, ChangesOfItsWavesComeBack)
{
  const GridSamples noise = RandomGround(31, 22, { 2.0, 3.0 }, 4);
  GridSamples coarse = CoarseGround(noise, OnThreads(2));
  GridSamples back = noise;
  TakeLongWaves(back, coarse, OnThreads(3));
  for (std::size_t n = 0; n < noise.Values.size(); ++n)
  {
    EXPECT_NEAR(back.Values[n], noise.Values[n], 1e-10);
  }
  const auto wave = [](const GridSamples& grid, std::size_t n) {
    const double x = (static_cast<double>(n % grid.Width) + 0.5) * grid.Spacing[0];
    const double y = (static_cast<double>(n / grid.Width) + 0.5) * grid.Spacing[1];
    return Wave(x, y, 62.0, 66.0);
  };
  for (std::size_t n = 0; n < coarse.Values.size(); ++n)
  {
    coarse.Values[n] += wave(coarse, n);
  }
  TakeLongWaves(back, coarse);
  for (std::size_t n = 0; n < noise.Values.size(); ++n)
  {
    EXPECT_NEAR(back.Values[n] - noise.Values[n], wave(noise, n), 1e-9);
  }
}

TEST(CoarseGround, KeepsOutlets)
{
  const GridSamples ground = RandomGround(31, 22, { 1.0, 1.0 }, 4);
  DrainageOutlets chosen;
  chosen.Choice = OutletChoice::Chosen;
  chosen.Cells.assign(ground.Values.size(), 0);
  chosen.Cells[0] = chosen.Cells[15] = chosen.Cells[31 * 22 - 1] = 1;
  const OutletMask mask = CoarseOutlets(chosen, ground).Cells;
  ASSERT_EQ(mask.size(), 16u * 11u);
  EXPECT_EQ(std::accumulate(mask.begin(), mask.end(), 0), 3);
  EXPECT_TRUE(mask.front() && mask[8] && mask.back()); // cell 15 of 31 is in the middle
  EXPECT_EQ(CoarseOutlets({}, ground).Choice, OutletChoice::Border);
}

TEST(CoarseGround, LargeGroundIsCarvedByItTheSameOnAnyThreads)
{
  // of more cells than are carved at once
  const auto hill = [](double x, double y) {
    double height = 400.0;
    for (int wave = 1; wave < 40; ++wave)
    {
      const double turn = 2.4 * wave;
      height += 60.0 / wave * std::cos(0.004 * wave * (x * std::cos(turn) + y * std::sin(turn)) + wave * wave);
    }
    return height;
  };
  const GridSamples hills = Ground(520, 510, { 10.0, 10.0 }, hill);
  CarvingParameters parameters;
  parameters.MaximumIterations = 2;
  const CarvingTarget target = TargetOf(hills, TargetStatistics());
  GridSamples one = hills;
  GridSamples other = hills;
  const CarvingReport report = CarveDrainage(one, target, parameters);
  CarveDrainage(other, target, parameters, OnThreads(3));
  EXPECT_EQ(one.Values, other.Values);
  EXPECT_EQ(report.After.DepressionFraction, 0.0);
  EXPECT_NEAR(
    report.After.StandardDeviation, target.Measures.StandardDeviation, 0.02 * target.Measures.StandardDeviation);
}
