// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPointCells_h
#define LittoralPointCells_h

#include "Patterns/ObservationWindow.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace littoral
{

/**
 * Points sorted into the square cells of a grid, row by row, to find those that are near. Points of cells that lie side
 * by side follow each other.
 */
class PointCells
{
public:
  /// Cells of at least a size [m], and no more than some for each point.
  PointCells(const std::vector<PlanePosition>& points, double size);

  std::size_t Size() const { return this->X.size(); }
  const std::vector<double>& GetX() const { return this->X; } ///< sorted [m]
  const std::vector<double>& GetY() const { return this->Y; } ///< sorted [m]
  /// The place in the given points of each sorted one.
  const std::vector<std::size_t>& GetOrder() const { return this->Order; }

  int ColumnOf(double x) const { return Clamped((x - this->Low[0]) / this->CellSize, this->Columns); }
  int RowOf(double y) const { return Clamped((y - this->Low[1]) / this->CellSize, this->Rows); }

  /// Calls found(begin, end) for ranges of sorted points that hold all those within a radius [m] of a position, and few
  /// others; those of rows before `firstRow` are left out.
  template <typename Found>
  void ForRangesNear(double x, double y, double radius, int firstRow, const Found& found) const
  {
    const int last = this->RowOf(y + radius);
    for (int row = std::max(firstRow, this->RowOf(y - radius)); row <= last; ++row)
    {
      // How far the circle reaches along x in this row.
      const double below = this->Low[1] + row * this->CellSize;
      const double off = std::max(0.0, std::max(below - y, y - below - this->CellSize));
      const double reach = std::sqrt(std::max(0.0, radius * radius - off * off)) + 1e-9 * this->CellSize;
      const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Columns);
      found(this->Starts[first + static_cast<std::size_t>(this->ColumnOf(x - reach))],
        this->Starts[first + static_cast<std::size_t>(this->ColumnOf(x + reach)) + 1]);
    }
  }

  /// Distance from a position to the nearest point [m], leaving out the sorted point `except`; infinite without one.
  double NearestDistance(double x, double y, std::size_t except = std::numeric_limits<std::size_t>::max()) const;

private:
  static int Clamped(double cell, int count)
  {
    return static_cast<int>(std::min(std::max(cell, 0.0), static_cast<double>(count - 1)));
  }

  PlanePosition Low{ 0.0, 0.0 };
  double CellSize = 1.0;
  int Columns = 1;
  int Rows = 1;
  std::vector<double> X;
  std::vector<double> Y;
  std::vector<std::size_t> Order;
  std::vector<std::size_t> Starts; ///< the first sorted point of each cell, and the end
};

}

#endif
