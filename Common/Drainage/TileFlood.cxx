// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/TileFlood.h"

#include "Drainage/FloodQueue.h"
#include "Numerics/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace littoral
{

namespace
{

constexpr double Missing = std::numeric_limits<double>::quiet_NaN();

/// Cells of a tile without its ring.
template <typename Visit>
void ForEachCell(const TileGround& ground, const Visit& visit)
{
  for (int j = 0; j < ground.Window.Height; ++j)
  {
    for (int i = 0; i < ground.Window.Width; ++i)
    {
      visit((j + 1) * ground.Heights.Width + i + 1);
    }
  }
}

/// Nodes of the tile of a ground.
template <typename Visit>
void ForEachNode(const TileGround& ground, const TileGrid& tiles, const Visit& visit)
{
  tiles.ForEachNode(tiles.TileOf(ground.Window.X, ground.Window.Y),
    [&](CellIndex node, int i, int j) { visit(node, ground.CellAt(i, j)); });
}

/// Priority-flood of a tile from cells whose level is there, NaN elsewhere: meet(cell, neighbour, isNew) for each
/// neighbour, once the cell is taken.
template <typename Meet>
void Flood(const TileGround& ground, std::vector<double>& levels, const Poll& poll, const Meet& meet)
{
  const std::vector<double>& heights = ground.Heights.Values;
  const CellLattice lattice(ground.Heights);
  const auto [lowest, highest] = RangeOf(heights);
  FloodQueue rim(lowest, highest, heights.size());
  std::vector<std::uint8_t> isOpen(heights.size(), 0);
  ForEachCell(ground, [&](CellIndex cell) {
    isOpen[cell] = !std::isnan(heights[cell]);
    if (!std::isnan(levels[cell]))
    {
      rim.Push(cell, levels[cell]);
    }
  });
  FloodFrom(rim, lattice, heights, levels, poll, [&](CellIndex cell, CellIndex neighbour) {
    if (!isOpen[neighbour])
    {
      return false;
    }
    const bool isNew = std::isnan(levels[neighbour]);
    meet(cell, neighbour, isNew);
    return isNew;
  });
}

/// Levels of a tile's outlets, NaN elsewhere.
std::vector<double> LevelsOfOutlets(const TileGround& ground, const OutletMask& outlets)
{
  std::vector<double> levels(outlets.size(), Missing);
  for (std::size_t cell = 0; cell < outlets.size(); ++cell)
  {
    levels[cell] = outlets[cell] ? ground.Heights.Values[cell] : Missing;
  }
  return levels;
}

}

OutletMask OutletsOfTile(const TileGround& ground, double seaLevel)
{
  const std::vector<double>& heights = ground.Heights.Values;
  const CellLattice lattice(ground.Heights);
  OutletMask outlets(heights.size(), 0);
  ForEachCell(ground, [&](CellIndex cell) {
    bool isOutlet = heights[cell] <= seaLevel;
    lattice.ForEachNeighbour(
      cell, [&](CellIndex neighbour, int) { isOutlet = isOutlet || std::isnan(heights[neighbour]); });
    outlets[cell] = isOutlet && !std::isnan(heights[cell]);
  });
  return outlets;
}

std::vector<SpillEdge> FindSpillEdges(
  const TileGround& ground, const TileGrid& tiles, const OutletMask& outlets, const Poll& poll)
{
  std::vector<double> levels = LevelsOfOutlets(ground, outlets);
  std::vector<CellIndex> nodes{ -1 };
  std::vector<int> labels(levels.size(), 0); // 0 for outlets, else the place among these nodes
  ForEachNode(ground, tiles, [&](CellIndex node, CellIndex cell) {
    if (!outlets[cell] && !std::isnan(ground.Heights.Values[cell]))
    {
      levels[cell] = ground.Heights.Values[cell];
      labels[cell] = static_cast<int>(nodes.size());
      nodes.push_back(node);
    }
  });
  DisjointSets sets(nodes.size());
  std::vector<SpillEdge> edges;
  Flood(ground, levels, poll, [&](CellIndex cell, CellIndex neighbour, bool isNew) {
    if (isNew)
    {
      labels[neighbour] = labels[cell];
      return;
    }
    // Edges come by their level, max(w_a, w_b) = w_a
    if (labels[neighbour] != labels[cell] && levels[neighbour] <= levels[cell] &&
      sets.Join(labels[cell], labels[neighbour]))
    {
      edges.push_back({ nodes[labels[cell]], nodes[labels[neighbour]], levels[cell] });
    }
  });
  return edges;
}

std::vector<double> LevelsOfTile(const TileGround& ground, const TileGrid& tiles, const OutletMask& outlets,
  const std::vector<double>& levelsOfNodes, const Poll& poll)
{
  std::vector<double> levels = LevelsOfOutlets(ground, outlets);
  ForEachNode(ground, tiles, [&](CellIndex node, CellIndex cell) { levels[cell] = levelsOfNodes[node]; });
  Flood(ground, levels, poll, [](CellIndex, CellIndex, bool) {});
  const TileWindow& window = ground.Window;
  const auto takeRing = [&](int i, int j) {
    levels[ground.CellAt(i, j)] = tiles.IsWithin(i, j) ? levelsOfNodes[tiles.NodeOf(i, j)] : Missing;
  };
  for (int i = window.X - 1; i <= window.X + window.Width; ++i)
  {
    takeRing(i, window.Y - 1);
    takeRing(i, window.Y + window.Height);
  }
  for (int j = window.Y; j < window.Y + window.Height; ++j)
  {
    takeRing(window.X - 1, j);
    takeRing(window.X + window.Width, j);
  }
  return levels;
}

}
