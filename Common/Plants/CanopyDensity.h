// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCanopyDensity_h
#define LittoralCanopyDensity_h

#include "Plants/CanopyCells.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

/// Why there is no such grid; empty if there is.
std::string WhyInvalid(const CanopyGrid& grid);

/// Leaves and wood of a stand in the cells of a grid. Amounts are added by any threads in any order.
class CanopyDensity
{
public:
  /// Kinds of plants by their dry leaf mass per area [kg/m2]; with a sum of leaves for each of them on request.
  CanopyDensity(const CanopyGrid& grid, const std::vector<double>& massPerArea, bool byKind);

  const CanopyGrid& GetGrid() const { return this->Grid; }

  /// Memory [bytes].
  static double BytesOf(const CanopyGrid& grid, const std::vector<double>& massPerArea, bool byKind);

  /// One-sided leaf area [m2] of a kind; the cell may be OutsideCells.
  void AddLeaf(int kind, std::size_t cell, double area)
  {
    const std::size_t place = std::min(cell, this->Cells);
    this->Leaf.Add(place, area);
    if (this->Mass.Size() > 0)
    {
      this->Mass.Add(place, area * this->MassPerArea[kind]);
    }
    if (!this->OfKind.empty())
    {
      this->OfKind[kind].Add(place, area);
    }
  }

  /// Half the surface of wood [m2].
  void AddWood(std::size_t cell, double area) { this->Wood.Add(std::min(cell, this->Cells), area); }

  /// Takes in what other processes count of the same grid.
  void AddUp(const WorkShare& share);

  double LeafArea(std::size_t cell) const { return this->Leaf.At(cell); }
  double LeafAreaOf(int kind, std::size_t cell) const { return this->OfKind[kind].At(cell); }
  double WoodArea(std::size_t cell) const { return this->Wood.At(cell); }
  double LeafMass(std::size_t cell) const
  {
    return this->Mass.Size() > 0 ? this->Mass.At(cell) : this->Leaf.At(cell) * this->MassPerArea.front();
  }
  double LeafOutside() const { return this->Leaf.At(this->Cells); }

private:
  static bool AreAlike(const std::vector<double>& massPerArea);

  CanopyGrid Grid;
  std::size_t Cells;
  std::vector<double> MassPerArea;
  OrderFreeSums Leaf; ///< of each cell, and of what is beyond
  OrderFreeSums Wood;
  OrderFreeSums Mass; ///< empty where all kinds have the same mass per area
  std::vector<OrderFreeSums> OfKind;
};

}

#endif
