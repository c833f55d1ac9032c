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

/// A distribution of heights: its quantiles, linear between the given ones.
struct HeightQuantiles
{
  std::vector<double> Probabilities; ///< increasing, between 0 and 1
  std::vector<double> Heights;       ///< increasing [m]

  double At(double probability) const;
  /// Number of the first quantile above a probability, and the height at a probability of which it is known.
  std::size_t After(double probability) const;
  double Below(std::size_t next, double probability) const;
};

/// Of given heights. Equal ones, as of whole metres, are taken as a height at the middle of their ranks: so the
/// distribution has no steps.
HeightQuantiles QuantilesOf(const std::vector<double>& heights);

/**
 * A distribution of a mean and a standard deviation [m], a skew, and a hypsometric integral (mean - lowest) / (highest
 * - lowest): lognormal (Gauss's for skew 0, mirrored below), without its ends beyond one and the same probability. The
 * integral must be within HypsometricIntegralRange().
 */
HeightQuantiles LognormalQuantiles(double mean, double deviation, double integral, double skew);

/// The least and the greatest hypsometric integral of such distributions of a skew, which is at most 2 in size.
std::array<double, 2> HypsometricIntegralRange(double skew);

/// Replaces each height by the distribution's at the same rank; equal heights by their index. No two become equal.
void MapQuantiles(std::vector<double>& heights, const HeightQuantiles& quantiles, const ParallelFor& parallel = SerialFor);

}

#endif
