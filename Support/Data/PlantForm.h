// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportPlantForm_h
#define LittoralSupportPlantForm_h

// The form of plants as blocks: what PlantBlocks.h and SeaweedBlocks.h may take for granted. Private: never installed,
// never wrapped.

#include <string>

class vtkMultiBlockDataSet;
class vtkPolyData;

namespace littoral
{

// Each of these throws InvalidInput where something is bad.

/**
 * Checks that blocks have the form of plants. Blocks and arrays may be absent; those that are there have the types,
 * components and tuples that plants have, finite positions, cells of points that there are, and ids of nodes that there
 * are. To be called before anything is read.
 */
void RequirePlants(vtkMultiBlockDataSet* plants);

/// The same for those that read the block High/Skeleton alone, if there is one.
void RequireSkeleton(vtkMultiBlockDataSet* plants);

/// Checks that polygonal data can be drawn: cells, positions, normals and texture coordinates.
void RequireDrawing(vtkPolyData* block, const std::string& owner);

/// Checks the texture that a block carries; it may have none.
void RequireTexture(vtkPolyData* block, const std::string& owner);

}

#endif
