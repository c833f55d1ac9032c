// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/StandingWater.h"

#include "Drainage/ConnectedCells.h"

namespace littoral
{

std::vector<std::uint8_t> StandingWater(const GridSamples& ground, std::size_t least)
{
  std::vector<std::uint8_t> isWater(ground.Values.size(), 0);
  const auto isLevel = [&](CellIndex cell, CellIndex next, int direction) {
    const bool isBeside = direction % 2 == 0;
    return isBeside && ground.Values[next] == ground.Values[cell];
  };
  const auto mark = [&](const std::vector<CellIndex>& level) {
    for (std::size_t n = 0; n < level.size() && level.size() >= least; ++n)
    {
      isWater[level[n]] = 1;
    }
  };
  ForEachConnected(CellLattice(ground), isLevel, mark);
  return isWater;
}

}
