// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/SceneCells.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

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

}

SceneCells::SceneCells(const std::vector<Vector3>& feet, const std::vector<Box>& boxes, double objectsPerCell)
{
  if (feet.empty())
  {
    return;
  }
  Box ground{ feet.front(), feet.front() };
  for (const Vector3& foot : feet)
  {
    Unite(ground, { foot, foot }, false);
  }
  const auto objects = static_cast<double>(feet.size());
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
  const std::size_t cells = static_cast<std::size_t>(this->Columns) * this->Rows;
  this->Cells.resize(feet.size());
  this->Count.assign(cells, 0);
  this->Boxes.resize(cells);
  for (std::size_t object = 0; object < feet.size(); ++object)
  {
    const int column = this->Place(feet[object].x, 0, this->Columns);
    const int cell = this->Place(feet[object].y, 1, this->Rows) * this->Columns + column;
    this->Cells[object] = cell;
    Unite(this->Boxes[cell], boxes[object], this->Count[cell] == 0);
    this->Filled += this->Count[cell] == 0;
    ++this->Count[cell];
  }
  this->BuildTiles();
}

int SceneCells::Place(double position, int axis, int count) const
{
  return std::clamp(static_cast<int>((position - this->Origin[axis]) / this->Step[axis]), 0, count - 1);
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
