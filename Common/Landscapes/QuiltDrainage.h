// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralQuiltDrainage_h
#define LittoralQuiltDrainage_h

#include "Drainage/ChannelGrading.h"
#include "Drainage/FlowRouting.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// Roughness of ground by which water finds its way: uniform random heights up to a greatest one, by seed and draw.
std::vector<float> WayRoughness(
  std::size_t count, double greatest, int seed, int draw, const ParallelFor& parallel = SerialFor);

/**
 * Takes depressions away along the ways of least cut: a part is cut there, the rest is filled. Rivers that are steeper
 * than a limit are cut down to it. Cuts fade to the sides over valleys that are the deeper the narrower they are, so
 * that no dam is opened by a slot. Ways lead over low passes and, by the roughness, wander on smooth ground. The flow
 * paths are returned.
 */
FlowRouting DrainQuilt(GridSamples& ground, const std::vector<float>& roughness, double leastSlope, double cut,
  const ChannelLaw& limit, const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

}

#endif
