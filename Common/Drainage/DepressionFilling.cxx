// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/DepressionFilling.h"

#include "Drainage/FloodQueue.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace littoral
{

DepressionFlood FloodDepressions(const GridSamples& heights, const OutletMask& outlets, const Poll& poll)
{
  const CellLattice lattice(heights);
  const CellIndex count = lattice.Count();
  DepressionFlood flood;
  flood.SpillElevation = heights.Values;
  poll();
  // Directions in which cells were reached: a byte each, so that those about the rim stay in the cache.
  constexpr std::int8_t unreached = -1;
  std::vector<std::int8_t> reached(static_cast<std::size_t>(count), unreached);
  const auto [lowest, highest] = RangeOf(heights.Values);
  FloodQueue rim(lowest, highest, heights.Values.size());
  poll();
  for (CellIndex cell = 0; cell < count; ++cell)
  {
    if (outlets[cell])
    {
      reached[cell] = CellLattice::Directions;
      if (!std::isnan(heights.Values[cell])) // else it is outside
      {
        rim.Push(cell, heights.Values[cell]);
      }
    }
  }
  // What lies below the water is filled at once, in the order in which it is reached: no heap is needed for it.
  std::vector<CellIndex> lake;
  SteppedPoll steps(poll, 1 << 16);
  while (!rim.IsEmpty())
  {
    double level = 0.0;
    lake.assign(1, rim.Pop(level));
    rim.ForNext([&](CellIndex cell) {
      lattice.PrefetchAround(flood.SpillElevation.data(), cell);
      lattice.PrefetchAround(reached.data(), cell);
    });
    for (std::size_t n = 0; n < lake.size(); ++n)
    {
      steps.Step();
      lattice.ForEachNeighbour(lake[n], [&](CellIndex neighbour, int direction) {
        if (reached[neighbour] != unreached)
        {
          return;
        }
        reached[neighbour] = static_cast<std::int8_t>(direction);
        const double ground = flood.SpillElevation[neighbour]; // not yet raised
        if (ground > level)
        {
          rim.Push(neighbour, ground);
          return;
        }
        // w = max(z, level of the cell before): priority-flood
        flood.SpillElevation[neighbour] = level;
        flood.DepressionCells += ground < level;
        flood.Volume += (level - ground) * lattice.CellArea();
        lake.push_back(neighbour);
      });
    }
  }
  flood.Backlink.resize(count);
  ForPolled(flood.Backlink.size(), poll, [&](std::size_t begin, std::size_t end) {
    for (auto cell = static_cast<CellIndex>(begin); cell < static_cast<CellIndex>(end); ++cell)
    {
      flood.Backlink[cell] = reached[cell] == unreached ? -1 : lattice.Before(cell, reached[cell]);
    }
  });
  return flood;
}

std::vector<double> SpillElevationsBy(const FlowRouting& routing, const GridSamples& heights, const Poll& poll)
{
  const CellLattice lattice(heights);
  const std::vector<double>& ground = heights.Values;
  std::vector<double> levels = ground;
  poll();
  enum State : std::uint8_t
  {
    Dry,
    Open,
    Reached
  };
  std::vector<State> states(ground.size(), Dry);
  std::vector<CellIndex> open;
  SteppedPoll steps(poll);
  for (const CellIndex cell : routing.Order)
  {
    steps.Step();
    levels[cell] = std::max(ground[cell], levels[routing.Receiver[cell]]);
    if (levels[cell] > ground[cell])
    {
      states[cell] = Open;
      open.push_back(cell);
    }
  }
  poll();
  const auto [lowest, highest] = RangeOf(ground);
  FloodQueue rim(lowest, highest, open.size());
  poll();
  for (const CellIndex cell : open)
  {
    steps.Step();
    lattice.ForEachNeighbour(cell, [&](CellIndex neighbour, int) {
      if (states[neighbour] == Dry)
      {
        states[neighbour] = Reached;
        rim.Push(neighbour, ground[neighbour]);
      }
    });
  }
  FloodFrom(rim, lattice, ground, levels, poll, [&](CellIndex, CellIndex neighbour) {
    const bool isReached = states[neighbour] == Open;
    states[neighbour] = isReached ? Reached : states[neighbour];
    return isReached;
  });
  return levels;
}

}
