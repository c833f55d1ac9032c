// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVoronoiTiles_h
#define LittoralVoronoiTiles_h

#include "Drainage/CellLattice.h"
#include "Numerics/Parallel.h"

#include <array>
#include <cstdint>
#include <vector>

namespace littoral
{

/// Points, one in each cell of a grid, row by row.
struct CellPoints
{
  int Width = 0;
  int Height = 0;
  std::array<double, 2> CellSize;                  ///< [units]
  std::vector<std::array<std::int32_t, 2>> Places; ///< within their cells, from the middle of the first [units]
};

/// Side of a point's cell of Voronoi.
struct VoronoiSide
{
  CellIndex Neighbour; ///< the point across it
  double Length;       ///< 0 where it has no end [units]
};

/// Cells of Voronoi of the points of a rectangle of cells, row by row.
struct VoronoiTile
{
  std::array<int, 2> First;       ///< column and row
  std::array<int, 2> End;         ///< after the last
  std::vector<int> SideCounts;    ///< of each point
  std::vector<VoronoiSide> Sides; ///< of all, counterclockwise
};

/// Whether cells of a size have tiles: those up to twice as long as wide have.
bool AreTiled(const std::array<double, 2>& cellSize);

struct VoronoiCells
{
  std::vector<VoronoiTile> Tiles;
  std::vector<std::array<CellIndex, 3>> Triangles; ///< of Delaunay, by the right ends of their circles
};

/**
 * Cells of Voronoi by Boost.Polygon, exact on integers, tile by tile with a margin: a circle without points is smaller
 * than two diagonals of a cell. Tiles are `side` cells wide about; they change nothing (VoronoiTiles.ChangeNothing).
 * Longer cells have one tile: circles at the border are larger there.
 */
VoronoiCells VoronoiCellsOf(
  const CellPoints& points, const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll, int side = 128);

}

#endif
