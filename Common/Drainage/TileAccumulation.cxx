// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/TileAccumulation.h"

#include <array>
#include <cstdint>

namespace littoral
{

namespace
{

/// Receivers of the cells of a tile, by their places in it: -1 where water leaves the tile or the grid.
std::vector<CellIndex> ReceiversIn(const TileGrid& tiles, int tile, const std::vector<FlowCode>& codes)
{
  const TileWindow window = tiles.Window(tile);
  std::vector<CellIndex> receivers;
  receivers.reserve(static_cast<std::size_t>(window.Width) * window.Height);
  for (int j = 0; j < window.Height; ++j)
  {
    const FlowCode* row = &codes[static_cast<std::size_t>(window.Y + j) * tiles.GetWidth() + window.X];
    for (int i = 0; i < window.Width; ++i)
    {
      const int direction = DirectionOf(row[i]);
      const int x = direction < 0 ? -1 : i + CellLattice::StepX[direction];
      const int y = direction < 0 ? -1 : j + CellLattice::StepY[direction];
      const bool stays = x >= 0 && y >= 0 && x < window.Width && y < window.Height;
      receivers.push_back(stays ? y * window.Width + x : -1);
    }
  }
  return receivers;
}

/// Adds what each cell has to its receiver, from the divides downstream: A_r += A.
void AddDownstream(const std::vector<CellIndex>& receivers, std::vector<CellIndex>& cells)
{
  const auto count = static_cast<CellIndex>(receivers.size());
  std::vector<CellIndex> donors(receivers.size(), 0);
  for (const CellIndex receiver : receivers)
  {
    if (receiver >= 0)
    {
      ++donors[receiver];
    }
  }
  for (CellIndex source = 0; source < count; ++source)
  {
    // A cell is added once all of its donors are.
    for (CellIndex cell = source; cell >= 0 && donors[cell] == 0;)
    {
      donors[cell] = -1;
      const CellIndex receiver = receivers[cell];
      if (receiver >= 0)
      {
        cells[receiver] += cells[cell];
        --donors[receiver];
      }
      cell = receiver;
    }
  }
}

/// The last cell in a tile of the way from a cell, kept for all cells of the way.
CellIndex LastOf(CellIndex first, const std::vector<CellIndex>& receivers, std::vector<CellIndex>& last)
{
  CellIndex end = first;
  while (last[end] < 0 && receivers[end] >= 0)
  {
    end = receivers[end];
  }
  end = last[end] < 0 ? end : last[end];
  for (CellIndex cell = first; cell >= 0 && last[cell] < 0; cell = receivers[cell])
  {
    last[cell] = end;
  }
  return end;
}

}

std::vector<CellIndex> AccumulateTile(
  const TileGrid& tiles, int tile, const std::vector<FlowCode>& codes, const std::vector<CellIndex>& inflow)
{
  const TileWindow window = tiles.Window(tile);
  const std::vector<CellIndex> receivers = ReceiversIn(tiles, tile, codes);
  std::vector<CellIndex> cells(receivers.size(), 1);
  if (!inflow.empty())
  {
    tiles.ForEachNode(
      tile, [&](CellIndex node, int i, int j) { cells[(j - window.Y) * window.Width + i - window.X] += inflow[node]; });
  }
  AddDownstream(receivers, cells);
  return cells;
}

void AddTileFlow(const TileGrid& tiles, int tile, const std::vector<FlowCode>& codes, FlowGraph& graph)
{
  const TileWindow window = tiles.Window(tile);
  const std::vector<CellIndex> receivers = ReceiversIn(tiles, tile, codes);
  const std::vector<CellIndex> cells = AccumulateTile(tiles, tile, codes);
  // The node in another tile to which a cell drains; -1 without.
  const auto across = [&](int i, int j) {
    const int direction = DirectionOf(codes[static_cast<std::size_t>(j) * tiles.GetWidth() + i]);
    const int x = direction < 0 ? i : i + CellLattice::StepX[direction];
    const int y = direction < 0 ? j : j + CellLattice::StepY[direction];
    return tiles.TileOf(x, y) == tile ? -1 : tiles.NodeOf(x, y);
  };
  std::vector<CellIndex> last(receivers.size(), -1);
  tiles.ForEachNode(tile, [&](CellIndex node, int i, int j) {
    const CellIndex own = (j - window.Y) * window.Width + i - window.X;
    const CellIndex neighbour = across(i, j);
    if (neighbour >= 0)
    {
      graph.Inflow[neighbour] += cells[own];
    }
    const CellIndex end = LastOf(own, receivers, last);
    graph.Next[node] = across(window.X + end % window.Width, window.Y + end / window.Width);
  });
}

std::vector<CellIndex> AccumulateFlowGraph(const FlowGraph& graph)
{
  std::vector<CellIndex> inflow = graph.Inflow;
  AddDownstream(graph.Next, inflow);
  return inflow;
}

}
