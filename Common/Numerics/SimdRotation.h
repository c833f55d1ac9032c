// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSimdRotation_h
#define LittoralSimdRotation_h

#include "Numerics/Rotation.h"
#include "Numerics/SimdDouble4.h"

namespace littoral
{

/// RotationBetween, lane by lane, to the same bytes.
LITTORAL_INLINE glm::qua<SimdDouble4> RotationBetween(
  const glm::vec<3, SimdDouble4>& from, const glm::vec<3, SimdDouble4>& to)
{
  const glm::vec<3, SimdDouble4> axis = glm::cross(from, to);
  const SimdDouble4 sizes = Sqrt(glm::dot(from, from) * glm::dot(to, to));
  const SimdDouble4 real = sizes + glm::dot(from, to);
  const SimdDouble4 square = glm::dot(axis, axis);
  const SimdDouble4 factor = SimdDouble4(1.0) / Sqrt(real * real + square);
  const SimdDouble4 same = SelectLess(SimdDouble4(0.0), square, factor * real, SimdDouble4(1.0));
  glm::qua<SimdDouble4> rotation{ same, factor * axis.x, factor * axis.y, factor * axis.z };
  // Opposite directions, and those without length, are rare.
  const SimdDouble4 rare = SelectLess(SimdDouble4(1e-12) * sizes, real, SimdDouble4(0.0), SimdDouble4(1.0));
  if (rare.Values[0] + rare.Values[1] + rare.Values[2] + rare.Values[3] > 0.0)
  {
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      if (rare.Values[lane] > 0.0)
      {
        const glm::dquat one = RotationBetween(LaneOf(from, lane), LaneOf(to, lane));
        rotation.w.Values[lane] = one.w;
        rotation.x.Values[lane] = one.x;
        rotation.y.Values[lane] = one.y;
        rotation.z.Values[lane] = one.z;
      }
    }
  }
  return rotation;
}

}

#endif
