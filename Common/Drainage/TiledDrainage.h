// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTiledDrainage_h
#define LittoralTiledDrainage_h

#include "Drainage/FlatRouting.h"
#include "Drainage/SpillGraph.h"
#include "Drainage/TileAccumulation.h"
#include "Drainage/TileFlood.h"
#include "Drainage/TileGrid.h"
#include "Numerics/Parallel.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// Drainage of the cells of a tile, x fastest.
struct TileDrainage
{
  std::vector<double> SpillElevation; ///< [m], NaN where missing
  std::vector<FlowCode> Flow;
  std::vector<CellIndex> Cells; ///< flow accumulation
};

/**
 * Drainage of a grid of which no more than a tile of heights is there at a time: spill elevations, receivers and flow
 * accumulation are those of RouteFlow() over the whole grid, cell for cell. A byte a cell is kept, and what the edges
 * of tiles need. Outlets are those of OutletsOfTile().
 *
 * Every tile is given to FindSpills(), then every one to Route(); then any to Drain(). The order of tiles is free.
 */
class TiledDrainage
{
public:
  TiledDrainage(int width, int height, int side, double seaLevel);

  const TileGrid& Tiles() const { return this->Grid; }

  /// Cells below their spill elevation, known when every tile is routed.
  std::size_t DepressionCells() const { return this->Sunk; }

  void FindSpills(const TileGround& ground, const Poll& poll = NoPoll);
  void JoinSpills(const Poll& poll = NoPoll);
  void Route(const TileGround& ground, const Poll& poll = NoPoll);
  void JoinFlow(const Poll& poll = NoPoll);
  TileDrainage Drain(const TileGround& ground, const Poll& poll = NoPoll) const;

private:
  void RouteTile(const TileGround& ground, const OutletMask& outlets, const std::vector<double>& levels);
  void FindExitsAcross(CellIndex node);

  TileGrid Grid;
  double SeaLevel;
  SpillGraph Spills;
  std::vector<double> Levels;    ///< spill elevations of nodes [m]
  std::vector<FlowCode> Codes;   ///< of all cells
  std::vector<CellIndex> Inflow; ///< cells that drain into nodes from other tiles
  std::size_t Sunk = 0;
};

}

#endif
