// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStreamRelief_h
#define LittoralStreamRelief_h

#include "Drainage/CellLattice.h"
#include "Drainage/FlowRouting.h"
#include "Drainage/GroundMeasures.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/// Channels by the break of slope and area.
struct ChannelDensity
{
  double HeadCells = 0.0; ///< drainage area of channel heads [cells]; NaN where slopes have no break
  double Heads = 0.0;     ///< channel heads, cells that drain so many of which no receiver's donor does
  double Density = 0.0;   ///< length of channels over the area [1/m]; NaN without a break
};

/**
 * Drainage area [cells] at which the plateau of hillslopes and the power law of channels meet: A_c of
 *
 *   S = S_0 / (1 + (A / A_c)^theta),
 *
 * of least squares of ln S through bins of slope and area, each with the weight of its cells. NaN where slopes fall
 * from the first cell on, for hillslopes are shorter than cells; where they do not fall; and with fewer than six bins.
 */
double BreakOfSlopes(const std::vector<SlopeAreaBin>& bins);

/// Mean slope to the receiver, where it is not 0, and number of cells by drainage area, in bins of half an octave from
/// one cell to a tenth of the grid.
std::vector<SlopeAreaBin> SlopesByArea(
  const GridSamples& heights, const FlowRouting& routing, const std::vector<CellIndex>& accumulation);

ChannelDensity ChannelsOf(
  const GridSamples& heights, const FlowRouting& routing, const std::vector<CellIndex>& accumulation);

/// Cells at a distance from the stream that they drain to.
struct StreamDistanceBin
{
  double Distance = 0.0; ///< mean [m]
  double Height = 0.0;   ///< mean height above that stream [m]
  double Count = 0.0;
};

/// Mean heights above the stream cell to which cells drain, by the straight distance to it rounded to 1 to `most`
/// cells; streams begin where `threshold` cells drain. Distances that no cell has are left out.
std::vector<StreamDistanceBin> HeightsAboveStreams(const GridSamples& heights, const FlowRouting& routing,
  const std::vector<CellIndex>& accumulation, CellIndex threshold, int most);

}

#endif
