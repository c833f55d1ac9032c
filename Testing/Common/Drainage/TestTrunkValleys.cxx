// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/TrunkValleys.h"
#include "RandomGround.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace littoral;
using namespace littoral::testing;

namespace
{

constexpr int Width = 120;
constexpr int Height = 60;

/// Length over the root of the cells of a river in row 30 of a plain, of so many cells of drainage area, between ranges
/// from `near` to `far` cells off it; with x and y changed on request.
double LengthOf(int nearest, int farthest, int cells, bool isTurned = false)
{
  const GridSamples ground =
    Ground(isTurned ? Height : Width, isTurned ? Width : Height, { 1.0, 1.0 }, [&](double x, double y) {
      const double off = std::abs((isTurned ? x : y) - 30.0);
      return off >= nearest && off <= farthest ? 100.0 : 0.0;
    });
  std::vector<CellIndex> accumulation(ground.Values.size(), 1);
  for (int n = 0; n < Width; ++n)
  {
    accumulation[isTurned ? n * Height + 30 : 30 * Width + n] = cells;
  }
  return TrunkValleyLength(ground, accumulation);
}

}

TEST(TrunkValleys, AreRiversBetweenMountains)
{
  // Reach: a twelfth of 60 cells, four diagonal ones. Within three cells of an end two diagonals have no range.
  const double length = (Width - 6) / std::sqrt(Width * Height);
  constexpr int river = Width * Height / 50;
  EXPECT_NEAR(LengthOf(3, 10, river), length, 1e-12);
  EXPECT_NEAR(LengthOf(3, 10, river, true), length, 1e-12);
  EXPECT_NEAR(LengthOf(4, 11, river), (Width - 8) / std::sqrt(Width * Height), 1e-12);
  EXPECT_NEAR(LengthOf(3, 29, river), length, 1e-12);
  // diagonals end before the range; the river is too small
  EXPECT_EQ(LengthOf(5, 12, river), 0.0);
  EXPECT_EQ(LengthOf(3, 10, river - 1), 0.0);
}

TEST(TrunkValleys, RiversAtTheFootOfARangeAreNone)
{
  const GridSamples ground = Ground(Width, Height, { 1.0, 1.0 }, [](double, double y) { return y > 32.0 ? y : 0.0; });
  std::vector<CellIndex> accumulation(ground.Values.size(), 1);
  for (int n = 0; n < Width; ++n)
  {
    accumulation[30 * Width + n] = Width * Height;
  }
  EXPECT_EQ(TrunkValleyLength(ground, accumulation), 0.0);
}
