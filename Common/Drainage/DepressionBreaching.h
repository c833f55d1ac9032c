// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDepressionBreaching_h
#define LittoralDepressionBreaching_h

#include "Drainage/DrainageOutlets.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <cstddef>

namespace littoral
{

/// The way a channel takes out of a depression.
enum class BreachPath
{
  FloodOrder = 0, ///< over the lowest sill, as the rising flood does: one pass
  LeastCost = 1,  ///< where the depths of the cut sum to the least
};

/// What breaching did.
struct BreachCount
{
  std::size_t Pits = 0;    ///< from which channels were cut
  std::size_t Lowered = 0; ///< cells
  double Volume = 0.0;     ///< [m^3] of ground that was removed
};

/**
 * Cuts a channel from the bottom of each depression to the next ground that is lower, or to an outlet, so that every
 * cell has a way downhill (complete breaching, Lindsay 2016). No cell is raised. The floor of a channel falls evenly to
 * the ground where it ends; where that is an outlet that is not lower, the outlet is lowered to just below the pit.
 * LeastCost visits at most `most` cells for a pit, and then takes the way of FloodOrder.
 */
BreachCount BreachDepressions(GridSamples& heights, const OutletMask& outlets, BreachPath path,
  const Poll& poll = NoPoll, std::size_t maximumVisits = 131072);

}

#endif
