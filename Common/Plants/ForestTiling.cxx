// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/ForestTiling.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace littoral
{

namespace
{

constexpr int Quarters = 4;
constexpr double MostMetres = 1e6;

}

double ErrorAt(double distance)
{
  constexpr double pixels = 16.0 / 1080.0;
  // e = d 2 tan(a / 2) p
  return distance * 2.0 * std::tan(Pi / 6.0) * pixels;
}

std::string WhyInvalid(const ForestTilingOptions& options)
{
  ParameterCheck check;
  check.Range("TreesPerTile", options.TreesPerTile, 1, 65536);
  check.Within("NearDistance", options.NearDistance, ValueInterval::Above(0.0, MostMetres), "m");
  if (check.IsGood())
  {
    check.Range("FarDistance", options.FarDistance, options.NearDistance, MostMetres, "m");
  }
  return check.Reason();
}

ForestTiling::ForestTiling(const std::vector<std::array<double, 2>>& feet, const ForestTilingOptions& options)
  : Feet(feet)
  , Options(options)
  , Order(feet.size())
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  for (std::size_t most = static_cast<std::size_t>(options.TreesPerTile); most < feet.size(); most *= Quarters)
  {
    ++this->Depth;
  }
  if (!feet.empty())
  {
    this->AddQuarter(0, feet.size(), 0, -1);
  }
}

std::array<double, 2> ForestTiling::SidesOf(std::size_t first, std::size_t end) const
{
  std::array<double, 2> sides{};
  for (int axis = 0; axis < 2; ++axis)
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t place = first; place < end; ++place)
    {
      low = std::min(low, this->Feet[this->Order[place]][axis]);
      high = std::max(high, this->Feet[this->Order[place]][axis]);
    }
    sides[axis] = high > low ? high - low : 0.0;
  }
  return sides;
}

/// The place in the order behind the first half.
std::size_t ForestTiling::CutInHalf(std::size_t first, std::size_t end)
{
  const std::array<double, 2> sides = this->SidesOf(first, end);
  const int axis = sides[1] > sides[0] ? 1 : 0;
  const std::size_t middle = first + (end - first + 1) / 2;
  const auto at = [this](std::size_t place) { return this->Order.begin() + static_cast<std::ptrdiff_t>(place); };
  std::nth_element(at(first), at(middle), at(end),
    [&](int a, int b) { return std::pair(this->Feet[a][axis], a) < std::pair(this->Feet[b][axis], b); });
  // nth_element leaves each side as its own library likes it.
  std::sort(at(first), at(middle));
  std::sort(at(middle), at(end));
  return middle;
}

int ForestTiling::AddTile(std::size_t first, std::size_t end, PlantLevel level, std::size_t stride, int places)
{
  ForestTile tile;
  tile.First = first;
  tile.End = end;
  tile.Level = level;
  tile.Stride = stride;
  const int index = static_cast<int>(this->Tiles.size());
  tile.Places = places < 0 ? index : places;
  if (level != PlantLevel::High)
  {
    tile.Error = ErrorAt(level == PlantLevel::Medium ? this->Options.NearDistance : this->Options.FarDistance);
  }
  if (stride > 1)
  {
    // sqrt(s A / n)
    const std::array<double, 2> sides = this->SidesOf(first, end);
    const double each = sides[0] * sides[1] / static_cast<double>(end - first);
    tile.Error = std::max(tile.Error, std::sqrt(static_cast<double>(stride) * each));
  }
  this->Tiles.push_back(tile);
  return index;
}

/// Adds the tiles of a quarter, from the coarsest level that it has to the finest, and all below them.
int ForestTiling::AddQuarter(std::size_t first, std::size_t end, int depth, int places)
{
  int top = -1;
  int last = -1;
  const auto add = [&](PlantLevel level, std::size_t stride, int placesOf) {
    const int tile = this->AddTile(first, end, level, stride, placesOf);
    if (last >= 0)
    {
      this->Tiles[last].Children.push_back(tile);
    }
    top = top < 0 ? tile : top;
    last = tile;
  };
  const int lowDepth = std::max(0, this->Depth - 2);
  if (depth < lowDepth)
  {
    add(PlantLevel::Low, std::size_t{ 1 } << (2 * (lowDepth - depth)), -1);
  }
  if (depth == lowDepth)
  {
    add(PlantLevel::Low, 1, -1);
    places = last;
  }
  if (depth == std::max(0, this->Depth - 1))
  {
    add(PlantLevel::Medium, 1, places);
  }
  if (depth == this->Depth)
  {
    add(PlantLevel::High, 1, places);
  }
  else
  {
    const std::size_t middle = this->CutInHalf(first, end);
    const std::size_t cuts[Quarters + 1] = { first, this->CutInHalf(first, middle), middle,
      this->CutInHalf(middle, end), end };
    const int below = depth >= lowDepth ? places : -1;
    for (int quarter = 0; quarter < Quarters; ++quarter)
    {
      if (cuts[quarter] < cuts[quarter + 1])
      {
        const int child = this->AddQuarter(cuts[quarter], cuts[quarter + 1], depth + 1, below);
        this->Tiles[last].Children.push_back(child);
      }
    }
  }
  for (int tile = last; tile >= top; --tile)
  {
    for (const int child : this->Tiles[tile].Children)
    {
      this->Tiles[tile].Error = std::max(this->Tiles[tile].Error, this->Tiles[child].Error);
    }
  }
  return top;
}

}
