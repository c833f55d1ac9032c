// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralQuadratPattern_h
#define LittoralQuadratPattern_h

#include "Numerics/Parallel.h"
#include "Patterns/QuadratLaws.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

/// A rectangle of the plane cut into equal cells; cell (i, j) has number j * Count[0] + i.
struct QuadratGrid
{
  std::array<double, 2> Origin{ 0.0, 0.0 }; ///< [m], lower left corner
  std::array<double, 2> Size{ 1.0, 1.0 };   ///< [m]
  std::array<int, 2> Count{ 1, 1 };

  long long NumberOfQuadrats() const { return static_cast<long long>(this->Count[0]) * this->Count[1]; }
};

/// Why this is no grid, in words for a user; empty when it is one.
std::string WhyInvalid(const QuadratGrid& grid);

/// Takes as many quadrats as points, nearly square.
void ChooseQuadrats(QuadratGrid& grid, double points);

/// Assignment of counts to quadrats.
enum class QuadratMode
{
  Quota = 0,    ///< the law's own frequencies, rounded: the paper's way; the total is exact
  Sampling = 1, ///< each quadrat draws from the law: the total varies as in nature
};

/**
 * Numbers of quadrats that get 0, 1, 2... points: those with at most so many, as the law has them, rounded up where
 * remainders are largest, so that the total of points is the nearest whole number to quadrats * mean. Cumulated numbers
 * are off by less than 1, so that tails are kept where each count alone is expected less than once.
 */
std::vector<long long> QuotaFrequencies(const QuadratLawParameters& law, long long quadrats);

/// The number of points in each quadrat. Samples are drawn in parallel; a quota is dealt on the caller's thread, which
/// polls.
std::vector<int> QuadratCounts(const QuadratLawParameters& law, long long quadrats, QuadratMode mode, int seed,
  const Poll& poll = NoPoll, const ParallelFor& parallel = SerialFor);

/// Number of points in all quadrats before each one that begins a block of the range [begin, end), and before its end.
std::vector<long long> QuadratSites(
  const std::vector<int>& counts, std::size_t begin, std::size_t end, std::size_t quadratsAtOnce);

/**
 * The points of the quadrats [begin, end), whose counts are given for all: to each its position (x, y, 0) [m], uniform
 * in its quadrat by the seed, the quadrat and the point's index in it, and its quadrat, from where the range's first
 * point belongs. Ranges may be placed in any order, on any threads. Id is int or long long.
 */
template <typename Id>
void PlaceQuadratPoints(const QuadratGrid& grid, int seed, const std::vector<int>& counts, std::size_t begin,
  std::size_t end, double* positions, Id* quadrats);

/// The quadrat that holds a position, or -1 outside. The upper edges of the grid belong to its last cells.
long long QuadratOf(const QuadratGrid& grid, double x, double y);

}

#endif
