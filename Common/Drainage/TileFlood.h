// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTileFlood_h
#define LittoralTileFlood_h

#include "Drainage/DrainageOutlets.h"
#include "Drainage/TileGrid.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/// Heights of a tile and of the ring of cells around it, which are NaN beyond the grid.
struct TileGround
{
  TileWindow Window;
  GridSamples Heights; ///< two columns and two rows more than the window

  /// Index of a cell of the grid among these.
  CellIndex CellAt(int i, int j) const
  {
    return (j - this->Window.Y + 1) * this->Heights.Width + i - this->Window.X + 1;
  }
};

/// Outlets of a tile, as of RimOutlets() and SeaOutlets(): cells beside missing ones or the border of the grid, and
/// those at or below a level [m], which may be -infinity. The ring has none, missing heights neither.
OutletMask OutletsOfTile(const TileGround& ground, double seaLevel);

/// The lowest level at which water passes from one node to another within a tile [m]; node -1 are the tile's outlets.
struct SpillEdge
{
  CellIndex A;
  CellIndex B;
  double Level;
};

/**
 * Edges of a minimum spanning forest of the spills between the nodes of a tile (Barnes 2016). Floods come from all of
 * them at once; where two meet first, at max(w_a, w_b), is an edge if nothing lower connects them (Kruskal 1956).
 */
std::vector<SpillEdge> FindSpillEdges(
  const TileGround& ground, const TileGrid& tiles, const OutletMask& outlets, const Poll& poll = NoPoll);

/// Spill elevations w of a tile, as of the whole grid, of those of all nodes; with those of the ring, NaN beyond the
/// grid.
std::vector<double> LevelsOfTile(const TileGround& ground, const TileGrid& tiles, const OutletMask& outlets,
  const std::vector<double>& levelsOfNodes, const Poll& poll = NoPoll);

}

#endif
