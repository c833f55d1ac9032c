// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../Drainage/RandomGround.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/DrainageOutlets.h"
#include "Landscapes/GroundRoughness.h"
#include "Numerics/RandomStream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

using namespace littoral;
using namespace littoral::testing;

namespace
{

constexpr int Side = 128;
constexpr double Deviation = 0.05;

/// Ground z(x), in cells of 2 m, with white noise of a deviation that goes with a factor by x.
template <typename Height, typename Factor>
GridSamples NoisyGround(const Height& height, const Factor& factor)
{
  GridSamples ground = Ground(Side, Side, { 2.0, 2.0 }, [&](double x, double) { return height(x); });
  const RandomStream random(7, RandomPurpose::DrainageWaves);
  for (std::size_t n = 0; n < ground.Values.size(); ++n)
  {
    ground.Values[n] += Deviation * factor(2.0 * static_cast<double>(n % Side)) * random.NormalPair(n, 0)[0];
  }
  return ground;
}

double Even(double)
{
  return 1.0;
}

double Ramp(double x)
{
  return 0.5 * x;
}

}

TEST(GroundRoughness, WhiteNoiseComesBackAtShortWaves)
{
  const GridSamples place = NoisyGround(Ramp, Even);
  const GridSamples ramp = Ground(Side, Side, { 2.0, 2.0 }, [](double x, double) { return Ramp(x); });
  const GroundRoughness roughness = RoughnessOf(place);
  const auto power = [&](const GridSamples& ground) {
    double sum = 0.0;
    for (std::size_t n = 0; n < ground.Values.size(); ++n)
    {
      sum += std::pow(ground.Values[n] - ramp.Values[n], 2);
    }
    return sum;
  };
  double mean = 0.0;
  for (int seed = 1; seed <= 4; ++seed)
  {
    GridSamples ground = ramp;
    AddRoughness(ground, roughness, 0.0, seed);
    mean += 0.25 * power(ground) / power(place);
  }
  // of the waves up to k = 1/2 along both axes: 1 - pi 0.2^2, and 4 pi / 2 of the integral of t^2 (3 - 2t) k from 0.1
  // to 0.2 with t = 10 k - 1, 0.0085
  EXPECT_NEAR(mean, 0.928, 0.02);
}

TEST(GroundRoughness, GoesWithTheSlope)
{
  // slopes from 0.1 to 1; V ~ q where the deviation goes with them, and is far above what curvature leaves
  const auto slope = [](double x) { return 30.0 * (0.1 + 0.9 * x / (2.0 * Side)); };
  const auto bowl = [](double x) { return 0.1 * x + 0.45 * x * x / (2.0 * Side); };
  EXPECT_NEAR(RoughnessOf(NoisyGround(bowl, slope)).SlopeExponent, 1.0, 0.15);
  EXPECT_NEAR(RoughnessOf(NoisyGround(bowl, Even)).SlopeExponent, 0.0, 0.15);
}

TEST(GroundRoughness, CurvatureOfWhiteNoise)
{
  // the integral of k^5 e^(-(4 pi k)^2) from 0.1 over that from 0: e^-u (u^2 + 2u + 2) / 2, u = (0.4 pi)^2
  EXPECT_NEAR(RoughnessOf(NoisyGround(Ramp, Even)).CurvaturePart, 0.789, 0.03);
  const GridSamples waves =
    Ground(Side, Side, { 2.0, 2.0 }, [](double x, double y) { return std::sin(0.1 * (x + y)); });
  EXPECT_LT(RoughnessOf(waves).CurvaturePart, 0.01);
}

TEST(GroundRoughness, RoughGroundStaysAndFlatGroundDrains)
{
  const GridSamples place = NoisyGround(Ramp, Even);
  GridSamples same = place;
  AddRoughness(same, RoughnessOf(place), 0.0, 1);
  for (std::size_t n = 0; n < place.Values.size(); ++n)
  {
    ASSERT_NEAR(same.Values[n], place.Values[n], 1e-9);
  }
  GridSamples flat = Ground(Side, Side, { 2.0, 2.0 }, [](double x, double y) { return 1e-3 * (x + 0.3 * y); });
  AddRoughness(flat, RoughnessOf(place), 1e-5, 1);
  EXPECT_EQ(FloodDepressions(flat, BorderOutlets(Side, Side)).DepressionCells, 0u);
}

TEST(GroundRoughness, EndsWhereItsPollDoes)
{
  struct Ended
  {
  };
  GridSamples ground = NoisyGround(Ramp, Even);
  const GroundRoughness roughness = RoughnessOf(ground);
  int polls = 0;
  AddRoughness(ground, roughness, 1e-5, 1, SerialFor, [&] { ++polls; });
  // once a row in the plane, two margins, slopes, and every 4096 cells along the paths
  EXPECT_GT(polls, 4 * Side);
  for (int last = 1; last <= polls; last += Side / 2)
  {
    int left = last;
    const auto poll = [&] {
      if (--left == 0)
      {
        throw Ended();
      }
    };
    EXPECT_THROW(AddRoughness(ground, roughness, 1e-5, 1, SerialFor, poll), Ended);
  }
}
