// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGroundStatistics_h
#define LittoralGroundStatistics_h

#include "Drainage/CellLattice.h"
#include "Drainage/DrainageOutlets.h"
#include "Drainage/StreamNetwork.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <limits>
#include <vector>

namespace littoral
{

/// Moments of a sample, its extremes, and its skew, the third central moment over the cube of the standard deviation.
struct SampleShape
{
  double Minimum = 0.0;
  double Maximum = 0.0;
  double Mean = 0.0;
  double StandardDeviation = 0.0;
  double Skew = 0.0; ///< NaN where all values are equal

  /// (mean - minimum)/(maximum - minimum); of heights, the hypsometric integral (Strahler 1952). NaN as Skew.
  double Integral() const { return (this->Mean - this->Minimum) / (this->Maximum - this->Minimum); }
};
SampleShape ShapeOf(const std::vector<double>& values);

/// Slope of the inner cells, the size of the gradient by central differences [m/m], row by row.
std::vector<double> GradientsOf(const GridSamples& heights);

/// Curvature of the inner cells, the five-point Laplacian [1/m], row by row: above 0 in valleys.
std::vector<double> LaplaciansOf(const GridSamples& heights);

/// Quantiles at 0, 1/n, 2/n ... 1 with n = count - 1, linear between the values in their order; count at least 2.
std::vector<double> QuantilesOf(std::vector<double> values, int count);

/// Cells of about one drainage area.
struct SlopeAreaBin
{
  double Area = 0.0;  ///< [m^2], geometric mean
  double Slope = 0.0; ///< [m/m], mean
  CellIndex Cells = 0;
};

/// Slope over drainage area: S = Steepness A^-Concavity, A in m^2.
struct SlopeArea
{
  std::vector<SlopeAreaBin> Bins;
  double Concavity = std::numeric_limits<double>::quiet_NaN();
  double Steepness = std::numeric_limits<double>::quiet_NaN();
};

/**
 * Mean slopes in `bins` bins of drainage area of equal ratio, from `leastCells` cells to a tenth of the grid, and the
 * line of least squares through their logarithms. Slopes that are NaN count nowhere; bins whose mean is not above 0 are
 * left out; fewer than two bins tell no concavity.
 */
SlopeArea SlopeAreaOf(const std::vector<double>& slopes, const std::vector<CellIndex>& drainageCells, double cellArea,
  CellIndex leastCells = 100, int bins = 20);

/// Hack's exponent h (1957), longest flow length L ~ A^h, by least squares of logarithms over the cells that drain
/// `leastCells` cells or more; NaN where there are none.
double HackExponent(
  const std::vector<double>& lengths, const std::vector<CellIndex>& drainageCells, CellIndex leastCells = 100);

/// What tells a landscape from a random surface.
struct GroundStatistics
{
  SampleShape Heights;    ///< [m]
  SampleShape Slopes;     ///< [m/m]
  SampleShape Curvature;  ///< [1/m]
  double SunkShare = 0.0; ///< of cells that are below the level of a flood from the outlets
  double FillRatio = 0.0; ///< mean depth of that flood over all cells, over the standard deviation of the heights
  SlopeArea Profile;
  double Hack = 0.0;
  HortonRatios Horton{};
  std::vector<StreamOrderClass> Streams;
};

/**
 * Statistics of a grid without missing values that is not constant, of three rows and columns or more. Streams begin
 * where `leastCells` cells drain. The order of sums does not depend on the threads.
 */
GroundStatistics MeasureGround(const GridSamples& heights, const OutletMask& outlets, CellIndex leastCells = 100,
  const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

}

#endif
