// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralShallowDepressions_h
#define LittoralShallowDepressions_h

#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/// Depths of water [m] in the shallowest depressions of a ground with the spill elevations `levels`, which have a share
/// of its cells together at most; 0 elsewhere. They are filled to their spill elevation, or empty. Of two that are as
/// deep the one with the first cell counts as shallower.
std::vector<double> ShallowDepressions(
  const GridSamples& ground, const std::vector<double>& levels, double share, const Poll& poll = NoPoll);

}

#endif
