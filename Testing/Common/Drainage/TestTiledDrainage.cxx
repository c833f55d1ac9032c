// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Drainage by tiles: the cells of the whole grid, whatever the tiles; the shortest ways out of flats by a search of its
// own; areas that sum to the grid.
#include "Drainage/DepressionFilling.h"
#include "Drainage/FlowRouting.h"
#include "Drainage/TiledDrainage.h"
#include "RandomGround.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

using namespace littoral;
using littoral::testing::Ground;
using littoral::testing::RandomGround;

namespace
{

constexpr double NoSea = -std::numeric_limits<double>::infinity();
const double NaN = std::numeric_limits<double>::quiet_NaN();

/// Heights of a tile with its ring.
TileGround Cut(const GridSamples& whole, const TileWindow& window)
{
  TileGround ground;
  ground.Window = window;
  ground.Heights.Width = window.Width + 2;
  ground.Heights.Height = window.Height + 2;
  ground.Heights.Spacing = whole.Spacing;
  for (int j = window.Y - 1; j <= window.Y + window.Height; ++j)
  {
    for (int i = window.X - 1; i <= window.X + window.Width; ++i)
    {
      const bool isWithin = i >= 0 && j >= 0 && i < whole.Width && j < whole.Height;
      ground.Heights.Values.push_back(isWithin ? whole.At(i, j) : NaN);
    }
  }
  return ground;
}

TiledDrainage DrainByTiles(const GridSamples& whole, int side, double seaLevel)
{
  TiledDrainage drainage(whole.Width, whole.Height, side, seaLevel);
  const TileGrid& tiles = drainage.Tiles();
  for (int tile = 0; tile < tiles.Count(); ++tile)
  {
    drainage.FindSpills(Cut(whole, tiles.Window(tile)));
  }
  drainage.JoinSpills();
  for (int tile = tiles.Count(); tile-- > 0;)
  {
    drainage.Route(Cut(whole, tiles.Window(tile)));
  }
  drainage.JoinFlow();
  return drainage;
}

/// Compares a drainage by tiles with that of the whole grid, cell for cell.
void ExpectWhole(const GridSamples& whole, int side, double seaLevel = NoSea)
{
  SCOPED_TRACE(::testing::Message() << whole.Width << " x " << whole.Height << " by " << side);
  const OutletMask outlets = SeaOutlets(whole, seaLevel);
  const CellLattice lattice(whole);
  const FlowRouting routing = RouteFlow(whole, outlets, SerialFor, NoPoll, FlatWays::Shortest);
  const std::vector<CellIndex> cells = FlowAccumulation(routing);
  const std::vector<double> levels = FloodDepressions(whole, outlets).SpillElevation;
  const TiledDrainage drainage = DrainByTiles(whole, side, seaLevel);
  std::size_t different = 0;
  double leaving = 0.0;
  for (int tile = 0; tile < drainage.Tiles().Count(); ++tile)
  {
    const TileGround ground = Cut(whole, drainage.Tiles().Window(tile));
    const TileDrainage own = drainage.Drain(ground);
    for (std::size_t n = 0; n < own.Cells.size(); ++n)
    {
      const int i = ground.Window.X + static_cast<int>(n) % ground.Window.Width;
      const int j = ground.Window.Y + static_cast<int>(n) / ground.Window.Width;
      const CellIndex cell = j * whole.Width + i;
      const int direction = lattice.DirectionTo(cell, routing.Receiver[cell]);
      const bool isMissing = std::isnan(whole.Values[cell]);
      const bool isLevel = isMissing ? std::isnan(own.SpillElevation[n]) : own.SpillElevation[n] == levels[cell];
      different += !isLevel || own.Cells[n] != cells[cell] || DirectionOf(own.Flow[n]) != direction;
      leaving += direction < 0 ? own.Cells[n] : 0;
    }
  }
  EXPECT_EQ(different, 0u);
  EXPECT_EQ(leaving, static_cast<double>(whole.Values.size()));
  EXPECT_EQ(drainage.DepressionCells(), routing.DepressionCells);
}

/// Midpoint-like ground: noise of several sizes, with lakes and hills of all of them.
GridSamples Fractal(int width, int height, int seed, double step = 0.0)
{
  GridSamples sum = Ground(width, height, { 2.0, 3.0 }, [](double, double) { return 0.0; });
  for (int size = 32, octave = 0; size > 0; size /= 2, ++octave)
  {
    const GridSamples noise = RandomGround(width / size + 2, height / size + 2, { 1.0, 1.0 }, 10 * seed + octave);
    for (int j = 0; j < height; ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        const double x = static_cast<double>(i % size) / size;
        const double y = static_cast<double>(j % size) / size;
        const auto row = [&](int k) {
          return (1.0 - x) * noise.At(i / size, j / size + k) + x * noise.At(i / size + 1, j / size + k);
        };
        sum.At(i, j) += 0.2 * size * ((1.0 - y) * row(0) + y * row(1));
      }
    }
  }
  for (double& height_ : sum.Values)
  {
    height_ = step > 0.0 ? step * std::floor(height_ / step) : height_;
  }
  return sum;
}

}

TEST(TiledDrainage, HasTheCellsOfTheWholeGrid)
{
  for (int seed = 0; seed < 3; ++seed)
  {
    for (const int side : { 1, 2, 5, 16, 33, 200 })
    {
      ExpectWhole(Fractal(100, 67, seed), side);
      ExpectWhole(RandomGround(41, 56, { 2.0, 1.0 }, seed), side);
    }
  }
}

TEST(TiledDrainage, RoutesFlatsOverTiles)
{
  for (const int side : { 1, 3, 8, 25, 80 })
  {
    ExpectWhole(Fractal(100, 67, 4, 5.0), side);
    ExpectWhole(Fractal(81, 90, 5, 40.0), side);
    ExpectWhole(RandomGround(51, 51, { 1.0, 1.0 }, 6, 4.0), side);
    ExpectWhole(Ground(60, 40, { 1.0, 1.0 }, [](double, double) { return 7.0; }), side);
  }
}

TEST(TiledDrainage, FillsALakeAcrossManyTiles)
{
  // A bowl with a rim and one low sill
  GridSamples bowl = Ground(90, 80, { 1.0, 1.0 },
    [](double x, double y) { return std::floor(0.2 * std::hypot(x - 44.0, y - 37.0)) + 0.3 * std::sin(x * y); });
  bowl.At(0, 40) = bowl.At(1, 40) = 5.0;
  for (const int side : { 7, 20, 64 })
  {
    ExpectWhole(bowl, side);
  }
}

TEST(TiledDrainage, KnowsMissingHeightsAndTheSea)
{
  GridSamples ground = Fractal(95, 70, 8, 2.0);
  for (int j = 0; j < ground.Height; ++j)
  {
    for (int i = 0; i < ground.Width; ++i)
    {
      if (std::hypot(i - 32.0, j - 31.0) < 9.0 || (i > 60 && j == 50) || (i == 16 && j < 20) || i + j < 30)
      {
        ground.At(i, j) = NaN;
      }
    }
  }
  const auto [lowest, highest] = RangeOf(ground.Values);
  for (const int side : { 1, 9, 16, 31 })
  {
    ExpectWhole(ground, side);
    ExpectWhole(ground, side, lowest + 0.4 * (highest - lowest));
  }
}

TEST(FlatRouting, TakesTheShortestWayOut)
{
  // Steps to an exit by relaxation over all pairs of neighbours, until nothing changes.
  const GridSamples ground = Fractal(60, 50, 11, 30.0);
  const OutletMask outlets = BorderOutlets(60, 50);
  const CellLattice lattice(ground);
  const FlowRouting routing = RouteFlow(ground, outlets, SerialFor, NoPoll, FlatWays::Shortest);
  const std::vector<double> levels = FloodDepressions(ground, outlets).SpillElevation;
  constexpr int far = 1 << 20;
  std::vector<int> steps(levels.size(), far);
  for (CellIndex cell = 0; cell < lattice.Count(); ++cell)
  {
    lattice.ForEachNeighbour(
      cell, [&](CellIndex other, int) { steps[cell] = levels[other] < levels[cell] ? 0 : steps[cell]; });
    steps[cell] = outlets[cell] ? 0 : steps[cell];
  }
  for (bool hasChanged = true; hasChanged;)
  {
    hasChanged = false;
    for (CellIndex cell = 0; cell < lattice.Count(); ++cell)
    {
      lattice.ForEachNeighbour(cell, [&](CellIndex other, int) {
        if (levels[other] == levels[cell] && steps[other] + 1 < steps[cell])
        {
          steps[cell] = steps[other] + 1;
          hasChanged = true;
        }
      });
    }
  }
  int furthest = 0;
  for (CellIndex cell = 0; cell < lattice.Count(); ++cell)
  {
    if (steps[cell] == 0)
    {
      continue;
    }
    CellIndex first = -1;
    lattice.ForEachNeighbour(cell, [&](CellIndex other, int) {
      const bool isNearer = levels[other] == levels[cell] && steps[other] + 1 == steps[cell];
      first = first < 0 && isNearer ? other : first;
    });
    EXPECT_EQ(routing.Receiver[cell], first);
    furthest = std::max(furthest, steps[cell]);
  }
  EXPECT_GT(furthest, 5);
}

TEST(TiledDrainage, EndsWhenAsked)
{
  const GridSamples ground = RandomGround(300, 300, { 1.0, 1.0 }, 1);
  TiledDrainage drainage(300, 300, 300, NoSea);
  const Poll stop = [] { throw std::runtime_error("stop"); };
  EXPECT_THROW(drainage.FindSpills(Cut(ground, drainage.Tiles().Window(0)), stop), std::runtime_error);
}
