// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralInstances_h
#define LittoralInstances_h

#include "vtkBoundingBox.h" // for the bounds of instances
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace littoral
{

/// Whether a block is points that place prototypes: with the arrays Prototype, Rotation, Scale and Tint.
bool AreInstances(vtkDataObject* block);

/// The index of a block among the prototypes, its field array Prototype; -1 if it is none.
int PrototypeIndex(vtkDataObject* block);

/// Calls a function with each prototype of a tree and the points before it.
void EachPrototype(
  vtkDataObject* tree, const std::function<void(vtkPolyData* instances, vtkPolyData* prototype)>& call);

/// The instances of one prototype.
struct InstanceBatch
{
  /// Of each instance: place and scale, rotation as a quaternion x, y, z, w, and tint with a fourth number.
  static constexpr int Numbers = 12;

  std::vector<float> Values;
  vtkBoundingBox Bounds;
};

/// What the points say of a prototype's instances. Blocks whose field array Tinted is 0 have a tint of 1.
std::shared_ptr<const InstanceBatch> BatchOf(vtkPolyData* instances, vtkPolyData* prototype);

}

#endif
