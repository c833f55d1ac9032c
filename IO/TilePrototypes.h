// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTilePrototypes_h
#define LittoralTilePrototypes_h

// The prototypes of a forest as parts of glTF files that share them. Private: never installed.

#include "Plants/PlantMesh.h"

#include <map>
#include <string>

class vtkMultiBlockDataSet;

namespace littoral
{

/// A glTF without nodes: its buffer, and the lists of its JSON that other files take over.
struct TileLibrary
{
  std::string Buffer;                       ///< bytes of a file of its own
  std::map<std::string, std::string> Lists; ///< JSON by names, as "[{...},{...}]"
  int Accessors = 0;
  int BufferViews = 0;
};

/// The library of a scene, taken out of its GLB file. Throws InvalidInput if a text is no GLB.
TileLibrary LibraryOf(const std::string& glb);

/// The prototypes of one level.
struct TilePrototypes
{
  TileLibrary Library;
  std::map<int, int> Meshes; ///< by species
};

/// The prototypes of a level in blocks with instances; where a species has none there, those of its next coarser or
/// else finer level.
TilePrototypes PrototypesOf(vtkMultiBlockDataSet* blocks, int level);

/// The cylinder about each species in all levels, upright at the foot.
std::map<int, PlantExtent> ExtentsOf(vtkMultiBlockDataSet* blocks);

}

#endif
