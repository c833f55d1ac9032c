// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneCells_h
#define LittoralSceneCells_h

#include "Geometry/ViewFrustum.h"

#include <array>
#include <cstddef>
#include <vector>

namespace littoral
{

/// The cells of a scene's ground, counted row by row from the smallest x and y.
class CellGrid
{
public:
  CellGrid() = default;
  /// Cells as nearly square as can be, for about as many of the objects each as asked for (positive). Of the ground's
  /// box x and y count.
  CellGrid(const Box& ground, double objects, double objectsPerCell);

  int GetColumns() const { return this->Columns; }
  int GetRows() const { return this->Rows; }
  /// The cell of a foot; the nearest one of a foot beside the ground.
  int CellAt(const Vector3& foot) const;

private:
  int Place(double position, int axis, int count) const;

  int Columns = 0;
  int Rows = 0;
  double Origin[2] = { 0.0, 0.0 };
  double Step[2] = { 1.0, 1.0 };
};

/// The first cell of a part and the one behind its last, of parts with as many objects each as whole cells allow.
std::array<int, 2> CellsOfPart(const std::vector<int>& objectsInCells, int part, int parts);

/**
 * A regular grid of cells over a scene, seen from above (Setas et al., section 4: a view need process only the objects
 * of the cells that its volume meets). An object belongs to the cell of its foot. A cell's box holds the boxes of all
 * of its objects, so that a crown which leans into the picture from a cell beside it is not lost.
 */
class SceneCells
{
public:
  /// The cells of a grid from the first up to the end, and the objects in them. A cell's number here is counted from
  /// the row of the first.
  SceneCells(const CellGrid& grid, const std::array<int, 2>& cells, const std::vector<Vector3>& feet,
    const std::vector<Box>& boxes);
  /// All cells of a grid over the feet.
  SceneCells(const std::vector<Vector3>& feet, const std::vector<Box>& boxes, double objectsPerCell);

  int GetColumns() const { return this->Columns; }
  int GetRows() const { return this->Rows; }

  /// The cell of an object.
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
  void BuildTiles();

  int Columns = 0;
  int Rows = 0;
  int Filled = 0;
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
