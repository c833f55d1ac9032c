// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSkinning_h
#define LittoralSkinning_h

#include "SimdClones.h"
#include "Vector3.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

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

/// What a joint adds to all that follows it: Turn x + Shift.
struct JointChange
{
  glm::dmat3 Turn{ 0.0 }; ///< the rotation less the identity
  Vector3 Shift{ 0.0, 0.0, 0.0 };
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
/// keep unit length.
template <typename Real>
void MoveSkin(const RestSkin<Real>& rest, const JointChange* joints, std::size_t begin, std::size_t end, Real* points,
  Real* normals)
{
  for (std::size_t vertex = begin; vertex < end; ++vertex)
  {
    const Real* weights = rest.JointWeights + 4 * vertex;
    const int* ids = rest.JointIds + 4 * vertex;
    glm::dmat3 blended;
    Vector3 shift;
    const glm::dmat3* with = &blended;
    if (weights[0] == Real(1))
    {
      with = &joints[ids[0]].Turn;
      shift = joints[ids[0]].Shift;
    }
    else
    {
      blended = static_cast<double>(weights[0]) * joints[ids[0]].Turn;
      shift = static_cast<double>(weights[0]) * joints[ids[0]].Shift;
      for (int i = 1; i < 4; ++i)
      {
        if (weights[i] != Real(0))
        {
          blended += static_cast<double>(weights[i]) * joints[ids[i]].Turn;
          shift += static_cast<double>(weights[i]) * joints[ids[i]].Shift;
        }
      }
    }
    const glm::dmat3& turn = *with;
    const Real* p = rest.Points + 3 * vertex;
    const Vector3 moved = turn * Vector3(p[0], p[1], p[2]) + shift;
    for (int axis = 0; axis < 3; ++axis)
    {
      points[3 * vertex + axis] = static_cast<Real>(p[axis] + moved[axis]);
    }
    if (!rest.Normals)
    {
      continue;
    }
    const Vector3 n(rest.Normals[3 * vertex], rest.Normals[3 * vertex + 1], rest.Normals[3 * vertex + 2]);
    const Vector3 change = turn * n;
    const Vector3 turned = n + change;
    const bool moves = change != Vector3(0.0);
    const double factor = moves ? glm::length(n) / std::sqrt(std::max(1e-300, glm::dot(turned, turned))) : 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      normals[3 * vertex + axis] = static_cast<Real>(factor * turned[axis]);
    }
  }
}

}

#endif
