// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralHeightQuantiles_h
#define LittoralHeightQuantiles_h

#include "Numerics/Parallel.h"

#include <vector>

namespace littoral
{

/// A distribution of heights: its quantiles, linear between the given ones.
struct HeightQuantiles
{
  std::vector<double> Probabilities; ///< increasing, between 0 and 1
  std::vector<double> Heights;       ///< increasing [m]

  double At(double probability) const;
};

/// Of given heights. Equal ones, as of whole metres, are taken as a height at the middle of their ranks: so the
/// distribution has no steps.
HeightQuantiles QuantilesOf(const std::vector<double>& heights);

/// A beta distribution between two limits, of a mean, a standard deviation [m], a hypsometric integral (mean - lowest)
/// / (highest - lowest) and a skew. Both must have the same sign of asymmetry: see WhyNoBeta().
HeightQuantiles BetaQuantiles(double mean, double deviation, double integral, double skew);

/// Whether a beta distribution has such an integral and skew.
bool IsBeta(double integral, double skew);

/// Replaces each height by the distribution's at the same rank; equal heights by their index. No two become equal.
void MapRanks(std::vector<double>& heights, const HeightQuantiles& quantiles, const ParallelFor& parallel = SerialFor);

}

#endif
