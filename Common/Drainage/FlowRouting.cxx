// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/FlowRouting.h"

#include "Drainage/DepressionFilling.h"
#include "Drainage/FlatRouting.h"
#include "Numerics/Prefetch.h"

#include <atomic>
#include <cstddef>

namespace littoral
{

namespace
{

/// Receivers of steepest descent, and whether all cells but outlets have one.
bool FindReceivers(const std::vector<double>& heights, const OutletMask& outlets, const CellLattice& lattice,
  const ParallelFor& parallel, std::vector<CellIndex>& receivers)
{
  std::atomic<bool> isDrained{ true };
  parallel(lattice.GetHeight(), [&](std::size_t begin, std::size_t end) {
    const auto width = static_cast<std::size_t>(lattice.GetWidth());
    for (std::size_t n = begin * width; n < end * width; ++n)
    {
      const auto cell = static_cast<CellIndex>(n);
      const int direction = outlets[cell] ? -1 : SteepestDirection(heights, lattice, cell);
      receivers[cell] = direction >= 0 ? cell + lattice.Offset(direction) : outlets[cell] ? cell : -1;
      if (receivers[cell] < 0)
      {
        isDrained = false;
      }
    }
  });
  return isDrained;
}

/// Receivers of the cells of flats, which have none, by the shortest way out.
void DrainFlats(const std::vector<double>& levels, const CellLattice& lattice, const ParallelFor& parallel,
  const Poll& poll, std::vector<CellIndex>& receivers)
{
  std::vector<FlowCode> codes(receivers.size());
  parallel(receivers.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const auto cell = static_cast<CellIndex>(n);
      codes[n] = receivers[n] >= 0 ? FlowEnds : FirstExit(lattice, cell, [&](CellIndex other) {
        return receivers[other] >= 0 && levels[other] == levels[cell];
      });
    }
  });
  RouteFlats(lattice, codes, poll);
  for (std::size_t n = 0; n < receivers.size(); ++n)
  {
    receivers[n] = receivers[n] >= 0 ? receivers[n] : static_cast<CellIndex>(n) + lattice.Offset(DirectionOf(codes[n]));
  }
}

}

int SteepestDirection(const std::vector<double>& heights, const CellLattice& lattice, CellIndex cell)
{
  int steepestDirection = -1;
  double steepest = 0.0;
  lattice.ForEachNeighbour(cell, [&](CellIndex neighbour, int direction) {
    const double slope = (heights[cell] - heights[neighbour]) / lattice.Distance(direction);
    if (slope > steepest)
    {
      steepest = slope;
      steepestDirection = direction;
    }
  });
  return steepestDirection;
}

FlowRouting RouteFlow(
  const GridSamples& heights, const OutletMask& outlets, const ParallelFor& parallel, const Poll& poll, FlatWays flats)
{
  const CellLattice lattice(heights);
  FlowRouting routing;
  routing.Receiver.resize(lattice.Count());
  const bool isDrained = FindReceivers(heights.Values, outlets, lattice, parallel, routing.Receiver) ||
    (flats == FlatWays::Flood && RouteFlatsAsFlood(heights.Values, outlets, lattice, routing.Receiver, poll));
  if (!isDrained)
  {
    const DepressionFlood flood = FloodDepressions(heights, outlets, poll);
    routing.DepressionCells = flood.DepressionCells;
    routing.Volume = flood.Volume;
    const bool hasFlats = !FindReceivers(flood.SpillElevation, outlets, lattice, parallel, routing.Receiver);
    for (CellIndex cell = 0; hasFlats && flats == FlatWays::Flood && cell < lattice.Count(); ++cell)
    {
      if (routing.Receiver[cell] < 0)
      {
        routing.Receiver[cell] = flood.Backlink[cell];
      }
    }
    if (hasFlats && flats == FlatWays::Shortest)
    {
      DrainFlats(flood.SpillElevation, lattice, parallel, poll, routing.Receiver);
    }
  }
  poll();
  routing.Order = StackOrder(routing.Receiver, poll);
  return routing;
}

std::vector<CellIndex> StackOrder(const std::vector<CellIndex>& receivers, const Poll& poll)
{
  SteppedPoll steps(poll, 1 << 16);
  // Donors of cell r lie from first[r] to first[r + 1], by their index.
  const auto count = static_cast<CellIndex>(receivers.size());
  std::vector<CellIndex> first(static_cast<std::size_t>(count) + 1, 0);
  for (CellIndex cell = 0; cell < count; ++cell)
  {
    steps.Step();
    if (receivers[cell] != cell)
    {
      ++first[static_cast<std::size_t>(receivers[cell]) + 1];
    }
  }
  for (CellIndex cell = 0; cell < count; ++cell)
  {
    first[static_cast<std::size_t>(cell) + 1] += first[cell];
  }
  std::vector<CellIndex> donors(first[count]);
  std::vector<CellIndex> next(first.begin(), first.end() - 1);
  for (CellIndex cell = 0; cell < count; ++cell)
  {
    steps.Step();
    if (receivers[cell] != cell)
    {
      donors[next[receivers[cell]]++] = cell;
    }
  }
  // Depth first from each outlet.
  std::vector<CellIndex> order;
  order.reserve(count);
  std::vector<CellIndex> open;
  for (CellIndex outlet = 0; outlet < count; ++outlet)
  {
    if (receivers[outlet] != outlet)
    {
      continue;
    }
    open.assign(1, outlet);
    while (!open.empty())
    {
      steps.Step();
      const CellIndex cell = open.back();
      open.pop_back();
      order.push_back(cell);
      for (CellIndex donor = first[static_cast<std::size_t>(cell) + 1]; donor > first[cell]; --donor)
      {
        open.push_back(donors[static_cast<std::size_t>(donor) - 1]);
        Prefetch(&first[open.back()]);
      }
    }
  }
  return order;
}

std::vector<CellIndex> FlowAccumulation(const FlowRouting& routing, const Poll& poll)
{
  SteppedPoll stepped(poll);
  std::vector<CellIndex> cells(routing.Receiver.size(), 1);
  for (std::size_t n = routing.Order.size(); n-- > 0;)
  {
    stepped.Step();
    // A_r += A, from the divides downstream
    const CellIndex cell = routing.Order[n];
    if (routing.Receiver[cell] != cell)
    {
      cells[routing.Receiver[cell]] += cells[cell];
    }
  }
  return cells;
}

std::vector<double> DrainageArea(const FlowRouting& routing, const CellLattice& lattice)
{
  const std::vector<CellIndex> cells = FlowAccumulation(routing);
  std::vector<double> area(cells.size());
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
  {
    area[cell] = cells[cell] * lattice.CellArea();
  }
  return area;
}

std::vector<double> SlopesToReceivers(
  const GridSamples& heights, const FlowRouting& routing, const ParallelFor& parallel)
{
  const CellLattice lattice(heights);
  std::vector<double> slopes(routing.Receiver.size(), 0.0);
  parallel(slopes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const auto cell = static_cast<CellIndex>(n);
      const int direction = lattice.DirectionTo(cell, routing.Receiver[cell]);
      if (direction >= 0)
      {
        const double fall = heights.Values[cell] - heights.Values[routing.Receiver[cell]];
        slopes[cell] = fall / lattice.Distance(direction);
      }
    }
  });
  return slopes;
}

}
