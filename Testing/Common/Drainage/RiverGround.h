// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTestRiverGround_h
#define LittoralTestRiverGround_h

#include "Drainage/CellLattice.h"
#include "Drainage/StreamPower.h"

namespace littoral::testing
{

/// Ground that rises from these heights under rivers [a]: steps of the law, with routing between them.
inline void GrowByStreamPower(GridSamples& heights, const OutletMask& outlets, const StreamPowerLaw& law, double time,
  int steps, const ParallelFor& parallel = SerialFor)
{
  const CellLattice lattice(heights);
  for (int step = 0; step < steps; ++step)
  {
    const FlowRouting routing = RouteFlow(heights, outlets, parallel);
    StepStreamPower(heights, routing, DrainageArea(routing, lattice), law, time / steps);
  }
}

}

#endif
