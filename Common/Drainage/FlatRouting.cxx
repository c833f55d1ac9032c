// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/FlatRouting.h"

namespace littoral
{

namespace
{

/// Cells without a way beside a cell that has one, which are marked as found.
constexpr FlowCode Found = 11;

void FindBeside(const CellLattice& lattice, CellIndex cell, std::vector<FlowCode>& codes, std::vector<CellIndex>& found)
{
  lattice.ForEachNeighbour(cell, [&](CellIndex neighbour, int) {
    if (codes[neighbour] == FlowUnknown)
    {
      codes[neighbour] = Found;
      found.push_back(neighbour);
    }
  });
}

}

void RouteFlats(const CellLattice& lattice, std::vector<FlowCode>& codes, const Poll& poll)
{
  SteppedPoll steps(poll, 1 << 16);
  std::vector<CellIndex> found;
  for (CellIndex cell = 0; cell < lattice.Count(); ++cell)
  {
    steps.Step();
    if (codes[cell] >= FlowOnFlat)
    {
      FindBeside(lattice, cell, codes, found);
    }
  }
  std::vector<CellIndex> next;
  std::vector<FlowCode> ways;
  while (!found.empty())
  {
    // Two cells without a lower neighbour that touch have one level, so each way on a flat is one step nearer.
    ways.clear();
    for (const CellIndex cell : found)
    {
      steps.Step();
      ways.push_back(FirstExit(lattice, cell, [&](CellIndex neighbour) { return codes[neighbour] >= FlowOnFlat; }));
    }
    for (std::size_t n = 0; n < found.size(); ++n)
    {
      codes[found[n]] = ways[n];
    }
    next.clear();
    for (const CellIndex cell : found)
    {
      FindBeside(lattice, cell, codes, next);
    }
    found.swap(next);
  }
}

}
