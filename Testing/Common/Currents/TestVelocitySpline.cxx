// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Splines of velocities: polynomials are exact, the error and the divergence fall with the fourth and third power of
// the spacing, few samples and any order of them will do.
#include "Currents/VelocitySpline.h"
#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using namespace littoral;

namespace
{

VelocitySpline SplineOf(const std::array<std::vector<double>, 3>& nodes, const std::function<Vector3(Vector3)>& field)
{
  return { { SplineAxis(nodes[0]), SplineAxis(nodes[1]), SplineAxis(nodes[2]) }, [&](std::size_t n) {
            const std::size_t i = n % nodes[0].size();
            const std::size_t j = n / nodes[0].size() % nodes[1].size();
            return field({ nodes[0][i], nodes[1][j], nodes[2][n / nodes[0].size() / nodes[1].size()] });
          } };
}

Vector3 PlaceIn(int n, const Vector3& low, const Vector3& high)
{
  const RandomStream random(8, RandomPurpose::ParticlePositions);
  const auto number = [&](int k) { return random.UniformPair(static_cast<std::uint64_t>(n), k)[0]; };
  return low + (high - low) * Vector3(number(0), number(1), number(2));
}

/// The curl of (0, sin x sin z sin y, sin x sin y cos z).
Vector3 Eddies(const Vector3& p)
{
  const Vector3 s = glm::sin(p);
  const Vector3 c = glm::cos(p);
  return { s.x * c.y * c.z - s.x * c.z * s.y, -c.x * s.y * c.z, c.x * s.z * s.y };
}

std::vector<double> Even(int count, double end)
{
  std::vector<double> nodes;
  for (int n = 0; n < count; ++n)
  {
    nodes.push_back(end * n / (count - 1));
  }
  return nodes;
}

}

TEST(VelocitySpline, HasCubicPolynomialsExactly)
{
  const auto field = [](const Vector3& p) {
    return Vector3(p.x * p.x * p.x - p.y * p.z, p.y * p.y * p.x + 2.0 * p.z * p.z * p.z, 1.0 + p.x * p.y * p.z * p.z);
  };
  // Uneven, falling, and as many samples as the degree needs.
  const std::array<std::vector<double>, 3> nodes{ { { -2.0, -1.0, -0.9, 0.5, 1.0, 2.0 }, { 3.0, 1.0, 0.5, -0.25, -1.0 },
    { 0.0, 1.0, 1.25, 2.0 } } };
  const VelocitySpline spline = SplineOf(nodes, field);
  for (int n = 0; n < 300; ++n)
  {
    const Vector3 place = PlaceIn(n, { -2.0, -1.0, 0.0 }, { 2.0, 3.0, 2.0 });
    EXPECT_LT(glm::length(spline.At(place) - field(place)), 2e-5);
  }
  for (const Vector3 corner : { Vector3(-2.0, 3.0, 0.0), Vector3(2.0, -1.0, 2.0), Vector3(-2.0, -1.0, 2.0) })
  {
    EXPECT_LT(glm::length(spline.At(corner) - field(corner)), 2e-5);
  }
  EXPECT_EQ(spline.At({ 2.001, 0.0, 1.0 }), Vector3(0.0));
  EXPECT_EQ(spline.At({ 0.0, -1.001, 1.0 }), Vector3(0.0));
  EXPECT_EQ(spline.At({ 0.0, 0.0, std::nan("") }), Vector3(0.0));
}

TEST(VelocitySpline, MakesDoWithFewSamples)
{
  const auto field = [](const Vector3& p) { return Vector3(1.0 + p.x * p.x, 2.0 * p.y - p.x * p.y, p.y); };
  const VelocitySpline spline = SplineOf({ { { 0.0, 1.0, 3.0 }, { -1.0, 2.0 }, { 7.0 } } }, field);
  for (int n = 0; n < 100; ++n)
  {
    const Vector3 place = PlaceIn(n, { 0.0, -1.0, -100.0 }, { 3.0, 2.0, 100.0 });
    EXPECT_LT(glm::length(spline.At(place) - field(place)), 1e-5);
  }
  EXPECT_TRUE(SplineAxis::IsMonotone({ 1.0 }) && SplineAxis::IsMonotone({ 2.0, 1.0, 0.0 }));
  EXPECT_FALSE(SplineAxis::IsMonotone({ 1.0, 1.0 }) || SplineAxis::IsMonotone({ 0.0, 1.0, 0.5 }));
}

TEST(VelocitySpline, HasHardlyADivergenceWhereSamplesHaveNone)
{
  double errors[2];
  double divergences[2];
  for (int fine = 0; fine < 2; ++fine)
  {
    const std::vector<double> nodes = Even(fine ? 33 : 17, TwoPi);
    const VelocitySpline spline = SplineOf({ { nodes, nodes, nodes } }, Eddies);
    errors[fine] = divergences[fine] = 0.0;
    for (int n = 0; n < 4000; ++n)
    {
      const Vector3 place = PlaceIn(n, Vector3(0.01), Vector3(TwoPi - 0.01));
      errors[fine] = std::max(errors[fine], glm::length(spline.At(place) - Eddies(place)));
      double divergence = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        Vector3 shift(0.0);
        shift[axis] = 1e-3;
        divergence += (spline.At(place + shift)[axis] - spline.At(place - shift)[axis]) / 2e-3;
      }
      divergences[fine] = std::max(divergences[fine], std::abs(divergence));
    }
    std::cout << nodes.size() << " samples: error " << errors[fine] << ", divergence " << divergences[fine]
              << std::endl;
  }
  EXPECT_GT(std::log2(errors[0] / errors[1]), 3.5);
  EXPECT_GT(std::log2(divergences[0] / divergences[1]), 2.5);
  EXPECT_LT(errors[0], 3e-3);
}
