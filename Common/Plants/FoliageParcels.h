// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFoliageParcels_h
#define LittoralFoliageParcels_h

#include "Plants/PlantFoliage.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// All of a plant's leaves, or of its bark, that lie in a small box.
struct FoliageParcel
{
  Vector3 Center; ///< mean place of the area [m]
  double Across;  ///< half side along x and y [m]: the box has the deviations of the area
  double Up;      ///< half side along z [m]
  double Area;    ///< [m2]
};

/// Triangles in parcels, for many plants of a kind in cells that are coarser than leaves.
class FoliageParcels
{
public:
  FoliageParcels() = default;

  /// Boxes with sides of at most `side` [m].
  FoliageParcels(const std::vector<FoliageTriangle>& triangles, double side);

  const std::vector<FoliageParcel>& Parcels() const { return this->List; }

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
  void Begin(const CanopyGrid& grid, const Vector3& low, const Vector3& high);
  void Add(const Vector3& center, double across, double up, double area);
  /// Hands over all sums that are not 0, and the rest that is beyond the grid.
  template <typename Take>
  void End(const Take& take)
  {
    const std::size_t rows = static_cast<std::size_t>(this->Count[1]) * this->Count[2];
    for (std::size_t row = 0, n = 0; row < rows; ++row)
    {
      const auto j = static_cast<int>(row % this->Count[1]);
      const auto k = static_cast<int>(row / this->Count[1]);
      const std::size_t first = this->Grid->IndexOf(this->First[0], this->First[1] + j, this->First[2] + k);
      for (int i = 0; i < this->Count[0]; ++i, ++n)
      {
        if (this->Sums[n] > 0.0)
        {
          take(first + i, this->Sums[n]);
        }
      }
    }
    if (this->Outside > 0.0)
    {
      take(OutsideCells, this->Outside);
    }
  }

private:
  const CanopyGrid* Grid = nullptr;
  std::array<int, 3> First{ 0, 0, 0 };
  std::array<int, 3> Count{ 0, 0, 0 };
  std::vector<double> Sums;
  double Outside = 0.0;
};

/// A plant by its parcels. Totals are exact, places within half a parcel.
void AddPlant(const ParcelledPlant& plant, const FoliagePlace& place, PlantCells& cells, CanopyDensity& density);

}

#endif
