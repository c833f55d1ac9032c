// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDepressionFilling_h
#define LittoralDepressionFilling_h

#include "Drainage/CellLattice.h"
#include "Drainage/DrainageOutlets.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// What a flood that rises from the outlets finds.
struct DepressionFlood
{
  std::vector<double> SpillElevation;     ///< [m], the lowest height of water that can leave: at least the ground's
  std::vector<CellIndex> Backlink; ///< the neighbour from which the flood came, nearer to an outlet; outlets: themselves
  std::size_t DepressionCells = 0;          ///< cells below their level
  double Volume = 0.0;           ///< [m^3] of all depressions
};

/**
 * Exact levels of filled depressions over eight neighbours (priority-flood, Barnes, Lehman & Mulla 2014). Flats keep
 * one level; Backlink leads out of them by the fewest steps from their rim. Cells of equal height are flooded in the
 * order in which they were reached, so the result is unique.
 */
DepressionFlood FloodDepressions(const GridSamples& heights, const OutletMask& outlets, const Poll& poll = NoPoll);

}

#endif
