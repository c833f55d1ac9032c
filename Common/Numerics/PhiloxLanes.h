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
 * The words of RandomStream::Words() for a multiple of as many counters as the processor's vectors hold, up to 7 less
 * than there are: the first word above the second, and the third above the fourth. Returns how many.
 */
std::size_t PhiloxBits(const std::array<std::uint32_t, 2>& key, std::size_t count, const std::uint64_t* objects,
  const std::uint64_t* draws, std::uint64_t* first, std::uint64_t* second);

/// The lanes of each version that this processor can run, the widest first; none on processors without one.
std::array<std::size_t, 3> PhiloxWidths();

/// PhiloxBits() by the version of so many lanes, which must be one of PhiloxWidths().
std::size_t PhiloxBitsOfWidth(std::size_t lanes, const std::array<std::uint32_t, 2>& key, std::size_t count,
  const std::uint64_t* objects, const std::uint64_t* draws, std::uint64_t* first, std::uint64_t* second);

}

#endif
