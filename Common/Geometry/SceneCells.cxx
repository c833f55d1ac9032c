// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/SceneCells.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

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

std::array<int, 2> CellsOfPart(const std::vector<int>& objectsInCells, int part, int parts)
{
  const long long objects = std::accumulate(objectsInCells.begin(), objectsInCells.end(), 0LL);
  const int cells = static_cast<int>(objectsInCells.size());
  // A cell is in the part of its first object: in part p where p <= n before / N < p + 1.
  const auto firstOf = [&](long long wanted) {
    long long before = 0;
    int cell = 0;
    for (; cell < cells && before * parts < objects * wanted; ++cell)
    {
      before += objectsInCells[cell];
    }
    return cell;
  };
  return { firstOf(part), part + 1 < parts ? firstOf(part + 1) : cells };
}

SceneCells::SceneCells(const std::vector<Vector3>& feet, const std::vector<Box>& boxes, double objectsPerCell)
{
  const CellGrid grid = GridOver(feet, objectsPerCell);
  *this = SceneCells(grid, { 0, grid.GetColumns() * grid.GetRows() }, feet, boxes);
}

SceneCells::SceneCells(const CellGrid& grid, const std::array<int, 2>& cells, const std::vector<Vector3>& feet,
  const std::vector<Box>& boxes)
  : Columns(grid.GetColumns())
{
  if (cells[0] >= cells[1])
  {
    return;
  }
  const int firstRow = cells[0] / this->Columns;
  this->Rows = (cells[1] - 1) / this->Columns + 1 - firstRow;
  const std::size_t count = static_cast<std::size_t>(this->Columns) * this->Rows;
  this->Cells.resize(feet.size());
  this->Count.assign(count, 0);
  this->Boxes.resize(count);
  for (std::size_t object = 0; object < feet.size(); ++object)
  {
    const int cell = grid.CellAt(feet[object]) - firstRow * this->Columns;
    this->Cells[object] = cell;
    Unite(this->Boxes[cell], boxes[object], this->Count[cell] == 0);
    this->Filled += this->Count[cell] == 0;
    ++this->Count[cell];
  }
  this->BuildTiles();
}

void SceneCells::BuildTiles()
{
  this->TileColumns = (this->Columns + TileSide - 1) / TileSide;
  const int tileRows = (this->Rows + TileSide - 1) / TileSide;
  this->Tiles.resize(static_cast<std::size_t>(this->TileColumns) * tileRows);
  this->TileIsFilled.assign(this->Tiles.size(), 0);
  for (int row = 0; row < this->Rows; ++row)
  {
    for (int column = 0; column < this->Columns; ++column)
    {
      const int cell = row * this->Columns + column;
      const int tile = row / TileSide * this->TileColumns + column / TileSide;
      if (this->Count[cell] > 0)
      {
        Unite(this->Tiles[tile], this->Boxes[cell], !this->TileIsFilled[tile]);
        this->TileIsFilled[tile] = 1;
      }
    }
  }
}

std::vector<char> SceneCells::Show(const ViewFrustum& frustum) const
{
  // What is beyond a plane as a tile is so in all its cells, in floating point too: rounding keeps order.
  std::vector<char> shown(this->Count.size(), 0);
  for (std::size_t tile = 0; tile < this->Tiles.size(); ++tile)
  {
    if (!this->TileIsFilled[tile] || !frustum.MayShow(this->Tiles[tile]))
    {
      continue;
    }
    const int firstRow = static_cast<int>(tile) / this->TileColumns * TileSide;
    const int firstColumn = static_cast<int>(tile) % this->TileColumns * TileSide;
    for (int row = firstRow; row < std::min(firstRow + TileSide, this->Rows); ++row)
    {
      for (int column = firstColumn; column < std::min(firstColumn + TileSide, this->Columns); ++column)
      {
        const int cell = row * this->Columns + column;
        shown[cell] = this->Count[cell] > 0 && frustum.MayShow(this->Boxes[cell]);
      }
    }
  }
  return shown;
}

}
