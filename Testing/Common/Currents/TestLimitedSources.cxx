// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/LimitedSources.h"

#include "Currents/FlowPrimitives.h"
#include "Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

using namespace littoral;

namespace
{

Vector3 RandomPlace(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> along(-size, size);
  const double x = along(random);
  const double y = along(random);
  return { x, y, along(random) };
}

/// Sources and sinks with boxes of some metres about them, in a cube of 8 m.
std::vector<FlowPrimitive> RandomWakes(std::size_t count)
{
  std::mt19937 random(7);
  std::vector<FlowPrimitive> wakes(count);
  for (std::size_t n = 0; n < count; ++n)
  {
    FlowPrimitive& wake = wakes[n];
    wake.Type = n % 3 == 0 ? FlowType::Sink : FlowType::Source;
    wake.Strength = 0.1 * static_cast<double>(n + 1);
    wake.Center = RandomPlace(random, 4.0);
    wake.CoreRadius = 0.1 + 0.02 * static_cast<double>(n % 5);
    const Vector3 half = Vector3(0.4) + 0.1 * static_cast<double>(n % 7);
    wake.InfluenceBox = { wake.Center - half, wake.Center + half };
    wake.InfluenceMargin = 0.3 + 0.1 * static_cast<double>(n % 4);
  }
  return wakes;
}

/// Eq. 1 of the design page, in another form: Q R / (4 pi (R^2 + e^2)^(3/2)) (1 - d^2 / M^2)^2.
Vector3 FlowOf(const FlowPrimitive& wake, const Vector3& place)
{
  const Vector3 arm = place - wake.Center;
  const double softened = std::hypot(glm::length(arm), wake.CoreRadius);
  double squaredAway = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double nearest = std::fmin(std::fmax(place[axis], wake.InfluenceBox.Low[axis]), wake.InfluenceBox.High[axis]);
    squaredAway += std::pow(place[axis] - nearest, 2.0);
  }
  const double inside = 1.0 - squaredAway / std::pow(wake.InfluenceMargin, 2.0);
  const double sign = wake.Type == FlowType::Sink ? -1.0 : 1.0;
  return inside > 0.0 ? sign * wake.Strength / (4.0 * Pi) * std::pow(inside, 2.0) * std::pow(softened, -3.0) * arm
                      : Vector3(0.0);
}

}

/// A vortex that ends far away takes the sum out of the four lanes, and adds nothing: the bytes are the same.
TEST(LimitedSources, FourAtATimeAreOneAfterTheOther)
{
  for (const std::size_t count : { 1, 3, 4, 5, 64 })
  {
    std::vector<FlowPrimitive> wakes = RandomWakes(count);
    const FlowField four(wakes);
    FlowPrimitive vortex;
    vortex.Type = FlowType::Vortex;
    vortex.Strength = 1.0;
    vortex.Center = Vector3(1e4);
    vortex.Axis = Vector3(0.0, 0.0, 1.0);
    vortex.CoreRadius = 0.5;
    vortex.InfluenceRadius = 1.0;
    wakes.push_back(vortex);
    const FlowField one(wakes);
    std::mt19937 random(11);
    int moved = 0;
    for (int n = 0; n < 20000; ++n)
    {
      const Vector3 place = RandomPlace(random, 5.0);
      const Vector3 flow = four.Velocity(place);
      EXPECT_EQ(flow, one.Velocity(place));
      moved += glm::length(flow) > 0.0;
    }
    EXPECT_GT(moved, 20);
    EXPECT_LT(moved, 20000);
  }
}

TEST(LimitedSources, FlowIsThatOfTheFormula)
{
  const std::vector<FlowPrimitive> wakes = RandomWakes(30);
  const FlowField field(wakes);
  std::mt19937 random(5);
  for (int n = 0; n < 5000; ++n)
  {
    const Vector3 place = RandomPlace(random, 5.0);
    Vector3 sum(0.0);
    double largest = 0.0;
    for (const FlowPrimitive& wake : wakes)
    {
      const Vector3 flow = FlowOf(wake, place);
      largest += glm::length(flow);
      sum += flow;
    }
    EXPECT_LE(glm::length(field.Velocity(place) - sum), 1e-13 * largest);
  }
}

/// Those of the list alone, in lists of any length; a lane too many adds nothing.
TEST(LimitedSources, ListsOfAnyLength)
{
  LimitedSources sources;
  const Box whole{ Vector3(-1.0), Vector3(1.0) };
  for (int n = 0; n < 11; ++n)
  {
    sources.Add({ Vector3(0.0), std::pow(2.0, n), 0.0, whole, 1.0 });
  }
  EXPECT_EQ(sources.Size(), 11U);
  std::vector<int> list(11);
  std::iota(list.begin(), list.end(), 0);
  for (int first = 0; first <= 11; ++first)
  {
    for (int end = first; end <= 11; ++end)
    {
      Vector3 sum(0.0, 1.0, 0.0);
      sources.AddFlow(list.data() + first, list.data() + end, Vector3(0.5, 0.0, 0.0), sum);
      // R / R^3 = 4 at 0.5 m
      EXPECT_EQ(sum, Vector3(4.0 * (std::pow(2.0, end) - std::pow(2.0, first)), 1.0, 0.0));
    }
  }
  Vector3 none(0.0);
  sources.AddFlow(list.data(), list.data() + 11, Vector3(2.0, 0.0, 0.0), none); // where the margin ends
  EXPECT_EQ(none, Vector3(0.0));
}
