// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/TiledTerrain.h"

#include "Data/Arrays.h"
#include "Data/Tables.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Memory.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace littoral
{

namespace
{

/// Cells about a tile that are asked for: a ring, and one more, so that the narrowest tile has three.
constexpr int Margin = 2;

/// A byte for the direction, and the fronts of flats.
constexpr double BytesACell = 1.5;
constexpr double BytesANode = 140.0;       // levels, edges both ways, the queue of the graph
constexpr double BytesACellOfTile = 110.0; // heights, levels, labels, the queue of the flood

}

bool TiledTerrain::BeginsAnew(const std::vector<double>& key)
{
  const bool isNew = key != this->Key;
  this->Key = key;
  return isNew;
}

void TiledTerrain::Begin(const std::array<int, 6>& whole, int side, double seaLevel)
{
  this->Drainage.reset();
  const double width = whole[1] - whole[0] + 1.0;
  const double height = whole[3] - whole[2] + 1.0;
  Require(width * height <= std::numeric_limits<std::int32_t>::max()
      ? ""
      : "Terrain has more than 2147483647 heights; water can be routed over no more.");
  const double nodes = 4.0 * width * height / side;
  const double tile = std::min<double>(side, width) * std::min<double>(side, height);
  RequireMemory(BytesACell * width * height + BytesANode * nodes + BytesACellOfTile * tile,
    "Terrain of " + std::to_string(static_cast<int>(width)) + " x " + std::to_string(static_cast<int>(height)) +
      " points: draining it by tiles",
    "take a part of it or a coarser one");
  this->Whole = whole;
  this->Side = side;
  this->Stage = Spills;
  this->Tile = 0;
  this->Lowest = std::numeric_limits<double>::infinity();
  this->Highest = -this->Lowest;
  this->Drainage = std::make_unique<TiledDrainage>(static_cast<int>(width), static_cast<int>(height), side, seaLevel);
}

double TiledTerrain::Share() const
{
  const double count = this->Drainage ? this->Drainage->Tiles().Count() : 1;
  return this->Stage == Known ? 1.0 : 0.5 * (this->Stage + this->Tile / count);
}

std::array<int, 6> TiledTerrain::NextExtent(const std::array<int, 6>& part) const
{
  std::array<int, 6> extent = part;
  for (int axis = 0; axis < 2; ++axis)
  {
    int& first = extent[2 * axis];
    int& last = extent[2 * axis + 1];
    const int begin = this->Whole[2 * axis];
    if (this->Stage == Known)
    {
      // Out to the borders of tiles
      first = begin + (first - begin) / this->Side * this->Side;
      last = begin + (last - begin) / this->Side * this->Side + this->Side - 1;
    }
    else
    {
      const TileWindow window = this->Drainage->Tiles().Window(this->Tile);
      first = begin + (axis == 0 ? window.X : window.Y);
      last = first + (axis == 0 ? window.Width : window.Height) - 1;
    }
    first = std::max(first - Margin, begin);
    last = std::min(last + Margin, this->Whole[2 * axis + 1]);
  }
  extent[4] = this->Whole[4];
  extent[5] = this->Whole[5];
  return extent;
}

TileGround TiledTerrain::GroundOf(vtkImageData* image, vtkDataArray* heights, const TileWindow& window) const
{
  TileGround ground;
  ground.Window = window;
  ground.Heights.Width = window.Width + 2;
  ground.Heights.Height = window.Height + 2;
  ground.Heights.Spacing = { image->GetSpacing()[0], image->GetSpacing()[1] };
  ground.Heights.Values.reserve(static_cast<std::size_t>(ground.Heights.Width) * ground.Heights.Height);
  const int* extent = image->GetExtent();
  const vtkIdType width = extent[1] - extent[0] + 1;
  for (int j = this->Whole[2] + window.Y - 1; j <= this->Whole[2] + window.Y + window.Height; ++j)
  {
    for (int i = this->Whole[0] + window.X - 1; i <= this->Whole[0] + window.X + window.Width; ++i)
    {
      const bool isThere = i >= extent[0] && i <= extent[1] && j >= extent[2] && j <= extent[3];
      const double height = isThere ? heights->GetComponent((j - extent[2]) * width + i - extent[0], 0) : std::nan("");
      ground.Heights.Values.push_back(std::isfinite(height) ? height : std::nan(""));
    }
  }
  return ground;
}

void TiledTerrain::TakeRange(const TileGround& ground)
{
  for (const double height : ground.Heights.Values)
  {
    Require(std::isnan(height) || IsSensible(height) ? "" : "The terrain has heights beyond all numbers of metres.");
    this->Lowest = std::min(this->Lowest, std::isnan(height) ? this->Lowest : height);
    this->Highest = std::max(this->Highest, std::isnan(height) ? this->Highest : height);
  }
}

void TiledTerrain::FinishStage(const Poll& poll)
{
  if (this->Stage == Spills)
  {
    Require(this->Lowest <= this->Highest ? "" : "The terrain has no heights.");
    Require(
      this->Lowest < this->Highest ? "" : "Terrain is constant: water has no way to run, and nothing is to measure.");
    this->Drainage->JoinSpills(poll);
    this->Stage = Directions;
  }
  else
  {
    this->Drainage->JoinFlow(poll);
    this->Stage = Known;
  }
  this->Tile = 0;
}

void TiledTerrain::Take(vtkImageData* image, vtkDataArray* heights, const Poll& poll)
{
  const TileGround ground = this->GroundOf(image, heights, this->Drainage->Tiles().Window(this->Tile));
  if (this->Stage == Spills)
  {
    this->TakeRange(ground);
    this->Drainage->FindSpills(ground, poll);
  }
  else
  {
    this->Drainage->Route(ground, poll);
  }
  if (++this->Tile == this->Drainage->Tiles().Count())
  {
    this->FinishStage(poll);
  }
}

void TiledTerrain::Write(vtkImageData* image, vtkDataArray* heights, const std::array<int, 6>& part,
  vtkImageData* output, const Poll& poll) const
{
  output->ShallowCopy(image);
  output->Crop(part.data());
  const vtkIdType count = output->GetNumberOfPoints();
  const auto elevations = NewArray<vtkDoubleArray>("Elevation", 1, count);
  const auto areas = NewArray<vtkDoubleArray>("DrainageArea", 1, count);
  const auto directions = NewArray<vtkSignedCharArray>("FlowDirection", 1, count);
  const auto depths = NewArray<vtkDoubleArray>("DepressionDepth", 1, count);
  const double area = image->GetSpacing()[0] * image->GetSpacing()[1];
  const TileGrid& tiles = this->Drainage->Tiles();
  for (int tile = 0; tile < tiles.Count(); ++tile)
  {
    const TileWindow window = tiles.Window(tile);
    const int x = this->Whole[0] + window.X;
    const int y = this->Whole[2] + window.Y;
    if (x > part[1] || x + window.Width <= part[0] || y > part[3] || y + window.Height <= part[2])
    {
      continue;
    }
    poll();
    const TileGround ground = this->GroundOf(image, heights, window);
    const TileDrainage drainage = this->Drainage->Drain(ground, poll);
    for (int j = std::max(y, part[2]); j <= std::min(y + window.Height - 1, part[3]); ++j)
    {
      for (int i = std::max(x, part[0]); i <= std::min(x + window.Width - 1, part[1]); ++i)
      {
        const std::size_t own = static_cast<std::size_t>(j - y) * window.Width + (i - x);
        const double height = ground.Heights.Values[ground.CellAt(i - this->Whole[0], j - this->Whole[2])];
        const vtkIdType cell = static_cast<vtkIdType>(j - part[2]) * (part[1] - part[0] + 1) + i - part[0];
        elevations->SetValue(cell, height);
        areas->SetValue(cell, std::isnan(height) ? height : drainage.Cells[own] * area);
        directions->SetValue(cell, static_cast<signed char>(DirectionOf(drainage.Flow[own])));
        depths->SetValue(cell, drainage.SpillElevation[own] - height);
      }
    }
  }
  vtkPointData* points = output->GetPointData();
  points->AddArray(elevations);
  points->AddArray(areas);
  points->AddArray(directions);
  points->AddArray(depths);
  points->SetActiveScalars("Elevation");
  const double cells = static_cast<double>(tiles.GetWidth()) * tiles.GetHeight();
  const double sunk = static_cast<double>(this->Drainage->DepressionCells()) / cells;
  AddField(output, "DepressionFraction", { sunk, sunk });
}

}
