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

/// Mask of the cells at the border of a grid.
OutletMask BorderOutlets(int width, int height);

// Missing heights are outside the terrain: outlets themselves, of which no water comes and into which none runs. The
// rim is the cells beside them, and those at the border of the grid.

/// Mask of the missing heights.
OutletMask OutsideOf(const GridSamples& heights);

/// Mask of the rim, and of what is outside.
OutletMask RimOutlets(const GridSamples& heights);

/// Mask of the cells at or below sea level [m], and of those of RimOutlets().
OutletMask SeaOutlets(const GridSamples& heights, double seaLevel);

/// Mask of the cells at or below sea level [m] alone, and of what is outside.
OutletMask SeaOutletsAlone(const GridSamples& heights, double seaLevel);

/// Mask of the lowest cell of the rim of each connected part, and of what is outside: catchments.
OutletMask LowestRimOutlets(const GridSamples& heights);

/// Cells at which water leaves the grid.
enum class OutletChoice
{
  Border = 0,   ///< every cell of the rim
  SeaLevel = 1, ///< those, and every cell at or below a level
  Chosen = 2,   ///< cells of a given mask alone
};

/// Outlets of a grid, through which water leaves it.
struct DrainageOutlets
{
  OutletChoice Choice = OutletChoice::Border;
  double SeaLevel = 0.0; ///< [m], for SeaLevel
  OutletMask Cells;      ///< for Chosen
  OutletMask Outside;    ///< cells that are outside although they have a height; empty: none

  OutletMask Of(const GridSamples& heights) const;
};

/// Why flow cannot be routed over these heights: too few rows, numbers that are no heights, cells without a way to an
/// outlet; empty when it can.
std::string WhyUndrainable(const GridSamples& heights, const OutletMask& outlets, const Poll& poll = NoPoll);

}

#endif
