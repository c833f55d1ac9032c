// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralConnectedCells_h
#define LittoralConnectedCells_h

#include "Drainage/CellLattice.h"
#include "Numerics/Parallel.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace littoral
{

/// Calls visit(cells) with the cells of each connected part, in the order of their first cells. Neighbours are
/// connected where joins(cell, neighbour, direction) is true, which it is both ways or neither.
template <typename Joins, typename Visit>
void ForEachConnected(const CellLattice& lattice, const Joins& joins, const Visit& visit, const Poll& poll = NoPoll)
{
  SteppedPoll steps(poll, 1 << 16);
  std::vector<std::uint8_t> isFound(static_cast<std::size_t>(lattice.Count()), 0);
  std::vector<CellIndex> cells;
  for (CellIndex first = 0; first < lattice.Count(); ++first)
  {
    steps.Step();
    cells.assign(isFound[first] ? 0 : 1, first);
    isFound[first] = 1;
    for (std::size_t n = 0; n < cells.size(); ++n)
    {
      const CellIndex cell = cells[n];
      lattice.ForEachNeighbour(cell, [&](CellIndex next, int direction) {
        if (!isFound[next] && joins(cell, next, direction))
        {
          isFound[next] = 1;
          cells.push_back(next);
        }
      });
    }
    if (!cells.empty())
    {
      visit(cells);
    }
  }
}

}

#endif
