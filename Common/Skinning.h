// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSkinning_h
#define LittoralSkinning_h

#include "Lanes.h"
#include "Vector3.h"

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace littoral
{

/// Where a joint went from its place at rest. At rest all of it is exactly zero or one.
struct JointPose
{
  glm::dquat Rotation{ 1.0, 0.0, 0.0, 0.0 };
  Vector3 Shift{ 0.0, 0.0, 0.0 }; ///< [m]
};

/// By how much a rotation moves a vector: exactly zero for the identity.
template <typename Real>
LITTORAL_INLINE glm::vec<3, Real> TurnedBy(const glm::qua<Real>& rotation, const glm::vec<3, Real>& vector)
{
  const glm::vec<3, Real> axis{ rotation.x, rotation.y, rotation.z };
  const glm::vec<3, Real> once = glm::cross(axis, vector);
  return Real(2.0) * (rotation.w * once + glm::cross(axis, once));
}

/// The shortest rotation from one direction to another; neither needs unit length. The identity, exactly, for equal
/// ones; half a turn about a right angle to opposite ones.
inline glm::dquat RotationBetween(const Vector3& from, const Vector3& to)
{
  const Vector3 axis = glm::cross(from, to);
  const double alike = glm::dot(from, to);
  if (axis == Vector3(0.0) && alike >= 0.0)
  {
    return { 1.0, 0.0, 0.0, 0.0 };
  }
  // (|a||b| + a.b, a x b) is the rotation but for its length, whose square is the sum of squares of its parts
  const double sizes = std::sqrt(glm::dot(from, from) * glm::dot(to, to));
  const double real = sizes + alike;
  if (real <= 1e-12 * sizes)
  {
    const Vector3 side = Perpendicular(Normalised(from));
    return { 0.0, side.x, side.y, side.z };
  }
  const double factor = 1.0 / std::sqrt(real * real + glm::dot(axis, axis));
  return { factor * real, factor * axis.x, factor * axis.y, factor * axis.z };
}

/// What a joint adds to all that follows it: a rotation less the identity, and a shift.
struct JointChange
{
  /// Three columns of the matrix and the shift [m], of three numbers each; the fourth lane is idle.
  std::array<Lanes, 4> Columns{ 0.0, 0.0, 0.0, 0.0 };

  /// By how much a place moves.
  Vector3 Of(const Vector3& place) const;
};

/// The change of a joint that lies at a position at rest.
JointChange ChangeOf(const JointPose& pose, const Vector3& rest);

/// A skin over joints at rest; tuples of 3, 4 and 4 numbers, one a vertex. Weights sum to 1.
template <typename Real>
struct RestSkin
{
  const Real* Points = nullptr;
  const Real* Normals = nullptr; ///< may be null
  const int* JointIds = nullptr;
  const Real* JointWeights = nullptr;
};

/// Linear blend skinning of the vertices [begin, end): where joints are at rest, vertices stay to the last bit. Normals
/// keep their lengths.
void MoveSkin(const RestSkin<float>& rest, const JointChange* joints, std::size_t begin, std::size_t end, float* points,
  float* normals);
void MoveSkin(const RestSkin<double>& rest, const JointChange* joints, std::size_t begin, std::size_t end,
  double* points, double* normals);

}

#endif
