// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCoarseGround_h
#define LittoralCoarseGround_h

#include "Drainage/DrainageOutlets.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

namespace littoral
{

/// Terrain on half as many cells along each axis, low-pass filtered: its plane, and the coefficients of its cosine
/// transform that the coarse grid has.
GridSamples CoarseGround(const GridSamples& ground, const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

/// Replaces the plane and the long waves of a terrain by those of coarse terrain, CoarseGround() of it that was
/// changed.
void TakeLongWaves(
  GridSamples& ground, const GridSamples& coarse, const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

/// Outlets of the coarse grid: cells that cover an outlet.
DrainageOutlets CoarseOutlets(const DrainageOutlets& outlets, const GridSamples& ground);

}

#endif
