// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "Drainage/DepressionBreaching.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/FlatRouting.h"
#include "Drainage/FlowRouting.h"
#include "RandomGround.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>

using namespace littoral;
using littoral::testing::Ground;
using littoral::testing::OnThreads;
using littoral::testing::RandomGround;

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();

/// Neighbours by their distance on the grid, in the order of their index.
std::vector<int> NeighboursOf(const GridSamples& ground, int cell)
{
  std::vector<int> neighbours;
  for (int other = 0; other < ground.Width * ground.Height; ++other)
  {
    const int x = std::abs(other % ground.Width - cell % ground.Width);
    const int y = std::abs(other / ground.Width - cell / ground.Width);
    if (std::max(x, y) == 1)
    {
      neighbours.push_back(other);
    }
  }
  return neighbours;
}

double DistanceOf(const GridSamples& ground, int a, int b)
{
  const double x = (a % ground.Width - b % ground.Width) * ground.Spacing[0];
  const double y = (a / ground.Width - b / ground.Width) * ground.Spacing[1];
  return std::sqrt(x * x + y * y);
}

/// Levels by relaxation from a full flood, w = max(z, least w around), until nothing changes (Planchon & Darboux 2002).
std::vector<double> RelaxedLevels(const GridSamples& ground, const OutletMask& outlets)
{
  std::vector<double> level(ground.Values.size(), Infinite);
  std::vector<std::vector<int>> around;
  for (std::size_t cell = 0; cell < level.size(); ++cell)
  {
    around.push_back(NeighboursOf(ground, static_cast<int>(cell)));
  }
  for (bool hasChanged = true; hasChanged;)
  {
    hasChanged = false;
    for (std::size_t cell = 0; cell < level.size(); ++cell)
    {
      double lowest = outlets[cell] ? -Infinite : Infinite;
      for (const int other : around[cell])
      {
        lowest = std::min(lowest, level[other]);
      }
      const double water = std::max(ground.Values[cell], lowest);
      hasChanged = hasChanged || water < level[cell];
      level[cell] = std::min(level[cell], water);
    }
  }
  return level;
}

/// Cells through which the water of each cell goes, followed one by one down the steepest of all ways.
std::vector<int> CountedCells(const GridSamples& ground, const OutletMask& outlets)
{
  std::vector<int> counts(ground.Values.size(), 0);
  std::vector<int> down(ground.Values.size(), -1);
  for (int cell = 0; cell < static_cast<int>(down.size()); ++cell)
  {
    double steepest = 0.0;
    for (const int other : NeighboursOf(ground, cell))
    {
      const double slope = (ground.Values[cell] - ground.Values[other]) / DistanceOf(ground, cell, other);
      if (!outlets[cell] && slope > steepest)
      {
        steepest = slope;
        down[cell] = other;
      }
    }
  }
  for (int cell = 0; cell < static_cast<int>(down.size()); ++cell)
  {
    for (int at = cell; at >= 0; at = down[at])
    {
      ++counts[at];
    }
  }
  return counts;
}

void ExpectSound(const FlowRouting& routing, const CellLattice& lattice, const OutletMask& outlets)
{
  ASSERT_EQ(routing.Order.size(), routing.Receiver.size());
  std::vector<int> turn(routing.Order.size(), -1);
  for (std::size_t n = 0; n < routing.Order.size(); ++n)
  {
    turn[routing.Order[n]] = static_cast<int>(n);
  }
  for (CellIndex cell = 0; cell < lattice.Count(); ++cell)
  {
    ASSERT_GE(turn[cell], 0);
    if (outlets[cell])
    {
      EXPECT_EQ(routing.Receiver[cell], cell);
    }
    else
    {
      EXPECT_GE(lattice.DirectionTo(cell, routing.Receiver[cell]), 0);
      EXPECT_LT(turn[routing.Receiver[cell]], turn[cell]);
    }
  }
}

std::int64_t CellsAtOutlets(const FlowRouting& routing, const OutletMask& outlets)
{
  const std::vector<CellIndex> cells = FlowAccumulation(routing);
  std::int64_t sum = 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
  {
    sum += outlets[cell] ? cells[cell] : 0;
  }
  return sum;
}

}

TEST(DepressionFilling, AgreesWithRelaxation)
{
  for (int seed = 0; seed < 6; ++seed)
  {
    const GridSamples ground = RandomGround(23, 17, { 2.0, 3.0 }, seed, seed % 2 ? 1.0 : 0.0);
    OutletMask outlets = BorderOutlets(23, 17);
    if (seed >= 4)
    {
      std::fill(outlets.begin(), outlets.end(), 0);
      outlets[23 * 8 + 11] = 1; // a single one, inside
    }
    const DepressionFlood flood = FloodDepressions(ground, outlets);
    const std::vector<double> levels = RelaxedLevels(ground, outlets);
    std::size_t sunk = 0;
    double volume = 0.0;
    for (std::size_t cell = 0; cell < levels.size(); ++cell)
    {
      EXPECT_EQ(flood.SpillElevation[cell], levels[cell]);
      sunk += levels[cell] > ground.Values[cell];
      volume += 6.0 * (levels[cell] - ground.Values[cell]);
    }
    EXPECT_EQ(flood.DepressionCells, sunk);
    EXPECT_NEAR(flood.Volume, volume, 1e-9 * volume);
    EXPECT_GT(sunk, 20u);
  }
}

TEST(DepressionFilling, APitIsFilledToItsSill)
{
  GridSamples ground = Ground(9, 9, { 5.0, 5.0 }, [](double, double) { return 7.0; });
  ground.At(4, 4) = 2.0;
  ground.At(4, 0) = 6.0;
  const DepressionFlood flood = FloodDepressions(ground, BorderOutlets(9, 9));
  EXPECT_EQ(flood.DepressionCells, 1u);
  EXPECT_DOUBLE_EQ(flood.Volume, 5.0 * 25.0);
  EXPECT_EQ(flood.SpillElevation[4 * 9 + 4], 7.0);
}

TEST(DepressionFilling, SpillElevationsByAnyFlowPaths)
{
  for (int seed = 0; seed < 8; ++seed)
  {
    const GridSamples ground = RandomGround(31, 22, { 2.0, 3.0 }, seed, seed % 2 ? 1.0 : 0.0);
    const OutletMask outlets = BorderOutlets(31, 22);
    // paths of the ground, and of another one, which leave most cells to be flooded
    for (const int of : { seed, seed + 1 })
    {
      const FlowRouting routing = RouteFlow(RandomGround(31, 22, { 2.0, 3.0 }, of), outlets);
      EXPECT_EQ(SpillElevationsBy(routing, ground), RelaxedLevels(ground, outlets));
    }
  }
}

TEST(DepressionBreaching, LeavesNoSunkCellAndRaisesNone)
{
  for (const BreachPath path : { BreachPath::FloodOrder, BreachPath::LeastCost })
  {
    for (int seed = 0; seed < 8; ++seed)
    {
      const GridSamples before = RandomGround(31, 22, { 2.0, 3.0 }, seed, seed % 2 ? 1.0 : 0.0);
      GridSamples ground = before;
      const OutletMask outlets = BorderOutlets(31, 22);
      const BreachCount count = BreachDepressions(ground, outlets, path, NoPoll, seed < 6 ? 16384 : 12);
      const std::vector<double> levels = RelaxedLevels(ground, outlets);
      double volume = 0.0;
      for (std::size_t cell = 0; cell < levels.size(); ++cell)
      {
        EXPECT_EQ(levels[cell], ground.Values[cell]);
        EXPECT_LE(ground.Values[cell], before.Values[cell]);
        volume += 6.0 * (before.Values[cell] - ground.Values[cell]);
      }
      EXPECT_NEAR(count.Volume, volume, 1e-9 * volume);
      EXPECT_GT(count.Pits, 5u);
    }
  }
}

TEST(DepressionBreaching, TakesTheCheaperWay)
{
  // A bowl whose lowest sill is behind a long ridge, and a thin high wall on the other side.
  GridSamples ground = Ground(40, 9, { 1.0, 1.0 }, [](double, double) { return 10.0; });
  for (int i = 1; i < 39; ++i)
  {
    ground.At(i, 4) = i < 3 ? 0.0 : i == 3 ? 6.0 : i == 4 ? 1.0 : 5.0;
  }
  ground.At(0, 4) = 0.0;
  ground.At(39, 4) = 0.0;
  GridSamples flooded = ground;
  const BreachCount along = BreachDepressions(flooded, BorderOutlets(40, 9), BreachPath::FloodOrder);
  const BreachCount least = BreachDepressions(ground, BorderOutlets(40, 9), BreachPath::LeastCost);
  EXPECT_LT(ground.At(3, 4), 1.0);
  EXPECT_EQ(ground.At(20, 4), 5.0);
  EXPECT_EQ(flooded.At(3, 4), 6.0);
  EXPECT_LT(flooded.At(20, 4), 1.0);
  EXPECT_LT(least.Volume, 0.1 * along.Volume);
}

TEST(DepressionBreaching, GoesAroundWhatIsHigh)
{
  // A pit five cells from the border, and a trench that is longer, but all the way but little above the pit.
  GridSamples ground = Ground(30, 11, { 1.0, 1.0 }, [](double, double) { return 10.0; });
  ground.At(5, 5) = 0.0;
  for (int i = 6; i < 29; ++i)
  {
    ground.At(i, 5) = 1.0 - 0.01 * i;
  }
  ground.At(29, 5) = -1.0;
  BreachDepressions(ground, BorderOutlets(30, 11), BreachPath::LeastCost);
  EXPECT_EQ(ground.At(3, 5), 10.0);
  EXPECT_LT(ground.At(10, 5), 0.0);
}

// As many cells lie between a pit and each side, but they are narrower along one axis.
TEST(DepressionBreaching, CostsAreOfLengthsNotOfCells)
{
  for (const int axis : { 0, 1 })
  {
    const std::array<double, 2> spacing = { axis == 0 ? 2.0 : 3.0, axis == 0 ? 3.0 : 2.0 };
    GridSamples ground = Ground(11, 11, spacing, [](double, double) { return 10.0; });
    ground.At(5, 5) = 0.0;
    BreachDepressions(ground, BorderOutlets(11, 11), BreachPath::LeastCost);
    double alongX = 0.0;
    double alongY = 0.0;
    for (int n = 0; n < 11; ++n)
    {
      alongX += 10.0 - ground.At(n, 5);
      alongY += 10.0 - ground.At(5, n);
    }
    EXPECT_GT(axis == 0 ? alongX : alongY, 50.0);
    EXPECT_NEAR(axis == 0 ? alongY : alongX, 10.0, 1e-12);
  }
}

TEST(DepressionBreaching, LowersAnOutletThatIsNotLower)
{
  GridSamples ground = Ground(9, 9, { 1.0, 1.0 }, [](double x, double y) { return std::hypot(x - 4.0, y - 4.0); });
  const OutletMask outlets = BorderOutlets(9, 9);
  EXPECT_GT(BreachDepressions(ground, outlets, BreachPath::LeastCost).Lowered, 2u);
  EXPECT_EQ(FloodDepressions(ground, outlets).DepressionCells, 0u);
  EXPECT_EQ(ground.At(4, 4), 0.0);
  // Four cells to the border, each lower by 1e-7 of the relief.
  EXPECT_NEAR(*std::min_element(ground.Values.begin(), ground.Values.end()), -4e-7 * std::hypot(4.0, 4.0), 1e-15);
}

TEST(FlowRouting, AgreesWithFollowingEachCell)
{
  for (int seed = 0; seed < 6; ++seed)
  {
    GridSamples ground = RandomGround(27, 19, { 2.0, 3.0 }, seed);
    const OutletMask outlets = BorderOutlets(27, 19);
    BreachDepressions(ground, outlets, BreachPath::LeastCost);
    const FlowRouting routing = RouteFlow(ground, outlets);
    ExpectSound(routing, CellLattice(ground), outlets);
    EXPECT_EQ(FlowAccumulation(routing), CountedCells(ground, outlets));
  }
}

TEST(FlowRouting, DrainsDepressionsAndFlats)
{
  for (int seed = 0; seed < 6; ++seed)
  {
    const GridSamples ground = RandomGround(27, 19, { 2.0, 3.0 }, seed, seed % 2 ? 2.5 : 0.0);
    const OutletMask outlets = SeaOutlets(ground, 0.3);
    const FlowRouting routing = RouteFlow(ground, outlets);
    ExpectSound(routing, CellLattice(ground), outlets);
    EXPECT_EQ(CellsAtOutlets(routing, outlets), 27 * 19);
  }
}

TEST(FlowRouting, FlatsOfDrainedGroundAreRoutedAsFlooded)
{
  int routed = 0;
  for (int seed = 0; seed < 400; ++seed)
  {
    // lakes of one level each; of steps many are entered from two cells at once
    constexpr std::array<double, 4> steps{ 0.0, 0.1, 0.5, 1.0 };
    const double step = steps[seed % 4];
    GridSamples ground = RandomGround(14, 11, { 2.0, 3.0 }, seed, step);
    OutletMask outlets = BorderOutlets(14, 11);
    outlets[5 * 14 + 6] = 1;
    ground.Values = RelaxedLevels(ground, outlets);
    const DepressionFlood flood = FloodDepressions(ground, outlets);
    const CellLattice lattice(ground);
    std::vector<CellIndex> receivers;
    std::vector<CellIndex> expected;
    for (CellIndex cell = 0; cell < lattice.Count(); ++cell)
    {
      const int direction = outlets[cell] ? -1 : SteepestDirection(ground.Values, lattice, cell);
      const bool isOnFlat = direction < 0 && !outlets[cell];
      receivers.push_back(isOnFlat ? -1 : direction < 0 ? cell : cell + lattice.Offset(direction));
      expected.push_back(isOnFlat ? flood.Backlink[cell] : receivers.back());
    }
    EXPECT_EQ(RouteFlow(ground, outlets).Receiver, expected);
    if (RouteFlatsAsFlood(ground.Values, outlets, lattice, receivers))
    {
      ++routed;
      EXPECT_EQ(receivers, expected);
    }
    ground.At(3, 3) -= 20.0;
    expected[3 * 14 + 3] = -1;
    EXPECT_FALSE(RouteFlatsAsFlood(ground.Values, outlets, lattice, expected));
  }
  EXPECT_GT(routed, 200); // else the flood is asked
}

TEST(FlowRouting, AreaAtTheOutletsIsTheGrids)
{
  const GridSamples ground = RandomGround(64, 48, { 8.0, 4.0 }, 3);
  const OutletMask outlets = BorderOutlets(64, 48);
  const FlowRouting routing = RouteFlow(ground, outlets);
  const std::vector<double> area = DrainageArea(routing, CellLattice(ground));
  double sum = 0.0;
  for (std::size_t cell = 0; cell < area.size(); ++cell)
  {
    sum += outlets[cell] ? area[cell] : 0.0;
  }
  EXPECT_EQ(sum, 64 * 48 * 32.0);
}

TEST(FlowRouting, OfACone)
{
  // Round a peak every cell drains away from it; each of the eight ways of the peak is downhill.
  const GridSamples ground =
    Ground(41, 41, { 1.0, 1.0 }, [](double x, double y) { return 100.0 - std::hypot(x - 20.0, y - 20.0); });
  const FlowRouting routing = RouteFlow(ground, BorderOutlets(41, 41));
  const std::vector<CellIndex> cells = FlowAccumulation(routing);
  EXPECT_EQ(cells[20 * 41 + 20], 1);
  for (int k = 1; k < 20; ++k)
  {
    // along an axis: straight on
    EXPECT_EQ(routing.Receiver[20 * 41 + 20 + k], 20 * 41 + 20 + k + 1);
    EXPECT_EQ(routing.Receiver[(20 + k) * 41 + 20 + k], (21 + k) * 41 + 21 + k);
  }
}

TEST(FlowRouting, OfARampWhoseCellsAreNotSquare)
{
  // Down in -y by 1 m/m, in x by s: the diagonal, dx = 2, dy = 1, is steeper for 2 s + 1 > sqrt(5).
  for (const double s : { 0.6, 0.64 })
  {
    const GridSamples ground = Ground(12, 20, { 2.0, 1.0 }, [=](double x, double y) { return y + s * x; });
    const FlowRouting routing = RouteFlow(ground, BorderOutlets(12, 20));
    const CellLattice lattice(ground);
    const CellIndex cell = 10 * 12 + 6;
    EXPECT_EQ(lattice.DirectionTo(cell, routing.Receiver[cell]), 2.0 * s + 1.0 > std::sqrt(5.0) ? 5 : 6);
  }
  const GridSamples ramp = Ground(5, 20, { 2.0, 3.0 }, [](double, double y) { return 0.25 * y; });
  const FlowRouting routing = RouteFlow(ramp, BorderOutlets(5, 20));
  const std::vector<double> area = DrainageArea(routing, CellLattice(ramp));
  const std::vector<double> slopes = SlopesToReceivers(ramp, routing);
  for (int j = 1; j < 19; ++j)
  {
    EXPECT_DOUBLE_EQ(area[j * 5 + 2], 6.0 * (19 - j));
    EXPECT_DOUBLE_EQ(slopes[j * 5 + 2], 0.25);
  }
}

TEST(FlowRouting, SameForAnyThreads)
{
  const GridSamples ground = RandomGround(61, 47, { 2.0, 3.0 }, 7, 0.5);
  const OutletMask outlets = BorderOutlets(61, 47);
  const FlowRouting one = RouteFlow(ground, outlets);
  for (const int threads : { 2, 5 })
  {
    const FlowRouting several = RouteFlow(ground, outlets, OnThreads(threads));
    EXPECT_EQ(several.Receiver, one.Receiver);
    EXPECT_EQ(several.Order, one.Order);
  }
}

TEST(FlowRouting, EndsWhenPolledTo)
{
  const GridSamples ground = RandomGround(300, 300, { 1.0, 1.0 }, 7);
  const Poll stop = [] { throw std::runtime_error("enough"); };
  GridSamples cut = ground;
  EXPECT_THROW(RouteFlow(ground, BorderOutlets(300, 300), SerialFor, stop), std::runtime_error);
  EXPECT_THROW(BreachDepressions(cut, BorderOutlets(300, 300), BreachPath::LeastCost, stop), std::runtime_error);
}

TEST(DrainageOutlets, RefusesWhatCannotDrain)
{
  const auto reason = [](const GridSamples& ground) {
    return WhyUndrainable(ground, OutletMask(ground.Values.size(), 1));
  };
  GridSamples ground = RandomGround(9, 7, { 1.0, 1.0 }, 1);
  EXPECT_EQ(reason(ground), "");
  EXPECT_EQ(WhyUndrainable(ground, OutletMask(63, 0)), "No cell is an outlet; water must be able to leave somewhere.");
  EXPECT_EQ(WhyUndrainable(ground, OutletMask(62, 1)), "Outlets must have one value for each height.");
  ground.At(3, 3) = std::numeric_limits<double>::quiet_NaN();
  ground.At(4, 3) = Infinite;
  EXPECT_EQ(reason(ground), "The terrain has 1 of 63 heights beyond all numbers of metres.");
  ground.Values.assign(63, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(reason(ground), "The terrain has no heights.");
  EXPECT_EQ(reason(RandomGround(9, 1, { 1.0, 1.0 }, 1)),
    "The terrain has 9 by 1 heights; water needs at least 3 by 3 to flow.");
  ground = RandomGround(9, 7, { 1.0, 0.0 }, 1);
  EXPECT_EQ(reason(ground), "Spacing along y is 0 m; it must be positive and finite.");
}

TEST(FlowRouting, MissingHeightsAreOutside)
{
  for (int seed = 1; seed <= 6; ++seed)
  {
    GridSamples ground = RandomGround(33, 27, { 2.0, 1.5 }, seed);
    for (std::size_t cell = 0; cell < ground.Values.size(); ++cell)
    {
      const double x = static_cast<double>(cell % 33) - 15.0;
      const double y = static_cast<double>(cell / 33) - 13.0;
      const bool isHole = std::hypot(x, y) > 13.0 || std::hypot(x - 4.0, y) < 3.0 || (cell * 7 + seed) % 97 == 0;
      ground.Values[cell] = isHole ? std::numeric_limits<double>::quiet_NaN() : ground.Values[cell];
    }
    for (const OutletMask& outlets : { RimOutlets(ground), LowestRimOutlets(ground), SeaOutlets(ground, 0.1) })
    {
      ASSERT_EQ(WhyUndrainable(ground, outlets), "");
      const FlowRouting routing = RouteFlow(ground, outlets);
      const std::vector<CellIndex> cells = FlowAccumulation(routing);
      ASSERT_EQ(routing.Order.size(), ground.Values.size());
      CellIndex atOutlets = 0;
      for (std::size_t cell = 0; cell < cells.size(); ++cell)
      {
        const auto receiver = static_cast<std::size_t>(routing.Receiver[cell]);
        if (std::isnan(ground.Values[cell]))
        {
          EXPECT_EQ(receiver, cell);
          EXPECT_EQ(cells[cell], 1);
          continue;
        }
        EXPECT_FALSE(std::isnan(ground.Values[receiver]));
        EXPECT_EQ(receiver == cell, outlets[cell] != 0);
        atOutlets += outlets[cell] ? cells[cell] : 0;
      }
      EXPECT_EQ(atOutlets, static_cast<CellIndex>(PresentValues(ground.Values).size()));
    }
    // The rim: cells that have a missing neighbour, or too few. The lowest of its cells in each part are on it.
    const OutletMask rim = RimOutlets(ground);
    const OutletMask lowest = LowestRimOutlets(ground);
    for (std::size_t cell = 0; cell < rim.size(); ++cell)
    {
      EXPECT_LE(lowest[cell], rim[cell]);
    }
    for (std::size_t cell = 0; cell < rim.size(); ++cell)
    {
      const std::vector<int> around = NeighboursOf(ground, static_cast<int>(cell));
      const bool isBeside =
        std::any_of(around.begin(), around.end(), [&](int n) { return std::isnan(ground.Values[n]); });
      EXPECT_EQ(rim[cell] != 0, around.size() < 8 || isBeside || std::isnan(ground.Values[cell]));
    }
  }
}

TEST(FlowRouting, EachPartNeedsAnOutlet)
{
  GridSamples ground = RandomGround(20, 12, { 1.0, 1.0 }, 3);
  for (int j = 0; j < 12; ++j)
  {
    ground.At(9, j) = std::numeric_limits<double>::quiet_NaN();
  }
  const OutletMask lowest = LowestRimOutlets(ground);
  EXPECT_EQ(std::count(lowest.begin(), lowest.end(), 1), 12 + 2);
  OutletMask one = OutsideOf(ground);
  one[0] = 1;
  EXPECT_EQ(WhyUndrainable(ground, one),
    "No cell is an outlet in 1 of 2 parts of the terrain; water must be able to leave each.");
  EXPECT_EQ(WhyUndrainable(ground, SeaOutletsAlone(ground, -1e9)),
    "No cell is an outlet in 2 of 2 parts of the terrain; water must be able to leave each.");
}

TEST(FlowRouting, HolesAreFilledSmoothly)
{
  const GridSamples plane = Ground(37, 30, { 1.0, 1.0 }, [](double x, double y) { return 3.0 + 0.2 * x - 0.1 * y; });
  GridSamples holed = plane;
  for (int j = 10; j < 15; ++j)
  {
    for (int i = 12; i < 20; ++i)
    {
      holed.At(i, j) = std::numeric_limits<double>::quiet_NaN();
    }
  }
  FillHoles(holed);
  for (std::size_t cell = 0; cell < plane.Values.size(); ++cell)
  {
    EXPECT_NEAR(holed.Values[cell], plane.Values[cell], 0.8);
  }
  EXPECT_EQ(holed.At(11, 12), plane.At(11, 12));
  GridSamples none = plane;
  none.Values.assign(none.Values.size(), std::numeric_limits<double>::quiet_NaN());
  FillHoles(none);
  EXPECT_TRUE(std::isnan(none.At(3, 3)));
}
