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

/// Bin of the slope-area relation.
struct SlopeAreaBin
{
  double Cells = 0.0; ///< mean drainage area [cells]
  double Slope = 0.0; ///< mean slope to the receiver [m/m]
  double Count = 0.0; ///< cells in the bin
};

/// Statistics that differ between fluvial terrain and a random surface. Missing heights (NaN) are left out.
struct GroundMeasures
{
  double DepressionFraction = 0.0;  ///< cells in depressions over all cells
  double RelativeFillDepth = 0.0;   ///< mean fill depth of all cells over the standard deviation of heights
  double Lowest = 0.0;              ///< [m]
  double Highest = 0.0;             ///< [m]
  double StandardDeviation = 0.0;   ///< standard deviation of heights [m]
  double HypsometricIntegral = 0.0; ///< (mean - lowest) / (highest - lowest)
  double ElevationSkewness = 0.0;
  double Concavity = 0.0;         ///< index theta of S = k_s A^-theta; NaN where fewer than 3 bins have cells
  double MaximumArea = 0.0;       ///< largest drainage area of the slope-area relation [m^2]
  double CurvatureSkewness = 0.0; ///< skewness of the five-point Laplacian of inner cells
  double ChannelSlope = 0.0;      ///< mean slope above 0 at drainage areas of 100 to 200 cells [m/m]
  std::vector<SlopeAreaBin> SlopeArea;
  std::vector<double> Lags;         ///< lags of SemivarianceLags(), times the mean spacing [m]
  std::vector<double> Semivariance; ///< semivariance at these lags [m^2]

  /// Semivariance at a lag [m], by a power law between the lags; NaN beyond the last.
  double SemivarianceAt(double lag) const;
};

/**
 * Statistics of a terrain with outlets. The slope-area relation has 20 bins of the logarithm of drainage area, from 100
 * cells to a tenth of the grid and at most `maximumArea` [m^2]; none where that is less than a decade. Slopes are those
 * to the receivers, S = max(0, z - z_r) / d, 0 on flats and in depressions; outlets, which have none, are left out.
 *
 *   hypsometric integral (mean - min) / (max - min),  skewness m_3 / m_2^(3/2),
 *   concavity by least squares of ln S = ln k_s - theta ln A over the bins, every bin alike.
 */
GroundMeasures MeasureGround(const GridSamples& heights, const OutletMask& outlets,
  const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll,
  double maximumArea = std::numeric_limits<double>::infinity());

/// The bins of the slope-area relation alone, of a terrain without missing heights.
std::vector<SlopeAreaBin> SlopeAreaOf(const GridSamples& heights, const OutletMask& outlets,
  const ParallelFor& parallel = SerialFor, double maximumArea = std::numeric_limits<double>::infinity(),
  const Poll& poll = NoPoll);

/// Lags of the semivariances [cells]: 1 to 100, or to half the shorter side, in steps that grow.
std::vector<int> SemivarianceLags(int width, int height);

/// Experimental semivariances [m^2] of all pairs so many cells apart along x or along y, half the mean squared
/// difference: gamma(h) = sum (z(x + h) - z(x))^2 / (2 N(h)).
std::vector<double> SemivarianceAlongAxes(
  const GridSamples& heights, const std::vector<int>& lags, const ParallelFor& parallel = SerialFor);

}

#endif
