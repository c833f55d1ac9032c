// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralValleySpreading_h
#define LittoralValleySpreading_h

#include "Numerics/Parallel.h"

#include <vector>

namespace littoral
{

/// Gaussian smoothing of a standard deviation [cells] by three moving averages along each axis, whose variances sum to
/// its square. The grid is mirrored at its edges.
void SmoothGrid(
  std::vector<double>& values, int width, int height, double deviation, const ParallelFor& parallel = SerialFor);

/**
 * Spreads changes of some cells over the cells about them by normalized convolution: c = G(w c) / max(G(w), e), with
 * weights w of 1 where a change is known and 0 elsewhere, Gaussian smoothing G of a standard deviation [cells], and e =
 * 0.3 G(w) on a straight line of known cells. So a valley takes on its channel's change, which fades to its sides.
 */
void SpreadChanges(std::vector<double>& changes, std::vector<double>& weights, int width, int height, double deviation,
  const ParallelFor& parallel = SerialFor);

}

#endif
