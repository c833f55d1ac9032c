// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralShallowDepressions_h
#define LittoralShallowDepressions_h

#include "Drainage/DrainageOutlets.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/// Depths of water [m] in the shallowest depressions of a ground, which have a share of its cells together at most; 0
/// elsewhere. They are filled to their spill elevation, or empty. Of two that are as deep the one with the first cell
/// counts as shallower.
std::vector<double> ShallowDepressions(
  const GridSamples& ground, const OutletMask& outlets, double share, const Poll& poll = NoPoll);

}

#endif
