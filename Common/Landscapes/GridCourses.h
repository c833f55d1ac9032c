// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGridCourses_h
#define LittoralGridCourses_h

#include "Landscapes/GivenGround.h"
#include "Terrain/GridSamples.h"

namespace littoral
{

/**
 * Brings what a grid of grown ground has lost of given lines back: each cell of a river is lowered to its lowest
 * neighbour of no river, and to a least slope [m/m] from the one before, so that D8 follows it; each cell of a ridge is
 * raised to its highest neighbour, and no step between two of them is diagonal, so that no flow crosses it. Cells of
 * both are the river's.
 */
void LeadGrid(GridSamples& ground, const GivenGround& given, double leastSlope);

}

#endif
