// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralHeightQuantiles_h
#define LittoralHeightQuantiles_h

#include "Numerics/Parallel.h"

#include <array>
#include <cstddef>
#include <vector>

namespace littoral
{

/// Distribution of elevations by quantiles, linear between the given ones: the hypsometric curve.
struct HeightQuantiles
{
  std::vector<double> Probabilities; ///< increasing, between 0 and 1
  std::vector<double> Heights;       ///< increasing [m]

  double At(double probability) const;
  /// Index of the first quantile above a probability, and the height at a probability whose index is known.
  std::size_t After(double probability) const;
  double Below(std::size_t next, double probability) const;
};

/// Quantiles of a sample of elevations. Equal ones, as of whole metres, stand at the middle of their ranks, so that the
/// distribution has no steps.
HeightQuantiles QuantilesOf(const std::vector<double>& heights);

/**
 * Truncated lognormal distribution of a mean and a standard deviation [m], a skewness, and a hypsometric integral (mean
 * - lowest) / (highest - lowest): normal for the skewness 0, mirrored below, truncated at both ends at the same
 * probability. The integral must be within HypsometricIntegralRange().
 */
HeightQuantiles LognormalQuantiles(double mean, double deviation, double integral, double skew);

/// Minimum and maximum hypsometric integral of such distributions of a skewness, -2 to 2.
std::array<double, 2> HypsometricIntegralRange(double skew);

/// Quantile mapping: replaces each height by the distribution's quantile at its rank, z' = Q((r - 1/2) / n); equal
/// heights are ranked by their index. No two become equal.
void MapQuantiles(
  std::vector<double>& heights, const HeightQuantiles& quantiles, const ParallelFor& parallel = SerialFor);

}

#endif
