// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPhiloxLanes_h
#define LittoralPhiloxLanes_h

#include <array>
#include <cstddef>
#include <cstdint>

namespace littoral
{

/**
 * The numbers of RandomStream::UniformPair() for a multiple of as many counters as the processor's vectors hold, up to
 * 7 less than there are. Returns how many.
 */
std::size_t PhiloxPairs(const std::array<std::uint32_t, 2>& key, std::size_t count, const std::uint64_t* objects,
  const std::uint64_t* draws, double* first, double* second);

/// The lanes of each version that this processor can run, the widest first; none on processors without one.
std::array<std::size_t, 3> PhiloxWidths();

/// PhiloxPairs() by the version of so many lanes, which must be one of PhiloxWidths().
std::size_t PhiloxPairsOfWidth(std::size_t lanes, const std::array<std::uint32_t, 2>& key, std::size_t count,
  const std::uint64_t* objects, const std::uint64_t* draws, double* first, double* second);

}

#endif
