// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTileAccumulation_h
#define LittoralTileAccumulation_h

#include "Drainage/FlatRouting.h"
#include "Drainage/TileGrid.h"

#include <vector>

namespace littoral
{

/// Flow accumulation of the cells of a tile, itself included, x fastest: what comes into its nodes from other tiles is
/// given, 0 where `inflow` is empty.
std::vector<CellIndex> AccumulateTile(
  const TileGrid& tiles, int tile, const std::vector<FlowCode>& codes, const std::vector<CellIndex>& inflow = {});

/// Graph of the flow across tiles: what flows in from the neighbour tiles' own cells, and the node of another tile to
/// which what comes into a node flows on; -1 where it stays.
struct FlowGraph
{
  std::vector<CellIndex> Inflow;
  std::vector<CellIndex> Next;
};

/// Adds what the cells of a tile give to others, and where their nodes lead.
void AddTileFlow(const TileGrid& tiles, int tile, const std::vector<FlowCode>& codes, FlowGraph& graph);

/// Inflow of all nodes: what comes into each goes on to the next (Barnes 2017).
std::vector<CellIndex> AccumulateFlowGraph(const FlowGraph& graph);

}

#endif
