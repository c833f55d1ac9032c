// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/TiledDrainage.h"

#include "Drainage/FlowRouting.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace littoral
{

TiledDrainage::TiledDrainage(int width, int height, int side, double seaLevel)
  : Grid(width, height, side)
  , SeaLevel(seaLevel)
{
  this->Spills.Heights.resize(this->Grid.NodeCount());
  this->Spills.IsOutlet.resize(this->Grid.NodeCount());
}

void TiledDrainage::FindSpills(const TileGround& ground, const Poll& poll)
{
  const OutletMask outlets = OutletsOfTile(ground, this->SeaLevel);
  this->Grid.ForEachNode(this->Grid.TileOf(ground.Window.X, ground.Window.Y), [&](CellIndex node, int i, int j) {
    const CellIndex cell = ground.CellAt(i, j);
    this->Spills.Heights[node] = ground.Heights.Values[cell];
    this->Spills.IsOutlet[node] = outlets[cell];
  });
  const std::vector<SpillEdge> edges = FindSpillEdges(ground, this->Grid, outlets, poll);
  this->Spills.Edges.insert(this->Spills.Edges.end(), edges.begin(), edges.end());
}

void TiledDrainage::JoinSpills(const Poll& poll)
{
  this->Levels = FloodSpillGraph(this->Grid, this->Spills, poll);
  this->Spills = SpillGraph();
  this->Codes.resize(static_cast<std::size_t>(this->Grid.GetWidth()) * this->Grid.GetHeight());
}

void TiledDrainage::RouteTile(const TileGround& ground, const OutletMask& outlets, const std::vector<double>& levels)
{
  const CellLattice lattice(ground.Heights);
  const TileWindow& window = ground.Window;
  const auto codeAt = [&](int i, int j) -> FlowCode& {
    return this->Codes[static_cast<std::size_t>(j) * this->Grid.GetWidth() + i];
  };
  std::vector<FlowCode> codes(levels.size(), FlowMissing);
  std::vector<CellIndex> flats;
  for (int j = window.Y; j < window.Y + window.Height; ++j)
  {
    for (int i = window.X; i < window.X + window.Width; ++i)
    {
      const CellIndex cell = ground.CellAt(i, j);
      const int direction = outlets[cell] ? FlowEnds : SteepestDirection(levels, lattice, cell);
      const bool isMissing = std::isnan(levels[cell]);
      codes[cell] = isMissing ? FlowMissing : direction >= 0 ? static_cast<FlowCode>(direction) : FlowUnknown;
      codeAt(i, j) = codes[cell];
      if (codes[cell] == FlowUnknown)
      {
        flats.push_back(cell);
      }
      this->Sunk += levels[cell] > ground.Heights.Values[cell];
    }
  }
  for (const CellIndex cell : flats)
  {
    const auto isExit = [&](CellIndex other) { return LeavesFlat(codes[other]) && levels[other] == levels[cell]; };
    const int width = ground.Heights.Width;
    codeAt(window.X + cell % width - 1, window.Y + cell / width - 1) = FirstExit(lattice, cell, isExit);
  }
}

void TiledDrainage::Route(const TileGround& ground, const Poll& poll)
{
  const OutletMask outlets = OutletsOfTile(ground, this->SeaLevel);
  this->RouteTile(ground, outlets, LevelsOfTile(ground, this->Grid, outlets, this->Levels, poll));
}

void TiledDrainage::FindExitsAcross(CellIndex node)
{
  const std::array<int, 2> cell = this->Grid.CellOf(node);
  const std::size_t width = this->Grid.GetWidth();
  FlowCode& code = this->Codes[cell[1] * width + cell[0]];
  if (code < FlowUnknown || code == FlowMissing)
  {
    return;
  }
  for (int d = 0; d < CellLattice::Directions; ++d)
  {
    const int i = cell[0] + CellLattice::StepX[d];
    const int j = cell[1] + CellLattice::StepY[d];
    const bool isAcross = this->Grid.IsWithin(i, j) && this->Grid.TileOf(i, j) != this->Grid.TileOf(cell[0], cell[1]);
    if (isAcross && LeavesFlat(this->Codes[j * width + i]) &&
      this->Levels[this->Grid.NodeOf(i, j)] == this->Levels[node])
    {
      // The first by direction, be it within the tile or not
      const auto across = static_cast<FlowCode>(d | FlowOnFlat);
      code = code == FlowUnknown ? across : std::min(code, across);
      return;
    }
  }
}

void TiledDrainage::JoinFlow(const Poll& poll)
{
  for (CellIndex node = 0; node < this->Grid.NodeCount(); ++node)
  {
    this->FindExitsAcross(node);
  }
  RouteFlats(CellLattice(this->Grid.GetWidth(), this->Grid.GetHeight(), { 1.0, 1.0 }), this->Codes, poll);
  FlowGraph graph;
  graph.Inflow.resize(this->Grid.NodeCount(), 0);
  graph.Next.resize(this->Grid.NodeCount(), -1);
  for (int tile = 0; tile < this->Grid.Count(); ++tile)
  {
    poll();
    AddTileFlow(this->Grid, tile, this->Codes, graph);
  }
  this->Inflow = AccumulateFlowGraph(graph);
}

TileDrainage TiledDrainage::Drain(const TileGround& ground, const Poll& poll) const
{
  const TileWindow& window = ground.Window;
  const OutletMask outlets = OutletsOfTile(ground, this->SeaLevel);
  const std::vector<double> levels = LevelsOfTile(ground, this->Grid, outlets, this->Levels, poll);
  TileDrainage drainage;
  for (int j = window.Y; j < window.Y + window.Height; ++j)
  {
    const double* row = &levels[ground.CellAt(window.X, j)];
    drainage.SpillElevation.insert(drainage.SpillElevation.end(), row, row + window.Width);
    const FlowCode* codes = &this->Codes[static_cast<std::size_t>(j) * this->Grid.GetWidth() + window.X];
    drainage.Flow.insert(drainage.Flow.end(), codes, codes + window.Width);
  }
  drainage.Cells = AccumulateTile(this->Grid, this->Grid.TileOf(window.X, window.Y), this->Codes, this->Inflow);
  return drainage;
}

}
