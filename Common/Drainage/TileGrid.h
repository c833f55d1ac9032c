// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTileGrid_h
#define LittoralTileGrid_h

#include "Drainage/CellLattice.h"

#include <array>
#include <vector>

namespace littoral
{

/// Cells of a tile: its first one and their numbers along x and y.
struct TileWindow
{
  int X = 0;
  int Y = 0;
  int Width = 0;
  int Height = 0;
};

/// A grid cut into square tiles, row by row; those at its far sides may be smaller. The cells along the edges of all
/// tiles are nodes, numbered tile by tile.
class TileGrid
{
public:
  TileGrid(int width, int height, int side);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  int Count() const { return static_cast<int>(this->First.size()) - 1; }
  CellIndex NodeCount() const { return this->First.back(); }
  TileWindow Window(int tile) const;
  int TileOf(int i, int j) const { return j / this->Side * this->TilesAlongX + i / this->Side; }
  bool IsWithin(int i, int j) const { return i >= 0 && j >= 0 && i < this->Width && j < this->Height; }

  /// Node of a cell; -1 of cells that are not at the edge of their tile.
  CellIndex NodeOf(int i, int j) const;

  /// Column and row of a node.
  std::array<int, 2> CellOf(CellIndex node) const;

  /// Calls visit(node, i, j) for the nodes of a tile, in their order.
  template <typename Visit>
  void ForEachNode(int tile, const Visit& visit) const
  {
    for (CellIndex node = this->First[tile]; node < this->First[tile + 1]; ++node)
    {
      const std::array<int, 2> cell = this->CellIn(tile, node - this->First[tile]);
      visit(node, cell[0], cell[1]);
    }
  }

private:
  std::array<int, 2> CellIn(int tile, int place) const;

  int Width;
  int Height;
  int Side;
  int TilesAlongX;
  std::vector<CellIndex> First; ///< first node of each tile, and the number of nodes
};

}

#endif
