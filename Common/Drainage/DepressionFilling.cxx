// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/DepressionFilling.h"

#include "Drainage/FloodQueue.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

DepressionFlood FloodDepressions(const GridSamples& heights, const OutletMask& outlets, const Poll& poll)
{
  const CellLattice lattice(heights);
  const CellIndex count = lattice.Count();
  DepressionFlood flood;
  flood.SpillElevation = heights.Values;
  flood.Backlink.assign(count, -1);
  const auto [lowest, highest] = RangeOf(heights.Values);
  FloodQueue rim(lowest, highest, heights.Values.size());
  for (CellIndex cell = 0; cell < count; ++cell)
  {
    if (outlets[cell])
    {
      flood.Backlink[cell] = cell;
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
    lake.assign(1, rim.Pop());
    const double level = flood.SpillElevation[lake.front()];
    for (std::size_t n = 0; n < lake.size(); ++n)
    {
      steps.Step();
      lattice.ForEachNeighbour(lake[n], [&](CellIndex neighbour, int) {
        if (flood.Backlink[neighbour] >= 0)
        {
          return;
        }
        flood.Backlink[neighbour] = lake[n];
        const double ground = heights.Values[neighbour];
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
  return flood;
}

}
