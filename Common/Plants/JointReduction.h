// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralJointReduction_h
#define LittoralJointReduction_h

#include "Numerics/Parallel.h"
#include "Numerics/Vector3.h"

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace littoral
{

/// Joints at rest, parents before their children.
struct JointTree
{
  /// The box around what follows a joint [m]; empty where nothing does.
  struct Box
  {
    Vector3 Low{ 1.0, 1.0, 1.0 };
    Vector3 High{ -1.0, -1.0, -1.0 };

    bool IsEmpty() const { return this->Low.x > this->High.x; }
    void Add(const Vector3& place);
  };

  std::vector<int> Parents;   ///< -1 for a root
  std::vector<Vector3> Rests; ///< [m]
  std::vector<Box> Boxes;
};

/// All joints of a plant at one time: rotations since rest, and positions [m].
struct JointFrame
{
  std::vector<glm::quat> Rotations;
  std::vector<glm::vec3> Positions;
};

/// The frames of a plant, and by how much what follows its joints may be off [m].
struct PlantFrames
{
  std::vector<JointFrame> Frames;
  double Tolerance = 0.0;
};

/// The motion of a joint relative to the one that it hangs on: samples, with the shortest turn and a straight line
/// from one to the next, or cubic curves (Hermite's) of the numbers of the quaternion and of the place.
struct JointTrack
{
  int Stride = 1; ///< frames from a sample to the next one, see SampledFrames()
  bool IsSmooth =
    false; ///< cubic curves: three entries a sample, the slope [1/s] before it, its value, the slope after
  std::vector<std::array<std::int16_t, 4>> Rotations; ///< quaternions x, y, z, w times 32767; one if always the same
  std::vector<glm::vec3> Translations; ///< [m]; empty where the joint stays at its place at rest on the other
};

/// Fewer joints that do nearly what all of them do.
struct ReducedJoints
{
  std::vector<int> Kept;                       ///< joints of the tree
  std::vector<int> Parents;                    ///< indices into Kept; -1 for a root
  std::vector<int> Follows;                    ///< for each joint of the tree, an index into Kept
  std::vector<std::vector<JointTrack>> Tracks; ///< of each plant, a track a kept joint
};

/**
 * The joints and samples that are needed to move plants of one tree so that no place in the box of a joint is further
 * than the tolerance of the plant [m] from where all joints take it, in any frame. Roots are kept; tolerances of 0 keep
 * all joints and samples. There are frameRate frames a second.
 */
ReducedJoints ReduceJoints(const JointTree& tree, const std::vector<PlantFrames>& plants, double frameRate,
  const ParallelFor& parallelFor = SerialFor);

}

#endif
