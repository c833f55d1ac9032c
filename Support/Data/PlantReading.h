// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportPlantReading_h
#define LittoralSupportPlantReading_h

// Plants from blocks back to the numerics. Private: never installed, never wrapped.

#include "Data/PlantBlocks.h"
#include "Plants/PlantScatter.h"
#include "Plants/WoodParameters.h"
#include "Sway/LeafMotion.h"

#include <string>
#include <vector>

namespace littoral
{

/// A part of a level; null where there is none.
vtkPolyData* PlantPartOf(vtkMultiBlockDataSet* plants, const char* level, const char* part);

/// The points of a block in single precision; null where it has others or none.
vtkFloatArray* FloatPointsOf(vtkPolyData* block);

/// The skeleton of a block, all plants in one. The reason why there is none, or nothing.
std::string ReadSkeleton(vtkPolyData* block, Skeleton& skeleton);

/// Why the joints of a skin or of leaves are bad; empty when they are not.
std::string WhyBadSkin(vtkPolyData* block, const char* name, std::size_t joints);

/// The leaves of a block, whose skin is good.
std::vector<LeafCorners> ReadLeaves(vtkPolyData* block);

/// The wood that a plant says it is of, as field data `Wood`; false where it does not.
bool ReadWood(vtkDataObject* plant, WoodParameters& wood);

/// The table of a scattered forest: its plants, but for their tints, with their levels.
struct PlantTable
{
  std::vector<PlantPlace> Places;
  std::vector<PlantLevel> Levels;

  /// The row of a plant by its PlantId; -1 if there is none.
  int RowOf(int plant) const;

private:
  friend bool ReadTable(vtkDataObject* forest, PlantTable& table);
  std::vector<std::pair<int, int>> Rows; // by PlantId
};

/// False where plants are not scattered.
bool ReadTable(vtkDataObject* forest, PlantTable& table);

/// The picture that a block carries; empty if it has none.
TextureImage ReadTexture(vtkPolyData* block);

/// Polygons with colors and texture coordinates.
PlantMesh ReadMesh(vtkPolyData* block);

/// Puts a block in the place of that of the same name.
void ReplaceBlock(vtkMultiBlockDataSet* blocks, const char* name, vtkDataObject* data);

/// An array of the same name and size, not filled.
vtkSmartPointer<vtkFloatArray> FloatsLike(vtkFloatArray* other);

}

#endif
