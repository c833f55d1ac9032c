// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "Drainage/ChannelGrading.h"
#include "Drainage/DepressionBreaching.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/FlowRouting.h"
#include "Drainage/StreamPower.h"
#include "RandomGround.h"
#include "RiverGround.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace littoral;
using namespace littoral::testing;

namespace
{

/// The largest of |K A^m S^n / U - 1| over the cells of a ramp that rivers have shaped until nothing changes.
double LargestError(const StreamPowerLaw& law, const std::array<double, 2>& spacing)
{
  GridSamples ramp = Ground(7, 60, spacing, [](double, double y) { return 0.02 * y; });
  OutletMask outlets(ramp.Values.size(), 0);
  std::fill(outlets.begin(), outlets.begin() + 7, 1); // the lowest row alone
  GrowByStreamPower(ramp, outlets, law, 1e8, 200);
  const FlowRouting routing = RouteFlow(ramp, outlets);
  const std::vector<double> area = DrainageArea(routing, CellLattice(ramp));
  const std::vector<double> slopes = SlopesToReceivers(ramp, routing);
  double most = 0.0;
  for (std::size_t cell = 7; cell < area.size(); ++cell)
  {
    const double rate =
      law.Erodibility * std::pow(area[cell], law.AreaExponent) * std::pow(slopes[cell], law.SlopeExponent);
    most = std::max(most, std::abs(rate / law.Uplift - 1.0));
  }
  return most;
}

}

TEST(StreamPower, ReachesItsSteadyStateOnARamp)
{
  for (const double n : { 1.0, 0.7, 1.6 })
  {
    StreamPowerLaw law;
    law.Erodibility = 2e-5;
    law.SlopeExponent = n;
    law.AreaExponent = 0.4 * n;
    law.Uplift = 5e-4;
    EXPECT_LT(LargestError(law, { 30.0, 30.0 }), 1e-6) << n;
    EXPECT_LT(LargestError(law, { 30.0, 20.0 }), 1e-6) << n;
  }
}

TEST(StreamPower, StepsAreImplicit)
{
  // One cell above an outlet: (h1 - h0) / dt = U - K A^m (h1 / d)^n, whatever the step.
  for (const double n : { 1.0, 0.6, 2.0 })
  {
    for (const double time : { 1.0, 1e3, 1e7 })
    {
      StreamPowerLaw law;
      law.SlopeExponent = n;
      GridSamples ground = Ground(3, 3, { 50.0, 50.0 }, [](double, double) { return 0.0; });
      ground.At(1, 1) = 12.0;
      const FlowRouting routing = RouteFlow(ground, BorderOutlets(3, 3));
      const std::vector<double> area = DrainageArea(routing, CellLattice(ground));
      StepStreamPower(ground, routing, area, law, time);
      const double after = ground.At(1, 1);
      const double rate = law.Uplift - law.Erodibility * std::pow(2500.0, law.AreaExponent) * std::pow(after / 50.0, n);
      EXPECT_NEAR(after, 12.0 + time * rate, 1e-9 * (12.0 + time * law.Uplift)) << n << " " << time;
    }
  }
}

TEST(StreamPower, HillslopesAreLiftedAlone)
{
  StreamPowerLaw law;
  law.MinimumArea = 1000.0;
  GridSamples ramp = Ground(5, 30, { 10.0, 10.0 }, [](double, double y) { return 0.1 * y; });
  OutletMask outlets(ramp.Values.size(), 0);
  std::fill(outlets.begin(), outlets.begin() + 5, 1);
  const GridSamples before = ramp;
  const FlowRouting routing = RouteFlow(ramp, outlets);
  const std::vector<double> area = DrainageArea(routing, CellLattice(ramp));
  StepStreamPower(ramp, routing, area, law, 100.0);
  int hillslopes = 0;
  for (std::size_t cell = 5; cell < area.size(); ++cell)
  {
    const double lift = ramp.Values[cell] - before.Values[cell];
    if (area[cell] < 1000.0)
    {
      EXPECT_NEAR(lift, 0.1, 1e-12);
      ++hillslopes;
    }
    else
    {
      EXPECT_LT(lift, 0.1);
    }
  }
  EXPECT_EQ(hillslopes, 9 * 5);
}

TEST(StreamPower, GrowsTheSameOnAnyThreads)
{
  StreamPowerLaw law;
  GridSamples one = RandomGround(40, 33, { 30.0, 30.0 }, 4);
  GridSamples two = one;
  const OutletMask outlets = BorderOutlets(40, 33);
  GrowByStreamPower(one, outlets, law, 1e6, 10);
  GrowByStreamPower(two, outlets, law, 1e6, 10, OnThreads(3));
  EXPECT_EQ(one.Values, two.Values);
  EXPECT_EQ(FloodDepressions(one, outlets).DepressionCells, 0u);
}

TEST(StreamPower, RefusesWhatNoRiverFollows)
{
  StreamPowerLaw law;
  EXPECT_EQ(WhyInvalid(law), "");
  law.Erodibility = 0.0;
  EXPECT_EQ(WhyInvalid(law), "Erodibility is 0; it must be positive and finite.");
  law = {};
  law.SlopeExponent = 0.0;
  EXPECT_EQ(WhyInvalid(law), "SlopeExponent is 0; it must be from 0.2 to 5.");
}

TEST(ChannelGrading, NoSlopeIsBelowTheLaw)
{
  const GridSamples ground = RandomGround(45, 38, { 20.0, 30.0 }, 9);
  const OutletMask outlets = BorderOutlets(45, 38);
  GridSamples breached = ground;
  BreachDepressions(breached, outlets, BreachPath::LeastCost);
  const FlowRouting routing = RouteFlow(breached, outlets);
  const std::vector<CellIndex> cells = FlowAccumulation(routing);
  ChannelLaw law;
  law.ChannelThreshold = 20.0;
  for (const double cut : { 0.0, 0.3, 1.0 })
  {
    GridSamples graded = ground;
    graded.Values = GradeAlong(ground, routing, cells, law, cut);
    const std::vector<double> slopes = SlopesToReceivers(graded, routing);
    for (std::size_t cell = 0; cell < slopes.size(); ++cell)
    {
      if (!outlets[cell])
      {
        const double least =
          cells[cell] < 20 ? 0.1 * 0.01 * std::pow(0.2, -0.45) : 0.01 * std::pow(cells[cell] / 100.0, -0.45);
        EXPECT_GE(slopes[cell], least * (1.0 - 1e-9));
      }
      EXPECT_TRUE(cut > 0.0 || graded.Values[cell] >= ground.Values[cell]);
      EXPECT_TRUE(cut < 1.0 || graded.Values[cell] <= ground.Values[cell] + 1e-12);
    }
    EXPECT_EQ(FloodDepressions(graded, outlets).DepressionCells, 0u);
  }
}

TEST(ChannelGrading, LeavesSteepGroundAlone)
{
  const GridSamples ramp = Ground(9, 30, { 10.0, 10.0 }, [](double, double y) { return 0.5 * y; });
  const FlowRouting routing = RouteFlow(ramp, BorderOutlets(9, 30));
  EXPECT_EQ(GradeAlong(ramp, routing, FlowAccumulation(routing), {}, 0.5), ramp.Values);
}
