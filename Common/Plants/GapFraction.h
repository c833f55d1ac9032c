// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGapFraction_h
#define LittoralGapFraction_h

#include "Numerics/Parallel.h"
#include "Numerics/WorkShare.h"
#include "Plants/CanopyCells.h"

namespace littoral
{

/**
 * Mean part of the sky that is seen from the lowest face of a grid, at an angle to the vertical [rad], below 90
 * degrees: the mean of exp(-G times the integral of the leaf area density along a line) over lines from 64 x 64 places
 * at most towards 16 azimuths. Leaves are random within a cell; the grid repeats itself sideways. Processes that have
 * the same grid share the rows of places.
 */
double GapFraction(const CanopyGrid& grid, const float* density, double zenith, double projection,
  const ParallelFor& parallel = SerialFor, const WorkShare& share = {});

}

#endif
