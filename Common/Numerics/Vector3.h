// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVector3_h
#define LittoralVector3_h

#include "Numerics/ParameterCheck.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace littoral
{

/// A point or direction of space.
using Vector3 = glm::dvec3;

inline bool IsFinite(const Vector3& a)
{
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Whether each part is 0 or of a magnitude that a parameter can have.
inline bool IsSensible(const Vector3& a)
{
  return IsSensible(a.x) && IsSensible(a.y) && IsSensible(a.z);
}

/// The direction of a vector; up for the zero vector.
inline Vector3 Normalised(const Vector3& a)
{
  const double length = glm::length(a);
  return length > 0.0 ? a / length : Vector3(0.0, 0.0, 1.0);
}

/// A unit vector at a right angle to a unit vector.
inline Vector3 Perpendicular(const Vector3& a)
{
  const Vector3 other = std::abs(a.x) < 0.8 ? Vector3(1.0, 0.0, 0.0) : Vector3(0.0, 1.0, 0.0);
  return glm::normalize(glm::cross(a, other));
}

}

#endif
