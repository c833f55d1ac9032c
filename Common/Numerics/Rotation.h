// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRotation_h
#define LittoralRotation_h

#include "Numerics/SimdClones.h"
#include "Numerics/Vector3.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace littoral
{

/// (R - 1) v, exactly zero for the identity.
template <typename Real>
LITTORAL_INLINE glm::vec<3, Real> RotationOffset(const glm::qua<Real>& rotation, const glm::vec<3, Real>& vector)
{
  const glm::vec<3, Real> axis{ rotation.x, rotation.y, rotation.z };
  const glm::vec<3, Real> once = glm::cross(axis, vector);
  return Real(2.0) * (rotation.w * once + glm::cross(axis, once));
}

/// R v; cheaper than two quaternion products.
template <typename Real>
LITTORAL_INLINE glm::vec<3, Real> Rotated(const glm::qua<Real>& rotation, const glm::vec<3, Real>& vector)
{
  return vector + RotationOffset(rotation, vector);
}

template <typename Real>
LITTORAL_INLINE glm::qua<Real> Conjugate(const glm::qua<Real>& q)
{
  return { q.w, -q.x, -q.y, -q.z };
}

template <typename Real>
LITTORAL_INLINE glm::qua<Real> IdentityRotation()
{
  return { Real(1.0), Real(0.0), Real(0.0), Real(0.0) };
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

}

#endif
