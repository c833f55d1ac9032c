// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStreamNetwork_h
#define LittoralStreamNetwork_h

#include "Drainage/CellLattice.h"
#include "Drainage/FlowRouting.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/// Strahler stream: from its head to its confluence with a stream of higher order, or to an outlet.
struct River
{
  std::vector<CellIndex> Cells; ///< downstream, two or more; the last is that of the confluence or the outlet
  int Order = 1;                ///< Strahler order
  double Area = 0.0;            ///< drainage area of the last cell before the confluence [m^2]
  double Length = 0.0;          ///< length along the cells [m]
  double Slope = 0.0;           ///< mean slope from head to end [m/m]
};

/// Stream network of a routed grid.
struct StreamNetwork
{
  std::vector<int> Orders;   ///< Strahler order of each cell; 0 where there is no stream
  std::vector<River> Rivers; ///< rivers in the order of the indices of their heads
};

/**
 * Strahler orders (1957) of the cells with a flow accumulation of at least `threshold` cells: 1 at heads; where streams
 * of one order meet, one more; else the highest order that comes in. Accumulation must grow downstream.
 */
std::vector<int> StrahlerOrders(const FlowRouting& routing, const std::vector<CellIndex>& accumulation,
  CellIndex threshold, const Poll& poll = NoPoll);

/// Stream network with the Strahler orders. Streams of a single cell, as outlets where two meet, are left out of
/// Rivers.
StreamNetwork FindStreams(const GridSamples& heights, const FlowRouting& routing,
  const std::vector<CellIndex>& accumulation, CellIndex threshold, const Poll& poll = NoPoll);

/// Length of the longest flow path to each cell from upstream [m], L_r = max(L_r, L + d); 0 where no cell drains to it.
std::vector<double> LongestFlowLengths(const FlowRouting& routing, const CellLattice& lattice);

/// Streams of one order, for Horton's laws.
struct StreamOrderClass
{
  int Order = 1;
  int Streams = 0;
  double MeanLength = 0.0; ///< [m]
  double MeanArea = 0.0;   ///< [m^2]
};

/// Classes of the orders from 1 to the highest.
std::vector<StreamOrderClass> ClassesByOrder(const std::vector<River>& rivers);

/**
 * Horton's ratios (1945) by least squares of ln N = a - w ln R_B, ln L = b + w ln R_L and ln A = c + w ln R_A over the
 * orders w, each with the weight of its streams; NaN where there are fewer than two orders.
 */
struct HortonRatios
{
  double Bifurcation; ///< R_B, bifurcation ratio of the numbers of streams
  double Length;      ///< R_L, ratio of mean lengths
  double Area;        ///< R_A, ratio of mean drainage areas
};
HortonRatios RatiosOf(const std::vector<StreamOrderClass>& classes);

}

#endif
