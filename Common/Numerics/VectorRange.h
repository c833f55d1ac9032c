// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVectorRange_h
#define LittoralVectorRange_h

#include <array>
#include <cstddef>
#include <limits>

namespace littoral
{

/// Bounds of the components of vectors and of the squares of their lengths.
struct VectorRange
{
  static constexpr float Infinity = std::numeric_limits<float>::infinity();
  std::array<float, 3> Low{ Infinity, Infinity, Infinity };
  std::array<float, 3> High{ -Infinity, -Infinity, -Infinity };
  double MinimumSquare = std::numeric_limits<double>::infinity();
  double MaximumSquare = -std::numeric_limits<double>::infinity();
  bool IsFinite = true; ///< else the others mean nothing
};

/// The ranges of vectors that come in parts, as they are found: in lanes, that are brought together once.
struct VectorRangeSum
{
  static constexpr std::size_t Lanes = 8;
  std::array<std::array<float, Lanes>, 3> Low;
  std::array<std::array<float, Lanes>, 3> High;
  std::array<double, Lanes> MinimumSquare;
  std::array<double, Lanes> MaximumSquare;
  std::array<double, Lanes> Checks{}; ///< no number as soon as one of them is not finite

  VectorRangeSum();
  VectorRange Range() const;
};

/// Adds vectors that follow each other in memory. Bound by reading them, eight at a time.
void AddVectors(const float* vectors, std::size_t count, VectorRangeSum& sum);

/// The ranges of vectors that follow each other in memory.
VectorRange RangeOf(const float* vectors, std::size_t count);

/// The same of vectors of bytes, such as colors.
VectorRange RangeOfBytes(const unsigned char* vectors, std::size_t count);

/// The same of pairs, such as texture coordinates; the third component stays without values.
VectorRange RangeOfPairs(const float* pairs, std::size_t count);

}

#endif
