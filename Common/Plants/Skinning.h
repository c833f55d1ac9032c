// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSkinning_h
#define LittoralSkinning_h

#include "Numerics/Rotation.h"

#include <array>
#include <cstddef>

namespace littoral
{

/// Where a joint went from its place at rest. At rest all of it is exactly zero or one.
struct JointPose
{
  glm::dquat Rotation{ 1.0, 0.0, 0.0, 0.0 };
  Vector3 Shift{ 0.0, 0.0, 0.0 }; ///< [m]
};

/// What a joint adds to a place p at rest that follows it: (R - 1) (p - r) + s, where r is the place of the joint at
/// rest and s its shift. As p is near r, single precision is enough wherever the plant stands.
struct alignas(64) JointChange
{
  /// Columns of R - 1, each with the component of r [m] behind it, and s [m].
  std::array<std::array<float, 4>, 4> Columns{};

  /// By how much a place moves.
  Vector3 Of(const Vector3& place) const;
};

/// The change of a joint that lies at a position at rest.
JointChange ChangeOf(const JointPose& pose, const Vector3& rest);

/// A skin over joints at rest; tuples of 3, 4 and 4 numbers, one a vertex. Weights sum to 1.
struct RestSkin
{
  const float* Points = nullptr;
  const float* Normals = nullptr; ///< may be null
  const int* JointIds = nullptr;
  const float* JointWeights = nullptr;
};

/// Linear blend skinning of the vertices [begin, end): where joints are at rest, vertices stay to the last bit. Normals
/// keep their lengths. In single precision: displacements are exact to some 1e-7 of themselves and of the distance from
/// the joint.
void MoveSkin(
  const RestSkin& rest, const JointChange* joints, std::size_t begin, std::size_t end, float* points, float* normals);

}

#endif
