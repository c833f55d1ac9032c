// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGroundStatistics_h
#define LittoralGroundStatistics_h

#include "Drainage/CellLattice.h"
#include "Drainage/DrainageOutlets.h"
#include "Drainage/GroundMeasures.h"
#include "Drainage/StreamNetwork.h"
#include "Drainage/StreamRelief.h"
#include "Numerics/Parallel.h"
#include "Terrain/Geomorphons.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/// Extremes and moments of a sample; skewness g = m_3 / m_2^(3/2).
struct SampleShape
{
  double Minimum = 0.0;
  double Maximum = 0.0;
  double Mean = 0.0;
  double StandardDeviation = 0.0;
  double Skew = 0.0; ///< NaN where all values are equal
};
SampleShape ShapeOf(const std::vector<double>& values, const Poll& poll = NoPoll);

/// Slope of the inner cells, the size of the gradient by central differences [m/m], row by row.
std::vector<double> GradientsOf(const GridSamples& heights, const Poll& poll = NoPoll);

/// Curvature of the inner cells, the five-point Laplacian [1/m], row by row: above 0 in valleys.
std::vector<double> LaplaciansOf(const GridSamples& heights, const Poll& poll = NoPoll);

/// Quantiles at 0, 1/n, 2/n ... 1 with n = count - 1, linear between the values in their order; count at least 2.
std::vector<double> EvenQuantiles(std::vector<double> values, int count, const Poll& poll = NoPoll);

/// Hack's exponent h (1957), longest flow length L ~ A^h, by least squares of logarithms over the cells that drain
/// `threshold` cells or more; NaN where there are none.
double HackExponent(
  const std::vector<double>& lengths, const std::vector<CellIndex>& accumulation, CellIndex threshold = 100);

/// Geomorphometric and hydrological statistics of a terrain.
struct GroundStatistics
{
  GroundMeasures Measures;
  SampleShape Slopes;     ///< [m/m]
  SampleShape Curvature;  ///< [1/m]
  double Steepness = 0.0; ///< k_s of S = k_s A^-theta, A in m^2; NaN where there is no concavity theta
  double Hack = 0.0;      ///< exponent h of Hack's law
  HortonRatios Horton{};
  std::vector<StreamOrderClass> Streams;
  double ThresholdSlope = 0.0; ///< slope that a hundredth of the cells exceeds [m/m]
  ChannelDensity Channels;
  std::vector<StreamDistanceBin> Relief;       ///< heights above streams, 1 to 10 cells off them
  std::array<double, GeomorphonForms> Forms{}; ///< shares of geomorphons
};

/**
 * Statistics of a grid without missing values that is not constant, of three rows and columns or more. Streams, and the
 * cells of Hack's law, begin where `threshold` cells drain; geomorphons are those of `search`. The order of sums does
 * not depend on the threads.
 */
GroundStatistics DescribeGround(const GridSamples& heights, const OutletMask& outlets, CellIndex threshold = 100,
  const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll, const GeomorphonSearch& search = {});

}

#endif
