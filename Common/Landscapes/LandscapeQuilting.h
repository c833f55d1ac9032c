// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLandscapeQuilting_h
#define LittoralLandscapeQuilting_h

#include "Drainage/DrainageCarving.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <string>

namespace littoral
{

/// Why a terrain cannot be quilted of a place; empty when it can.
std::string WhyNoQuilt(const GridSamples& terrain, const GridSamples& place);

/// Memory that quilting takes beside the terrain and the place [bytes].
double QuiltMemory(int width, int height);

/**
 * Quilts a landscape of pieces of a place (Documentation/design/drainage.md). Its long waves are those of the terrain,
 * a random field with the spectrum of the place; all that is shorter is the place's own.
 *
 * 1. Waves of the terrain that are longer than a piece, with the heights and the plane of the place, are the guide of
 *    QuiltGround(). What the quilt lacks of them is added. Where both have 160 cells along a side and more, they are
 *    those of a quilt that is made so of the place with half as many cells along each side.
 * 2. Heights are matched (PlaceMatching). The shallowest depressions stay, with about as many cells as in the place;
 *    the others are taken away along the ways by which least is cut, partly by cutting and partly by filling. Water
 *    finds its way on ground that is rougher by a tenth of the mean fall from cell to cell, so that it wanders in
 *    plains. Rivers of a large place are cut down to its slopes by drainage area (RiverSteepness), times a limit, and
 *    heights are matched again.
 * 3. The long waves are corrected by the semivariances that are missing, the part of cuts by the mean slope, the limit
 *    by the slopes of rivers, and the depressions that stay by those that are there. After at most eight rounds of 2
 *    and 3 the best ground is taken.
 *
 * Of terrain of 450000 cells or fewer as many draws as have 900000 cells are made so, 16 at most, until one meets
 * all of StreamMisfits(); the one whose sum is least is taken.
 *
 * Missing heights are filled smoothly, and missing again; water leaves at the border and at their rim. The seed chooses
 * pieces, and waves that the terrain lacks. The result does not depend on the threads.
 */
CarvingReport QuiltLandscape(GridSamples& terrain, const GridSamples& place, int seed,
  const ParallelFor& parallel = SerialFor, const CarvingProgress& progress = NoProgress);

}

#endif
