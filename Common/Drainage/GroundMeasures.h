// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGroundMeasures_h
#define LittoralGroundMeasures_h

#include "Drainage/DrainageOutlets.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <limits>
#include <vector>

namespace littoral
{

/// Mean slope of cells of like drainage area.
struct SlopeAreaBin
{
  double Cells = 0.0; ///< mean drainage area [cells]
  double Slope = 0.0; ///< mean slope to the receiver [m/m]
  double Count = 0.0;
};

/// What tells ground that water has shaped from a random surface.
struct GroundMeasures
{
  double DepressionFraction = 0.0;           ///< of the cells: those that a flood from the outlets covers
  double RelativeFillDepth = 0.0;   ///< mean depth of the flood over the standard deviation of heights
  double Lowest = 0.0;              ///< [m]
  double Highest = 0.0;             ///< [m]
  double StandardDeviation = 0.0;           ///< standard deviation of heights [m]
  double HypsometricIntegral = 0.0; ///< (mean - lowest) / (highest - lowest)
  double ElevationSkewness = 0.0;
  double Concavity = 0.0;     ///< minus the slope of log slope over log area; NaN where fewer than 3 bins have cells
  double MaximumArea = 0.0;   ///< upper end of the drainage areas of the concavity [m^2]
  double CurvatureSkewness = 0.0; ///< of the five-point Laplacian of inner cells
  double ChannelSlope = 0.0;  ///< mean slope above 0 at drainage areas of 100 to 200 cells [m/m]
  std::vector<SlopeAreaBin> SlopeArea;
  std::vector<double> Lags;         ///< those of SemivarianceLags(), times the mean spacing [m]
  std::vector<double> Semivariance; ///< [m^2] at these lags

  /// Between the lags, by a power law; NaN beyond the last.
  double SemivarianceAt(double lag) const;
};

/**
 * Slope over area: 20 bins of the logarithm of drainage area, from 100 cells to a tenth of the grid, and no further
 * than to an area [m^2]; none where that is less than a decade. Slopes are those along the receivers, 0 on flats and in
 * depressions; outlets, which have none, are left out.
 */
GroundMeasures MeasureGround(const GridSamples& heights, const OutletMask& outlets,
  const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll,
  double maximumArea = std::numeric_limits<double>::infinity());

/// The lags of the semivariances [cells]: 1 to 100, or to half the shorter side, in steps that grow.
std::vector<int> SemivarianceLags(int width, int height);

/// Half the mean squared difference of all pairs so many cells apart along x or along y [m^2].
std::vector<double> SemivarianceAlongAxes(
  const GridSamples& heights, const std::vector<int>& lags, const ParallelFor& parallel = SerialFor);

}

#endif
