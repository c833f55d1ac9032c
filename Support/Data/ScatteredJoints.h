// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportScatteredJoints_h
#define LittoralSupportScatteredJoints_h

// Joints of scattered plants that do not carry them. Private: never installed, never wrapped.

#include "Data/PlantTable.h"
#include "Plants/Skeleton.h"
#include "Plants/StandBinding.h"

#include <vector>

class vtkIntArray;
class vtkMultiBlockDataSet;
class vtkPolyData;

namespace littoral
{

/// The nodes of a plant among those of all plants.
struct PlantNodes
{
  int First = 0;
  int Count = 0;
};

/// The nodes by row of the table. `plantIds` are those of the nodes.
std::vector<PlantNodes> NodesByRow(
  const PlantTable& table, const std::vector<Skeleton>& skeletons, vtkIntArray* plantIds);

/// Whether a block tells the joints of its vertices.
bool TellsJoints(vtkPolyData* block);

/**
 * The binding of a part of the level High, from that of its prototypes: each plant has the vertices of its prototype,
 * in their order, and the joints count from its first node. Throws InvalidInput where plants are not of the prototypes.
 */
StandBinding BindingOfPrototypes(vtkPolyData* block, const char* name, const PlantTable& table,
  const std::vector<PlantNodes>& nodes, const std::vector<vtkMultiBlockDataSet*>& prototypes);

}

#endif
