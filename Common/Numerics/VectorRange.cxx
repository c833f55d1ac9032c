// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/VectorRange.h"

#include "Numerics/VectorRangeLanes.h"

#include <algorithm>
#include <limits>

namespace littoral
{

namespace
{

void AddPair(const float* pair, VectorRange& range, double& check)
{
  double square = 0.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    range.Low[axis] = std::min(range.Low[axis], pair[axis]);
    range.High[axis] = std::max(range.High[axis], pair[axis]);
    square += static_cast<double>(pair[axis]) * pair[axis];
  }
  range.MinimumSquare = std::min(range.MinimumSquare, square);
  range.MaximumSquare = std::max(range.MaximumSquare, square);
  check += square - square;
}

/// Squared lengths that none have.
LITTORAL_INLINE SquareRange NoSquares()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return { SimdDouble4(infinity), SimdDouble4(-infinity), SimdDouble4(0.0) };
}

/// Adds the squares of all lanes to a range and a check.
LITTORAL_INLINE void EndSquares(const SquareRange& squares, VectorRange& range, double& check)
{
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    range.MinimumSquare = std::min(range.MinimumSquare, squares.Least.Values[lane]);
    range.MaximumSquare = std::max(range.MaximumSquare, squares.Most.Values[lane]);
    check += squares.Checks.Values[lane];
  }
}

}

VectorRangeSum::VectorRangeSum()
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Low[axis].fill(VectorRange::Infinity);
    this->High[axis].fill(-VectorRange::Infinity);
  }
  this->MinimumSquare.fill(VectorRange::Infinity);
  this->MaximumSquare.fill(-VectorRange::Infinity);
}

VectorRange VectorRangeSum::Range() const
{
  VectorRange range;
  double check = 0.0;
  for (std::size_t lane = 0; lane < Lanes; ++lane)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      range.Low[axis] = std::min(range.Low[axis], this->Low[axis][lane]);
      range.High[axis] = std::max(range.High[axis], this->High[axis][lane]);
    }
    range.MinimumSquare = std::min(range.MinimumSquare, this->MinimumSquare[lane]);
    range.MaximumSquare = std::max(range.MaximumSquare, this->MaximumSquare[lane]);
    check += this->Checks[lane];
  }
  range.IsFinite = check == 0.0;
  return range;
}

LITTORAL_SIMD_CLONES void AddVectors(const float* vectors, std::size_t count, VectorRangeSum& sum)
{
  constexpr std::size_t eight = EightVectors::Count;
  VectorRangeLanes lanes(sum);
  if (count > 0 && count < eight)
  {
    float few[3 * eight];
    FillEight(vectors, count, few);
    lanes.Add(EightVectors::At(few));
  }
  // The last eight go back to vectors before, which are there twice.
  for (std::size_t next = 0; count >= eight && next < count; next += eight)
  {
    lanes.Add(EightVectors::At(vectors + 3 * std::min(next, count - eight)));
  }
  lanes.Store(sum);
}

VectorRange RangeOf(const float* vectors, std::size_t count)
{
  VectorRangeSum sum;
  AddVectors(vectors, count, sum);
  return sum.Range();
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
  SquareRange squares = NoSquares();
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
    const SimdDouble4 x = DoublesOf(__builtin_shufflevector(part[0], part[1], 0, 2, 4, 6));
    const SimdDouble4 y = DoublesOf(__builtin_shufflevector(part[0], part[1], 1, 3, 5, 7));
    squares.Add(x * x + y * y);
  }
  for (int i = 0; i < 4; ++i)
  {
    range.Low[i % 2] = std::min(range.Low[i % 2], low[i]);
    range.High[i % 2] = std::max(range.High[i % 2], high[i]);
  }
  double check = 0.0;
  EndSquares(squares, range, check);
  for (; next < count; ++next)
  {
    AddPair(pairs + 2 * next, range, check);
  }
  range.IsFinite = check == 0.0;
  return range;
}

}
