// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLandscapeMeasures_h
#define LittoralLandscapeMeasures_h

#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/// Statistics of slopes and valleys that tell a place from a surface of the same variogram. Water leaves at the border.
struct LandscapeMeasures
{
  double MeanSlope = 0.0;          ///< by central differences [m/m]
  std::vector<double> Slopes;      ///< even quantiles of the slopes, from the least to the greatest [m/m]
  double GentleFraction = 0.0;     ///< cells with slopes under a quarter of the mean
  double BlockVariation = 0.0;     ///< deviation over mean of the mean slopes of blocks, a tenth of the shorter side
  double CurvatureDeviation = 0.0; ///< standard deviation of the Laplacian after a Gauss filter of two cells [1/m]
  double Concavity = 0.0;          ///< theta of S = k_s A^-theta on filled ground; NaN where there are too few cells
  double ChannelSlope = 0.0;       ///< that law's slope at ReferenceCells; 0 without a concavity [m/m]

  static constexpr double ReferenceCells = 500.0;
};

/// Statistics of a grid without missing values, of three rows and columns or more.
LandscapeMeasures MeasureLandscape(
  const GridSamples& heights, const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

/// Kolmogorov's distance of two samples by as many even quantiles of each: the largest difference of their shares.
double KolmogorovDistance(const std::vector<double>& one, const std::vector<double>& other);

/// Share of n-fold symmetry in the directions of slope, |sum s exp(i n a)| / sum s, with the slopes s and the aspects a
/// of the inner cells: 0 on ground that prefers no direction, much of it in eight of ground shaped along a grid.
double AspectShare(const GridSamples& heights, int folds);

}

#endif
