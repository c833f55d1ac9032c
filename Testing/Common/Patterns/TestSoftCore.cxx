// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MappedPatterns.h"
#include "Patterns/ProcessDraws.h"
#include "Patterns/ProcessFit.h"
#include "Patterns/ProcessPattern.h"
#include "Patterns/SoftCoreChain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

using namespace littoral;
using littoral::testing::Mapped;

namespace
{

PointProcessParameters SoftCore(double intensity, double distance, double softness)
{
  PointProcessParameters process;
  process.Process = PointProcess::SoftCore;
  process.Intensity = intensity;
  process.Distance = distance;
  process.Softness = softness;
  return process;
}

/// Square of the gradient, and Laplacian, of the potential of a point: of (D / r)^m they are m (D / r)^m / r along the
/// line to the other point, and m^2 (D / r)^m / r^2.
struct Curvature
{
  double Square = 0.0;
  double Laplacian = 0.0;
};

Curvature CurvatureAt(const std::vector<PlanePosition>& points, std::size_t at, const PointProcessParameters& process)
{
  const double m = 2.0 / process.Softness;
  double gradient[2] = { 0.0, 0.0 };
  Curvature result;
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    const double dx = points[at][0] - points[n][0];
    const double dy = points[at][1] - points[n][1];
    const double r2 = dx * dx + dy * dy;
    const double potential = n == at ? 0.0 : std::pow(process.Distance * process.Distance / r2, 0.5 * m);
    if (potential > 0.005)
    {
      gradient[0] += m * potential * dx / r2;
      gradient[1] += m * potential * dy / r2;
      result.Laplacian += m * m * potential / r2;
    }
  }
  result.Square = gradient[0] * gradient[0] + gradient[1] * gradient[1];
  return result;
}

}

// In equilibrium the mean of |grad U|^2 is that of the Laplacian of U (Rugh 1997; integration by parts of exp(-U)), for
// points that are crowded and for such that are not. Points that still overlap, as random ones do, have more of the
// former.
TEST(SoftCore, ForcesBalanceAsInEquilibrium)
{
  for (const auto& [distance, softness, seeds] :
    { std::tuple(0.03, 0.4, 30), std::tuple(0.1, 0.2, 20), std::tuple(0.1, 0.4, 12) })
  {
    const PointProcessParameters process = SoftCore(100.0, distance, softness);
    double sum = 0.0;
    double squares = 0.0;
    double laplacians = 0.0;
    for (int seed = 1; seed <= seeds; ++seed)
    {
      ProcessOptions options;
      options.Seed = seed;
      const std::vector<PlanePosition> points = SimulateProcess(process, options, ObservationWindow()).Points;
      const double margin = distance * std::pow(0.005, -0.5 * softness);
      double difference = 0.0;
      for (std::size_t n = 0; n < points.size(); ++n)
      {
        const bool isInside =
          points[n][0] > margin && points[n][0] < 1.0 - margin && points[n][1] > margin && points[n][1] < 1.0 - margin;
        if (isInside)
        {
          const Curvature curvature = CurvatureAt(points, n, process);
          difference += curvature.Square - curvature.Laplacian;
          laplacians += curvature.Laplacian;
        }
      }
      sum += difference;
      squares += difference * difference;
    }
    const double error = std::sqrt((squares - sum * sum / seeds) * seeds / (seeds - 1.0));
    EXPECT_NEAR(sum, 0.0, 3.0 * error) << distance << " " << softness;
    EXPECT_LT(error, 0.15 * laplacians) << distance << " " << softness; // the test sees a difference
  }
}

// A chain has the steps that its crowding asks for, whatever the unit of length: 20, and 4 more for each hundredth of
// intensity times squared distance, at most 200.
TEST(SoftCore, CrowdedPointsTakeMoreSweeps)
{
  for (const double unit : { 0.01, 1.0, 50.0 })
  {
    const auto sweeps = [unit](
                          double crowding) { return SoftCoreSweeps(SoftCore(crowding / (unit * unit), unit, 0.4)); };
    EXPECT_EQ(sweeps(0.01), 24);
    EXPECT_EQ(sweeps(0.1), 60);
    EXPECT_EQ(sweeps(0.3), 140);
    EXPECT_EQ(sweeps(1.0), 200);
  }
}

// The number of points in the torus is given, so that the intensity is too: three standard errors, which are below 0.6.
TEST(SoftCore, IntensityIsThatAskedFor)
{
  const int seeds = 150;
  double sum = 0.0;
  double squares = 0.0;
  for (int seed = 1; seed <= seeds; ++seed)
  {
    ProcessOptions options;
    options.Seed = seed;
    const ProcessPattern pattern = SimulateProcess(SoftCore(60.3, 0.1, 0.1), options, ObservationWindow());
    EXPECT_FALSE(pattern.IsExact);
    const auto points = static_cast<double>(pattern.Points.size());
    sum += points;
    squares += points * points;
  }
  const double mean = sum / seeds;
  const double error = std::sqrt((squares / seeds - mean * mean) / (seeds - 1.0));
  EXPECT_LT(3.0 * error, 0.6);
  EXPECT_NEAR(mean, 60.3, 3.0 * error);
}

// Points leave a torus on one side and come in on the other: those that hardly feel each other stay uniform.
TEST(SoftCore, PointsMoveOnATorus)
{
  PatternArea torus;
  torus.Size = { 3.0, 2.0 };
  SoftCoreChain chain(SoftCore(100.0, 0.001, 0.4), torus, 3);
  chain.Fill(600);
  for (int sweep = 1; sweep < 40; ++sweep)
  {
    chain.Sweep(sweep);
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    int outer = 0;
    for (const PlanePosition& place : chain.GetPlaces())
    {
      ASSERT_TRUE(place[axis] >= 0.0 && place[axis] < torus.Size[axis]);
      outer += place[axis] < 0.01 * torus.Size[axis] || place[axis] > 0.99 * torus.Size[axis];
    }
    EXPECT_NEAR(outer, 12.0, 3.0 * std::sqrt(12.0)) << axis;
  }
}

// The table of potentials is as near to the formula as it says, up to its ends.
TEST(SoftCore, PotentialsAreTabulated)
{
  for (const double softness : { 0.05, 0.4, 0.8 })
  {
    const SoftCorePotential potential(SoftCore(1.0, 2.0, softness));
    EXPECT_NEAR(potential.GetSquareReach(), 4.0 * std::pow(0.005, -softness), 1e-9);
    const double low = 4.0 * std::pow(50.0, -softness);
    for (int n = 0; n <= 1000; ++n)
    {
      const double r2 = low + (potential.GetSquareReach() - low) * std::pow(0.001 * n, 4);
      const double wanted = std::pow(4.0 / r2, 1.0 / softness);
      EXPECT_NEAR(potential(r2), wanted, (wanted < 10.0 ? 1e-3 : 0.02) * wanted) << softness << " " << r2;
    }
    EXPECT_NEAR(potential(0.5 * low), 100.0, 1e-6);
    EXPECT_TRUE(std::isfinite(potential(0.0)));
  }
}

// ppm of spatstat 3.0 with the same quadrature, quadscheme(cells, dummy = gridcentres(square(1), 128, 128), ntile =
// 128), Softcore(kappa) and a border of 0.13: sigma = 0.12603, and the maximum over kappa in steps of 0.05 is there
// too. By default ppm has 32 x 32 tiles, in which a point of the pattern weighs no more than a dummy one, so that sigma
// grows with their number: 0.117, 0.123, 0.129 with nd = 64, 128, 256.
TEST(SoftCore, CellsAreThoseOfSpatstat)
{
  const ProcessFit fit = FitSoftCore(Mapped("cells"), ObservationWindow(), 0.13);
  ASSERT_TRUE(fit.Exists);
  EXPECT_NEAR(fit.Process.Softness, 0.45, 1e-9);
  EXPECT_NEAR(fit.Process.Distance, 0.12603, 1e-3 * 0.12603);
  EXPECT_DOUBLE_EQ(fit.Process.Intensity, 42.0);
}

// Without bias, and not by chance: single fits have standard deviations of about 13 % and 0.14.
TEST(SoftCore, WhatWasSimulatedIsFoundAgain)
{
  double distance = 0.0;
  double softness = 0.0;
  double squares[2] = { 0.0, 0.0 };
  const int seeds = 3;
  for (int seed = 1; seed <= seeds; ++seed)
  {
    ProcessOptions options;
    options.Seed = seed;
    const ProcessFit fit = FitProcess(PointProcess::SoftCore,
      SimulateProcess(SoftCore(200.0, 0.05, 0.4), options, ObservationWindow()).Points, ObservationWindow(), {});
    ASSERT_TRUE(fit.Exists) << seed;
    distance += fit.Process.Distance / seeds;
    softness += fit.Process.Softness / seeds;
    squares[0] += std::pow(fit.Process.Distance / 0.05 - 1.0, 2) / seeds;
    squares[1] += std::pow(fit.Process.Softness - 0.4, 2) / seeds;
  }
  EXPECT_NEAR(distance, 0.05, 0.1 * 0.05);
  EXPECT_NEAR(softness, 0.4, 0.1);
  EXPECT_LT(std::sqrt(squares[0]), 0.2);
  EXPECT_LT(std::sqrt(squares[1]), 0.2);
}

// One random pattern in twenty has a soft core by chance, within three standard errors.
TEST(SoftCore, RandomPointsHaveNone)
{
  int random = 0;
  const int seeds = 15;
  for (int seed = 1; seed <= seeds; ++seed)
  {
    ProcessOptions options;
    options.Seed = seed;
    PointProcessParameters poisson;
    poisson.Process = PointProcess::Poisson;
    poisson.Intensity = 100.0;
    random += FitSoftCore(SimulateProcess(poisson, options, ObservationWindow()).Points, {}, 0.085).Exists;
  }
  EXPECT_LE(random, 0.05 * seeds + 3.0 * std::sqrt(0.05 * 0.95 * seeds));
}

TEST(SoftCore, FrozenPointsAreRefused)
{
  EXPECT_NE(WhyInvalid(SoftCore(100.0, 0.15, 0.4)).find("Distance^2"), std::string::npos);
  EXPECT_EQ(WhyInvalid(SoftCore(100.0, 0.14, 0.4)), "");
}
