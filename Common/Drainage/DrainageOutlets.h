// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDrainageOutlets_h
#define LittoralDrainageOutlets_h

#include "Terrain/GridSamples.h"

#include <cstdint>
#include <string>
#include <vector>

namespace littoral
{

/// Whether water leaves the grid at a cell, 1 or 0 for each.
using OutletMask = std::vector<std::uint8_t>;

/// Every cell at the border.
OutletMask BorderOutlets(int width, int height);

/// Every cell at or below sea level [m], and every cell at the border.
OutletMask SeaOutlets(const GridSamples& heights, double seaLevel);

/// Why water cannot be routed over these heights: too few rows, missing values, no outlet; empty when it can.
std::string WhyUndrainable(const GridSamples& heights, const OutletMask& outlets);

}

#endif
