// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralInstances_h
#define LittoralInstances_h

#include "vtkBoundingBox.h" // for the bounds of instances
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <memory>
#include <set>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace littoral
{

/**
 * Instances in a tree of blocks: points with the arrays Prototype, Rotation, Scale and Tint, and behind them the blocks
 * that they place, which have their index as the field array Prototype.
 */
struct InstancedBlocks
{
  /// Points and a prototype of theirs.
  struct Pair
  {
    vtkPolyData* Points;
    vtkPolyData* Prototype;
  };
  std::vector<Pair> Pairs;
  std::set<vtkDataObject*> Blocks; ///< all of both kinds
};

/// The instances in a tree; none in other data.
InstancedBlocks InstancesIn(vtkDataObject* data);

/// The blocks of the level before the far level that a pair places, as vtkPlantScatterFilter has them; none for other
/// pairs, and for seaweed, which moves.
std::vector<vtkPolyData*> MediumPlantOf(const InstancedBlocks& instanced, const InstancedBlocks::Pair& pair);

/// The points of the prototype of a far level, with their arrays, and those of the level before it with 1 in the array
/// Fades: both are drawn where they are about to change.
vtkSmartPointer<vtkPolyData> PlacesOf(const InstancedBlocks::Pair& pair);

/// Distances from the eye between which a level of plants is exchanged for the far one; 0 0 for other levels and where
/// the points do not tell the distance of the far one.
std::array<double, 2> FadeRangeOf(const InstancedBlocks::Pair& pair);

/// A box around an instance: its middle, and the halves of its edges.
struct InstanceBox
{
  std::array<double, 3> Center;
  std::array<std::array<double, 3>, 3> Halves;
};

/// The instances of one prototype.
struct InstanceBatch
{
  /// Numbers of each instance: place and scale, rotation as a quaternion x, y, z, w, and tint with a fourth number.
  static constexpr int Numbers = 12;

  std::vector<float> Values;
  std::vector<InstanceBox> Boxes; ///< around each
  vtkBoundingBox Bounds;
  std::uint64_t Shape = 0; ///< a number of where the instances are and of the points of their prototype

  /// Adds an instance by its numbers, of a prototype with a box.
  void Add(const std::array<float, Numbers>& values, const vtkBoundingBox& prototype);
};

/// Instances of a prototype as the points give them. Blocks whose field array Tinted is 0 have a tint of 1.
std::shared_ptr<const InstanceBatch> BatchOf(const InstancedBlocks::Pair& pair);

/// Instances that a prototype casts shadows for where leaves are not told apart: the medium level of a plant that
/// stands still, as vtkPlantScatterFilter has it, for all levels, so that a change of levels changes nothing; the
/// others none. Null for other prototypes, which do so as they are shown.
std::shared_ptr<const InstanceBatch> CoarseBatchOf(const InstancedBlocks::Pair& pair);

}

#endif
