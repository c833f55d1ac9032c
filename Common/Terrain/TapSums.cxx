// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/TapSums.h"

#include "Numerics/SimdClones.h"

#include <cstring>

namespace littoral
{

namespace
{

/// The sum of four taps side by side, of line n.
LITTORAL_INLINE float FourTaps(const float* table, const TapWeights& weights, int n)
{
  return (weights[0][n] * table[0] + weights[1][n] * table[1]) + (weights[2][n] * table[2] + weights[3][n] * table[3]);
}

/// Adds two lines and two lines, since with their weights four do not fit into 16 registers. At most
/// MaximumPointsAtOnce points.
LITTORAL_INLINE void AddPairs(const float* const* tables, const TapWeights& weights, int count, float* __restrict sums)
{
  alignas(64) float firstPair[MaximumPointsAtOnce];
  const float* a = tables[0];
  const float* b = tables[1];
  const float* c = tables[2];
  const float* d = tables[3];
  for (int i = 0; i < count; ++i)
  {
    firstPair[i] = FourTaps(a + i, weights, 0) + FourTaps(b + i, weights, 1);
  }
  for (int i = 0; i < count; ++i)
  {
    sums[i] += firstPair[i] + (FourTaps(c + i, weights, 2) + FourTaps(d + i, weights, 3));
  }
}

LITTORAL_WIDE_SIMD_CLONES void AddTapsAnywhere(
  const float* const (*taps)[4], const TapWeights& weights, int count, float* __restrict sums)
{
  const auto* a = taps[0];
  const auto* b = taps[1];
  const auto* c = taps[2];
  const auto* d = taps[3];
  const auto* u = weights[0];
  const auto* v = weights[1];
  const auto* w = weights[2];
  const auto* x = weights[3];
  for (int i = 0; i < count; ++i)
  {
    const float A = (u[0] * a[0][i] + v[0] * a[1][i]) + (w[0] * a[2][i] + x[0] * a[3][i]);
    const float B = (u[1] * b[0][i] + v[1] * b[1][i]) + (w[1] * b[2][i] + x[1] * b[3][i]);
    const float C = (u[2] * c[0][i] + v[2] * c[1][i]) + (w[2] * c[2][i] + x[2] * c[3][i]);
    const float D = (u[3] * d[0][i] + v[3] * d[1][i]) + (w[3] * d[2][i] + x[3] * d[3][i]);
    sums[i] += (A + B) + (C + D);
  }
}

#if LITTORAL_HAS_SIMD_VERSIONS
LITTORAL_AVX512_VERSION void AddTapsSideBySide(
  const float* const* tables, const TapWeights& weights, int count, float* __restrict sums)
{
  constexpr int wide = 16;
  using WidePack = float __attribute__((vector_size(wide * sizeof(float))));
  WidePack here[LinesAtOnce];
  WidePack weight[4][LinesAtOnce];
  for (int n = 0; n < LinesAtOnce; ++n)
  {
    std::memcpy(&here[n], tables[n], sizeof(WidePack));
    for (int tap = 0; tap < 4; ++tap)
    {
      weight[tap][n] = weights[tap][n] - WidePack{};
    }
  }
  for (int i = 0; i < count; i += wide)
  {
    WidePack line[LinesAtOnce];
    for (int n = 0; n < LinesAtOnce; ++n)
    {
      // Each node is loaded once; other taps come from the registers of this pack and the next.
      WidePack next;
      std::memcpy(&next, tables[n] + i + wide, sizeof(WidePack));
      const WidePack one =
        __builtin_shufflevector(here[n], next, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);
      const WidePack two =
        __builtin_shufflevector(here[n], next, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17);
      const WidePack three =
        __builtin_shufflevector(here[n], next, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18);
      line[n] = (weight[0][n] * here[n] + weight[1][n] * one) + (weight[2][n] * two + weight[3][n] * three);
      here[n] = next;
    }
    WidePack sum;
    std::memcpy(&sum, sums + i, sizeof(sum));
    sum += (line[0] + line[1]) + (line[2] + line[3]);
    std::memcpy(sums + i, &sum, sizeof(sum));
  }
}

LITTORAL_AVX2_VERSION void AddTapsSideBySide(
  const float* const* tables, const TapWeights& weights, int count, float* __restrict sums)
{
  AddPairs(tables, weights, count, sums);
}
#endif

LITTORAL_ANY_VERSION void AddTapsSideBySide(
  const float* const* tables, const TapWeights& weights, int count, float* __restrict sums)
{
  AddPairs(tables, weights, count, sums);
}

}

void AddTaps(const float* const (*taps)[4], const TapWeights& weights, int count, float* sums)
{
  AddTapsAnywhere(taps, weights, count, sums);
}

void AddNeighborTaps(const float* const* tables, const TapWeights& weights, int count, float* sums)
{
  AddTapsSideBySide(tables, weights, count, sums);
}

}
