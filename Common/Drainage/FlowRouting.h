// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFlowRouting_h
#define LittoralFlowRouting_h

#include "Drainage/CellLattice.h"
#include "Drainage/DrainageOutlets.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// Flow routing over a grid: a single receiver for each cell.
struct FlowRouting
{
  std::vector<CellIndex> Receiver; ///< neighbour to which a cell drains; outlets: themselves
  std::vector<CellIndex> Order;    ///< the stack: all cells, each after its receiver, catchment by catchment
  std::size_t DepressionCells = 0; ///< cells in depressions
  double Volume = 0.0;             ///< volume of the depressions [m^3]
};

/// Ways over flats.
enum class FlatWays
{
  Flood,    ///< the backlink of the priority-flood: the shortest way from the rim cell that came first
  Shortest, ///< RouteFlats(): the shortest way from the whole rim, whatever the order of cells, as by tiles
};

/**
 * Single flow direction (D8, O'Callaghan & Mark 1984): each cell's receiver is its neighbour of steepest descent, max
 * (z - z_r) / d, the first by direction of equal ones. Where depressions or flats leave none, it is that of the filled
 * heights, and on flats one of FlatWays. The order is the stack of Braun & Willett (2013), in O(n).
 */
FlowRouting RouteFlow(const GridSamples& heights, const OutletMask& outlets, const ParallelFor& parallel = SerialFor,
  const Poll& poll = NoPoll, FlatWays flats = FlatWays::Flood);

/// Direction of the neighbour of steepest descent, max (z - z_r) / d, the first of equal ones; -1 where none is lower.
int SteepestDirection(const std::vector<double>& heights, const CellLattice& lattice, CellIndex cell);

/// Stack of given receivers, outlets by their index.
std::vector<CellIndex> StackOrder(const std::vector<CellIndex>& receivers, const Poll& poll = NoPoll);

/// Flow accumulation: the number of cells that drain through each cell, itself included.
std::vector<CellIndex> FlowAccumulation(const FlowRouting& routing, const Poll& poll = NoPoll);

/// Drainage area of each cell [m^2], itself included: FlowAccumulation() times the area of a cell.
std::vector<double> DrainageArea(const FlowRouting& routing, const CellLattice& lattice);

/// Slope from each cell to its receiver [m/m]; 0 at outlets, negative out of depressions.
std::vector<double> SlopesToReceivers(
  const GridSamples& heights, const FlowRouting& routing, const ParallelFor& parallel = SerialFor);

}

#endif
