// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStandingWater_h
#define LittoralStandingWater_h

#include "Terrain/GridSamples.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace littoral
{

/// Marks of the cells of seas and lakes: level ground of so many cells and more that hang together by their sides.
std::vector<std::uint8_t> StandingWater(const GridSamples& ground, std::size_t least);

}

#endif
