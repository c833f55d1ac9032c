// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneBlocks_h
#define LittoralSceneBlocks_h

// Kinds of the blocks of a source. Private: never installed.

#include "Scene.h"

#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkMultiBlockDataSet;
class vtkPolyData;

namespace littoral
{

/// Block with its name; "Block 2" for the third one without a name.
struct NamedBlock
{
  std::string Name;
  vtkSmartPointer<vtkDataObject> Data;
  unsigned int Index = 0; ///< among all blocks
};

/// Whether data are blocks.
bool IsComposite(vtkDataObject* data);

/// The blocks that there are.
std::vector<NamedBlock> NamedBlocks(vtkMultiBlockDataSet* blocks);

/// Whether blocks are levels of plants, as vtkPlantSource and those that work on plants put them out.
bool ArePlants(vtkMultiBlockDataSet* blocks);

/// Whether blocks are the levels of a single plant; false for a scattered forest.
bool AreLevelsOfOne(vtkMultiBlockDataSet* plants);

/// Whether plants tell segments of seaweeds.
bool AreSeaweeds(vtkMultiBlockDataSet* plants);

/// Kind of surface of a block by its arrays; of a block of plants by its name.
SceneKind KindOf(vtkPolyData* block, const std::string& name, bool isOfPlant, bool isOfSeaweed);

/// Throws InvalidInput if points are no joints of moving plants.
void RequireJoints(vtkPolyData* joints, const std::string& owner);

/// Throws InvalidInput if the blocks of moving plants do not follow their joints.
void RequireMotion(vtkMultiBlockDataSet* plants, const std::string& owner);

/// Block of the instances of prototypes, see vtkPlantScatterFilter; null if there is none.
vtkPolyData* InstancesOf(vtkMultiBlockDataSet* blocks);

/// Index of the prototype of a block; -1 if it has none.
int PrototypeOf(vtkPolyData* part);

/// Whether a part of a prototype has the tints of its instances.
bool IsTinted(vtkPolyData* part);

/// Whether a part of a prototype is one of a seaweed.
bool IsOfSeaweed(vtkPolyData* part);

/// Throws InvalidInput if points do not place prototypes.
void RequireInstances(vtkPolyData* points, const std::string& owner);

/// Instances of the prototypes that `isChosen` accepts.
SceneInstances PlacesOf(vtkPolyData* points, const std::function<bool(int prototype)>& isChosen);

}

#endif
