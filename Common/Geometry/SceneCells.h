// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneCells_h
#define LittoralSceneCells_h

#include "Geometry/ViewFrustum.h"
#include "Numerics/WorkShare.h"

#include <array>
#include <cstddef>
#include <functional>
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

/// The first cell of each part and the number of all cells, of parts with as many objects each as whole cells allow.
/// Processes that share the objects each know the cells of their own.
std::vector<int> FirstCellsOfParts(
  const std::vector<int>& cellsOfObjects, int cells, int parts, const WorkShare& share = {});

/// Objects by their numbers. They are asked for their feet and boxes whenever these are needed, and none is kept.
struct SceneObjects
{
  std::size_t Count = 0;
  std::function<Vector3(std::size_t)> FootOf;
  std::function<Box(std::size_t)> BoxOf;
};

/**
 * A regular grid of cells over a scene, seen from above (Setas et al., section 4: a view need process only the objects
 * of the cells that its volume meets). An object belongs to the cell of its foot. A cell's box holds the boxes of all
 * of its objects, so that a crown which leans into the picture from a cell beside it is not lost. Kept are four bytes
 * an object, four a cell, and the boxes of tiles of cells; the boxes of cells are united anew where a tile is cut.
 */
class SceneCells
{
public:
  /// The cells of a grid from the first up to the end, and the objects in them. A cell's number here is counted from
  /// the row of the first.
  SceneCells(const CellGrid& grid, const std::array<int, 2>& cells, SceneObjects objects);
  /// The same of objects whose feet and boxes are there.
  SceneCells(const CellGrid& grid, const std::array<int, 2>& cells, const std::vector<Vector3>& feet,
    const std::vector<Box>& boxes);
  /// All cells of a grid over the feet.
  SceneCells(const std::vector<Vector3>& feet, const std::vector<Box>& boxes, double objectsPerCell);

  int GetColumns() const { return this->Columns; }
  int GetRows() const { return this->Rows; }

  /// The cell of an object.
  int CellOf(std::size_t object) const;

  /// Number of objects in a cell.
  int NumberIn(int cell) const { return this->Starts[cell + 1] - this->Starts[cell]; }

  /// Number of cells that hold an object.
  int NumberOfFilled() const { return this->Filled; }

  /// The box of what a cell holds; without meaning for an empty cell.
  Box BoxOf(int cell) const;

  /// A mark for each cell: whether it holds anything, and its box may be shown.
  std::vector<char> Show(const ViewFrustum& frustum) const;

  /// Calls a task with the objects of each marked cell, tile after tile, and in a tile row after row. Tiles whose boxes
  /// a test refuses are left out.
  void ForObjects(const std::vector<char>& marks, const std::function<bool(const Box&)>& isWanted,
    const std::function<void(const int* first, const int* end)>& task) const;

private:
  void SortObjects();
  void BuildTiles();
  template <typename Task>
  void ForRowsOf(std::size_t tile, const Task& task) const;

  SceneObjects Objects;
  CellGrid Grid;
  int FirstCell = 0;
  int Columns = 0;
  int Rows = 0;
  int Filled = 0;
  std::vector<int> Starts; ///< of the objects of each cell in the order, and the end
  std::vector<int> Order;  ///< objects by cells, increasing in each
  // Squares of cells, tested before the cells in them.
  int TileColumns = 0;
  std::vector<char> TileIsFilled;
  std::vector<Box> Tiles;
};

}

#endif
