// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFractalDimension_h
#define LittoralFractalDimension_h

#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"
#include "Terrain/Variogram.h"

namespace littoral
{

/// The fractal dimension of a surface, in [2, 3], and its standard error; both NaN where the data tell none.
struct DimensionEstimate
{
  double Dimension;
  double StandardError;
};

/**
 * Fractal dimension by the slope of the radial periodogram under a Hann window, which falls as k^(2D - 8) for a fractal
 * surface. The largest structures (fewer than six in the domain) and the finest (below five cells) are left out; what
 * points that sample such a surface fold back from beyond the grid's own wave numbers is taken away. Missing values
 * count as the mean. No dimension is told by a slope beyond those of 2 and 3 (smooth and band-limited fields, noise),
 * by one that bends (its halves tell dimensions that differ by more than 0.4 and two standard errors) or by one whose
 * standard error exceeds 0.12 (grids of less than about 100 cells).
 */
DimensionEstimate DimensionFromPeriodogram(const GridSamples& samples, const ParallelFor& parallel = SerialFor);

/**
 * Fractal dimension by the slope of the variogram between 2 and 16 cells, which rises as h^(6 - 2D) for a fractal
 * surface. No dimension is told by a variogram that starts as a parabola (D below 2.05 at the shortest third of the
 * lags), is level (above 2.97 at either end) or bends (its halves differ by more than 0.12 and two standard errors).
 */
DimensionEstimate DimensionFromVariogram(const VariogramMap& map);

}

#endif
