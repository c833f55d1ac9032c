// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLandscapeGrowth_h
#define LittoralLandscapeGrowth_h

#include "Drainage/DrainageCarving.h"
#include "Landscapes/GivenGround.h"
#include "Landscapes/UpliftSteering.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <string>

namespace littoral
{

/// Rock and faults by place, each one number a cell of the terrain or none at all; they count where the terrain has
/// heights.
struct GrowthRock
{
  std::vector<double> Erodibility;  ///< factor of K, positive; only its ratios count
  std::vector<double> UpliftFactor; ///< factor of U, positive; only its ratios count
  std::vector<double> FaultThrow;   ///< what a young fault lifts the ground by [m]
};

/// Parameters of growth.
struct GrowthParameters
{
  UpliftSteering Steering;
  int MaximumIterations = 12; ///< corrections of the law by what is measured, 0 to 100
  int Seed = 1;               ///< seed of points, of the first roughness, and of waves that the terrain lacks
  GrowthRock Rock;
  GivenGround Given;
};

/// Why a terrain cannot be grown with these parameters; empty when it can.
std::string WhyInvalid(const GridSamples& terrain, const GrowthParameters& parameters);

/// Why no landscape of the kind of a place can be grown; empty when it can. Missing heights are filled smoothly.
std::string WhyNoPlace(const GridSamples& place);

/// Memory that growth takes beside the terrain and the place [bytes].
double GrowthMemory(int width, int height);

/**
 * Grows a landscape of the kind of a place by evolution to near a steady state (Documentation/design/drainage.md): its
 * long waves are those of the terrain, a random field with the spectrum of the place, and its rivers and hillslopes
 * have the place's laws.
 *
 * 1. Points at random, one a cell, at a quarter of the resolution, then at half of it, then at all of it, so that trunk
 *    valleys come first, with a margin that is cut off at the end.
 * 2. Each step routes water, solves rivers and hillslopes (StepLandscape), and steers the hardness of the rock, which
 *    follows the place's slopes by height, to the long waves.
 * 3. Each iteration measures slopes, curvature, concavity and spectrum, corrects diffusivity, exponent, contrast of
 *    rocks and waves by what is missing, and goes on from where it is.
 * 4. The first that is within its tolerances, or else the best, is brought to the grid, its heights are matched, and
 *    it is breached where the grid lost its way. The roughness of the place that it lacks is added (AddRoughness),
 *    unless rock by place is given.
 * 5. Faults lift it by their throws, and it is breached where they dam rivers.
 *
 * Given rivers, ridges and heights are held in each step: points of the mesh stand on the lines, water runs along the
 * rivers and over no ridge (DrainMesh), and what is missing of given heights is added smoothly (CorrectHeights), at
 * last in turn with breaching.
 *
 * Rock and uplift by place multiply K and U over their geometric means, since the place tells these; the steering does
 * not take back what they ask for (KeepSteepness).
 *
 * Missing heights are filled smoothly, grown over and missing again: water leaves at their rim, too. On more than 2^18
 * cells the law is fitted on the middle 288 x 288 first. The result does not depend on the threads.
 */
CarvingReport GrowLandscape(GridSamples& terrain, const GridSamples& place, const GrowthParameters& parameters,
  const ParallelFor& parallel = SerialFor, const CarvingProgress& progress = NoProgress);

}

#endif
