// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralOctahedronMap_h
#define LittoralOctahedronMap_h

#include "Numerics/Vector3.h"

#include <glm/vec2.hpp>

#include <cmath>

namespace littoral
{

/// Normal of a place of the octahedron unfolded to a square, both numbers from -1 to 1.
inline Vector3 OctahedronNormal(double u, double v)
{
  const auto sign = [](double value) { return value >= 0.0 ? 1.0 : -1.0; };
  Vector3 n(u, v, 1.0 - std::abs(u) - std::abs(v));
  if (n.z < 0.0)
  {
    n = { (1.0 - std::abs(v)) * sign(u), (1.0 - std::abs(u)) * sign(v), n.z };
  }
  return glm::normalize(n);
}

/// Place of a direction on it: |x| + |y| + |z| = 1, whose lower half is folded outward.
inline glm::dvec2 OctahedronPlace(const Vector3& direction)
{
  const auto sign = [](double value) { return value >= 0.0 ? 1.0 : -1.0; };
  const Vector3 n = direction / (std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z));
  return n.z >= 0.0 ? glm::dvec2(n.x, n.y)
                    : glm::dvec2((1.0 - std::abs(n.y)) * sign(n.x), (1.0 - std::abs(n.x)) * sign(n.y));
}

}

#endif
