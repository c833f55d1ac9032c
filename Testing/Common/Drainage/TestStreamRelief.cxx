// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Channel heads, drainage density and relief beside streams of a valley whose slopes are known.
#include "Drainage/StreamRelief.h"
#include "RandomGround.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace littoral;
using namespace littoral::testing;

namespace
{

constexpr int Length = 120;
constexpr int Breadth = 61;
constexpr int Thalweg = 30;

/// A straight valley of 20 m cells: sides of slope 0.5, and a channel whose slope falls with its area A as A^-0.8.
GridSamples Valley()
{
  std::vector<double> channel(Length, 0.0);
  for (int i = Length - 2; i >= 0; --i)
  {
    channel[i] = channel[i + 1] + 20.0 * 0.15 * std::pow(std::max(1, i), -0.8);
  }
  return Ground(Length, Breadth, { 20.0, 20.0 },
    [&](double x, double y) { return channel[std::lround(x / 20.0)] + 0.5 * std::abs(y - 20.0 * Thalweg); });
}

SlopeAreaBin Bin(double cells, double slope)
{
  return { cells, slope, 1.0 };
}

}

TEST(StreamRelief, SlopesBreakWhereHillslopesAndChannelsMeet)
{
  for (const double area : { 3.0, 60.0, 700.0 })
  {
    for (const double exponent : { 0.3, 0.7, 1.6 })
    {
      std::vector<SlopeAreaBin> bins;
      for (double cells = 1.0; cells < 5000.0; cells *= 1.5)
      {
        bins.push_back({ cells, 0.4 / (1.0 + std::pow(cells / area, exponent)), 1e5 / cells });
      }
      EXPECT_NEAR(BreakOfSlopes(bins) / area, 1.0, 0.01) << area << " " << exponent;
      // One cell that is off hardly counts
      bins.back().Count = 1.0;
      bins.back().Slope *= 5.0;
      EXPECT_NEAR(BreakOfSlopes(bins) / area, 1.0, 0.03) << area << " " << exponent;
    }
  }
}

TEST(StreamRelief, SlopesThatFallFromTheFirstCellOnOrDoNotFallHaveNoBreak)
{
  for (const double exponent : { -0.5, 0.0, 0.5 })
  {
    std::vector<SlopeAreaBin> bins;
    for (double cells = 1.0; cells < 5000.0; cells *= 1.5)
    {
      bins.push_back(Bin(cells, 0.4 * std::pow(cells, exponent)));
    }
    EXPECT_TRUE(std::isnan(BreakOfSlopes(bins))) << exponent;
    bins.resize(5);
    EXPECT_TRUE(std::isnan(BreakOfSlopes(bins)));
  }
}

TEST(StreamRelief, ValleyHasOneChannel)
{
  const GridSamples valley = Valley();
  const FlowRouting routing = RouteFlow(valley, BorderOutlets(Length, Breadth));
  const std::vector<CellIndex> cells = FlowAccumulation(routing);
  const ChannelDensity channels = ChannelsOf(valley, routing, cells);
  // Sides have 29 cells and the channel's head has 59. Slopes fall there in one step, which the law has not.
  EXPECT_GT(channels.HeadCells, 29.0);
  EXPECT_LE(channels.HeadCells, 3.0 * 59.0);
  EXPECT_EQ(channels.Heads, 1.0);
  EXPECT_NEAR(channels.Density * Length * Breadth * 20.0, Length - 2, 2.0);
}

TEST(StreamRelief, HeightsAboveTheValleysStreamAreItsSides)
{
  const GridSamples valley = Valley();
  const FlowRouting routing = RouteFlow(valley, BorderOutlets(Length, Breadth));
  const std::vector<StreamDistanceBin> bins = HeightsAboveStreams(valley, routing, FlowAccumulation(routing), 40, 10);
  ASSERT_EQ(bins.size(), 10u);
  for (int n = 0; n < 10; ++n)
  {
    EXPECT_NEAR(bins[n].Distance, 20.0 * (n + 1), 1e-9);
    EXPECT_NEAR(bins[n].Height, 10.0 * (n + 1), 1e-9);
    EXPECT_EQ(bins[n].Count, 2.0 * (Length - 2));
  }
  EXPECT_TRUE(HeightsAboveStreams(valley, routing, FlowAccumulation(routing), 100000, 10).empty());
}
