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

template <typename Real>
LITTORAL_INLINE void Shift(const Real* from, std::size_t count, const Vector3& way, Real* to)
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
      to[next + lane] = static_cast<Real>(static_cast<double>(from[next + lane]) + ways[lane]);
    }
  }
  for (; next < 3 * count; ++next)
  {
    to[next] = static_cast<Real>(static_cast<double>(from[next]) + ways[next % 3]);
  }
}

}

LITTORAL_WIDE_SIMD_CLONES void ShiftTriples(const float* from, std::size_t count, const Vector3& way, float* to)
{
  Shift(from, count, way, to);
}

LITTORAL_WIDE_SIMD_CLONES void ShiftTriples(const double* from, std::size_t count, const Vector3& way, double* to)
{
  Shift(from, count, way, to);
}

}
