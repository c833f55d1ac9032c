// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralForestTiling_h
#define LittoralForestTiling_h

#include "Numerics/Vector3.h"
#include "Plants/PlantScatter.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

struct ForestTilingOptions
{
  int TreesPerTile = 1024;    ///< at most, in full; 1 to 65536
  double NearDistance = 30.0; ///< of the levels, up to which trees are in full [m], above 0
  double FarDistance = 130.0; ///< up to which they are Medium [m], not below NearDistance
};

/// Geometric error of what a viewer replaces at a distance [m], with 16 pixels of 1080 in a view of 60 degrees.
double ErrorAt(double distance);

/// Why a forest cannot be tiled so; empty when it can.
std::string WhyInvalid(const ForestTilingOptions& options);

/// A tile: trees at a level.
struct ForestTile
{
  std::size_t First = 0; ///< of the trees in the order
  std::size_t End = 0;
  std::size_t Stride = 1; ///< each so many-th tree is shown
  PlantLevel Level = PlantLevel::Low;
  double Error = 0.0; ///< geometric error of what is shown [m]
  int Places = 0;     ///< the tile that has the places of its trees: itself, or one below which it stands
  std::vector<int> Children;
};

/**
 * A quadtree over the feet of trees whose tiles replace one another. A tile with more trees than it may have is cut in
 * two halves, across its longer side, and these in two again: each quarter has as many trees. Finest tiles have all
 * trees in full, those above them Medium, those above these Low, and further up each tile has a quarter of the trees of
 * its children, as Low. Where there are fewer tiles than levels, tiles stand one in the other.
 *
 * The errors: 0 in full. Medium gives way at NearDistance and Low at FarDistance, d, where a viewer allows 16 pixels of
 * 1080 in a view of 60 degrees, as CesiumJS does: e = d 2 tan(30 degrees) 16 / 1080. Where each s-th of n trees on an
 * area A is shown, the ground between them is off by their distance, sqrt(s A / n), if this is more. No tile has a
 * smaller error than those below it.
 */
class ForestTiling
{
public:
  /// The feet must stay.
  ForestTiling(const std::vector<std::array<double, 2>>& feet, const ForestTilingOptions& options);

  /// The trees: a tile has neighbours in it.
  const std::vector<int>& GetOrder() const { return this->Order; }
  /// The tiles, each before those below it; the first is above all. None without trees.
  const std::vector<ForestTile>& GetTiles() const { return this->Tiles; }

private:
  const std::vector<std::array<double, 2>>& Feet;
  ForestTilingOptions Options;
  int Depth = 0; ///< of the tiles in full
  std::vector<int> Order;
  std::vector<ForestTile> Tiles;

  std::size_t CutInHalf(std::size_t first, std::size_t end);
  std::array<double, 2> SidesOf(std::size_t first, std::size_t end) const;
  int AddTile(std::size_t first, std::size_t end, PlantLevel level, std::size_t stride, int places);
  int AddQuarter(std::size_t first, std::size_t end, int depth, int places);
};

}

#endif
