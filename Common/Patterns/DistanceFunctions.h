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

// Nearest-neighbour distance distribution G and empty-space function F of a pattern. Baddeley, Rubak and Turner (2015),
// chapter 8. The same bytes for any parallel loop.

/// Edge corrections of nearest-neighbour distances, at the distance b from the edge.
enum class DistanceCorrection
{
  None = 0,        ///< nothing
  Border = 1,      ///< reduced sample: only places with b >= r count for r
  KaplanMeier = 2, ///< distances above b are censored at b (Baddeley and Gill 1997)
};

/// Values at all distances; G = F = 1 - exp(-lambda pi r^2) and J = 1 for complete spatial randomness.
struct DistanceFunctions
{
  std::vector<double> G; ///< part of the points whose nearest neighbour is at most r away
  std::vector<double> F; ///< part of the window that is at most r from a point
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
