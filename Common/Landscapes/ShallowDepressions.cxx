// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/ShallowDepressions.h"

#include "Drainage/ConnectedCells.h"
#include "Numerics/PolledMemory.h"

#include <algorithm>
#include <cstddef>

namespace littoral
{

namespace
{

struct Depression
{
  double Depth = 0.0; ///< [m]
  std::vector<CellIndex> Cells;
};

/// Cells under water that hang together, and so have one level.
std::vector<Depression> DepressionsOf(const CellLattice& lattice, const std::vector<double>& depths, const Poll& poll)
{
  std::vector<Depression> depressions;
  const auto areWet = [&](CellIndex cell, CellIndex next, int) { return depths[cell] > 0.0 && depths[next] > 0.0; };
  const auto add = [&](const std::vector<CellIndex>& cells) {
    double depth = 0.0;
    for (const CellIndex cell : cells)
    {
      depth = std::max(depth, depths[cell]);
    }
    if (depth > 0.0)
    {
      depressions.push_back({ depth, cells });
    }
  };
  ForEachConnected(lattice, areWet, add, poll);
  return depressions;
}

}

std::vector<double> ShallowDepressions(
  const GridSamples& ground, const std::vector<double>& levels, double share, const Poll& poll)
{
  std::vector<double> depths;
  Lengthen(depths, levels.size(), poll);
  ForPolled(levels.size(), poll, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      depths[n] = levels[n] - ground.Values[n];
    }
  });
  std::vector<Depression> depressions = DepressionsOf(CellLattice(ground), depths, poll);
  std::stable_sort(depressions.begin(), depressions.end(),
    [](const Depression& one, const Depression& other) { return one.Depth < other.Depth; });
  poll();
  std::vector<double> shallow;
  Lengthen(shallow, depths.size(), poll);
  double left = share * static_cast<double>(depths.size());
  for (const Depression& depression : depressions)
  {
    poll();
    left -= static_cast<double>(depression.Cells.size());
    if (left < 0.0)
    {
      break;
    }
    for (const CellIndex cell : depression.Cells)
    {
      shallow[cell] = depths[cell];
    }
  }
  return shallow;
}

}
