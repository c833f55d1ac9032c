// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralHeightCorrection_h
#define LittoralHeightCorrection_h

#include "Landscapes/GivenGround.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/**
 * Brings ground to given heights by successive corrections (Cressman 1959; Barnes 1964): the mean of what is missing
 * first, then by Gauss functions G of half the deviation each time, from a quarter of the shorter side to `least`
 * [cells], which is taken in so many passes,
 *
 *   c = G(sum r) / max(G(n), 0.3 G_0),
 *
 * with what is still missing r at n data of a cell and the height G_0 of the function of one. So the ground is moved
 * over as wide a way about each datum as the data about it allow, and far from all of them by the mean alone. Heights
 * that differ within a cell are met in their mean. Heights of no number are passed over.
 */
void CorrectHeights(GridSamples& ground, const std::vector<GivenHeight>& heights, double least = 1.0,
  const ParallelFor& parallel = SerialFor, int passes = 8);

/// Height of a grid between the middles of its cells, linear along both axes; as at its edge beyond it.
double HeightAt(const GridSamples& grid, const std::array<double, 2>& place);

}

#endif
