// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVectorRangeLanes_h
#define LittoralVectorRangeLanes_h

#include "Numerics/SimdDouble4.h"
#include "Numerics/VectorRange.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace littoral
{

/// Eight floats side by side.
typedef float SimdFloat8 __attribute__((vector_size(VectorRangeSum::Lanes * sizeof(float))));

LITTORAL_INLINE SimdFloat8 AllFloats(float x)
{
  return SimdFloat8{ x, x, x, x, x, x, x, x };
}

/// Eight vectors by component, of which those in memory are x0 y0 z0 x1 and so on.
struct EightVectors
{
  static constexpr std::size_t Count = VectorRangeSum::Lanes;

  SimdFloat8 X;
  SimdFloat8 Y;
  SimdFloat8 Z;

  LITTORAL_INLINE static EightVectors At(const float* from)
  {
    // Vectors 0 to 3 in the lower halves, 4 to 7 in the upper ones: halves are never crossed.
    const SimdFloat8 a = Halves(from, from + 12);     // x0 y0 z0 x1
    const SimdFloat8 b = Halves(from + 4, from + 16); // y1 z1 x2 y2
    const SimdFloat8 c = Halves(from + 8, from + 20); // z2 x3 y3 z3
    const SimdFloat8 xy = __builtin_shufflevector(b, c, 2, 3, 9, 10, 6, 7, 13, 14);
    const SimdFloat8 yz = __builtin_shufflevector(a, b, 1, 2, 8, 9, 5, 6, 12, 13);
    return { __builtin_shufflevector(a, xy, 0, 3, 8, 10, 4, 7, 12, 14),
      __builtin_shufflevector(yz, xy, 0, 2, 9, 11, 4, 6, 13, 15),
      __builtin_shufflevector(yz, c, 1, 3, 8, 11, 5, 7, 12, 15) };
  }

  LITTORAL_INLINE void Store(float* to) const
  {
    const SimdFloat8 xy = __builtin_shufflevector(this->X, this->Y, 0, 2, 8, 10, 4, 6, 12, 14); // x0 x2 y0 y2
    const SimdFloat8 yz = __builtin_shufflevector(this->Y, this->Z, 1, 3, 9, 11, 5, 7, 13, 15); // y1 y3 z1 z3
    const SimdFloat8 zx = __builtin_shufflevector(this->Z, this->X, 0, 2, 9, 11, 4, 6, 13, 15); // z0 z2 x1 x3
    StoreHalves(__builtin_shufflevector(xy, zx, 0, 2, 8, 10, 4, 6, 12, 14), to, to + 12);
    StoreHalves(__builtin_shufflevector(yz, xy, 0, 2, 9, 11, 4, 6, 13, 15), to + 4, to + 16);
    StoreHalves(__builtin_shufflevector(zx, yz, 1, 3, 9, 11, 5, 7, 13, 15), to + 8, to + 20);
  }

  friend LITTORAL_INLINE EightVectors operator+(const EightVectors& a, const EightVectors& b)
  {
    return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
  }
  friend LITTORAL_INLINE EightVectors operator-(const EightVectors& a, const EightVectors& b)
  {
    return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
  }
  friend LITTORAL_INLINE EightVectors operator*(const EightVectors& a, const SimdFloat8& b)
  {
    return { a.X * b, a.Y * b, a.Z * b };
  }

private:
  LITTORAL_INLINE static SimdFloat8 Halves(const float* lower, const float* upper)
  {
    return __builtin_shufflevector(LoadFloats(lower), LoadFloats(upper), 0, 1, 2, 3, 4, 5, 6, 7);
  }
  LITTORAL_INLINE static void StoreHalves(const SimdFloat8& from, float* lower, float* upper)
  {
    const SimdFloat4 low = __builtin_shufflevector(from, from, 0, 1, 2, 3);
    const SimdFloat4 high = __builtin_shufflevector(from, from, 4, 5, 6, 7);
    std::memcpy(lower, &low, sizeof low);
    std::memcpy(upper, &high, sizeof high);
  }
};

/// Squared lengths of four tuples at a time.
struct SquareRange
{
  SimdDouble4 Least;
  SimdDouble4 Most;
  SimdDouble4 Checks; ///< no number as soon as one of them is not finite

  LITTORAL_INLINE void Add(const SimdDouble4& squares)
  {
    this->Least = Min(this->Least, squares);
    this->Most = Max(this->Most, squares);
    this->Checks += squares - squares; // NOLINT(misc-redundant-expression): NaN where they are not finite
  }
};

LITTORAL_INLINE SimdDouble4 DoublesOf(const SimdFloat4& four)
{
  return SimdDouble4(__builtin_convertvector(four, SimdDouble4::Register));
}

/// A VectorRangeSum in registers.
class VectorRangeLanes
{
public:
  LITTORAL_INLINE explicit VectorRangeLanes(const VectorRangeSum& sum)
  {
    std::memcpy(this->Low, sum.Low.data(), sizeof this->Low);
    std::memcpy(this->High, sum.High.data(), sizeof this->High);
    for (int half = 0; half < 2; ++half)
    {
      std::memcpy(&this->Squares[half].Least, &sum.MinimumSquare[4 * half], sizeof(SimdDouble4));
      std::memcpy(&this->Squares[half].Most, &sum.MaximumSquare[4 * half], sizeof(SimdDouble4));
      std::memcpy(&this->Squares[half].Checks, &sum.Checks[4 * half], sizeof(SimdDouble4));
    }
  }

  LITTORAL_INLINE void Store(VectorRangeSum& sum) const
  {
    std::memcpy(sum.Low.data(), this->Low, sizeof this->Low);
    std::memcpy(sum.High.data(), this->High, sizeof this->High);
    for (int half = 0; half < 2; ++half)
    {
      std::memcpy(&sum.MinimumSquare[4 * half], &this->Squares[half].Least, sizeof(SimdDouble4));
      std::memcpy(&sum.MaximumSquare[4 * half], &this->Squares[half].Most, sizeof(SimdDouble4));
      std::memcpy(&sum.Checks[4 * half], &this->Squares[half].Checks, sizeof(SimdDouble4));
    }
  }

  LITTORAL_INLINE void Add(const EightVectors& eight)
  {
    this->AddComponent(0, eight.X);
    this->AddComponent(1, eight.Y);
    this->AddComponent(2, eight.Z);
    this->AddSquares(0, LowerOf(eight.X), LowerOf(eight.Y), LowerOf(eight.Z));
    this->AddSquares(1, UpperOf(eight.X), UpperOf(eight.Y), UpperOf(eight.Z));
  }

private:
  SimdFloat8 Low[3];
  SimdFloat8 High[3];
  SquareRange Squares[2];

  LITTORAL_INLINE static SimdFloat4 LowerOf(const SimdFloat8& x) { return __builtin_shufflevector(x, x, 0, 1, 2, 3); }
  LITTORAL_INLINE static SimdFloat4 UpperOf(const SimdFloat8& x) { return __builtin_shufflevector(x, x, 4, 5, 6, 7); }
  LITTORAL_INLINE void AddComponent(int axis, const SimdFloat8& x)
  {
    this->Low[axis] = x < this->Low[axis] ? x : this->Low[axis];
    this->High[axis] = this->High[axis] < x ? x : this->High[axis];
  }
  LITTORAL_INLINE void AddSquares(int half, const SimdFloat4& a, const SimdFloat4& b, const SimdFloat4& c)
  {
    const SimdDouble4 x = DoublesOf(a);
    const SimdDouble4 y = DoublesOf(b);
    const SimdDouble4 z = DoublesOf(c);
    this->Squares[half].Add(x * x + y * y + z * z);
  }
};

/// Fewer than eight vectors, but not none, as eight: the last one is there over and over.
LITTORAL_INLINE void FillEight(const float* vectors, std::size_t count, float* eight)
{
  std::memcpy(eight, vectors, 3 * count * sizeof(float));
  for (std::size_t i = 3 * count; i < 3 * EightVectors::Count; ++i)
  {
    eight[i] = eight[i - 3];
  }
}

}

#endif
