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

/**
 * Why blocks have not the form of plants, in words for a user; empty if they have. Blocks and arrays may be absent;
 * those that are there have the types, components and tuples that plants have, finite positions, cells of points that
 * there are, and ids of nodes that there are. To be called before anything is read.
 */
std::string WhyNoPlants(vtkMultiBlockDataSet* plants);

/// The same for those that read the block High/Skeleton alone, if there is one.
std::string WhyNoSkeleton(vtkMultiBlockDataSet* plants);

/// Why polygonal data cannot be drawn: cells, positions, normals or texture coordinates are bad. Empty if they can.
std::string WhyBadDrawing(vtkPolyData* block, const std::string& owner);

/// Why the texture that a block carries is bad; empty if it has a good one or none.
std::string WhyBadTexture(vtkPolyData* block, const std::string& owner);

}

#endif
