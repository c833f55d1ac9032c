// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTestQuadratPosition_h
#define LittoralTestQuadratPosition_h

#include "Numerics/RandomStream.h"
#include "Patterns/QuadratPattern.h"

#include <array>
#include <cstdint>

namespace littoral::testing
{

/// Position of one point, as PlaceQuadratPoints() has it, from its own two random numbers.
inline std::array<double, 2> QuadratPosition(const QuadratGrid& grid, long long quadrat, int index, int seed)
{
  const RandomStream random(seed, RandomPurpose::QuadratPositions);
  const auto u = random.UniformPair(static_cast<std::uint64_t>(quadrat), static_cast<std::uint64_t>(index));
  const long long i = quadrat % grid.Count[0];
  const long long j = quadrat / grid.Count[0];
  return { grid.Origin[0] + grid.Size[0] * (static_cast<double>(i) + u[0]) / grid.Count[0],
    grid.Origin[1] + grid.Size[1] * (static_cast<double>(j) + u[1]) / grid.Count[1] };
}

}

#endif
