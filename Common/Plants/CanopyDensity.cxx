// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/CanopyDensity.h"

namespace littoral
{

namespace
{

constexpr int MostAlong = 100000; ///< cells along a side
constexpr double BytesOfSum = 8.0;

}

std::string WhyInvalid(const CanopyGrid& grid)
{
  ParameterCheck check;
  const char* const axes[] = { "x", "y", "z" };
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string ofAxis = std::string(" along ") + axes[axis];
    check.Finite("Bounds" + ofAxis, grid.Origin[axis], "m");
    check.Positive("CellSize" + ofAxis, grid.Spacing[axis], "m");
    check.Count("The number of cells" + ofAxis, grid.Count[axis], 1, MostAlong);
  }
  return check.Reason();
}

bool CanopyDensity::AreAlike(const std::vector<double>& massPerArea)
{
  return std::all_of(massPerArea.begin(), massPerArea.end(), [&](double mass) { return mass == massPerArea.front(); });
}

double CanopyDensity::BytesOf(const CanopyGrid& grid, const std::vector<double>& massPerArea, bool byKind)
{
  const double sums =
    2.0 + (AreAlike(massPerArea) ? 0.0 : 1.0) + (byKind ? static_cast<double>(massPerArea.size()) : 0.0);
  return sums * BytesOfSum * static_cast<double>(grid.NumberOfCells());
}

CanopyDensity::CanopyDensity(const CanopyGrid& grid, const std::vector<double>& massPerArea, bool byKind)
  : Grid(grid)
  , Cells(grid.NumberOfCells())
  , MassPerArea(massPerArea)
  , Leaf(Cells + 1)
  , Wood(Cells + 1)
  , Mass(AreAlike(massPerArea) ? 0 : Cells + 1)
{
  for (std::size_t kind = 0; byKind && kind < massPerArea.size(); ++kind)
  {
    this->OfKind.emplace_back(this->Cells + 1);
  }
}

void CanopyDensity::AddUp(const WorkShare& share)
{
  for (OrderFreeSums* sums : { &this->Leaf, &this->Wood, &this->Mass })
  {
    sums->AddUp(share);
  }
  for (OrderFreeSums& sums : this->OfKind)
  {
    sums.AddUp(share);
  }
}

}
