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

/// Mask of the outlets: 1 where water leaves the grid, else 0, for each cell.
using OutletMask = std::vector<std::uint8_t>;

/// Mask of the cells at the border.
OutletMask BorderOutlets(int width, int height);

/// Mask of the cells at or below sea level [m], and of those at the border.
OutletMask SeaOutlets(const GridSamples& heights, double seaLevel);

/// Cells at which water leaves the grid.
enum class OutletChoice
{
  Border = 0,   ///< every cell at the border
  SeaLevel = 1, ///< those, and every cell at or below a level
  Chosen = 2,   ///< cells of a given mask alone
};

/// Outlets of a grid, through which water leaves it.
struct DrainageOutlets
{
  OutletChoice Choice = OutletChoice::Border;
  double SeaLevel = 0.0; ///< [m], for SeaLevel
  OutletMask Cells;      ///< for Chosen

  OutletMask Of(const GridSamples& heights) const;
};

/// Why flow cannot be routed over these heights: too few rows, missing values, no outlet; empty when it can.
std::string WhyUndrainable(const GridSamples& heights, const OutletMask& outlets);

}

#endif
