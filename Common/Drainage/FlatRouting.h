// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFlatRouting_h
#define LittoralFlatRouting_h

#include "Drainage/CellLattice.h"
#include "Drainage/DrainageOutlets.h"
#include "Numerics/Parallel.h"

#include <cstdint>
#include <vector>

namespace littoral
{

/// Flow of a cell in a byte: a direction, with FlowOnFlat of cells that have no lower neighbour; or one of these.
using FlowCode = std::uint8_t;
constexpr FlowCode FlowEnds = 8;     ///< an outlet
constexpr FlowCode FlowMissing = 9;  ///< outside
constexpr FlowCode FlowUnknown = 10; ///< on a flat, not yet routed
constexpr FlowCode FlowOnFlat = 16;

/// Direction of a code; -1 of outlets and of what is outside.
inline int DirectionOf(FlowCode code)
{
  const int direction = code & 15;
  return direction < CellLattice::Directions ? direction : -1;
}

/// Whether water leaves a cell downhill or at an outlet.
inline bool LeavesFlat(FlowCode code)
{
  return code <= FlowEnds;
}

/**
 * The first direction from a cell without a lower neighbour to one of its level from which water leaves the flat;
 * FlowUnknown without any.
 */
template <typename IsExit>
FlowCode FirstExit(const CellLattice& lattice, CellIndex cell, const IsExit& isExit)
{
  FlowCode code = FlowUnknown;
  lattice.ForEachNeighbour(cell, [&](CellIndex neighbour, int direction) {
    if (code == FlowUnknown && isExit(neighbour))
    {
      code = static_cast<FlowCode>(direction | FlowOnFlat);
    }
  });
  return code;
}

/**
 * Routes what is left of flats, given the cells at their exits: each cell drains to the first by direction of the
 * neighbours that are one step nearer to an exit. No order of cells has a part in it.
 */
void RouteFlats(const CellLattice& lattice, std::vector<FlowCode>& codes, const Poll& poll = NoPoll);

/**
 * Receivers of the cells of flats, below 0 before, as the backlinks of FloodDepressions(), without a flood: on a ground
 * without depressions it comes to a flat by that cell of its rim whose lowest neighbour is the lowest. False, with
 * receivers of some flats, where there is a depression or two cells come first.
 */
bool RouteFlatsAsFlood(const std::vector<double>& heights, const OutletMask& outlets, const CellLattice& lattice,
  std::vector<CellIndex>& receivers, const Poll& poll = NoPoll);

}

#endif
