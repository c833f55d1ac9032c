// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneCells_h
#define LittoralSceneCells_h

#include "Geometry/ViewFrustum.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/**
 * A regular grid of cells over a scene, seen from above (Setas et al., section 4: a view need process only the objects
 * of the cells that its volume meets). An object belongs to the cell of its foot. A cell's box holds the boxes of all
 * of its objects, so that a crown which leans into the picture from a cell beside it is not lost.
 */
class SceneCells
{
public:
  /// Cells as nearly square as can be, for about as many objects each as asked for (positive).
  SceneCells(const std::vector<Vector3>& feet, const std::vector<Box>& boxes, double objectsPerCell);

  int GetColumns() const { return this->Columns; }
  int GetRows() const { return this->Rows; }

  /// The cell of an object; cells are counted row by row, from the smallest x and y.
  int CellOf(std::size_t object) const { return this->Cells[object]; }

  /// Number of objects in a cell.
  int NumberIn(int cell) const { return this->Count[cell]; }

  /// Number of cells that hold an object.
  int NumberOfFilled() const { return this->Filled; }

  /// The box of what a cell holds; without meaning for an empty cell.
  const Box& BoxOf(int cell) const { return this->Boxes[cell]; }

  /// A mark for each cell: whether it holds anything, and its box may be shown.
  std::vector<char> Show(const ViewFrustum& frustum) const;

private:
  int Place(double position, int axis, int count) const;
  void BuildTiles();

  int Columns = 0;
  int Rows = 0;
  int Filled = 0;
  double Origin[2] = { 0.0, 0.0 };
  double Step[2] = { 1.0, 1.0 };
  std::vector<int> Cells;
  std::vector<int> Count;
  std::vector<Box> Boxes;
  // Squares of cells, tested before the cells in them.
  int TileColumns = 0;
  std::vector<char> TileIsFilled;
  std::vector<Box> Tiles;
};

}

#endif
