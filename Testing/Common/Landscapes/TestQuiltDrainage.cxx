// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../Drainage/RandomGround.h"
#include "../OnThreads.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/DrainageOutlets.h"
#include "Landscapes/QuiltDrainage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace littoral;
using namespace littoral::testing;

namespace
{

constexpr int Width = 90;
constexpr int Height = 60;
constexpr double Fall = 0.2; ///< of the plain, from cell to cell

/// A plain that falls to a dam, of cells of 10 m.
GridSamples DammedPlain()
{
  return Ground(Width, Height, { 10.0, 10.0 }, [](double x, double y) {
    const double rim = std::max(0.0, std::abs(y - 295.0) - 280.0);
    return 100.0 - Fall * x / 10.0 + 4.0 * rim + (x > 850.0 ? 3.0 : 0.0);
  });
}

ChannelLaw NoLimit()
{
  return EvenLaw(std::numeric_limits<double>::infinity());
}

/// Cells of the longest straight way of water from the plain.
int LongestRun(const FlowRouting& routing)
{
  std::vector<int> run(routing.Receiver.size(), 1);
  for (auto cell = routing.Order.rbegin(); cell != routing.Order.rend(); ++cell)
  {
    const CellIndex next = routing.Receiver[*cell];
    if (next != *cell && routing.Receiver[next] - next == next - *cell)
    {
      run[next] = std::max(run[next], run[*cell] + 1);
    }
  }
  return *std::max_element(run.begin(), run.end());
}

}

TEST(QuiltDrainage, WaysWanderOnSmoothGround)
{
  const OutletMask border = BorderOutlets(Width, Height);
  for (const int seed : { 1, 2, 3 })
  {
    GridSamples smooth = DammedPlain();
    GridSamples rough = smooth;
    const std::size_t count = smooth.Values.size();
    const int straight = LongestRun(DrainQuilt(smooth, WayRoughness(count, 0.0, seed, 0), 1e-5, 0.75, NoLimit()));
    const std::vector<float> roughness = WayRoughness(count, 5.0 * Fall, seed, 0);
    const int wandering = LongestRun(DrainQuilt(rough, roughness, 1e-5, 0.75, NoLimit()));
    EXPECT_GT(straight, 80);
    EXPECT_LT(wandering, 20);
    EXPECT_EQ(FloodDepressions(rough, border).DepressionCells, 0U);
    GridSamples same = DammedPlain();
    DrainQuilt(same, WayRoughness(count, 5.0 * Fall, seed, 0, OnThreads(3)), 1e-5, 0.75, NoLimit(), OnThreads(2));
    EXPECT_EQ(same.Values, rough.Values);
  }
}
