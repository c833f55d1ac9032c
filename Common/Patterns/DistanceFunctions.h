// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDistanceFunctions_h
#define LittoralDistanceFunctions_h

#include "Numerics/Parallel.h"
#include "Patterns/ObservationWindow.h"
#include "Patterns/PairFunctions.h"

#include <vector>

namespace littoral
{

// Distributions of distances to the nearest point of a pattern: from its points (G), and from anywhere in the window
// (F, the empty space). Baddeley, Rubak and Turner (2015), chapter 8. The same bytes for any parallel loop.

/// What is done about nearest points that may lie beyond the edge, at the distance b.
enum class DistanceCorrection
{
  None = 0,        ///< nothing
  Border = 1,      ///< only places with b >= r count for r
  KaplanMeier = 2, ///< distances above b are censored at b (Baddeley and Gill 1997)
};

/// Values at all distances; each is 1 - exp(-intensity pi r^2) for a random pattern, J is 1.
struct DistanceFunctions
{
  std::vector<double> G; ///< the part of the points whose nearest other point is at most at r
  std::vector<double> F; ///< the part of the window that is at most at r from a point
  std::vector<double> J; ///< (1 - G) / (1 - F); below 1 for clusters, above for regular patterns; NaN where F is 1
};

/// Distances up to half the diagonal of the bounding box, and up to that at which a random pattern has F = 1 - 1e-5.
DistanceRange DefaultNearestDistances(const ObservationWindow& window, std::size_t points, int steps = 512);

/**
 * Functions of one pattern, whose points must lie in the window. F is measured from the middles of places * places
 * cells of the bounding box.
 */
DistanceFunctions FindDistanceFunctions(const std::vector<PlanePosition>& points, const ObservationWindow& window,
  const DistanceRange& distances, DistanceCorrection correction, int places = 128,
  const ParallelFor& parallel = SerialFor);

}

#endif
