// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/FoliageParcels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace littoral
{

namespace
{

// Stretches of the table: 1/8 to 8.
constexpr int FactorSteps = 256;
const double LargestLogarithm = std::log(8.0);
const double LogarithmStep = 2.0 * LargestLogarithm / FactorSteps;

/// Sums of a parcel over its parts.
struct ParcelSums
{
  double Area = 0.0;
  Vector3 First{ 0.0, 0.0, 0.0 };
  Vector3 Second{ 0.0, 0.0, 0.0 };

  void Add(double area, const Vector3& place)
  {
    this->Area += area;
    this->First += area * place;
    this->Second += area * place * place;
  }

  FoliageParcel Parcel(double side) const
  {
    const Vector3 mean = this->First / this->Area;
    // a box of half side a has the variance a^2 / 3
    const Vector3 variance = glm::max(this->Second / this->Area - mean * mean, Vector3(0.0));
    const double most = 0.5 * side;
    return { mean, std::min(most, std::sqrt(1.5 * (variance.x + variance.y))),
      std::min(most, std::sqrt(3.0 * variance.z)), this->Area };
  }
};

/// A grid with cells of a side around triangles.
CanopyGrid GridAround(const std::vector<FoliageTriangle>& triangles, double side)
{
  Vector3 low(std::numeric_limits<double>::max());
  Vector3 high(-std::numeric_limits<double>::max());
  for (const FoliageTriangle& triangle : triangles)
  {
    for (const Vector3& corner : triangle.Corners)
    {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  CanopyGrid grid;
  grid.Spacing = Vector3(side);
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Origin[axis] = std::floor(low[axis] / side) * side;
    grid.Count[axis] = static_cast<int>(std::floor((high[axis] - grid.Origin[axis]) / side)) + 1;
  }
  return grid;
}

}

FoliageParcels::FoliageParcels(const std::vector<FoliageTriangle>& triangles, double side)
{
  if (triangles.empty())
  {
    return;
  }
  const CanopyGrid grid = GridAround(triangles, side);
  std::map<std::size_t, ParcelSums> sums; // by cells, in their order
  for (const FoliageTriangle& triangle : triangles)
  {
    const auto& corners = triangle.Corners;
    CutToCells(grid, TriangleOf(corners[0], corners[1], corners[2]),
      [&](std::size_t cell, const CutPolygon& part) { sums[cell].Add(triangle.Part * part.Area(), part.Center()); });
    const Vector3 normal = Normalised(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    this->Facets.push_back({ CountedArea(triangle), normal.z * normal.z });
  }
  for (const auto& [cell, sum] : sums)
  {
    if (sum.Area > 0.0)
    {
      this->List.push_back(sum.Parcel(side));
    }
  }
  for (int step = 0; step <= FactorSteps; ++step)
  {
    this->Factors.push_back(this->FactorOf(std::exp(step * LogarithmStep - LargestLogarithm)));
  }
}

double FoliageParcels::FactorOf(double stretch) const
{
  double area = 0.0;
  double stretched = 0.0;
  for (const Facet& facet : this->Facets)
  {
    // A' = A sqrt(r^2 (1 - n_z^2) + n_z^2)
    area += facet.Area;
    stretched += facet.Area * std::sqrt(stretch * stretch * (1.0 - facet.Square) + facet.Square);
  }
  return area > 0.0 ? stretched / area : 1.0;
}

double FoliageParcels::AreaFactor(double stretch) const
{
  if (stretch == 1.0 || this->Facets.empty())
  {
    return 1.0;
  }
  const double place = (std::log(stretch) + LargestLogarithm) / LogarithmStep;
  if (!(place >= 1.0 && place < FactorSteps - 1))
  {
    return this->FactorOf(stretch);
  }
  // the cubic through four neighbours
  const int step = static_cast<int>(place);
  const double t = place - step;
  const double* f = &this->Factors[step];
  return -t * (t - 1.0) * (t - 2.0) / 6.0 * f[-1] + (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0 * f[0] -
    (t + 1.0) * t * (t - 2.0) / 2.0 * f[1] + (t + 1.0) * t * (t - 1.0) / 6.0 * f[2];
}

void PlantCells::Begin(const CanopyGrid& grid, const Vector3& low, const Vector3& high)
{
  this->Grid = &grid;
  this->Outside = 0.0;
  std::size_t cells = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = grid.Count[axis] - 1.0;
    const auto indexOf = [&](double place) { return std::floor((place - grid.Origin[axis]) / grid.Spacing[axis]); };
    this->First[axis] = static_cast<int>(std::clamp(indexOf(low[axis]), 0.0, last + 1.0));
    this->Count[axis] = static_cast<int>(std::clamp(indexOf(high[axis]), -1.0, last)) - this->First[axis] + 1;
    this->Count[axis] = std::max(0, this->Count[axis]);
    cells *= static_cast<std::size_t>(this->Count[axis]);
  }
  this->Sums.assign(cells, 0.0);
}

void PlantCells::Add(const Vector3& center, double across, double up, double area)
{
  constexpr int Most = 64;
  const double halves[3] = { across, across, up };
  int first[3];
  int count[3];
  double shares[3][Most];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double side = this->Grid->Spacing[axis];
    // ends of the box in cells of the box around the plant
    const double origin = this->Grid->Origin[axis] + this->First[axis] * side;
    const double low = (center[axis] - halves[axis] - origin) / side;
    const double high = (center[axis] + halves[axis] - origin) / side;
    const double begin = std::floor(low);
    count[axis] = std::clamp(static_cast<int>(std::floor(high) - begin) + 1, 1, Most);
    first[axis] = static_cast<int>(std::clamp(begin, -1e9, 1e9));
    if (count[axis] == 1)
    {
      shares[axis][0] = 1.0;
      continue;
    }
    const double perLength = 1.0 / (high - low);
    double rest = 1.0;
    for (int n = 0; n + 1 < count[axis]; ++n)
    {
      shares[axis][n] = (begin + n + 1.0 - std::max(low, begin + n)) * perLength;
      rest -= shares[axis][n];
    }
    shares[axis][count[axis] - 1] = rest;
  }
  for (int k = 0; k < count[2]; ++k)
  {
    for (int j = 0; j < count[1]; ++j)
    {
      const double share = area * shares[2][k] * shares[1][j];
      const int z = first[2] + k;
      const int y = first[1] + j;
      const bool isWithin = z >= 0 && z < this->Count[2] && y >= 0 && y < this->Count[1];
      for (int i = 0; i < count[0]; ++i)
      {
        const int x = first[0] + i;
        if (isWithin && x >= 0 && x < this->Count[0])
        {
          this->Sums[(static_cast<std::size_t>(z) * this->Count[1] + y) * this->Count[0] + x] += share * shares[0][i];
        }
        else
        {
          this->Outside += share * shares[0][i];
        }
      }
    }
  }
}

namespace
{

/// Adds one part of a plant.
template <typename Take>
void AddParcels(
  const FoliageParcels& parcels, const FoliagePlace& place, PlantCells& cells, const CanopyGrid& grid, const Take& take)
{
  if (parcels.Parcels().empty())
  {
    return;
  }
  const Vector3& scale = place.Scale;
  const double width = std::sqrt(scale.x * scale.y);
  const double factor = width * width * parcels.AreaFactor(scale.z / width);
  const glm::dmat3 turn = glm::mat3_cast(place.Rotation);
  // the box of all parcels once they are turned
  Vector3 low(std::numeric_limits<double>::max());
  Vector3 high(-std::numeric_limits<double>::max());
  for (const FoliageParcel& parcel : parcels.Parcels())
  {
    const Vector3 center = turn * (scale * parcel.Center);
    const Vector3 half(width * parcel.Across, width * parcel.Across, scale.z * parcel.Up);
    low = glm::min(low, center - half);
    high = glm::max(high, center + half);
  }
  cells.Begin(grid, place.Foot + low, place.Foot + high);
  for (const FoliageParcel& parcel : parcels.Parcels())
  {
    const Vector3 center = place.Foot + turn * (scale * parcel.Center);
    cells.Add(center, width * parcel.Across, scale.z * parcel.Up, factor * parcel.Area);
  }
  cells.End(take);
}

}

void AddPlant(const ParcelledPlant& plant, const FoliagePlace& place, PlantCells& cells, CanopyDensity& density)
{
  const CanopyGrid& grid = density.GetGrid();
  AddParcels(
    plant.Leaves, place, cells, grid, [&](std::size_t cell, double area) { density.AddLeaf(place.Kind, cell, area); });
  AddParcels(plant.Wood, place, cells, grid, [&](std::size_t cell, double area) { density.AddWood(cell, area); });
}

}
