// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSkinning_h
#define LittoralSkinning_h

#include "Numerics/Rotation.h"
#include "Plants/SkinBinding.h"

#include <array>
#include <cstddef>

namespace littoral
{

/// Displacement of a joint from its place at rest. At rest all of it is exactly zero or one.
struct JointPose
{
  glm::dquat Rotation{ 1.0, 0.0, 0.0, 0.0 };
  Vector3 Shift{ 0.0, 0.0, 0.0 }; ///< [m]
};

/// Displacement by a joint of a place p at rest that follows it: (R - 1) (p - r) + s, where r is the place of the joint
/// at rest and s its shift. As p is near r, single precision is enough wherever the plant stands.
struct alignas(64) JointChange
{
  /// Columns of R - 1, each with the component of r [m] behind it, and s [m].
  std::array<std::array<float, 4>, 4> Columns{};

  /// Displacement of a place.
  Vector3 Of(const Vector3& place) const;
};

/// The change of a joint that lies at a position at rest.
JointChange ChangeOf(const JointPose& pose, const Vector3& rest);

/// A skin at rest; tuples of three numbers, one a vertex.
struct RestSkin
{
  const float* Points = nullptr;
  const float* Normals = nullptr; ///< may be null
  std::size_t First = 0;          ///< the vertex whose tuples are the first ones
};

/// Linear blend skinning of the vertices [begin, end): where joints are at rest, vertices stay to the last bit. Normals
/// keep their lengths. In single precision: displacements are exact to some 1e-7 of themselves and of the distance from
/// the joint. Weights of a vertex sum to 1; `rigidity` is 0 where it follows up to four joints so, 1 where it follows
/// the one of the largest weight alone. `run` is that of the first vertex; null: it is searched.
void MoveSkin(const RestSkin& rest, const SkinBinding& binding, const JointChange* joints, std::size_t begin,
  std::size_t end, float* points, float* normals, float rigidity = 0.0f, const SkinBinding::Run* run = nullptr);

}

#endif
