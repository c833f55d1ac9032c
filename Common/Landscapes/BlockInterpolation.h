// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralBlockInterpolation_h
#define LittoralBlockInterpolation_h

#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

namespace littoral
{

/**
 * Values between those of coarse cells by cubic convolution (Keys 1981, a = -1/2), at the middles of `factor` times
 * `factor` cells in each: quadratic surfaces stay what they are. Beyond its edge the grid goes on by reflection in the
 * points there, so planes stay planes. Two rows and columns or more, no missing values.
 */
GridSamples CubicRefinement(
  const GridSamples& coarse, int factor, const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

/**
 * Brings the means of squares of `factor` times `factor` cells to those of coarse cells (back-projection): each pass
 * adds the cubic refinement of what is missing. Eight passes leave 1/300 of what is missing of a single cell.
 */
void HoldBlockMeans(GridSamples& fine, const GridSamples& coarse, int factor, int passes,
  const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

/// Moves the means of blocks that are more than `limits` [m] from those of the coarse cells back to the limit.
void LimitBlockShifts(GridSamples& fine, const GridSamples& coarse, int factor, const std::vector<double>& limits,
  const Poll& poll = NoPoll);

}

#endif
