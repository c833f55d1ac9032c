// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../Drainage/RandomGround.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/DrainageOutlets.h"
#include "Drainage/FlowRouting.h"
#include "Landscapes/RiverSteepness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

using namespace littoral;
using namespace littoral::testing;

namespace
{

constexpr int Side = 230; ///< 52 900 cells

/// Rough ground that falls to its middle row and along it, without depressions.
GridSamples Valley(int seed)
{
  GridSamples rough = RandomGround(Side, Side, { 10.0, 10.0 }, seed);
  const GridSamples slopes = Ground(Side, Side, { 10.0, 10.0 },
    [](double x, double y) { return 0.02 * x + 0.15 * std::abs(y - 5.0 * Side) + 20.0 * std::sin(x / 90.0); });
  for (std::size_t n = 0; n < rough.Values.size(); ++n)
  {
    rough.Values[n] = 0.2 * rough.Values[n] + slopes.Values[n];
  }
  rough.Values = FloodDepressions(rough, BorderOutlets(Side, Side)).SpillElevation;
  return rough;
}

}

TEST(LimitAlong, RiverFallsAsItsLawWhereItIsOne)
{
  const GridSamples gutter = Ground(60, 1, { 5.0, 5.0 }, [](double x, double) { return 0.4 * x; });
  OutletMask lowest(60, 0);
  lowest[0] = 1;
  const FlowRouting routing = RouteFlow(gutter, lowest);
  ChannelLaw law;
  law.ReferenceCells = law.ChannelThreshold = 20.0;
  law.Steepness = 0.1;
  law.Concavity = 0.5;
  const std::vector<double> limited = LimitAlong(gutter, routing, FlowAccumulation(routing), law, 0.06);
  double height = 0.0;
  for (int i = 1; i < 60; ++i)
  {
    const double cells = 60.0 - i;
    height += 5.0 * std::max(0.06, 0.1 * std::sqrt(20.0 / cells));
    EXPECT_NEAR(limited[i], cells >= 20.0 ? height : 2.0 * i, 1e-9);
  }
}

TEST(RiverSteepness, RatioIsTheFactorOfHeights)
{
  const GridSamples place = Valley(1);
  const RiverSteepness rivers(place);
  ASSERT_TRUE(rivers.IsKnown());
  GridSamples steeper = place;
  for (double& height : steeper.Values)
  {
    height *= 1.3;
  }
  EXPECT_NEAR(rivers.RatioOf(place), 1.0, 1e-9);
  EXPECT_NEAR(rivers.RatioOf(steeper), 1.3, 1e-9);
  EXPECT_NEAR(RiverSteepness(steeper).Law(1.0).SlopeAt(700.0), rivers.Law(1.3).SlopeAt(700.0), 1e-9);
}

TEST(RiverSteepness, FewValleysTellNoLaw)
{
  GridSamples part = Valley(1);
  part.Height = 200;
  part.Values.resize(static_cast<std::size_t>(Side) * part.Height);
  const RiverSteepness rivers(part);
  EXPECT_FALSE(rivers.IsKnown());
  EXPECT_EQ(rivers.RatioOf(part), 1.0);
  EXPECT_EQ(rivers.Law(2.0).ChannelThreshold, std::numeric_limits<double>::infinity());
}
