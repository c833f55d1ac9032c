// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTerrainLevels_h
#define LittoralTerrainLevels_h

#include "Geometry/ViewFrustum.h"
#include "Numerics/Parallel.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace littoral
{

/// Heights [m] over a grid, rows one after the other from the first y.
struct HeightSamples
{
  int Width = 0; ///< samples along x, at least 2
  int Height = 0;
  std::array<double, 2> Origin{ 0.0, 0.0 };
  std::array<double, 2> Spacing{ 1.0, 1.0 };
  std::vector<float> Values; ///< NaN where there is none

  std::size_t Index(int x, int y) const { return static_cast<std::size_t>(y) * Width + x; }
  bool IsMissing(std::size_t index) const { return std::isnan(this->Values[index]); }
  Vector3 Position(std::size_t index) const;
};

constexpr int MaximumTerrainLevels = 8;

/// A square of the grid that is shown at one level: samples First to Last of x and y, both included.
struct TerrainTile
{
  std::array<int, 2> First{ 0, 0 };
  std::array<int, 2> Last{ 0, 0 };
  Box Bounds;                                       ///< of the heights that are there
  bool HasHoles = false;                            ///< some heights are missing: shown at level 0 alone
  bool IsEmpty = false;                             ///< all are
  std::array<float, MaximumTerrainLevels> Errors{}; ///< largest difference of a level from the samples [m]
};

/// The number of levels that tiles have, of those that are wanted: no level has cells larger than a tile.
int LevelsOfTiles(int tileSize, int levels);

/**
 * The terrain in tiles, each in levels of resolution: level k takes every 2^k-th sample of a tile and, whatever its
 * size, the last. No level has cells larger than a tile. Nothing here depends on the view. A triangle with a missing
 * height is left out, and tiles with such heights have level 0 alone, so that holes have one shape.
 */
class TerrainPyramid
{
public:
  /// tileSize: cells, a power of two; levels: 1 to MaximumTerrainLevels, cut to what a tile has.
  TerrainPyramid(HeightSamples samples, int tileSize, int levels, const ParallelFor& parallelFor = SerialFor);

  const HeightSamples& GetSamples() const { return this->Samples; }
  int GetLevels() const { return this->Levels; }
  int GetTilesAlong(int axis) const { return this->TilesAlong[axis]; }
  const std::vector<TerrainTile>& GetTiles() const { return this->Tiles; } ///< in rows
  const std::array<float, 3>& GetNormal(std::size_t sample) const { return this->Normals[sample]; }

private:
  void MeasureTile(TerrainTile& tile) const;
  std::array<float, 3> NormalAt(int x, int y) const;

  HeightSamples Samples;
  int Levels = 1;
  std::array<int, 2> TilesAlong{ 0, 0 };
  std::vector<TerrainTile> Tiles;
  std::vector<std::array<float, 3>> Normals;
};

/// Rule of the level of a tile in a view.
struct TerrainRule
{
  bool ByPixelError = false;
  double NearDistance = 250.0; ///< level 0 to this level distance [m]
  double FarDistance = 4000.0; ///< the coarsest from here on [m]
  double MaximumPixels = 1.0;  ///< the error on the screen that is allowed [pixels]
  bool UseCulling = true;      ///< leave out what the view cannot show
};

constexpr int Culled = -1;

/// The level by distance [m]: between near and far the changes are at equal ratios; at equal steps if near is 0.
int LevelAtDistance(double distance, const TerrainRule& rule, int levels);

/// A level, or Culled, for each tile.
std::vector<int> SelectLevels(const TerrainPyramid& pyramid, const ViewFrustum& view, const TerrainRule& rule);

/// Bound of the distance on the screen of a tile at a level from its samples [pixels].
double ScreenErrorOf(const TerrainTile& tile, int level, const ViewFrustum& view);

/// Vertices, as samples of the grid, and triangles, three vertices each, counter-clockwise from above.
struct TerrainMesh
{
  std::vector<std::size_t> Samples;
  std::vector<int> Triangles;
};

/// Levels by which a tile is meshed: its own, then those of its neighbours at the bottom, right, top and left, but its
/// own where they are coarser or not shown.
using PatchLevels = std::array<int, 5>;

PatchLevels PatchLevelsOf(const TerrainPyramid& pyramid, const std::vector<int>& levels, std::size_t tile);

/// A tile at its level, and what closes the gaps to its finer neighbours.
struct TerrainPatch
{
  PatchLevels Levels{ Culled, Culled, Culled, Culled, Culled };
  TerrainMesh Surface;
  TerrainMesh Seams;
};

/**
 * The mesh of a shown tile among its neighbours.
 *
 * Where an edge of a cell faces n + 1 finer edges, n vertical triangles fill the polygon between them. They are chosen
 * so that none has three vertices in line. When all vertices of the polygon are in line there is no gap to fill, yet
 * the finer vertices would meet the middle of an edge: they become vertices of the cell then, which splits its
 * triangle and leaves its shape. Either way each edge between shown tiles belongs to two triangles.
 */
TerrainPatch MakePatch(const TerrainPyramid& pyramid, const std::vector<int>& levels, std::size_t tile);

}

#endif
