// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRockHardness_h
#define LittoralRockHardness_h

#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/**
 * Mean slopes by height, of 64 classes of as many cells each, over the mean of all: the classes are of the heights
 * after a Gauss filter of a standard deviation [cells], and each mean is over the six classes below and above, too.
 * A rolling lowland beside a dissected plateau has its own here.
 */
std::vector<double> SlopesByHeight(const GridSamples& place, double smoothing, const ParallelFor& parallel = SerialFor);

/// The values of a profile of classes of height at the ranks of a terrain's smoothed heights.
std::vector<double> ProfileByHeight(const GridSamples& terrain, double smoothing, const std::vector<double>& profile,
  const ParallelFor& parallel = SerialFor);

}

#endif
