// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/SceneCells.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace littoral
{

namespace
{

/// Cells along each side of a tile.
constexpr int TileSide = 16;

/// Cells for each object at most: more would part nothing, and take memory.
constexpr double MostCellsPerObject = 64.0;
constexpr double MostCells = 1e9; ///< of all objects

/// Grows a box to hold another; the first one replaces it.
void Unite(Box& box, const Box& other, bool isFirst)
{
  box.Low = isFirst ? other.Low : glm::min(box.Low, other.Low);
  box.High = isFirst ? other.High : glm::max(box.High, other.High);
}

/// Cells along one side, for a wanted number in all.
int CellsAlong(double size, double otherSize, double wanted)
{
  if (!(size > 0.0))
  {
    return 1;
  }
  const double step = otherSize > 0.0 ? std::sqrt(size * otherSize / wanted) : size / wanted;
  return static_cast<int>(std::clamp(std::round(size / step), 1.0, wanted));
}

/// The grid over some feet.
CellGrid GridOver(const std::vector<Vector3>& feet, double objectsPerCell)
{
  if (feet.empty())
  {
    return {};
  }
  Box ground{ feet.front(), feet.front() };
  for (const Vector3& foot : feet)
  {
    Unite(ground, { foot, foot }, false);
  }
  return CellGrid(ground, static_cast<double>(feet.size()), objectsPerCell);
}

}

CellGrid::CellGrid(const Box& ground, double objects, double objectsPerCell)
{
  const double wanted = std::clamp(objects / objectsPerCell, 1.0, std::min(MostCellsPerObject * objects, MostCells));
  const Vector3 size = ground.High - ground.Low;
  this->Columns = CellsAlong(size.x, size.y, wanted);
  this->Rows = CellsAlong(size.y, size.x, wanted);
  const int counts[2] = { this->Columns, this->Rows };
  for (int axis = 0; axis < 2; ++axis)
  {
    this->Origin[axis] = ground.Low[axis];
    this->Step[axis] = size[axis] > 0.0 ? size[axis] / counts[axis] : 1.0;
  }
}

int CellGrid::CellAt(const Vector3& foot) const
{
  return this->Place(foot.y, 1, this->Rows) * this->Columns + this->Place(foot.x, 0, this->Columns);
}

int CellGrid::Place(double position, int axis, int count) const
{
  const double cell = (position - this->Origin[axis]) / this->Step[axis];
  return cell > 0.0 ? static_cast<int>(std::min(cell, count - 1.0)) : 0; // not a number: 0
}

std::vector<int> FirstCellsOfParts(const std::vector<int>& cellsOfObjects, int cells, int parts, const WorkShare& share)
{
  // Objects in blocks of cells tell the block in which a part begins, and those in its cells the cell: much less for
  // processes to tell each other than all cells.
  const int side = std::max(1, static_cast<int>(std::ceil(std::sqrt(cells))));
  std::vector<double> inBlocks((cells + side - 1) / side, 0.0);
  for (const int cell : cellsOfObjects)
  {
    ++inBlocks[cell / side];
  }
  share.AddUp(inBlocks);
  const double objects = std::accumulate(inBlocks.begin(), inBlocks.end(), 0.0);
  // A cell is in the part of its first object: in part p where p <= parts n / N < p + 1, of n objects before.
  const auto isBefore = [&](double before, int part) { return before * parts < objects * part; };
  struct Beginning
  {
    int Cell = 0;
    double Before = 0.0;
  };
  std::vector<Beginning> blocks(parts);
  std::vector<char> isCut(inBlocks.size(), 0);
  for (int part = 1; part < parts; ++part)
  {
    double before = 0.0;
    for (std::size_t block = 0; block < inBlocks.size() && isBefore(before, part); before += inBlocks[block++])
    {
      blocks[part] = { static_cast<int>(block) * side, before };
    }
    isCut[blocks[part].Cell / side] = 1;
  }
  std::map<int, double> inCells;
  for (const int cell : cellsOfObjects)
  {
    if (isCut[cell / side])
    {
      ++inCells[cell];
    }
  }
  share.AddUp(inCells);
  std::vector<int> first(parts + 1, cells);
  for (int part = 0; part < parts; ++part)
  {
    auto [cell, before] = blocks[part];
    for (; cell < cells && isBefore(before, part); ++cell)
    {
      const auto found = inCells.find(cell);
      before += found == inCells.end() ? 0.0 : found->second;
    }
    first[part] = cell;
  }
  return first;
}

SceneCells::SceneCells(const std::vector<Vector3>& feet, const std::vector<Box>& boxes, double objectsPerCell)
{
  const CellGrid grid = GridOver(feet, objectsPerCell);
  *this = SceneCells(grid, { 0, grid.GetColumns() * grid.GetRows() }, feet, boxes);
}

SceneCells::SceneCells(const CellGrid& grid, const std::array<int, 2>& cells, const std::vector<Vector3>& feet,
  const std::vector<Box>& boxes)
  : SceneCells(grid, cells,
      SceneObjects{ feet.size(), [feet](std::size_t object) { return feet[object]; },
        [boxes](std::size_t object) { return boxes[object]; } })
{
}

SceneCells::SceneCells(const CellGrid& grid, const std::array<int, 2>& cells, SceneObjects objects)
  : Objects(std::move(objects))
  , Grid(grid)
  , Columns(grid.GetColumns())
{
  if (cells[0] >= cells[1])
  {
    return;
  }
  const int firstRow = cells[0] / this->Columns;
  this->FirstCell = firstRow * this->Columns;
  this->Rows = (cells[1] - 1) / this->Columns + 1 - firstRow;
  this->SortObjects();
  this->BuildTiles();
}

int SceneCells::CellOf(std::size_t object) const
{
  return this->Grid.CellAt(this->Objects.FootOf(object)) - this->FirstCell;
}

void SceneCells::SortObjects()
{
  // Objects are counted two cells behind their own, so that filling leaves the starts.
  const std::size_t count = static_cast<std::size_t>(this->Columns) * this->Rows;
  this->Starts.assign(count + 2, 0);
  for (std::size_t object = 0; object < this->Objects.Count; ++object)
  {
    ++this->Starts[this->CellOf(object) + 2];
  }
  this->Filled = static_cast<int>(
    std::count_if(this->Starts.begin() + 2, this->Starts.end(), [](int objects) { return objects > 0; }));
  std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
  this->Order.resize(this->Objects.Count);
  for (std::size_t object = 0; object < this->Objects.Count; ++object)
  {
    this->Order[this->Starts[this->CellOf(object) + 1]++] = static_cast<int>(object);
  }
  this->Starts.pop_back();
}

/// Calls a task with the first cell of each row of a tile, and the one behind the last.
template <typename Task>
void SceneCells::ForRowsOf(std::size_t tile, const Task& task) const
{
  const int firstRow = static_cast<int>(tile) / this->TileColumns * TileSide;
  const int firstColumn = static_cast<int>(tile) % this->TileColumns * TileSide;
  const int endColumn = std::min(firstColumn + TileSide, this->Columns);
  for (int row = firstRow; row < std::min(firstRow + TileSide, this->Rows); ++row)
  {
    task(row * this->Columns + firstColumn, row * this->Columns + endColumn);
  }
}

void SceneCells::BuildTiles()
{
  this->TileColumns = (this->Columns + TileSide - 1) / TileSide;
  const int tileRows = (this->Rows + TileSide - 1) / TileSide;
  this->Tiles.resize(static_cast<std::size_t>(this->TileColumns) * tileRows);
  this->TileIsFilled.assign(this->Tiles.size(), 0);
  for (std::size_t object = 0; object < this->Objects.Count; ++object)
  {
    const int cell = this->CellOf(object);
    const int tile = cell / this->Columns / TileSide * this->TileColumns + cell % this->Columns / TileSide;
    Unite(this->Tiles[tile], this->Objects.BoxOf(object), !this->TileIsFilled[tile]);
    this->TileIsFilled[tile] = 1;
  }
}

Box SceneCells::BoxOf(int cell) const
{
  Box box{};
  for (int place = this->Starts[cell]; place < this->Starts[cell + 1]; ++place)
  {
    Unite(box, this->Objects.BoxOf(this->Order[place]), place == this->Starts[cell]);
  }
  return box;
}

std::vector<char> SceneCells::Show(const ViewFrustum& frustum) const
{
  // What is beyond a plane as a tile is so in all its cells, and what is within all is so too, in floating point as
  // well: rounding keeps order.
  std::vector<char> shown(static_cast<std::size_t>(this->Columns) * this->Rows, 0);
  for (std::size_t tile = 0; tile < this->Tiles.size(); ++tile)
  {
    if (!this->TileIsFilled[tile] || !frustum.MayShow(this->Tiles[tile]))
    {
      continue;
    }
    const bool isWithin = frustum.Holds(this->Tiles[tile], 0.0);
    this->ForRowsOf(tile, [&](int first, int end) {
      for (int cell = first; cell < end; ++cell)
      {
        shown[cell] = this->NumberIn(cell) > 0 && (isWithin || frustum.MayShow(this->BoxOf(cell)));
      }
    });
  }
  return shown;
}

void SceneCells::ForObjects(const std::vector<char>& marks, const std::function<bool(const Box&)>& isWanted,
  const std::function<void(const int* first, const int* end)>& task) const
{
  for (std::size_t tile = 0; tile < this->Tiles.size(); ++tile)
  {
    if (!this->TileIsFilled[tile] || !isWanted(this->Tiles[tile]))
    {
      continue;
    }
    this->ForRowsOf(tile, [&](int first, int end) {
      for (int cell = first; cell < end; ++cell)
      {
        if (marks[cell])
        {
          task(this->Order.data() + this->Starts[cell], this->Order.data() + this->Starts[cell + 1]);
        }
      }
    });
  }
}

}
