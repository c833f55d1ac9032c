// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCoarseGround_h
#define LittoralCoarseGround_h

#include "Drainage/DrainageOutlets.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

namespace littoral
{

/// The same ground on half as many cells along each side, of its long waves alone: plane and cosine transform, of which
/// the coefficients that the coarse grid has are kept.
GridSamples CoarseGround(const GridSamples& ground, const ParallelFor& parallel = SerialFor);

/// Gives ground the plane and the long waves of coarse ground that was CoarseGround() of it before it changed.
void TakeLongWaves(GridSamples& ground, const GridSamples& coarse, const ParallelFor& parallel = SerialFor);

/// A coarse cell is an outlet where one of the cells that it covers is one.
DrainageOutlets CoarseOutlets(const DrainageOutlets& outlets, const GridSamples& ground);

}

#endif
