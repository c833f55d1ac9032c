// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/FlatRouting.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

/// A cell beside a flat as high as it, and the cell by which a flood of drained ground comes to it: its lowest
/// neighbour, itself at outlets.
struct RimCell
{
  CellIndex Cell = -1;
  CellIndex From = -1;
  int Direction = -1;
  bool IsClear = true; ///< whether no other neighbour is as low
};

class FloodedFlats
{
public:
  FloodedFlats(const std::vector<double>& heights, const OutletMask& outlets, const CellLattice& lattice,
    std::vector<CellIndex>& receivers)
    : Heights(heights)
    , Outlets(outlets)
    , Lattice(lattice)
    , Receivers(receivers)
  {
  }

  /// Routes the flat of a cell; whether it has a rim of which one cell comes first.
  bool Route(CellIndex first)
  {
    this->Collect(first);
    if (this->Rim.empty())
    {
      return false;
    }
    RimCell earliest = this->RimCellOf(this->Rim.front());
    bool isClear = true;
    for (std::size_t n = 1; n < this->Rim.size(); ++n)
    {
      const RimCell other = this->RimCellOf(this->Rim[n]);
      const int order = this->Compare(earliest, other);
      isClear = order > 0 || (order < 0 && isClear) || (isClear && this->AreClear(earliest, other));
      const bool isOther = order > 0 || (order == 0 && this->DirectionFrom(other) < this->DirectionFrom(earliest));
      earliest = isOther ? other : earliest;
    }
    if (isClear)
    {
      this->FloodFrom(earliest.Cell);
    }
    return isClear;
  }

private:
  static constexpr CellIndex OnFlat = -2;

  /// Marks the cells of a flat, and finds the cells of its rim.
  void Collect(CellIndex first)
  {
    this->Flat.assign(1, first);
    this->Rim.clear();
    this->Receivers[first] = OnFlat;
    for (std::size_t n = 0; n < this->Flat.size(); ++n)
    {
      const CellIndex cell = this->Flat[n];
      this->Lattice.ForEachNeighbour(cell, [&](CellIndex neighbour, int) {
        if (this->Receivers[neighbour] == -1)
        {
          this->Receivers[neighbour] = OnFlat;
          this->Flat.push_back(neighbour);
        }
        else if (this->Receivers[neighbour] >= 0 && this->Heights[neighbour] == this->Heights[cell])
        {
          this->Rim.push_back(neighbour);
        }
      });
    }
    std::sort(this->Rim.begin(), this->Rim.end());
    this->Rim.erase(std::unique(this->Rim.begin(), this->Rim.end()), this->Rim.end());
  }

  RimCell RimCellOf(CellIndex cell) const
  {
    RimCell rim{ cell, cell };
    if (this->Outlets[cell])
    {
      return rim;
    }
    this->Lattice.ForEachNeighbour(cell, [&](CellIndex neighbour, int direction) {
      if (this->Heights[neighbour] < this->Heights[rim.From])
      {
        rim = { cell, neighbour, direction, true };
      }
      else if (this->Heights[neighbour] == this->Heights[rim.From])
      {
        rim.IsClear = false;
      }
    });
    return rim;
  }

  /// Below 0 where a flood comes to one cell of a rim before it does to another, as it begins at the outlets and goes
  /// on at the lowest cell; 0 where it comes to both from cells of one height.
  int Compare(const RimCell& one, const RimCell& other) const
  {
    if (this->Outlets[one.Cell] || this->Outlets[other.Cell])
    {
      return this->Outlets[one.Cell] && (!this->Outlets[other.Cell] || one.Cell < other.Cell) ? -1 : 1;
    }
    const double difference = this->Heights[one.From] - this->Heights[other.From];
    return difference < 0.0 ? -1 : difference > 0.0;
  }

  /// Whether it comes to both from the same cell.
  static bool AreClear(const RimCell& one, const RimCell& other)
  {
    return one.From == other.From && one.IsClear && other.IsClear;
  }

  /// Direction in which a flood comes to a cell of a rim.
  static int DirectionFrom(const RimCell& rim)
  {
    return (rim.Direction + CellLattice::Directions / 2) % CellLattice::Directions;
  }

  void FloodFrom(CellIndex rim)
  {
    this->Flat.assign(1, rim);
    for (std::size_t n = 0; n < this->Flat.size(); ++n)
    {
      const CellIndex cell = this->Flat[n];
      this->Lattice.ForEachNeighbour(cell, [&](CellIndex neighbour, int) {
        if (this->Receivers[neighbour] == OnFlat)
        {
          this->Receivers[neighbour] = cell;
          this->Flat.push_back(neighbour);
        }
      });
    }
  }

  const std::vector<double>& Heights;
  const OutletMask& Outlets;
  const CellLattice& Lattice;
  std::vector<CellIndex>& Receivers;
  std::vector<CellIndex> Flat;
  std::vector<CellIndex> Rim;
};

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

bool RouteFlatsAsFlood(const std::vector<double>& heights, const OutletMask& outlets, const CellLattice& lattice,
  std::vector<CellIndex>& receivers, const Poll& poll)
{
  FloodedFlats flats(heights, outlets, lattice, receivers);
  SteppedPoll steps(poll, 1 << 16);
  for (CellIndex cell = 0; cell < lattice.Count(); ++cell)
  {
    steps.Step();
    if (receivers[cell] < 0 && (std::isnan(heights[cell]) || !flats.Route(cell)))
    {
      return false;
    }
  }
  return true;
}

}
