// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "Drainage/GroundWetness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace littoral;
using littoral::testing::OnThreads;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr int Width = 24;
constexpr int Height = 30;

/// z = 0.3 x + 0.4 y, of the slope atan(0.5).
HeightGrid Plane()
{
  HeightGrid plane;
  plane.Count[0] = Width;
  plane.Count[1] = Height;
  plane.Spacing[0] = 4.0;
  plane.Spacing[1] = 1.0;
  plane.HeightOf = [](long long point) {
    return 1.2 * static_cast<double>(point % Width) + 0.4 * static_cast<double>(point / Width);
  };
  return plane;
}

double Even(long long)
{
  return 800.0;
}

}

TEST(GroundWetness, IndexOfASlopeAndOfLevelGround)
{
  EXPECT_NEAR(WetnessOf(800.0, 2.0, std::atan(0.5)), std::log(800.0), 1e-12);
  EXPECT_NEAR(WetnessOf(800.0, 2.0, 0.0), std::log(400.0 / 1e-3), 1e-12);
}

// One slope and one drainage area: the index is the same everywhere, also at the edges, and an average leaves it.
TEST(GroundWetness, PlaneIsEvenlyWet)
{
  const std::vector<double> wetness = SpreadWetness(Plane(), Even);
  ASSERT_EQ(wetness.size(), static_cast<std::size_t>(Width) * Height);
  for (const double index : wetness)
  {
    EXPECT_NEAR(index, std::log(800.0), 1e-9); // the cell is 2 m wide: the root of 4 m x 1 m
  }
}

// ln is additive: a channel of e times the drainage area adds 1 to its own row, which the average spreads and keeps.
TEST(GroundWetness, ChannelWetsItsBanks)
{
  constexpr int Channel = Height / 2;
  const auto areaOf = [](long long point) { return point / Width == Channel ? 800.0 * std::exp(1.0) : 800.0; };
  const std::vector<double> wetness = SpreadWetness(Plane(), areaOf);
  const auto more = [&](int row) { return wetness[static_cast<std::size_t>(row) * Width + 7] - std::log(800.0); };
  double sum = 0.0;
  double squares = 0.0;
  for (int row = 0; row < Height; ++row)
  {
    EXPECT_GE(more(row), -1e-9);
    sum += more(row);
    squares += more(row) * (row - Channel) * (row - Channel);
  }
  EXPECT_NEAR(sum, 1.0, 1e-9);
  EXPECT_NEAR(squares, 4.0, 1e-9); // a Gauss function of two cells
  for (int away = 1; away < Channel; ++away)
  {
    EXPECT_NEAR(more(Channel - away), more(Channel + away), 1e-9) << away << " rows away";
  }
}

TEST(GroundWetness, LevelBesideHoles)
{
  HeightGrid plane = Plane();
  const auto whole = plane.HeightOf;
  plane.HeightOf = [&](long long point) { return point == 15 * Width + 12 ? NaN : whole(point); };
  const std::vector<double> wetness = SpreadWetness(plane, Even);
  double most = 0.0;
  for (const double index : wetness)
  {
    EXPECT_TRUE(std::isfinite(index));
    most = std::max(most, index);
  }
  EXPECT_GT(most, std::log(800.0) + 0.1); // 0.001 in place of 0.5
  EXPECT_NEAR(wetness.front(), std::log(800.0), 1e-9);
}

// The area of a cell alone makes a coarse grid wetter, by the logarithm of its side: on an even slope of water that
// comes from a divide, A / w is the way to it on any grid.
TEST(GroundWetness, CoarseGridsAreNoWetter)
{
  const auto indexOf = [](double side, double share) {
    HeightGrid slope = Plane();
    slope.Spacing[0] = slope.Spacing[1] = side;
    slope.HeightOf = [side](long long point) { return 0.5 * side * static_cast<double>(point / Width); };
    return SpreadWetness(slope, [&](long long) { return share * side * side; })[Width * Height / 2];
  };
  EXPECT_NEAR(indexOf(80.0, 5.0), indexOf(10.0, 5.0), 1e-9);
  EXPECT_NEAR(indexOf(10.0, 5.0), std::log(50.0 / 0.5), 1e-9);
  EXPECT_NEAR(indexOf(2.0, 5.0), std::log(10.0 / 0.5), 1e-9); // finer ones as they are
}

TEST(GroundWetness, ThreadsMakeNoDifference)
{
  EXPECT_EQ(SpreadWetness(Plane(), Even), SpreadWetness(Plane(), Even, OnThreads(3)));
}
