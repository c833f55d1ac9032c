// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantMotion_h
#define LittoralPlantMotion_h

#include "Plants/Skeleton.h"
#include "Plants/Skinning.h"
#include "Sway/TrunkModes.h"

#include <vector>

namespace littoral
{

/// A segment of a branch, from its joint to the next.
struct BendingSegment
{
  Vector3 Along{ 0.0, 0.0, 0.0 }; ///< at rest [m]
  int Joint = 0;
  int Branch = 0;
};

/**
 * A skeleton whose branches bend as cantilevers, each clamped in its parent (section 3.2 of Setas et al.). The
 * displacement of a branch turns its segments; a segment takes along all that grows on it. Segments keep their lengths,
 * so that a large displacement bends a branch and does not stretch it.
 */
class PlantMotion
{
public:
  /// The skeleton must be valid; modes from 1 to MaximumModes. The first branch moves in the trunk's modes where there
  /// are as many, and all others in those of the uniform cantilever.
  PlantMotion(const Skeleton& rest, int numberOfModes, const std::vector<TrunkMode>& trunk = {});

  std::size_t GetNumberOfJoints() const { return this->Joints; }
  std::size_t GetNumberOfBranches() const { return this->Branches.size(); }

  /**
   * The poses of all joints for the amplitudes of the modes of all branches [m], those of a branch side by side; as
   * vectors at a right angle to the branch in the plant at rest. A tip goes by the amplitude times 2 or -2, that of a
   * trunk with modes of its own by the amplitude times their value there. The joint
   * of a node moves the segment that starts there; that of a tip the one that ends there.
   */
  void Pose(const Vector3* amplitudes, JointPose* poses) const;

private:
  struct Branch
  {
    int First;
    int Count;
    int Parent;   // node; -1 for a trunk
    Vector3 Foot; // from the parent node to the first [m]
  };

  int Modes;
  std::size_t Joints;
  std::vector<BendingSegment> Segments;
  std::vector<double> Rises; // of the modes' shapes over each segment
  std::vector<Branch> Branches;
};

/// The skeleton with its joints moved.
Skeleton Moved(const Skeleton& rest, const std::vector<JointPose>& poses);

/// The direction from the first node of a branch to its tip.
Vector3 BranchAxis(const Skeleton& skeleton, int branch);

}

#endif
