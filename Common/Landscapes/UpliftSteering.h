// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralUpliftSteering_h
#define LittoralUpliftSteering_h

#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/// Uplift that follows the long waves of a random field.
struct UpliftSteering
{
  double Smoothing = 5.0; ///< standard deviation of the Gauss filter that leaves the long waves [cells], positive
  double Gain = 0.2;      ///< growth of ln U at an error of one standard deviation, positive
  double Minimum = 0.08;  ///< least uplift over that of the start, positive
  double Maximum = 10.0;  ///< greatest uplift over that of the start
};

/**
 * Multiplies the uplift at each point where the heights' long waves are below those that are wanted, and divides it
 * where they are above: U' = U exp(g G(L - z) / s), with the Gauss filter G, the gain g and the standard deviation s of
 * L. A landscape in a steady state then has the long waves of L, as far as water can leave them, under an uplift that
 * is itself a smooth random field.
 */
void SteerUplift(const UpliftSteering& steering, const std::vector<double>& heights, const GridSamples& longWaves,
  std::vector<double>& uplift, const ParallelFor& parallel = SerialFor);

}

#endif
