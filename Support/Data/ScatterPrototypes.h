// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportScatterPrototypes_h
#define LittoralSupportScatterPrototypes_h

// The plants that a scattered forest consists of. Private: never installed, never wrapped.

#include "Data/PlantBlocks.h"
#include "Data/PlantMerge.h"
#include "Geometry/TextureAtlas.h"
#include "Plants/PlantScatter.h"
#include "Plants/StemShape.h"

#include "vtkFieldData.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace littoral
{

/// The blocks in the order of the output.
enum PartIndex
{
  SkeletonPart,
  SkinPart,
  LeavesPart,
  TrunkPart,
  CrownPart,
  LowPart,
  NumberOfParts
};

inline constexpr PartKind PartKinds[NumberOfParts] = {
  { plant::High, plant::Skeleton, true, false },
  { plant::High, plant::Skin, false, false },
  { plant::High, plant::Leaves, false, true },
  { plant::Medium, plant::Trunk, false, false },
  { plant::Medium, plant::Crown, false, true },
  { plant::Low, nullptr, false, true },
};

inline constexpr PlantLevel LevelOfPart[NumberOfParts] = { PlantLevel::High, PlantLevel::High, PlantLevel::High,
  PlantLevel::Medium, PlantLevel::Medium, PlantLevel::Low };

/// Whether a block is a surface of plants that sway.
constexpr bool IsSurface(int part)
{
  return part != SkeletonPart && part != LowPart;
}

/// The blocks of a prototype; null where it has none.
using PrototypeBlocks = std::array<vtkPolyData*, NumberOfParts>;

/// A block of a prototype; null if it has none.
vtkPolyData* PartOf(vtkMultiBlockDataSet* prototype, const PartKind& kind);

/// All blocks of a prototype.
PrototypeBlocks PartsOf(vtkMultiBlockDataSet* prototype);

/// Throws InvalidInput if a prototype, of the form that PlantForm.h checks, cannot be scattered. A level needs a
/// polygon, though not in each of its blocks: a bare tree has no leaves.
void RequirePrototype(const PrototypeBlocks& blocks);

/// The prototypes of all species, ready to be merged.
struct ScatterPrototypes
{
  std::vector<PlantPart> Parts;
  std::vector<PlantExtent> Extents;
  std::vector<StemShape> Stems;       ///< of the level High
  std::vector<StemShape> MediumStems; ///< of Medium, whose trunks have fewer corners
  TextureImage CrownAtlas;
  TextureImage LeafAtlas;
  PlantPart FacingLow; ///< one card a plant, not placed yet; plants without an impostor as in Low
  std::vector<std::optional<ImpostorShape>> Shapes;
  std::vector<AtlasArea> LowAreas;
  /// Textures as field data, the same arrays at each execution; null where there is none.
  std::array<vtkSmartPointer<vtkFieldData>, NumberOfParts> Textures;

  /// Polygons of a species in full.
  double HighPolygons(int species) const
  {
    return static_cast<double>(
      this->Parts[SkinPart].Meshes[species].NumberOfCells() + this->Parts[LeavesPart].Meshes[species].NumberOfCells());
  }
};

/// Takes all blocks from the prototypes, with or without the joints of their vertices, and joins their textures.
void TakeParts(const std::vector<PrototypeBlocks>& blocks, bool withJoints, ScatterPrototypes& prototypes);

}

#endif
