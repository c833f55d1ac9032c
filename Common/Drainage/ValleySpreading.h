// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralValleySpreading_h
#define LittoralValleySpreading_h

#include "Numerics/Parallel.h"

#include <vector>

namespace littoral
{

/// Smooths a grid by three moving averages along each axis, whose variances sum to that of a Gauss function of a
/// standard deviation [cells]. The grid goes on mirrored at its edges.
void SmoothGrid(
  std::vector<double>& values, int width, int height, double deviation, const ParallelFor& parallel = SerialFor);

/**
 * Spreads changes that are known at some cells over the cells about them: c = G(w c) / max(G(w), e), with weights w of
 * 1 where a change is known and 0 elsewhere, G a Gauss function of a standard deviation [cells], and e the part 0.3 of
 * G(w) on a straight line of known cells. So a valley has its floor's change in its middle, which fades to its sides.
 */
void SpreadChanges(std::vector<double>& changes, std::vector<double>& weights, int width, int height, double deviation,
  const ParallelFor& parallel = SerialFor);

}

#endif
