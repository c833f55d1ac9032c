// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlaceMatching_h
#define LittoralPlaceMatching_h

#include "Drainage/DrainageCarving.h"
#include "Drainage/GroundStatistics.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/// Brings heights of a landscape to the distribution and the semivariances of a place.
class PlaceMatching
{
public:
  PlaceMatching(const GridSamples& place, const CarvingTarget& target);

  /// Maps heights from a straight line through mean and deviation as far to the place's ranks as its hypsometry needs,
  /// at most by a part, 0 to 1, then scales them about the mean. The full map would stretch lowlands, whose slopes are
  /// the rock's.
  void Match(
    GridSamples& ground, double most = 1.0, const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll) const;

  /// Largest of |g / g_place - 1| of the semivariances g.
  double SemivarianceError(const GridSamples& ground, const ParallelFor& parallel = SerialFor) const;

private:
  std::vector<double> SemivarianceRatios(const GridSamples& ground, const ParallelFor& parallel) const;
  bool HasHypsometry(const SampleShape& is) const;

  HeightQuantiles Quantiles;
  GroundMeasures Measures;
  SampleShape Heights;
};

}

#endif
