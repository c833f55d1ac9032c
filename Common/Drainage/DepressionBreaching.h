// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDepressionBreaching_h
#define LittoralDepressionBreaching_h

#include "Drainage/DrainageOutlets.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace littoral
{

/// Path of the channel that breaches a depression.
enum class BreachPath
{
  FloodOrder = 0, ///< backlinks of the priority-flood, over the spill point: one pass
  LeastCost = 1,  ///< path of least cost, the sum of cut depths times distances
};

/// Result of breaching.
struct BreachCount
{
  std::size_t Pits = 0;     ///< pits that were breached
  std::size_t Lowered = 0;  ///< cells that were lowered
  std::size_t Searched = 0; ///< cells that searches for paths of least cost have taken, each time
  double Volume = 0.0;      ///< excavated volume [m^3]
};

/// Cells that a search for the end of a channel takes at most, unless told otherwise.
constexpr std::size_t MostBreachVisits = 131072;

/**
 * Breaches depressions: cuts a channel from each pit to the next lower cell, or to an outlet, so that every cell has a
 * path downhill (complete breaching, Lindsay 2016). No cell is raised. The bed of a channel falls evenly to its end;
 * where that is an outlet that is not lower, the outlet is lowered to just below the pit. LeastCost visits at most
 * `maximumVisits` cells for a pit, and then takes the path of FloodOrder.
 */
BreachCount BreachDepressions(GridSamples& heights, const OutletMask& outlets, BreachPath path,
  const Poll& poll = NoPoll, std::size_t maximumVisits = MostBreachVisits);

}

#endif
