// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/SpillGraph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace littoral
{

namespace
{

/// Edges of each node, both ways; those of the outlets are left out.
class NodeEdges
{
public:
  NodeEdges(CellIndex nodes, const std::vector<SpillEdge>& edges)
    : First(static_cast<std::size_t>(nodes) + 1, 0)
  {
    ForEachWay(edges, [&](CellIndex from, CellIndex, double) { ++this->First[from + 1]; });
    for (CellIndex node = 0; node < nodes; ++node)
    {
      this->First[node + 1] += this->First[node];
    }
    this->Ways.resize(this->First.back());
    std::vector<CellIndex> next(this->First.begin(), this->First.end() - 1);
    ForEachWay(edges, [&](CellIndex from, CellIndex to, double level) { this->Ways[next[from]++] = { to, level }; });
  }

  /// Calls visit(other node, level) for the edges of a node.
  template <typename Visit>
  void ForEach(CellIndex node, const Visit& visit) const
  {
    for (CellIndex n = this->First[node]; n < this->First[node + 1]; ++n)
    {
      visit(this->Ways[n].first, this->Ways[n].second);
    }
  }

private:
  template <typename Visit>
  static void ForEachWay(const std::vector<SpillEdge>& edges, const Visit& visit)
  {
    for (const SpillEdge& edge : edges)
    {
      if (edge.A >= 0 && edge.B >= 0)
      {
        visit(edge.A, edge.B, edge.Level);
        visit(edge.B, edge.A, edge.Level);
      }
    }
  }

  std::vector<CellIndex> First;
  std::vector<std::pair<CellIndex, double>> Ways;
};

/// Calls visit(other node) for the neighbours of a node that are in other tiles.
template <typename Visit>
void ForEachAcross(const TileGrid& tiles, CellIndex node, const Visit& visit)
{
  const std::array<int, 2> cell = tiles.CellOf(node);
  const int tile = tiles.TileOf(cell[0], cell[1]);
  for (int d = 0; d < CellLattice::Directions; ++d)
  {
    const int i = cell[0] + CellLattice::StepX[d];
    const int j = cell[1] + CellLattice::StepY[d];
    if (tiles.IsWithin(i, j) && tiles.TileOf(i, j) != tile)
    {
      visit(tiles.NodeOf(i, j));
    }
  }
}

}

std::vector<double> FloodSpillGraph(const TileGrid& tiles, const SpillGraph& graph, const Poll& poll)
{
  constexpr double unreached = std::numeric_limits<double>::infinity();
  using Entry = std::pair<double, CellIndex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> rim;
  std::vector<double> levels(graph.Heights.size(), unreached);
  const auto reach = [&](CellIndex node, double level) {
    if (level < levels[node])
    {
      levels[node] = level;
      rim.emplace(level, node);
    }
  };
  for (CellIndex node = 0; node < tiles.NodeCount(); ++node)
  {
    if (graph.IsOutlet[node])
    {
      reach(node, graph.Heights[node]);
    }
  }
  for (const SpillEdge& edge : graph.Edges)
  {
    if (edge.A < 0 || edge.B < 0)
    {
      reach(std::max(edge.A, edge.B), edge.Level);
    }
  }
  const NodeEdges edges(tiles.NodeCount(), graph.Edges);
  SteppedPoll steps(poll, 1 << 12);
  while (!rim.empty())
  {
    steps.Step();
    const auto [level, node] = rim.top();
    rim.pop();
    if (level > levels[node])
    {
      continue; // reached by a lower way before
    }
    const double own = level;
    edges.ForEach(node, [&](CellIndex other, double spill) { reach(other, std::max(own, spill)); });
    // w_b = max(w_a, z_b) across the border of tiles; a missing height is not reached
    ForEachAcross(tiles, node, [&](CellIndex other) {
      if (!std::isnan(graph.Heights[other]))
      {
        reach(other, std::max(own, graph.Heights[other]));
      }
    });
  }
  for (double& level : levels)
  {
    level = level < unreached ? level : std::numeric_limits<double>::quiet_NaN();
  }
  return levels;
}

}
