// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCellLattice_h
#define LittoralCellLattice_h

#include "Numerics/Prefetch.h"
#include "Terrain/GridSamples.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace littoral
{

/// Index of a cell of a grid, x fastest.
using CellIndex = std::int32_t;

/// Cells of a grid, one around each height, and their eight neighbours. Directions 0 to 7 run counter-clockwise in
/// steps of 45 degrees, 0 along x.
class CellLattice
{
public:
  static constexpr int Directions = 8;
  static constexpr std::array<int, Directions> StepX{ 1, 1, 0, -1, -1, -1, 0, 1 };
  static constexpr std::array<int, Directions> StepY{ 0, 1, 1, 1, 0, -1, -1, -1 };

  CellLattice(int width, int height, const std::array<double, 2>& spacing)
    : Width(width)
    , Height(height)
    , Area(spacing[0] * spacing[1])
  {
    for (int d = 0; d < Directions; ++d)
    {
      this->Offsets[d] = StepY[d] * width + StepX[d];
      this->Distances[d] = std::hypot(StepX[d] * spacing[0], StepY[d] * spacing[1]);
    }
  }
  explicit CellLattice(const GridSamples& samples)
    : CellLattice(samples.Width, samples.Height, samples.Spacing)
  {
  }

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  CellIndex Count() const { return static_cast<CellIndex>(static_cast<std::int64_t>(this->Width) * this->Height); }
  /// Area of a cell [m^2].
  double CellArea() const { return this->Area; }
  /// Distance to the neighbour in a direction [m].
  double Distance(int direction) const { return this->Distances[direction]; }
  /// Difference of the neighbour's index and the cell's.
  CellIndex Offset(int direction) const { return this->Offsets[direction]; }

  /// Calls visit(neighbour, direction) for the neighbours within the grid, by direction.
  template <typename Visit>
  void ForEachNeighbour(CellIndex cell, const Visit& visit) const
  {
    const int i = cell % this->Width;
    const int j = cell / this->Width;
    const bool isInside = i > 0 && j > 0 && i < this->Width - 1 && j < this->Height - 1;
    for (int d = 0; d < Directions; ++d)
    {
      if (isInside ||
        (i + StepX[d] >= 0 && i + StepX[d] < this->Width && j + StepY[d] >= 0 && j + StepY[d] < this->Height))
      {
        visit(cell + this->Offsets[d], d);
      }
    }
  }

  /// The direction from a cell to one of its neighbours; -1 to itself and to cells that are none.
  int DirectionTo(CellIndex cell, CellIndex neighbour) const
  {
    const int x = neighbour % this->Width - cell % this->Width;
    const int y = neighbour / this->Width - cell / this->Width;
    for (int d = 0; d < Directions; ++d)
    {
      if (x == StepX[d] && y == StepY[d])
      {
        return d;
      }
    }
    return -1;
  }

  /// Asks for the numbers of a cell and of its neighbours that are within the grid.
  template <typename Value>
  void PrefetchAround(const Value* values, CellIndex cell) const
  {
    for (const CellIndex row : { cell - this->Width, cell, cell + this->Width })
    {
      if (row >= 0 && row < this->Count())
      {
        Prefetch(values + row);
      }
    }
  }

  /// The cell before one that was reached in a direction; itself for Directions.
  CellIndex Before(CellIndex cell, int direction) const
  {
    return direction < Directions ? cell - this->Offsets[direction] : cell;
  }

private:
  int Width;
  int Height;
  double Area;
  std::array<CellIndex, Directions> Offsets{};
  std::array<double, Directions> Distances{};
};

}

#endif
