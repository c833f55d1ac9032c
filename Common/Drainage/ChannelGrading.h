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

/// The least slope along the ways of water, the steady state of stream power: S = k_s (A / ReferenceCells)^-Concavity,
/// and that times MaximumCells / A above MaximumCells.
struct ChannelLaw
{
  double Steepness = 0.01;                                    ///< k_s, the slope at the reference area [m/m]
  double ReferenceCells = 100.0;                              ///< drainage area [cells]
  double Concavity = 0.45;                                    ///< m/n
  double ChannelThreshold = 50.0;                                 ///< drainage area of the smallest channel [cells]
  double MaximumCells = std::numeric_limits<double>::infinity(); ///< drainage area up to which the law is known [cells]
  double HillslopeFraction = 0.1; ///< part of the law's slope at ChannelThreshold that holds on hillslopes

  double SlopeAt(double cells) const;
};

/**
 * Ground on which no slope along given ways is below the law: the part `cut` of the way from the ground that is filled
 * for it (each cell raised to its receiver's height and the fall from it, from the outlets up) to the ground that is
 * cut for it (each receiver lowered, from the divides down). Both, and so all between them, drain everywhere along the
 * ways.
 */
std::vector<double> GradeAlong(const GridSamples& heights, const FlowRouting& routing,
  const std::vector<CellIndex>& accumulation, const ChannelLaw& law, double cut,
  const ParallelFor& parallel = SerialFor);

}

#endif
