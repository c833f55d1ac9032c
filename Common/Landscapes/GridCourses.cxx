// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/GridCourses.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace littoral
{

namespace
{

constexpr int MostPasses = 20; ///< over rivers that take each other's water

using Cells = std::vector<CellIndex>;

Cells CellsOf(const GridSamples& ground, const GivenLine& line)
{
  Cells cells;
  for (const LineCell& piece : CellsAlong(line, ground.Width, ground.Height, ground.Spacing))
  {
    cells.push_back(piece.Cell);
  }
  return cells;
}

/// The same cells, with the higher one of the corners at each diagonal step.
Cells WithCorners(const GridSamples& ground, const Cells& cells)
{
  Cells whole;
  for (const CellIndex cell : cells)
  {
    if (!whole.empty() && whole.back() % ground.Width != cell % ground.Width &&
      whole.back() / ground.Width != cell / ground.Width)
    {
      const CellIndex before = whole.back();
      const CellIndex one = before / ground.Width * ground.Width + cell % ground.Width;
      const CellIndex other = cell / ground.Width * ground.Width + before % ground.Width;
      whole.push_back(ground.Values[one] > ground.Values[other] ? one : other);
    }
    whole.push_back(cell);
  }
  return whole;
}

/// Lowers the cells of a river to their banks and to what is upstream; whether any was higher.
bool LowerAlong(GridSamples& ground, const Cells& cells, const std::vector<std::uint8_t>& isRiver, double leastSlope)
{
  const CellLattice lattice(ground);
  bool isLowered = false;
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    double& height = ground.Values[cells[n]];
    lattice.ForEachNeighbour(cells[n], [&](CellIndex bank, int direction) {
      const double most = ground.Values[bank] - leastSlope * lattice.Distance(direction);
      const bool isBefore = n > 0 && bank == cells[n - 1];
      if ((isBefore || !isRiver[bank]) && height > most)
      {
        height = most;
        isLowered = true;
      }
    });
  }
  return isLowered;
}

void RaiseAlong(GridSamples& ground, const Cells& cells, const std::vector<std::uint8_t>& isRiver)
{
  const CellLattice lattice(ground);
  for (const CellIndex cell : cells)
  {
    double& height = ground.Values[cell];
    lattice.ForEachNeighbour(
      cell, [&](CellIndex next, int) { height = isRiver[cell] ? height : std::max(height, ground.Values[next]); });
  }
}

}

void LeadGrid(GridSamples& ground, const GivenGround& given, double leastSlope)
{
  std::vector<Cells> rivers;
  std::vector<std::uint8_t> isRiver(ground.Values.size(), 0);
  for (const GivenLine& river : given.Rivers)
  {
    rivers.push_back(CellsOf(ground, river));
    for (const CellIndex cell : rivers.back())
    {
      isRiver[cell] = 1;
    }
  }
  for (const GivenLine& ridge : given.Ridges)
  {
    RaiseAlong(ground, WithCorners(ground, CellsOf(ground, ridge)), isRiver);
  }
  // again for rivers whose tributaries came later
  bool isLowered = true;
  for (int pass = 0; pass < MostPasses && isLowered; ++pass)
  {
    isLowered = false;
    for (const Cells& cells : rivers)
    {
      isLowered |= LowerAlong(ground, cells, isRiver, leastSlope);
    }
  }
}

}
