// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVariogram_h
#define LittoralVariogram_h

#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <array>
#include <cstddef>
#include <vector>

namespace littoral
{

/**
 * The empirical semivariance of a grid at every separation (i, j) cells with 0 <= j <= LagHeight and
 * -LagWidth <= i <= LagWidth: half the mean squared difference of all pairs so separated, and their number.
 */
struct VariogramMap
{
  int LagWidth = 0;
  int LagHeight = 0;
  std::array<double, 2> Spacing{ 1.0, 1.0 }; ///< [m]
  std::vector<double> Semivariance;          ///< of no meaning where Pairs is 0
  std::vector<double> Pairs;

  std::size_t Index(int i, int j) const
  {
    return static_cast<std::size_t>(j) * (2 * this->LagWidth + 1) + (i + this->LagWidth);
  }
};

/// The variogram map up to a separation [m], by Fourier transform: exact pair counts, missing values left out.
VariogramMap ComputeVariogramMap(
  const GridSamples& samples, double maximumLag, const ParallelFor& parallel = SerialFor);

/// Pairs of similar separation, averaged.
struct LagBin
{
  double Lag = 0.0;                             ///< [m], mean length of the separations
  std::array<double, 2> Separation{ 0.0, 0.0 }; ///< [m], vector of that length along the mean direction
  double Semivariance = 0.0;
  double Pairs = 0.0;
  int Ring = 0;      ///< index of the distance class
  int Direction = 0; ///< index of the sector, direction 0 centered on x, counter-clockwise
};

/**
 * Averages the map over rings up to maximumLag [m], narrow near zero, where the variogram bends, and wide far out: ring
 * k ends at maximumLag ((k+1) / rings)^2; and over sectors of pi / directions (1: all directions together). Empty bins
 * are left out; order: sector by sector, lags increasing.
 */
std::vector<LagBin> BinVariogram(
  const VariogramMap& map, double maximumLag, int rings, int directions, const ParallelFor& parallel = SerialFor);

}

#endif
