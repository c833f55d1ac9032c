// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralUpliftSteering_h
#define LittoralUpliftSteering_h

#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/// Steering of a landscape to the long waves of a random field, by the hardness of its rock and its uplift.
struct UpliftSteering
{
  double Smoothing = 5.0; ///< standard deviation of the Gauss filter that leaves the long waves [cells], positive
  double Gain = 4.0;      ///< growth of ln h at an error of one standard deviation, where it is small; positive
  double Range = 4.0;     ///< largest factor by which an error changes the hardness, above 1
  double Rate = 0.2;      ///< part of the way to what is wanted that a step goes, 0 to 1
  double Minimum = 0.1;   ///< least hardness, positive
  double Maximum = 20.0;  ///< greatest hardness
};

/**
 * Moves the hardness of each point towards that of its rock, r, times what the error of its long waves asks for:
 *
 *   ln h' = (1 - q) ln h + q (ln r + ln R x / sqrt(1 + x^2)),  x = g G(L - z - mean(L - z)) / (s ln R)
 *
 * with the Gauss filter G, the gain g, the range R, the rate q and the standard deviation s of L. Where water cannot
 * follow the long waves, as in their closed basins, the hardness so stays within the range, and no plain is left.
 */
void SteerUplift(const UpliftSteering& steering, const std::vector<double>& heights, const GridSamples& longWaves,
  const std::vector<double>& rock, std::vector<double>& hardness, const ParallelFor& parallel = SerialFor);

/**
 * Takes out of the hardness what goes with a given steepness q, so that steering does not give soft ground back the
 * relief that its rock has taken:
 *
 *   ln h' = ln h - b (ln q - mean(ln q)),  b = cov(ln h, ln q) / var(ln q)
 *
 * Where q has two values, the means of ln h' over both grounds are the same. `logSteepness` is ln q at each point.
 */
void KeepSteepness(const std::vector<double>& logSteepness, std::vector<double>& hardness);

}

#endif
