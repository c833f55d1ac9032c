// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Arrows and rings of flow primitives against the flows' closed forms.
#include "Currents/FlowArrows.h"
#include "Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace littoral;

namespace
{

FlowPrimitive Flow(FlowType type)
{
  FlowPrimitive flow;
  flow.Type = type;
  flow.Strength = 0.3;
  flow.Center = { 5.0, -2.0, 7.0 };
  flow.Axis = { 1.0, 2.0, 2.0 };
  flow.CoreRadius = 0.4;
  return flow;
}

double LongestOf(const std::vector<FlowArrow>& arrows)
{
  double longest = 0.0;
  for (const FlowArrow& arrow : arrows)
  {
    longest = std::max(longest, glm::length(arrow.Arm));
  }
  return longest;
}

}

TEST(FlowArrows, Source)
{
  const FlowPrimitive flow = Flow(FlowType::Source);
  const auto arrows = ArrowsOf(flow);
  ASSERT_GT(arrows.size(), 40u);
  EXPECT_NEAR(LongestOf(arrows), 4.0 * 0.4 / 3.0, 1e-12);
  Vector3 sum(0.0);
  for (const FlowArrow& arrow : arrows)
  {
    const Vector3 from = arrow.Tail + 0.5 * arrow.Arm - flow.Center;
    const double r = glm::length(from);
    // Q R / (4 pi (R^2 + e^2)^(3/2)), outwards
    EXPECT_NEAR(arrow.Speed, 0.3 * r / (4.0 * Pi * std::pow(r * r + 0.16, 1.5)), 1e-12);
    EXPECT_NEAR(glm::dot(from, arrow.Arm), r * glm::length(arrow.Arm), 1e-9);
    sum += from / r;
  }
  EXPECT_LT(glm::length(sum), 0.02 * static_cast<double>(arrows.size())) << "directions are not spread evenly";
}

TEST(FlowArrows, SinkPointsInwards)
{
  const FlowPrimitive flow = Flow(FlowType::Sink);
  for (const FlowArrow& arrow : ArrowsOf(flow))
  {
    EXPECT_LT(glm::dot(arrow.Tail + 0.5 * arrow.Arm - flow.Center, arrow.Arm), 0.0);
  }
}

TEST(FlowArrows, Vortex)
{
  const FlowPrimitive flow = Flow(FlowType::Vortex);
  const Vector3 axis = flow.Axis / 3.0;
  const auto arrows = ArrowsOf(flow);
  ASSERT_GT(arrows.size(), 20u);
  for (const FlowArrow& arrow : arrows)
  {
    const Vector3 from = arrow.Tail + 0.5 * arrow.Arm - flow.Center;
    const double q = glm::length(from);
    EXPECT_NEAR(glm::dot(from, axis), 0.0, 1e-12);
    // G / (2 pi q) (1 - exp(-q^2/e^2)), right-handed
    EXPECT_NEAR(arrow.Speed, 0.3 / (2.0 * Pi * q) * (1.0 - std::exp(-q * q / 0.16)), 1e-12);
    EXPECT_NEAR(glm::dot(glm::cross(axis, from), arrow.Arm), q * glm::length(arrow.Arm), 1e-9);
  }
  const auto rings = RingsOf(flow);
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_DOUBLE_EQ(rings[0].Radius, 0.4);
  EXPECT_NEAR(glm::dot(rings[0].Normal, axis), 1.0, 1e-12);
}

TEST(FlowArrows, Uniform)
{
  FlowPrimitive flow = Flow(FlowType::Uniform);
  for (const FlowArrow& arrow : ArrowsOf(flow))
  {
    EXPECT_DOUBLE_EQ(arrow.Speed, 0.3);
    EXPECT_NEAR(glm::length(arrow.Arm - 2.0 / 3.0 * flow.Axis / 3.0), 0.0, 1e-12);
  }
  EXPECT_TRUE(RingsOf(flow).empty());
  flow.InfluenceRadius = 6.0;
  const auto rings = RingsOf(flow);
  ASSERT_EQ(rings.size(), 3u);
  EXPECT_DOUBLE_EQ(rings[1].Radius, 6.0);
  EXPECT_NEAR(LongestOf(ArrowsOf(flow)), 2.0, 1e-12);
}

TEST(FlowArrows, NoFlowNoArrows)
{
  FlowPrimitive flow = Flow(FlowType::Vortex);
  flow.Strength = 0.0;
  EXPECT_TRUE(ArrowsOf(flow).empty());
}

TEST(FlowArrows, OfSamplesAreOneACell)
{
  // 40 x 20 samples 10 m apart in two layers, of a current that grows eastwards and sinks below
  std::vector<FlowSample> samples;
  for (const double z : { -8.0, -1.0 })
  {
    for (int j = 0; j < 20; ++j)
    {
      for (int i = 0; i < 40; ++i)
      {
        samples.push_back({ { 10.0 * i, 10.0 * j, z }, { 0.01 * i, 0.0, z + 1.0 } });
      }
    }
  }
  const std::vector<FlowArrow> arrows = ArrowsAt(samples, 10);
  // cells of 39 m, ten by five
  EXPECT_EQ(arrows.size(), 50u);
  double longest = 0.0;
  for (const FlowArrow& arrow : arrows)
  {
    const Vector3 middle = arrow.Tail + 0.5 * arrow.Arm;
    EXPECT_EQ(middle.z, -1.0); // the upper layer
    EXPECT_NEAR(arrow.Speed, 1e-3 * middle.x, 1e-12);
    EXPECT_NEAR(arrow.Arm.y, 0.0, 1e-12);
    longest = std::max(longest, arrow.Arm.x);
  }
  EXPECT_NEAR(longest, 39.0, 1e-9);
  EXPECT_TRUE(ArrowsAt({}, 10).empty());
}
