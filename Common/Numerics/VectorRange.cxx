// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/VectorRange.h"

#include "Numerics/SimdDouble4.h"

#include <algorithm>
#include <limits>

namespace littoral
{

namespace
{

LITTORAL_INLINE SimdDouble4 Doubles(const SimdFloat4& four)
{
  return SimdDouble4(__builtin_convertvector(four, SimdDouble4::Register));
}

void AddOne(const float* vector, int components, VectorRange& range, double& check)
{
  double square = 0.0;
  for (int axis = 0; axis < components; ++axis)
  {
    range.Low[axis] = std::min(range.Low[axis], vector[axis]);
    range.High[axis] = std::max(range.High[axis], vector[axis]);
    square += static_cast<double>(vector[axis]) * vector[axis];
  }
  range.MinimumSquare = std::min(range.MinimumSquare, square);
  range.MaximumSquare = std::max(range.MaximumSquare, square);
  check += square - square;
}

/// Squared lengths of four tuples at a time.
struct SquareRange
{
  SimdDouble4 Least{ std::numeric_limits<double>::infinity() };
  SimdDouble4 Most{ -std::numeric_limits<double>::infinity() };
  SimdDouble4 Checks{ 0.0 }; ///< no number as soon as one of them is not finite

  LITTORAL_INLINE void Add(const SimdDouble4& squares)
  {
    this->Least = Min(this->Least, squares);
    this->Most = Max(this->Most, squares);
    this->Checks += squares - squares; // NOLINT(misc-redundant-expression): NaN where they are not finite
  }

  /// Adds those of all lanes to a range and a check.
  LITTORAL_INLINE void End(VectorRange& range, double& check) const
  {
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      range.MinimumSquare = std::min(range.MinimumSquare, this->Least.Values[lane]);
      range.MaximumSquare = std::max(range.MaximumSquare, this->Most.Values[lane]);
      check += this->Checks.Values[lane];
    }
  }
};

}

LITTORAL_SIMD_CLONES VectorRange RangeOf(const float* vectors, std::size_t count)
{
  VectorRange range;
  constexpr float largest = VectorRange::Infinity;
  const SimdFloat4 most{ largest, largest, largest, largest };
  SimdFloat4 low[3] = { most, most, most };
  SimdFloat4 high[3] = { -most, -most, -most };
  SquareRange squares;
  std::size_t next = 0;
  for (; next + 4 <= count; next += 4)
  {
    // x0 y0 z0 x1, y1 z1 x2 y2, z2 x3 y3 z3
    const SimdFloat4 part[3] = { LoadFloats(vectors + 3 * next), LoadFloats(vectors + 3 * next + 4),
      LoadFloats(vectors + 3 * next + 8) };
    for (int k = 0; k < 3; ++k)
    {
      low[k] = part[k] < low[k] ? part[k] : low[k];
      high[k] = high[k] < part[k] ? part[k] : high[k];
    }
    const SimdFloat4 xs = __builtin_shufflevector(part[0], part[1], 0, 3, 6, 6);
    const SimdFloat4 ys = __builtin_shufflevector(part[0], part[1], 1, 4, 7, 7);
    const SimdFloat4 zs = __builtin_shufflevector(part[0], part[1], 2, 5, 5, 5);
    const SimdDouble4 x = Doubles(__builtin_shufflevector(xs, part[2], 0, 1, 2, 5));
    const SimdDouble4 y = Doubles(__builtin_shufflevector(ys, part[2], 0, 1, 2, 6));
    const SimdDouble4 z = Doubles(__builtin_shufflevector(zs, part[2], 0, 1, 4, 7));
    squares.Add(x * x + y * y + z * z);
  }
  for (int i = 0; i < 12; ++i)
  {
    range.Low[i % 3] = std::min(range.Low[i % 3], low[i / 4][i % 4]);
    range.High[i % 3] = std::max(range.High[i % 3], high[i / 4][i % 4]);
  }
  double check = 0.0;
  squares.End(range, check);
  for (; next < count; ++next)
  {
    AddOne(vectors + 3 * next, 3, range, check);
  }
  range.IsFinite = check == 0.0;
  return range;
}

LITTORAL_SIMD_CLONES VectorRange RangeOfBytes(const unsigned char* vectors, std::size_t count)
{
  std::array<int, 3> low{ 255, 255, 255 };
  std::array<int, 3> high{ 0, 0, 0 };
  int least = std::numeric_limits<int>::max();
  int most = 0;
  LITTORAL_INDEPENDENT
  for (std::size_t n = 0; n < count; ++n)
  {
    const int x = vectors[3 * n];
    const int y = vectors[3 * n + 1];
    const int z = vectors[3 * n + 2];
    const int square = x * x + y * y + z * z;
    low = { std::min(low[0], x), std::min(low[1], y), std::min(low[2], z) };
    high = { std::max(high[0], x), std::max(high[1], y), std::max(high[2], z) };
    least = std::min(least, square);
    most = std::max(most, square);
  }
  VectorRange range;
  for (std::size_t axis = 0; axis < 3 && count > 0; ++axis)
  {
    range.Low[axis] = static_cast<float>(low[axis]);
    range.High[axis] = static_cast<float>(high[axis]);
  }
  range.MinimumSquare = count > 0 ? least : range.MinimumSquare;
  range.MaximumSquare = count > 0 ? most : range.MaximumSquare;
  return range;
}

LITTORAL_SIMD_CLONES VectorRange RangeOfPairs(const float* pairs, std::size_t count)
{
  VectorRange range;
  constexpr float largest = VectorRange::Infinity;
  const SimdFloat4 most{ largest, largest, largest, largest };
  SimdFloat4 low = most;
  SimdFloat4 high = -most;
  SquareRange squares;
  std::size_t next = 0;
  for (; next + 4 <= count; next += 4)
  {
    // x0 y0 x1 y1, x2 y2 x3 y3
    const SimdFloat4 part[2] = { LoadFloats(pairs + 2 * next), LoadFloats(pairs + 2 * next + 4) };
    for (const SimdFloat4& four : part)
    {
      low = four < low ? four : low;
      high = high < four ? four : high;
    }
    const SimdDouble4 x = Doubles(__builtin_shufflevector(part[0], part[1], 0, 2, 4, 6));
    const SimdDouble4 y = Doubles(__builtin_shufflevector(part[0], part[1], 1, 3, 5, 7));
    squares.Add(x * x + y * y);
  }
  for (int i = 0; i < 4; ++i)
  {
    range.Low[i % 2] = std::min(range.Low[i % 2], low[i]);
    range.High[i % 2] = std::max(range.High[i % 2], high[i]);
  }
  double check = 0.0;
  squares.End(range, check);
  for (; next < count; ++next)
  {
    AddOne(pairs + 2 * next, 2, range, check);
  }
  range.IsFinite = check == 0.0;
  return range;
}

}
