// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/ClusterOffsets.h"

#include "Numerics/Constants.h"
#include "Numerics/SimdClones.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace littoral
{

namespace
{

/// ln x = e ln 2 + 2 artanh((m - 1) / (m + 1)) with m in [1/sqrt 2, sqrt 2), as a series of s^2 < 0.0295.
LITTORAL_INLINE double LogarithmOf(double x)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof(bits));
  // The exponent is cut so that m lies about 1: the bits of sqrt(1/2) are the first ones of a period.
  constexpr std::uint64_t RootHalf = 0x3fe6a09e667f3bcd;
  const std::uint64_t from = bits - RootHalf;
  // The exponent as a number, made of its bits: 2^52 + e + 2^11, less 2^52 + 2^11.
  const std::uint64_t exponentBits = 0x4330000000000000 | ((from >> 52) & 0x7ff);
  double exponent = 0.0;
  std::memcpy(&exponent, &exponentBits, sizeof(exponent));
  exponent -= 0x1p52;
  exponent -= exponent > 1023.0 ? 2048.0 : 0.0;
  bits = (from & 0x000fffffffffffff) + RootHalf;
  double m = 0.0;
  std::memcpy(&m, &bits, sizeof(m));
  const double s = (m - 1.0) / (m + 1.0);
  const double s2 = s * s;
  double series = 2.0 / 15.0;
  series = series * s2 + 2.0 / 13.0;
  series = series * s2 + 2.0 / 11.0;
  series = series * s2 + 2.0 / 9.0;
  series = series * s2 + 2.0 / 7.0;
  series = series * s2 + 2.0 / 5.0;
  series = series * s2 + 2.0 / 3.0;
  series = series * s2 + 2.0;
  return s * series + exponent * 0.693147180559945309417;
}

/// sin and cos of 2 pi v, v in (0, 1): of the angle from the nearest eighth that is a multiple of a quarter.
LITTORAL_INLINE void Turn(double v, double& cosine, double& sine)
{
  const double quarter = (4.0 * v + 0x1.8p52) - 0x1.8p52; // rounded to a whole number, 0 to 4
  const double x = (4.0 * v - quarter) * (0.5 * Pi);      // from -pi/4 to pi/4
  const double x2 = x * x;
  double s = -1.0 / 39916800.0;
  s = s * x2 + 1.0 / 362880.0;
  s = s * x2 - 1.0 / 5040.0;
  s = s * x2 + 1.0 / 120.0;
  s = s * x2 - 1.0 / 6.0;
  s = s * x2 * x + x;
  double c = 1.0 / 479001600.0;
  c = c * x2 - 1.0 / 3628800.0;
  c = c * x2 + 1.0 / 40320.0;
  c = c * x2 - 1.0 / 720.0;
  c = c * x2 + 1.0 / 24.0;
  c = c * x2 - 0.5;
  c = c * x2 + 1.0;
  const bool isOdd = quarter == 1.0 || quarter == 3.0;
  const double one = isOdd ? s : c;
  const double other = isOdd ? c : s;
  cosine = quarter == 1.0 || quarter == 2.0 ? -one : one;
  sine = quarter == 2.0 || quarter == 3.0 ? -other : other;
}

/// An offset of a length in the direction of a number from 0 to 1, in place of that number and another.
LITTORAL_INLINE void PlaceOffset(double length, double& u, double& v)
{
  double cosine = 0.0;
  double sine = 0.0;
  Turn(v, cosine, sine);
  u = length * cosine;
  v = length * sine;
}

}

LITTORAL_SIMD_CLONES
void MakeNormalOffsets(double deviation, std::size_t count, double* u, double* v)
{
  constexpr double Least = 1.5229979744712628e-08; // exp(-NormalReach^2 / 2)
  static_assert(NormalReach == 6.0);
  LITTORAL_INDEPENDENT
  for (std::size_t n = 0; n < count; ++n)
  {
    const double r = deviation * std::sqrt(-2.0 * LogarithmOf(Least + (1.0 - Least) * u[n]));
    PlaceOffset(r, u[n], v[n]);
  }
}

LITTORAL_SIMD_CLONES
void MakeDiscOffsets(double radius, std::size_t count, double* u, double* v)
{
  LITTORAL_INDEPENDENT
  for (std::size_t n = 0; n < count; ++n)
  {
    const double r = radius * std::sqrt(u[n]);
    PlaceOffset(r, u[n], v[n]);
  }
}

LITTORAL_SIMD_CLONES
void MakeLogarithms(std::size_t count, double* u)
{
  LITTORAL_INDEPENDENT
  for (std::size_t n = 0; n < count; ++n)
  {
    u[n] = LogarithmOf(u[n]);
  }
}

}
