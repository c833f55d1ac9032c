// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSpillGraph_h
#define LittoralSpillGraph_h

#include "Drainage/TileFlood.h"
#include "Drainage/TileGrid.h"
#include "Numerics/Parallel.h"

#include <cstdint>
#include <vector>

namespace littoral
{

/// Nodes of all tiles and the spills between those of a tile.
struct SpillGraph
{
  std::vector<double> Heights;        ///< of nodes [m], NaN where missing
  std::vector<std::uint8_t> IsOutlet; ///< of nodes
  std::vector<SpillEdge> Edges;       ///< within tiles
};

/**
 * Spill elevations of the nodes: a priority-flood over the graph of the edges within tiles and of those between
 * neighbours in different tiles, at max(z_a, z_b) (Barnes 2016).
 */
std::vector<double> FloodSpillGraph(const TileGrid& tiles, const SpillGraph& graph, const Poll& poll = NoPoll);

}

#endif
