// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../Drainage/RandomGround.h"
#include "../OnThreads.h"
#include "Landscapes/HeightMatching.h"
#include "Landscapes/LandscapeStep.h"
#include "Landscapes/LongWaves.h"
#include "Landscapes/RockHardness.h"
#include "Landscapes/UpliftSteering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace littoral;
using namespace littoral::testing;

namespace
{

/// Heights of a function of the points' positions [m].
template <typename Function>
std::vector<double> HeightsOn(const PointMesh& mesh, const Function& heightAt)
{
  std::vector<double> heights;
  for (const std::array<double, 2>& point : mesh.Points)
  {
    heights.push_back(heightAt(point[0], point[1]));
  }
  return heights;
}

/// Slope of each point to its receiver; 0 at the rim.
std::vector<double> SlopesOf(const PointMesh& mesh, const MeshDrainage& drainage, const std::vector<double>& heights)
{
  std::vector<double> slopes;
  for (CellIndex n = 0; n < mesh.Count(); ++n)
  {
    const CellIndex link = drainage.Link[n];
    slopes.push_back(link < 0 ? 0.0 : (heights[n] - heights[mesh.Neighbour[link]]) / mesh.Distance[link]);
  }
  return slopes;
}

/// Landscape after so many steps from a rough plain.
std::vector<double> Evolved(const PointMesh& mesh, const LandscapeLaw& law, double uplift, double time, int steps,
  double hardness = 1.0, const RockFactors& factors = {})
{
  const RandomStream random(5, RandomPurpose::ElevationLines);
  int n = 0;
  std::vector<double> heights =
    HeightsOn(mesh, [&](double, double) { return mesh.IsRim(n) ? 0.0 * n++ : random.UniformPair(n++, 0)[0]; });
  const std::vector<double> rock(heights.size(), hardness);
  for (int step = 0; step < steps; ++step)
  {
    StepLandscape(mesh, DrainMesh(mesh, heights), law, uplift, rock, time, heights, SerialFor, factors);
  }
  return heights;
}

}

TEST(PointMesh, CellsOfVoronoiPaveTheGroundAndPlanesHaveNoCurvature)
{
  const PointMesh mesh = JitteredMesh(40, 30, { 70.0, 90.0 }, 3);
  const std::vector<double> plane = HeightsOn(mesh, [](double x, double y) { return 0.3 * x - 0.2 * y; });
  double area = 0.0;
  for (CellIndex n = 0; n < mesh.Count(); ++n)
  {
    const int i = n % mesh.Width;
    const int j = n / mesh.Width;
    if (i < 3 || j < 3 || i > mesh.Width - 4 || j > mesh.Height - 4)
    {
      continue;
    }
    // the flux of a plane through the closed rim of a cell is 0
    double flux = 0.0;
    for (CellIndex link = mesh.First[n]; link < mesh.First[n + 1]; ++link)
    {
      flux += mesh.EdgeRatio[link] * (plane[mesh.Neighbour[link]] - plane[n]);
    }
    EXPECT_NEAR(flux, 0.0, 1e-6);
    area += mesh.Area[n];
  }
  EXPECT_NEAR(area / (34.0 * 24.0 * 70.0 * 90.0), 1.0, 0.02);
}

TEST(PointMesh, DrawsShareNoPoints)
{
  const std::array<double, 2> unit{ 1.0, 1.0 };
  const PointMesh one = JitteredMesh(20, 20, unit, 3, 1);
  const PointMesh two = JitteredMesh(20, 20, unit, 2, 2);
  const PointMesh three = JitteredMesh(20, 20, unit, 3, 2);
  EXPECT_EQ(one.Points, JitteredMesh(20, 20, unit, 3, 1).Points);
  EXPECT_NE(one.Points[45], two.Points[45]);
  EXPECT_NE(one.Points[45], three.Points[45]);
}

TEST(PointMesh, PlanesStayPlanesOnTheGrid)
{
  const PointMesh mesh = JitteredMesh(30, 25, { 10.0, 15.0 }, 8);
  const GridSamples grid = GridOf(mesh, HeightsOn(mesh, [](double x, double y) { return 2.0 * x - 3.0 * y; }));
  for (int j = 3; j < 22; ++j)
  {
    for (int i = 3; i < 27; ++i)
    {
      EXPECT_NEAR(grid.At(i, j), 20.0 * i - 45.0 * j, 1e-9);
    }
  }
}

TEST(MeshDrainage, AllWaterReachesTheRimOutOfPits)
{
  const PointMesh mesh = JitteredMesh(33, 41, { 20.0, 20.0 }, 1);
  const GridSamples noise = RandomGround(33, 41, { 20.0, 20.0 }, 7);
  const MeshDrainage drainage = DrainMesh(mesh, noise.Values, OnThreads(3));
  double out = 0.0;
  for (CellIndex n = 0; n < mesh.Count(); ++n)
  {
    out += drainage.Link[n] < 0 ? drainage.Area[n] : 0.0;
    EXPECT_EQ(drainage.Link[n] < 0, mesh.IsRim(n));
  }
  const double all = std::accumulate(mesh.Area.begin(), mesh.Area.end(), 0.0);
  EXPECT_NEAR(out / all, 1.0, 1e-12);
  EXPECT_EQ(drainage.Order.size(), mesh.Points.size());
}

TEST(LandscapeStep, RiversReachTheirSteadyState)
{
  const PointMesh mesh = JitteredMesh(24, 30, { 50.0, 50.0 }, 2);
  LandscapeLaw law;
  law.Erodibility = 2e-4;
  law.AreaExponent = 0.4;
  law.Diffusivity = 0.0;
  law.ThresholdSlope = 1e6;
  law.MinimumSlope = 0.0;
  const double uplift = 1e-3;
  const std::vector<double> heights = Evolved(mesh, law, uplift, 1e9, 60);
  const MeshDrainage drainage = DrainMesh(mesh, heights);
  const std::vector<double> slopes = SlopesOf(mesh, drainage, heights);
  for (CellIndex n = 0; n < mesh.Count(); ++n)
  {
    if (!mesh.IsRim(n))
    {
      // S = U / K A^-m
      EXPECT_NEAR(slopes[n] * std::pow(drainage.Area[n], 0.4) * law.Erodibility / uplift, 1.0, 1e-5);
    }
  }
}

TEST(LandscapeStep, HillslopesArchAsAParabola)
{
  const PointMesh mesh = JitteredMesh(14, 120, { 10.0, 10.0 }, 4);
  LandscapeLaw law;
  law.Erodibility = 0.0;
  law.Diffusivity = 2.0;
  law.ThresholdSlope = 1e6;
  law.MinimumSlope = 0.0;
  const std::vector<double> heights = Evolved(mesh, law, 0.01, 1e9, 200);
  for (CellIndex n = 30 * 14; n < 90 * 14; ++n)
  {
    // z = U / (2D) x (L - x)
    const double x = mesh.Points[n][0];
    EXPECT_NEAR(heights[n], 0.01 / 4.0 * x * (130.0 - x), 0.03 * 0.01 / 4.0 * 65.0 * 65.0);
  }
}

TEST(LandscapeStep, SteepHillslopesAreStraighterThanParabolas)
{
  const PointMesh mesh = JitteredMesh(14, 80, { 10.0, 10.0 }, 4);
  LandscapeLaw law;
  law.Erodibility = 0.0;
  law.Diffusivity = 2.0;
  law.ThresholdSlope = 0.6;
  law.MinimumSlope = 0.0;
  const double uplift = 0.02;
  const std::vector<double> heights = Evolved(mesh, law, uplift, 1e9, 300);
  // D S / (1 - (S / S_c)^2) = U x at x from the crest: S = S_c (sqrt(1 + q^2) - 1) / q with q = 2 U x / (D S_c)
  double crest = 0.0;
  for (double x = 0.05; x < 65.0; x += 0.1)
  {
    const double q = 2.0 * uplift * x / (law.Diffusivity * law.ThresholdSlope);
    crest += 0.1 * law.ThresholdSlope * (std::sqrt(1.0 + q * q) - 1.0) / q;
  }
  double top = 0.0;
  for (int j = 30; j < 50; ++j)
  {
    top += *std::max_element(heights.begin() + j * 14, heights.begin() + (j + 1) * 14) / 20.0;
  }
  EXPECT_NEAR(top / crest, 1.0, 0.06);
}

TEST(LandscapeStep, NoSlopeIsAboveTheThreshold)
{
  const PointMesh mesh = JitteredMesh(20, 60, { 10.0, 10.0 }, 6);
  LandscapeLaw law;
  law.Erodibility = 0.0;
  law.Diffusivity = 0.01;
  law.ThresholdSlope = 0.7;
  const std::vector<double> heights = Evolved(mesh, law, 0.1, 1e6, 100);
  const std::vector<double> slopes = SlopesOf(mesh, DrainMesh(mesh, heights), heights);
  EXPECT_LE(*std::max_element(slopes.begin(), slopes.end()), 0.7 + 1e-9);
  EXPECT_NEAR(*std::max_element(heights.begin(), heights.end()), 0.7 * 95.0, 0.1 * 0.7 * 95.0);
}

TEST(LandscapeStep, RefusesWhatNoLandscapeFollows)
{
  LandscapeLaw law;
  EXPECT_EQ(WhyInvalid(law), "");
  law.ThresholdSlope = 0.0;
  EXPECT_EQ(WhyInvalid(law), "ThresholdSlope is 0; it must be positive and finite.");
}

TEST(LandscapeStep, HardRockRisesAndResists)
{
  const PointMesh mesh = JitteredMesh(24, 30, { 50.0, 50.0 }, 2);
  LandscapeLaw law;
  law.Erodibility = 2e-4;
  law.Diffusivity = 0.0;
  law.ThresholdSlope = 1e6;
  law.MinimumSlope = 0.0;
  const std::vector<double> heights = Evolved(mesh, law, 1e-3, 1e9, 60, 3.0);
  const MeshDrainage drainage = DrainMesh(mesh, heights);
  const std::vector<double> slopes = SlopesOf(mesh, drainage, heights);
  for (CellIndex n = 0; n < mesh.Count(); ++n)
  {
    // S = U h^1/2 / (K h^-1/2) A^-m
    EXPECT_NEAR(mesh.IsRim(n) ? 3.0 : slopes[n] * std::sqrt(drainage.Area[n]) * 2e-4 / 1e-3, 3.0, 1e-4);
  }
  // hillslopes without rivers: z = U h^1/2 / (2D) x (L - x)
  law.Erodibility = 0.0;
  law.Diffusivity = 2.0;
  const std::vector<double> one = Evolved(mesh, law, 0.01, 1e9, 100);
  const std::vector<double> four = Evolved(mesh, law, 0.01, 1e9, 100, 4.0);
  EXPECT_NEAR(four[15 * 24 + 12] / one[15 * 24 + 12], 2.0, 1e-2);
}

TEST(LandscapeStep, TwoRocksUnderTwoUpliftsHaveTheirSteepness)
{
  const PointMesh mesh = JitteredMesh(24, 30, { 50.0, 50.0 }, 2);
  LandscapeLaw law;
  law.Erodibility = 2e-4;
  law.AreaExponent = 0.4;
  law.Diffusivity = 0.0;
  law.ThresholdSlope = 1e6;
  law.MinimumSlope = 0.0;
  // the west is four times as soft, the south rises three times as fast
  const RockFactors factors{ HeightsOn(mesh, [](double x, double) { return x < 600.0 ? 4.0 : 1.0; }),
    HeightsOn(mesh, [](double, double y) { return y < 700.0 ? 3.0 : 1.0; }) };
  const std::vector<double> heights = Evolved(mesh, law, 1e-3, 1e9, 60, 1.0, factors);
  const MeshDrainage drainage = DrainMesh(mesh, heights);
  const std::vector<double> slopes = SlopesOf(mesh, drainage, heights);
  for (CellIndex n = 0; n < mesh.Count(); ++n)
  {
    // k_s = S A^m = U f / (K e)
    const double wanted = 1e-3 * factors.Uplift[n] / (2e-4 * factors.Erodibility[n]);
    EXPECT_NEAR(mesh.IsRim(n) ? 1.0 : slopes[n] * std::pow(drainage.Area[n], 0.4) / wanted, 1.0, 1e-4);
  }
}

TEST(UpliftSteering, LeavesTheSteepnessThatIsGiven)
{
  // hardness that would give back half of what two rocks ask for, and what has nothing to do with them
  std::vector<double> logSteepness;
  std::vector<double> hardness;
  std::vector<double> other;
  for (int n = 0; n < 300; ++n)
  {
    logSteepness.push_back(n < 100 ? -1.2 : 0.3);
    other.push_back(n % 2 == 0 ? 0.5 : -0.5);
    hardness.push_back(std::exp(-0.5 * logSteepness.back() + other.back()));
  }
  KeepSteepness(logSteepness, hardness);
  const double mean = (100.0 * 1.2 - 200.0 * 0.3) / 300.0;
  for (int n = 0; n < 300; ++n)
  {
    EXPECT_NEAR(std::log(hardness[n]), other[n] + 0.5 * mean, 1e-12);
  }
  const std::vector<double> before = hardness;
  KeepSteepness(std::vector<double>(300, 0.7), hardness);
  EXPECT_EQ(hardness, before);
}

TEST(UpliftSteering, GoesTowardsTheRockAndTheErrorWithinTheRange)
{
  const GridSamples wanted = Ground(32, 20, { 10.0, 10.0 }, [](double x, double) { return x < 155.0 ? -7.0 : 7.0; });
  const std::vector<double> rock(wanted.Values.size(), 2.0);
  std::vector<double> hardness(rock.size(), 1.0);
  UpliftSteering steering;
  steering.Smoothing = 1.0;
  steering.Rate = 1.0;
  SteerUplift(steering, wanted.Values, wanted, rock, hardness);
  EXPECT_NEAR(hardness[77], 2.0, 1e-12);
  // an error of one deviation and of a far greater one, with a mean that does not count
  for (const double errors : { 1.0, 1e6 })
  {
    std::vector<double> heights = wanted.Values;
    for (double& height : heights)
    {
      height = height - errors * height + 100.0;
    }
    SteerUplift(steering, heights, wanted, rock, hardness);
    const double deviation = std::sqrt(Moments(wanted).Variance);
    const double x = 4.0 * 7.0 * errors / (deviation * std::log(4.0));
    EXPECT_NEAR(hardness[31], 2.0 * std::pow(4.0, x / std::sqrt(1.0 + x * x)), 1e-5);
    EXPECT_NEAR(hardness[0], 4.0 / hardness[31], 1e-5);
  }
  steering.Rate = 0.25;
  hardness.assign(rock.size(), 1.0);
  SteerUplift(steering, wanted.Values, wanted, rock, hardness);
  EXPECT_NEAR(hardness[77], std::pow(2.0, 0.25), 1e-12);
}

TEST(RockHardness, ProfileKnowsTheSlopesOfTwoGrounds)
{
  // low ground of slope 1 that goes on as high ground of slope 3, without smoothing to speak of
  const GridSamples place =
    Ground(200, 80, { 1.0, 1.0 }, [](double x, double) { return x < 100.0 ? x : 100.0 + 3.0 * (x - 100.0); });
  const std::vector<double> profile = SlopesByHeight(place, 0.1);
  ASSERT_EQ(profile.size(), 64u);
  EXPECT_NEAR(profile[10], 1.0 / 2.0, 0.01);
  EXPECT_NEAR(profile[50], 3.0 / 2.0, 0.03);
  GridSamples other = Ground(90, 50, { 7.0, 7.0 }, [](double, double y) { return -y; });
  const std::vector<double> rock = ProfileByHeight(other, 0.1, profile);
  EXPECT_EQ(rock[90 * 48 + 30], profile[1]);
  EXPECT_EQ(rock[90 * 10 + 3], profile[64 * 39 / 50]);
}

TEST(HeightMatching, ExponentialHeightsBecomeUniform)
{
  std::vector<double> heights;
  HeightQuantiles uniform;
  for (int n = 0; n <= 4000; ++n)
  {
    const double p = n / 4000.0;
    heights.push_back(std::expm1(1.5 * p)); // quantiles of ln(1 + z) / 1.5
    uniform.Probabilities.push_back(p);
    uniform.Heights.push_back(100.0 + 50.0 * p);
  }
  MatchHeights(heights, uniform);
  for (int n = 0; n <= 4000; ++n)
  {
    EXPECT_NEAR(heights[n], 100.0 + 50.0 * n / 4000.0, 0.05);
    EXPECT_TRUE(n == 0 || heights[n] > heights[n - 1]);
  }
}

TEST(LongWaves, PlanesGoOnInMarginsAndBetweenCells)
{
  const GridSamples plane = Ground(9, 7, { 2.0, 3.0 }, [](double x, double y) { return x - 4.0 * y; });
  const GridSamples wide = WithMargins(plane, 3, 4, 2);
  ASSERT_EQ(wide.Width, 16);
  ASSERT_EQ(wide.Height, 12);
  for (int j = 0; j < 12; ++j)
  {
    for (int i = 0; i < 16; ++i)
    {
      EXPECT_NEAR(wide.At(i, j), 2.0 * (i - 3) - 12.0 * (j - 3), 1e-12);
    }
  }
  EXPECT_EQ(PartOf(wide, 3, 3, 9, 7).Values, plane.Values);
  const GridSamples coarse = BlockMeans(wide, 2);
  const std::vector<double> fine = Refined(coarse.Values, coarse.Width, coarse.Height);
  EXPECT_NEAR(fine[5 * 16 + 6], wide.At(6, 5), 1e-12);
}
