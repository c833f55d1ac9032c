// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/ShiftedTriples.h"

#include "Numerics/SimdClones.h"

namespace littoral
{

namespace
{

/// Numbers side by side: eight places.
constexpr std::size_t Lanes = 24;
/// Places that are not worth the choice between versions.
constexpr std::size_t Few = 16;

template <typename Real>
LITTORAL_INLINE Real Sum(Real number, double way)
{
  return static_cast<Real>(static_cast<double>(number) + way);
}

template <typename Real>
LITTORAL_INLINE void ShiftOnes(const Real* from, std::size_t count, const Vector3& way, Real* to)
{
  for (std::size_t n = 0; n < count; ++n, from += 3, to += 3)
  {
    to[0] = Sum(from[0], way.x);
    to[1] = Sum(from[1], way.y);
    to[2] = Sum(from[2], way.z);
  }
}

template <typename Real>
LITTORAL_INLINE void ShiftLanes(const Real* from, std::size_t count, const Vector3& way, Real* to)
{
  double ways[Lanes];
  for (std::size_t lane = 0; lane < Lanes; ++lane)
  {
    ways[lane] = way[static_cast<int>(lane % 3)];
  }
  std::size_t next = 0;
  for (; next + Lanes <= 3 * count; next += Lanes)
  {
    for (std::size_t lane = 0; lane < Lanes; ++lane)
    {
      to[next + lane] = Sum(from[next + lane], ways[lane]);
    }
  }
  ShiftOnes(from + next, count - next / 3, way, to + next);
}

LITTORAL_WIDE_SIMD_CLONES void ShiftSingles(const float* from, std::size_t count, const Vector3& way, float* to)
{
  ShiftLanes(from, count, way, to);
}

LITTORAL_WIDE_SIMD_CLONES void ShiftDoubles(const double* from, std::size_t count, const Vector3& way, double* to)
{
  ShiftLanes(from, count, way, to);
}

}

void ShiftTriples(const float* from, std::size_t count, const Vector3& way, float* to)
{
  count < Few ? ShiftOnes(from, count, way, to) : ShiftSingles(from, count, way, to);
}

void ShiftTriples(const double* from, std::size_t count, const Vector3& way, double* to)
{
  count < Few ? ShiftOnes(from, count, way, to) : ShiftDoubles(from, count, way, to);
}

}
