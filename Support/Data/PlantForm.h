// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportPlantForm_h
#define LittoralSupportPlantForm_h

// The form of plants as blocks: what PlantBlocks.h and SeaweedBlocks.h may take for granted. Private: never installed,
// never wrapped.

#include <string>

class vtkMultiBlockDataSet;

namespace littoral
{

/**
 * Why blocks have not the form of plants, in words for a user; empty if they have. Blocks and arrays may be absent;
 * those that are there have the types, components and tuples that plants have, finite positions, cells of points that
 * there are, and ids of nodes that there are. To be called before anything is read.
 */
std::string WhyNoPlants(vtkMultiBlockDataSet* plants);

}

#endif
