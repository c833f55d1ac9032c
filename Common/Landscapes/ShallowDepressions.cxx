// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/ShallowDepressions.h"

#include "Drainage/CellLattice.h"

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
  SteppedPoll steps(poll, 1 << 16);
  std::vector<Depression> depressions;
  std::vector<char> isFound(depths.size(), 0);
  for (CellIndex first = 0; first < lattice.Count(); ++first)
  {
    steps.Step();
    if (isFound[first] || !(depths[first] > 0.0))
    {
      continue;
    }
    isFound[first] = 1;
    Depression depression{ 0.0, { first } };
    for (std::size_t n = 0; n < depression.Cells.size(); ++n)
    {
      const CellIndex cell = depression.Cells[n];
      depression.Depth = std::max(depression.Depth, depths[cell]);
      lattice.ForEachNeighbour(cell, [&](CellIndex next, int) {
        if (!isFound[next] && depths[next] > 0.0)
        {
          isFound[next] = 1;
          depression.Cells.push_back(next);
        }
      });
    }
    depressions.push_back(std::move(depression));
  }
  return depressions;
}

}

std::vector<double> ShallowDepressions(
  const GridSamples& ground, const std::vector<double>& levels, double share, const Poll& poll)
{
  std::vector<double> depths(levels.size());
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
  std::vector<double> shallow(depths.size(), 0.0);
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
