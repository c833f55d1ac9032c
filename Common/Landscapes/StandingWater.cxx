// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/StandingWater.h"

#include "Drainage/CellLattice.h"

namespace littoral
{

std::vector<std::uint8_t> StandingWater(const GridSamples& ground, std::size_t least)
{
  const CellLattice lattice(ground);
  std::vector<std::uint8_t> isWater(ground.Values.size(), 0);
  std::vector<std::uint8_t> isSeen = isWater;
  std::vector<CellIndex> level;
  for (CellIndex first = 0; first < lattice.Count(); ++first)
  {
    level.assign(isSeen[first] ? 0 : 1, first);
    for (std::size_t n = 0; n < level.size(); ++n)
    {
      isSeen[level[n]] = 1;
      lattice.ForEachNeighbour(level[n], [&](CellIndex next, int direction) {
        const bool isBeside = direction % 2 == 0;
        if (isBeside && !isSeen[next] && ground.Values[next] == ground.Values[first])
        {
          isSeen[next] = 1;
          level.push_back(next);
        }
      });
    }
    for (std::size_t n = 0; n < level.size() && level.size() >= least; ++n)
    {
      isWater[level[n]] = 1;
    }
  }
  return isWater;
}

}
