// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFoliageParcels_h
#define LittoralFoliageParcels_h

#include "Plants/PlantFoliage.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace littoral
{

/// All of a plant's leaves, or of its bark, that lie in a small box.
struct FoliageParcel
{
  Vector3 Center;   ///< mean place of the area [m]
  double Across;    ///< half side along x and y [m]: the box has the deviations of the area
  double Up;        ///< half side along z [m]
  double PerAcross; ///< 1 over the whole side [1/m]; 0 of none
  double PerUp;
  double Area; ///< [m2]
};

/// Triangles in parcels, for many plants of a kind in cells that are coarser than leaves.
class FoliageParcels
{
public:
  FoliageParcels() = default;

  /// Boxes with sides of at most `side` [m].
  FoliageParcels(const std::vector<FoliageTriangle>& triangles, double side);

  const std::vector<FoliageParcel>& Parcels() const { return this->List; }

  /// Area of all parcels [m2].
  double Area() const { return this->Sum; }

  /// Corners of a box around them [m].
  const Vector3& Low() const { return this->Lowest; }
  const Vector3& High() const { return this->Highest; }

  /// Area of all triangles scaled by (1, 1, stretch), over their own: the sum over triangles of
  /// A sqrt(stretch^2 (1 - n_z^2) + n_z^2) over that of A.
  double AreaFactor(double stretch) const;

private:
  /// A triangle's area and the square of the vertical part of its normal.
  struct Facet
  {
    double Area;
    double Square;
  };

  double FactorOf(double stretch) const;

  std::vector<FoliageParcel> List;
  double Sum = 0.0;
  Vector3 Lowest{ std::numeric_limits<double>::max() };
  Vector3 Highest{ -std::numeric_limits<double>::max() };
  std::vector<Facet> Facets;
  std::vector<double> Factors; ///< at equal steps of the logarithm of the stretch
};

/// Leaves and bark of a kind in parcels.
struct ParcelledPlant
{
  FoliageParcels Leaves;
  FoliageParcels Wood;
};

/// Sums over a box of cells around one plant, in which it is added up before the whole grid is touched.
class PlantCells
{
public:
  /// Starts with the cells between two places [m]; returns the lowest corner of the first of them.
  Vector3 Begin(const CanopyGrid& grid, const Vector3& low, const Vector3& high);
  bool HasCells() const { return !this->Sums.empty(); }

  /// Adds a box by its middle, half sides and 1 over its sides (0 of none), in units of cells from the first one.
  void Add(const Vector3& center, const Vector3& half, const Vector3& perSide, double area);

  /// Hands over all sums that are not 0, and the rest that is beyond the grid.
  template <typename Take>
  void End(const Take& take)
  {
    std::size_t n = 0;
    for (int k = 0; k <= this->Count[2]; ++k)
    {
      for (int j = 0; j <= this->Count[1]; ++j)
      {
        const std::size_t first = this->Grid->IndexOf(this->First[0], this->First[1] + j, this->First[2] + k);
        for (int i = 0; i <= this->Count[0]; ++i, ++n)
        {
          const bool isWithin = i < this->Count[0] && j < this->Count[1] && k < this->Count[2];
          if (isWithin && this->Sums[n] > 0.0)
          {
            take(first + static_cast<std::size_t>(i), this->Sums[n]);
          }
          this->Outside += isWithin ? 0.0 : this->Sums[n];
        }
      }
    }
    if (this->Outside > 0.0)
    {
      take(OutsideCells, this->Outside);
    }
  }

private:
  /// Adds a box that reaches beyond the next cell, or beyond the cells.
  void AddLarge(const Vector3& center, const Vector3& half, double area);

  const CanopyGrid* Grid = nullptr;
  std::array<int, 3> First{ 0, 0, 0 };
  std::array<int, 3> Count{ 0, 0, 0 };
  std::vector<double> Sums;
  double Outside = 0.0;
};

/// Plants in an order in which neighbours come one after the other.
std::vector<std::size_t> OrderOfNeighbors(const CanopyGrid& grid, const std::vector<FoliagePlace>& places);

/// A plant by its parcels. Totals are exact, places within half a parcel.
void AddPlant(const ParcelledPlant& plant, const FoliagePlace& place, PlantCells& cells, CanopyDensity& density);

}

#endif
