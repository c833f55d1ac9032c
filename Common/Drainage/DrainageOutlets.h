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

/// What lets water out.
enum class OutletChoice
{
  Border = 0,   ///< every cell at the border
  SeaLevel = 1, ///< those, and every cell at or below a level
  Chosen = 2,   ///< given cells alone
};

/// Where water leaves the grid.
struct DrainageOutlets
{
  OutletChoice Choice = OutletChoice::Border;
  double SeaLevel = 0.0; ///< [m], for SeaLevel
  OutletMask Cells;      ///< for Chosen

  OutletMask Of(const GridSamples& heights) const;
};

/// Why water cannot be routed over these heights: too few rows, missing values, no outlet; empty when it can.
std::string WhyUndrainable(const GridSamples& heights, const OutletMask& outlets);

}

#endif
