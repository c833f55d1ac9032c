// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralHeightMatching_h
#define LittoralHeightMatching_h

#include "Drainage/HeightQuantiles.h"
#include "Numerics/Parallel.h"

#include <vector>

namespace littoral
{

/**
 * Maps heights smoothly to a distribution: a monotone cubic (Fritsch & Carlson 1980) takes 21 of their ranks to
 * the distribution's. A map by all ranks would print the distribution's own steps on the ground as terraces.
 * It grows everywhere, so that no path of the water changes.
 */
void MatchHeights(std::vector<double>& heights, const HeightQuantiles& quantiles,
  const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

}

#endif
