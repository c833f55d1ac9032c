// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/FoliageParcels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

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
    const double across = std::min(most, std::sqrt(1.5 * (variance.x + variance.y)));
    const double up = std::min(most, std::sqrt(3.0 * variance.z));
    return { mean, across, up, across > 0.0 ? 0.5 / across : 0.0, up > 0.0 ? 0.5 / up : 0.0, this->Area };
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
      const FoliageParcel& parcel = this->List.emplace_back(sum.Parcel(side));
      const Vector3 half(parcel.Across, parcel.Across, parcel.Up);
      this->Lowest = glm::min(this->Lowest, parcel.Center - half);
      this->Highest = glm::max(this->Highest, parcel.Center + half);
      this->Sum += parcel.Area;
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

Vector3 PlantCells::Begin(const CanopyGrid& grid, const Vector3& low, const Vector3& high)
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
    // one more, for what reaches beyond the last one
    cells *= this->Count[axis] > 0 ? static_cast<std::size_t>(this->Count[axis]) + 1 : 0;
  }
  this->Sums.assign(cells, 0.0);
  return grid.Origin + grid.Spacing * Vector3(this->First[0], this->First[1], this->First[2]);
}

namespace
{

/// The whole number at or below a number of moderate size.
int FloorOf(double number)
{
  const int whole = static_cast<int>(number);
  return whole - (number < whole ? 1 : 0);
}

/// The part of a box in each cell along an axis.
struct AxisShares
{
  static constexpr int Most = 64;
  int First = 0;
  int Count = 1;
  double Shares[Most];

  /// Shares of a box with a middle and half a side, in units of cells.
  AxisShares(double middle, double half)
  {
    const double low = middle - half;
    const double high = middle + half;
    this->First = FloorOf(low);
    this->Count = std::min(FloorOf(high) - this->First + 1, Most);
    if (this->Count == 1)
    {
      this->Shares[0] = 1.0;
      return;
    }
    const double perLength = 1.0 / (high - low);
    this->Shares[0] = (this->First + 1.0 - low) * perLength;
    double rest = 1.0 - this->Shares[0];
    for (int n = 1; n + 1 < this->Count; ++n)
    {
      this->Shares[n] = perLength;
      rest -= perLength;
    }
    this->Shares[this->Count - 1] = rest;
  }
};

}

void PlantCells::Add(const Vector3& center, const Vector3& half, const Vector3& perSide, double area)
{
  int cell[3];
  double far[3]; // part of the box in the next cell along each axis
  bool isSmall = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    cell[axis] = FloorOf(center[axis] - half[axis]);
    const double beyond = center[axis] + half[axis] - (cell[axis] + 1.0);
    far[axis] = std::max(0.0, beyond) * perSide[axis];
    isSmall &= beyond < 1.0 && cell[axis] >= 0 && cell[axis] < this->Count[axis];
  }
  if (!isSmall)
  {
    this->AddLarge(center, half, area);
    return;
  }
  const std::size_t row = static_cast<std::size_t>(this->Count[0]) + 1;
  const std::size_t layer = row * (static_cast<std::size_t>(this->Count[1]) + 1);
  double* sum = &this->Sums[cell[2] * layer + cell[1] * row + cell[0]];
  for (int corner = 0; corner < 4; ++corner)
  {
    const double share = area * (corner & 1 ? far[1] : 1.0 - far[1]) * (corner & 2 ? far[2] : 1.0 - far[2]);
    double* to = sum + (corner & 1 ? row : 0) + (corner & 2 ? layer : 0);
    to[0] += share * (1.0 - far[0]);
    to[1] += share * far[0];
  }
}

void PlantCells::AddLarge(const Vector3& center, const Vector3& half, double area)
{
  const AxisShares x(center.x, half.x);
  const AxisShares y(center.y, half.y);
  const AxisShares z(center.z, half.z);
  for (int k = 0; k < z.Count; ++k)
  {
    for (int j = 0; j < y.Count; ++j)
    {
      const double share = area * z.Shares[k] * y.Shares[j];
      const int row = y.First + j;
      const int layer = z.First + k;
      const bool isWithin = layer >= 0 && layer < this->Count[2] && row >= 0 && row < this->Count[1];
      const std::size_t first = (static_cast<std::size_t>(layer) * (this->Count[1] + 1) + row) * (this->Count[0] + 1);
      for (int i = 0; i < x.Count; ++i)
      {
        const int column = x.First + i;
        double& sum = isWithin && column >= 0 && column < this->Count[0] ? this->Sums[first + column] : this->Outside;
        sum += share * x.Shares[i];
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
  // a box around all parcels, by the corners of theirs
  Vector3 low(std::numeric_limits<double>::max());
  Vector3 high(-std::numeric_limits<double>::max());
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 own((corner & 1 ? parcels.High() : parcels.Low()).x, (corner & 2 ? parcels.High() : parcels.Low()).y,
      (corner & 4 ? parcels.High() : parcels.Low()).z);
    const Vector3 turned = place.Foot + turn * (scale * own);
    low = glm::min(low, turned);
    high = glm::max(high, turned);
  }
  const Vector3 begin = cells.Begin(grid, low, high);
  if (!cells.HasCells())
  {
    take(OutsideCells, factor * parcels.Area());
    return;
  }
  // all in units of cells
  const Vector3 foot = (place.Foot - begin) / grid.Spacing;
  glm::dmat3 toCells;
  for (int axis = 0; axis < 3; ++axis)
  {
    toCells[axis] = turn[axis] * scale[axis] / grid.Spacing;
  }
  const Vector3 halves = Vector3(width, width, scale.z) / grid.Spacing;
  const Vector3 perHalf = 1.0 / halves;
  for (const FoliageParcel& parcel : parcels.Parcels())
  {
    cells.Add(foot + toCells * parcel.Center, halves * Vector3(parcel.Across, parcel.Across, parcel.Up),
      perHalf * Vector3(parcel.PerAcross, parcel.PerAcross, parcel.PerUp), factor * parcel.Area);
  }
  cells.End(take);
}

}

std::vector<std::size_t> OrderOfNeighbors(const CanopyGrid& grid, const std::vector<FoliagePlace>& places)
{
  constexpr double tile = 32.0; // cells
  std::vector<std::pair<long long, std::size_t>> keys;
  keys.reserve(places.size());
  for (std::size_t plant = 0; plant < places.size(); ++plant)
  {
    const auto tileOf = [&](int axis) {
      const double cells = (places[plant].Foot[axis] - grid.Origin[axis]) / grid.Spacing[axis];
      return static_cast<long long>(std::clamp(std::floor(cells / tile), -1e6, 1e6));
    };
    keys.emplace_back(tileOf(1) * 10000000 + tileOf(0), plant);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::size_t> order;
  order.reserve(places.size());
  for (const auto& key : keys)
  {
    order.push_back(key.second);
  }
  return order;
}

void AddPlant(const ParcelledPlant& plant, const FoliagePlace& place, PlantCells& cells, CanopyDensity& density)
{
  const CanopyGrid& grid = density.GetGrid();
  AddParcels(
    plant.Leaves, place, cells, grid, [&](std::size_t cell, double area) { density.AddLeaf(place.Kind, cell, area); });
  AddParcels(plant.Wood, place, cells, grid, [&](std::size_t cell, double area) { density.AddWood(cell, area); });
}

}
