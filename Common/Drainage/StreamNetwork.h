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

/// A stream from its head to where a stream of higher order takes it in, or to an outlet.
struct River
{
  std::vector<CellIndex> Cells; ///< downstream, two or more; the last belongs to the stream that takes it in, if any
  int Order = 1;                ///< Strahler's
  double Area = 0.0;            ///< [m^2] drained by the last cell of its own
  double Length = 0.0;          ///< [m] along the cells
  double Slope = 0.0;           ///< [m/m] from head to end
};

/// The streams of a routed grid.
struct StreamNetwork
{
  std::vector<int> Orders;   ///< Strahler's order of each cell; 0 where there is no stream
  std::vector<River> Rivers; ///< by the index of their heads
};

/**
 * Strahler's orders (1957) of the cells that drain at least `threshold` cells, themselves included: 1 at heads; where
 * streams of one order meet, one more; else the highest order that comes in. The number of cells must grow downstream.
 */
std::vector<int> StrahlerOrders(
  const FlowRouting& routing, const std::vector<CellIndex>& accumulation, CellIndex threshold);

/// Orders and streams. Streams of a single cell, as outlets where two meet, are left out of Rivers.
StreamNetwork FindStreams(const GridSamples& heights, const FlowRouting& routing,
  const std::vector<CellIndex>& accumulation, CellIndex threshold);

/// Length of the longest way of water to each cell from above [m]; 0 where none comes in.
std::vector<double> LongestFlowLengths(const FlowRouting& routing, const CellLattice& lattice);

/// Streams of one order, for Horton's laws.
struct StreamOrderClass
{
  int Order = 1;
  int Streams = 0;
  double MeanLength = 0.0; ///< [m]
  double MeanArea = 0.0;   ///< [m^2]
};

/// A class for each order from 1 to the highest.
std::vector<StreamOrderClass> ClassesByOrder(const std::vector<River>& rivers);

/**
 * Horton's ratios (1945) from lines of least squares through the logarithms of number, mean length and mean area over
 * the order; NaN where there are fewer than two orders.
 */
struct HortonRatios
{
  double Bifurcation; ///< R_B, falling numbers
  double Length;      ///< R_L, growing lengths
  double Area;        ///< R_A, growing areas
};
HortonRatios RatiosOf(const std::vector<StreamOrderClass>& classes);

}

#endif
