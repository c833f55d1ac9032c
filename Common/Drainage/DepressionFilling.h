// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDepressionFilling_h
#define LittoralDepressionFilling_h

#include "Drainage/CellLattice.h"
#include "Drainage/DrainageOutlets.h"
#include "Drainage/FlowRouting.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// Result of a priority-flood from the outlets.
struct DepressionFlood
{
  std::vector<double> SpillElevation; ///< lowest elevation from which water can leave, at least the ground's [m]
  std::vector<CellIndex> Backlink;    ///< neighbour from which the flood came, nearer to an outlet; outlets: themselves
  std::size_t DepressionCells = 0;    ///< cells below their spill elevation
  double Volume = 0.0;                ///< volume of all depressions [m^3]
};

/**
 * Spill elevations w over eight neighbours by priority-flood (Barnes, Lehman & Mulla 2014), w = max(z, w of the cell
 * before). Flats keep one level; Backlink leads out of them by the fewest steps from their rim. Cells of equal height
 * are flooded in the order in which they were reached, so the result is unique.
 */
DepressionFlood FloodDepressions(const GridSamples& heights, const OutletMask& outlets, const Poll& poll = NoPoll);

/**
 * Spill elevations alone, by known flow paths to the outlets: the greatest height on the path of a cell is no less than
 * its spill elevation, so that cells which are as high are dry, and the others are flooded from these. The better the
 * paths drain the ground, the less there is to flood. Heights may not be missing.
 */
std::vector<double> SpillElevationsBy(
  const FlowRouting& routing, const GridSamples& heights, const Poll& poll = NoPoll);

}

#endif
