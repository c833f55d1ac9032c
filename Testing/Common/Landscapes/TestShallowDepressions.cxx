// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../Drainage/RandomGround.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/DrainageOutlets.h"
#include "Landscapes/ShallowDepressions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

using namespace littoral;
using namespace littoral::testing;

namespace
{

constexpr int Width = 40;
constexpr int Height = 30;

struct Pit
{
  int X;
  int Y;
  int Side; ///< [cells]
  double Depth;
};

/// A table 50 m high with square pits, the middle of each half as deep again.
GridSamples Table(const std::vector<Pit>& pits)
{
  GridSamples table = Ground(Width, Height, { 2.0, 2.0 }, [](double, double) { return 50.0; });
  for (const Pit& pit : pits)
  {
    for (int n = 0; n < pit.Side * pit.Side; ++n)
    {
      table.At(pit.X + n % pit.Side, pit.Y + n / pit.Side) -= pit.Depth;
    }
    table.At(pit.X + pit.Side / 2, pit.Y + pit.Side / 2) -= 0.5 * pit.Depth;
  }
  return table;
}

std::vector<double> Shallow(const GridSamples& ground, int cells)
{
  const std::vector<double> levels = FloodDepressions(ground, BorderOutlets(Width, Height)).SpillElevation;
  return ShallowDepressions(ground, levels, (cells + 0.5) / (Width * Height));
}

}

TEST(ShallowDepressions, FillsTheShallowestThatHaveRoom)
{
  const std::vector<Pit> pits{ { 20, 20, 5, 1.0 }, { 5, 5, 3, 4.0 }, { 12, 5, 4, 2.0 }, { 30, 8, 3, 3.0 } };
  const GridSamples table = Table(pits);
  const auto rest = [&](const std::vector<Pit>& left, int cells) {
    GridSamples ground = table;
    const std::vector<double> depths = Shallow(table, cells);
    for (std::size_t n = 0; n < depths.size(); ++n)
    {
      ground.Values[n] += depths[n];
    }
    EXPECT_EQ(ground.Values, Table(left).Values) << cells;
  };
  rest(pits, 24);
  rest({ pits[1], pits[2], pits[3] }, 25);
  rest({ pits[1], pits[2], pits[3] }, 40);
  rest({ pits[1], pits[3] }, 41);
  rest({ pits[1] }, 50); // the smaller of the rest is deeper, and waits
  rest({ pits[1] }, 58);
  rest({}, 59);
}

TEST(ShallowDepressions, PitsThatTouchAreOne)
{
  // at a corner; the deeper of the two counts
  const GridSamples table = Table({ { 5, 5, 3, 1.0 }, { 8, 8, 3, 6.0 }, { 20, 20, 4, 2.0 } });
  const std::vector<double> depths = Shallow(table, 18);
  EXPECT_EQ(std::count_if(depths.begin(), depths.end(), [](double depth) { return depth > 0.0; }), 16);
  EXPECT_EQ(depths[21 * Width + 21], 2.0);
}

TEST(ShallowDepressions, AllOfThemAreWhatAFloodFills)
{
  const GridSamples ground = RandomGround(Width, Height, { 2.0, 2.0 }, 3);
  const std::vector<double> levels = FloodDepressions(ground, BorderOutlets(Width, Height)).SpillElevation;
  const std::vector<double> depths = Shallow(ground, Width * Height);
  for (std::size_t n = 0; n < depths.size(); ++n)
  {
    EXPECT_EQ(depths[n], levels[n] - ground.Values[n]);
  }
  EXPECT_EQ(Shallow(ground, -1), std::vector<double>(depths.size(), 0.0));
}
