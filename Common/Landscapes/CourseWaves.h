// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCourseWaves_h
#define LittoralCourseWaves_h

#include "Landscapes/GivenGround.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

namespace littoral
{

/**
 * Long waves with valleys where rivers are given and heights where ridges are: along a river the waves are lowered to
 * the lowest within 1.5 s and to what is upstream, along a ridge they are raised to the highest within 1.5 s, and a
 * change r fades to the sides as a Gauss function G of the deviation s [cells],
 *
 *   c = G(sum r) / max(G(n), G_1),
 *
 * with the number n of pieces of lines in a cell and G_1 = 1 / (sqrt(2 pi) s) on a straight line.
 */
void LeadWaves(GridSamples& waves, const GivenGround& given, double deviation, const ParallelFor& parallel = SerialFor);

}

#endif
