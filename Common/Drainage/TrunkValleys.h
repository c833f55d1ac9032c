// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTrunkValleys_h
#define LittoralTrunkValleys_h

#include "Drainage/FlowRouting.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/// Cells of rivers that drain a fiftieth of a map and more, between mountains, over the root of the map's cells. These
/// are ground of the map's highest quarter within a twelfth of its shorter side, in six of the eight directions.
double TrunkValleyLength(const GridSamples& ground, const std::vector<CellIndex>& accumulation);

}

#endif
