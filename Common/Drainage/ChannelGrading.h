// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralChannelGrading_h
#define LittoralChannelGrading_h

#include "Drainage/FlowRouting.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <limits>
#include <vector>

namespace littoral
{

/// Minimum slope along flow paths, the steady state of the stream power law: S = k_s (A / ReferenceCells)^-Concavity,
/// and that times MaximumCells / A above MaximumCells. A is the drainage area.
struct ChannelLaw
{
  double Steepness = 0.01;        ///< steepness index k_s, the slope at the reference area [m/m]
  double ReferenceCells = 100.0;  ///< reference drainage area [cells]
  double Concavity = 0.45;        ///< concavity index m/n
  double ChannelThreshold = 50.0; ///< drainage area of the smallest channel [cells]
  double MaximumCells = std::numeric_limits<double>::infinity(); ///< drainage area up to which the law is known [cells]
  double HillslopeFraction = 0.1; ///< part of the law's slope at ChannelThreshold that holds on hillslopes

  double SlopeAt(double cells) const;
};

/// One least slope along all flow paths [m/m].
ChannelLaw EvenLaw(double slope);

/**
 * Heights graded along the flow paths so that no slope is below the law, (1 - cut) z_fill + cut z_cut:
 *
 *   z_fill = max(z, z_r + S d) from the outlets upstream,  z_cut: z_r = min(z_r, z - S d) from the divides downstream,
 *
 * with the height z_r of the receiver at the distance d. Both, and so all between them, drain everywhere along the
 * flow paths.
 */
std::vector<double> GradeAlong(const GridSamples& heights, const FlowRouting& routing,
  const std::vector<CellIndex>& accumulation, const ChannelLaw& law, double cut,
  const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

/// Falls S d of the law from each cell to its receiver; 0 at outlets.
std::vector<double> FallsAlong(const GridSamples& heights, const FlowRouting& routing,
  const std::vector<CellIndex>& accumulation, const ChannelLaw& law, const ParallelFor& parallel = SerialFor);

/// GradeAlong() by known falls.
std::vector<double> GradeBy(const std::vector<double>& falls, const GridSamples& heights, const FlowRouting& routing,
  double cut, const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

/**
 * Heights of a grid lowered along the flow paths so that no channel is steeper than the law, or a least slope S_0:
 *
 *   z = min(z, z_r + max(S, S_0) d) where A >= ChannelThreshold, from the outlets upstream.
 *
 * Heights that fall by S_0 at least along the flow paths still do.
 */
std::vector<double> LimitAlong(const GridSamples& heights, const FlowRouting& routing,
  const std::vector<CellIndex>& accumulation, const ChannelLaw& law, double leastSlope, const Poll& poll = NoPoll);

}

#endif
