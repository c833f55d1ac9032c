// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/TileGrid.h"

#include <algorithm>

namespace littoral
{

TileGrid::TileGrid(int width, int height, int side)
  : Width(width)
  , Height(height)
  , Side(side)
  , TilesAlongX((width - 1) / side + 1)
{
  const int count = this->TilesAlongX * ((height - 1) / side + 1);
  this->First.push_back(0);
  for (int tile = 0; tile < count; ++tile)
  {
    const TileWindow window = this->Window(tile);
    const int rows = std::min(window.Height, 2);
    const int columns = std::min(window.Width, 2);
    this->First.push_back(this->First.back() + rows * window.Width + columns * (window.Height - rows));
  }
}

TileWindow TileGrid::Window(int tile) const
{
  const int x = tile % this->TilesAlongX * this->Side;
  const int y = tile / this->TilesAlongX * this->Side;
  return { x, y, std::min(this->Side, this->Width - x), std::min(this->Side, this->Height - y) };
}

CellIndex TileGrid::NodeOf(int i, int j) const
{
  // The first row, the last one, then the first and the last column between them.
  const int tile = this->TileOf(i, j);
  const TileWindow window = this->Window(tile);
  const int x = i - window.X;
  const int y = j - window.Y;
  const int first = this->First[tile];
  if (y == 0)
  {
    return first + x;
  }
  if (y == window.Height - 1)
  {
    return first + window.Width + x;
  }
  if (x == 0)
  {
    return first + 2 * window.Width + y - 1;
  }
  return x == window.Width - 1 ? first + 2 * window.Width + window.Height - 2 + y - 1 : -1;
}

std::array<int, 2> TileGrid::CellIn(int tile, int place) const
{
  const TileWindow window = this->Window(tile);
  if (place < window.Width)
  {
    return { window.X + place, window.Y };
  }
  if (place < 2 * window.Width)
  {
    return { window.X + place - window.Width, window.Y + window.Height - 1 };
  }
  const int beyond = place - 2 * window.Width;
  const bool isFirstColumn = beyond < window.Height - 2;
  return { isFirstColumn ? window.X : window.X + window.Width - 1,
    window.Y + 1 + (isFirstColumn ? beyond : beyond - (window.Height - 2)) };
}

std::array<int, 2> TileGrid::CellOf(CellIndex node) const
{
  const auto next = std::upper_bound(this->First.begin(), this->First.end(), node);
  const int tile = static_cast<int>(next - this->First.begin()) - 1;
  return this->CellIn(tile, node - this->First[tile]);
}

}
