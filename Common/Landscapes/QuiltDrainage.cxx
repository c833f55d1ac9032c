// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/QuiltDrainage.h"

#include "Drainage/DepressionBreaching.h"
#include "Drainage/ValleySpreading.h"
#include "Numerics/RandomStream.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

/// Deviations over which cuts fade, from the widest valley by halves to the bed [cells], and the part of what is to be
/// cut that each but the last takes.
constexpr double ValleyWidth = 8.0;
constexpr double BedWidth = 1.0;
constexpr double ValleyPart = 0.5;

/// Height by which a pass costs e times as much, over the deviation of heights.
constexpr double PassHeight = 0.25;

/// Ground by which water finds its way: of heights z, exp((z + r) / h) with random roughness r. So the way of least cut
/// from a depression leads through low passes and along valleys, else it is straight through whatever is in between;
/// and rivers wander on smooth ground, else they run along the grid.
GridSamples GroundOfWays(
  const GridSamples& heights, const std::vector<float>& roughness, const ParallelFor& parallel, const Poll& poll)
{
  const SampleMoments moments = Moments(heights, poll);
  GridSamples ground = CopyOf(heights, poll);
  const double growth = PassHeight * std::sqrt(moments.Variance);
  parallel(ground.Values.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      ground.Values[n] = std::exp((ground.Values[n] + roughness[n] - moments.Mean) / growth);
    }
  });
  return ground;
}

}

std::vector<float> WayRoughness(std::size_t count, double greatest, int seed, int draw, const ParallelFor& parallel)
{
  const RandomStream random(seed, RandomPurpose::LandscapeChannels);
  std::vector<float> heights(count);
  parallel(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      heights[n] = static_cast<float>(greatest * random.UniformPair(n, draw)[0]);
    }
  });
  return heights;
}

FlowRouting DrainQuilt(GridSamples& ground, const std::vector<float>& roughness, double leastSlope, double cut,
  const ChannelLaw& limit, const ParallelFor& parallel, const Poll& poll)
{
  const OutletMask outlets = BorderOutlets(ground.Width, ground.Height);
  GridSamples breached = GroundOfWays(ground, roughness, parallel, poll);
  BreachDepressions(breached, outlets, BreachPath::LeastCost, poll);
  FlowRouting routing = RouteFlow(breached, outlets, parallel, poll);
  breached.Values = std::vector<double>();
  const std::vector<CellIndex> areas = FlowAccumulation(routing, poll);
  const std::vector<double> falls = FallsAlong(ground, routing, areas, EvenLaw(leastSlope), parallel);
  const auto grade = [&] { return GradeBy(falls, ground, routing, cut, parallel, poll); };
  for (double width = ValleyWidth; width >= BedWidth; width *= 0.5)
  {
    const GridSamples bed{ ground.Width, ground.Height, ground.Spacing, grade() };
    std::vector<double> cuts = LimitAlong(bed, routing, areas, limit, leastSlope, poll);
    std::vector<double> weights(cuts.size());
    parallel(cuts.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        cuts[n] = std::min(0.0, cuts[n] - ground.Values[n]);
        weights[n] = cuts[n] < 0.0 ? 1.0 : 0.0;
      }
    });
    SpreadChanges(cuts, weights, ground.Width, ground.Height, width, parallel);
    const double part = width > BedWidth ? ValleyPart : 1.0;
    parallel(cuts.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        ground.Values[n] += part * cuts[n];
      }
    });
  }
  ground.Values = grade();
  return routing;
}

}
