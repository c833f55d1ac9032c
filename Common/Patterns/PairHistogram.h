// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPairHistogram_h
#define LittoralPairHistogram_h

#include "Numerics/Parallel.h"
#include "Patterns/ObservationWindow.h"
#include "Patterns/PairFunctions.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace littoral
{

class CommonAreaTable;

/**
 * K and g with translation correction for many patterns of one window, as an envelope has them: the weights of the
 * pairs are summed in bins, 32 a step, and the kernel of g is laid over the bins, where FindPairFunctions() lays it
 * over each pair. K is the same; a distance of g is a 64th of a step off at most.
 */
class PairHistogram
{
public:
  /// Half width of the Epanechnikov kernel of g [m].
  PairHistogram(const ObservationWindow& window, const DistanceRange& distances, double halfWidth,
    const ParallelFor& parallel = SerialFor);

  /// K at all distances [m2]; 0 of a pattern without a pair.
  std::vector<double> RipleyK(const std::vector<PlanePosition>& points) const;

  /// g at all distances, of which that at 0 is NaN; 0 of a pattern without a pair.
  std::vector<double> PairCorrelation(const std::vector<PlanePosition>& points) const;

private:
  std::vector<double> Sum(const std::vector<PlanePosition>& points, double reach) const;
  void AddRange(const double* xs, const double* ys, std::size_t count, double x, double y, double reach,
    std::vector<double>& bins) const;

  DistanceRange Distances;
  double HalfWidth;
  double PerBin; ///< bins on 1 m
  double Area;   ///< [m2]
  PlanePosition Sides;
  std::shared_ptr<const CommonAreaTable> Areas; ///< of a polygon
};

}

#endif
