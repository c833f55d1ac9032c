// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFractalDimension_h
#define LittoralFractalDimension_h

#include "GridSamples.h"
#include "Parallel.h"
#include "Variogram.h"

namespace littoral
{

/// A fractal dimension of a surface, 2 to 3 for a fractal one, and its standard error. NaN where there are too few
/// data.
struct DimensionEstimate
{
  double Dimension;
  double StandardError;
};

/**
 * From the slope of the radial periodogram under a Hann window, which falls as k^(2D - 8) for a fractal surface. The
 * largest structures (fewer than six in the domain) and the finest (below five cells) are left out. Missing values
 * count as the mean.
 */
DimensionEstimate DimensionFromPeriodogram(const GridSamples& samples, const ParallelFor& parallel = SerialFor);

/// From the slope of the variogram between 2 and 16 cells, which rises as h^(6 - 2D) for a fractal surface.
DimensionEstimate DimensionFromVariogram(const VariogramMap& map);

}

#endif
