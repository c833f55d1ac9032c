// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralForestTileFiles_h
#define LittoralForestTileFiles_h

// Files of a forest as 3D Tiles. Private: never installed.

#include "EarthPlaces.h"
#include "Plants/ForestTiling.h"
#include "ReplacedFile.h"
#include "Scene.h"
#include "SceneFile.h"
#include "TilePrototypes.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace littoral
{

/// A forest as instances of prototypes.
struct TiledForest
{
  std::vector<Vector3> Feet; ///< of the data [m]
  std::vector<int> Species;
  std::vector<float> Rotations; ///< quaternions x, y, z, w
  std::vector<float> Scales;    ///< along x, y and z
  std::map<int, PlantExtent> Extents;
  std::array<TilePrototypes, 3> Levels;
};

/**
 * Writes a tileset and a folder of tiles beside it, named like the file and by its content. The folder gets its name
 * when all its files are on the disk, the tileset after it; then the folder of an older tileset of this name goes.
 */
FileOutcome WriteForestTiles(const std::string& path, const TiledForest& forest, const EarthPlaces& earth,
  const ForestTilingOptions& options, const SceneProgress& progress);

}

#endif
