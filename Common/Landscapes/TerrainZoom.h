// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTerrainZoom_h
#define LittoralTerrainZoom_h

#include "Drainage/DrainageCarving.h"
#include "Landscapes/LandscapeMeasures.h"
#include "Landscapes/LandscapeStep.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <array>
#include <string>
#include <vector>

namespace littoral
{

/// Parameters of a zoom.
struct ZoomParameters
{
  int Factor = 3;            ///< fine cells along the side of a coarse one, 2 to 16
  double Growth = 1.0;       ///< uplift during the growth over the fall of a coarse cell, 0 to 10; 0: no growth
  double MaximumShift = 0.5; ///< shift of a coarse height at most, over the relief of its 3 x 3 cells, 0 to 1
  int Seed = 1;              ///< seed of the points on which the ground grows
};

/// Why parameters are invalid, with the name of one; empty when they are not.
std::string WhyInvalid(const ZoomParameters& parameters);

/// Why a terrain cannot be zoomed with these parameters; empty when it can.
std::string WhyInvalid(const GridSamples& coarse, const ZoomParameters& parameters);

/// Memory that a zoom takes beside the coarse terrain of a spacing [bytes].
double ZoomMemory(int width, int height, int factor, const std::array<double, 2>& spacing);

/// Zoomed terrain, and how far the coarse heights, which are means of their cells, have moved.
struct ZoomedTerrain
{
  GridSamples Heights;
  double LargestShift = 0.0; ///< [m]
  double LargestShare = 0.0; ///< over the relief of the 3 x 3 coarse cells about
};

/**
 * Zooms a terrain, whose heights are means of square cells, by the factors of `Factor` from the least on
 * (Documentation/design/drainage.md). Each:
 *
 * 1. refines by cubic convolution, holds the means, and breaches what the coarse valleys lost;
 * 2. lets rivers and hillslopes of the coarser ground's own law run on irregular points, while what they take from a
 *    coarse cell is given back to it smoothly, so that the uplift is what the place's heights ask for;
 * 3. breaches what the grid lost.
 *
 * At last no mean of a coarse cell is further from its height than `MaximumShift` of its relief, even where a lake
 * needs it. Missing heights are filled smoothly, and missing again. The result does not depend on the threads.
 */
ZoomedTerrain ZoomTerrain(const GridSamples& coarse, const ZoomParameters& parameters,
  const ParallelFor& parallel = SerialFor, const CarvingProgress& progress = NoProgress);

/// Law of a coarse ground by its measures, with which its fine ground grows at an uplift of 1: K A^m = 1 / S at 500
/// cells, or at 0.3 of the mean slope where channels tell none, and D = 1 / (90 s) with the deviation s of curvature.
LandscapeLaw LawForZoom(const GridSamples& coarse, const LandscapeMeasures& measures);

/// Greatest less least height of the 3 x 3 cells about each [m].
std::vector<double> ReliefAround(const GridSamples& heights);

}

#endif
