// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Distances to the nearest point: definitions place by place, random patterns and lattices, spatstat's values.
#include "../OnThreads.h"
#include "Numerics/Constants.h"
#include "Patterns/CurveEnvelope.h"
#include "Patterns/DistanceFunctions.h"
#include "SyntheticPatterns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace littoral;
using namespace littoral::testing;

namespace
{

constexpr DistanceCorrection AllCorrections[] = { DistanceCorrection::None, DistanceCorrection::Border,
  DistanceCorrection::KaplanMeier };

TEST(DistanceFunctions, AgreeWithSpatstat)
{
  const std::vector<ReferenceValue> references = ReadReference(LITTORAL_TEST_DATA "/PointPatterns/spatstat.csv");
  const char* names[] = { "none", "rs", "km" };
  int compared = 0;
  for (const SyntheticPattern& pattern : SyntheticPatterns())
  {
    const double intensity = static_cast<double>(pattern.Points.size()) / pattern.Window.GetArea();
    const DistanceRange range{ 0.5 * std::sqrt(std::log(1e5) / (Pi * intensity)), 512 };
    for (const DistanceCorrection correction : AllCorrections)
    {
      const DistanceFunctions found = FindDistanceFunctions(pattern.Points, pattern.Window, range, correction);
      for (const ReferenceValue& reference : references)
      {
        const bool isG = reference.Function == "G";
        if (reference.Pattern != pattern.Name || reference.Correction != names[static_cast<int>(correction)] ||
          !(isG || reference.Function == "F"))
        {
          continue;
        }
        ++compared;
        const std::size_t k = static_cast<std::size_t>(std::lround(reference.Distance / range.Maximum * 512.0));
        EXPECT_NEAR((isG ? found.G : found.F)[k], reference.Value, (isG ? 1e-3 : 0.01) * reference.Value)
          << pattern.Name << " " << reference.Function << " " << reference.Correction << " at " << reference.Distance;
        EXPECT_NEAR(found.J[k] * (1.0 - found.F[k]), 1.0 - found.G[k], 1e-12);
      }
    }
  }
  EXPECT_EQ(compared, 3 * 48);
}

TEST(DistanceFunctions, OfRandomPatternsAreThoseOfChance)
{
  constexpr int Patterns = 200;
  constexpr std::size_t Points = 150;
  const ObservationWindow window = SyntheticPatterns().back().Window;
  const double intensity = Points / window.GetArea();
  const DistanceRange range{ 0.8 / std::sqrt(intensity), 8 };
  for (const DistanceCorrection correction : { DistanceCorrection::Border, DistanceCorrection::KaplanMeier })
  {
    std::vector<double> g(9, 0.0), gSquare(9, 0.0), f(9, 0.0), fSquare(9, 0.0);
    for (int n = 0; n < Patterns; ++n)
    {
      const DistanceFunctions found =
        FindDistanceFunctions(UniformPattern(window, Points, 8, n), window, range, correction, 60);
      for (std::size_t k = 1; k < 9; ++k)
      {
        g[k] += found.G[k] / Patterns;
        gSquare[k] += found.G[k] * found.G[k] / Patterns;
        f[k] += found.F[k] / Patterns;
        fSquare[k] += found.F[k] * found.F[k] / Patterns;
      }
    }
    for (std::size_t k = 1; k < 9; ++k)
    {
      const double r = range[static_cast<int>(k)];
      // Of a fixed number of points: n - 1 or n others, each within r with a probability of pi r^2 / |W|.
      const double part = Pi * r * r / window.GetArea();
      const auto error = [&](double mean, double square) { return std::sqrt((square - mean * mean) / Patterns); };
      EXPECT_NEAR(g[k], 1.0 - std::pow(1.0 - part, Points - 1.0), 4.0 * error(g[k], gSquare[k]) + 1e-3) << k;
      EXPECT_NEAR(f[k], 1.0 - std::pow(1.0 - part, 1.0 * Points), 4.0 * error(f[k], fSquare[k]) + 1e-3) << k;
      EXPECT_LT(error(g[k], gSquare[k]), 0.01);
    }
  }
}

// A square lattice: all points have their nearest at 1 m; a circle of r <= 0.5 m about each covers pi r^2 of each m2.
TEST(DistanceFunctions, FillTheSpaceOfALattice)
{
  std::vector<PlanePosition> points;
  for (int i = 0; i < 256; ++i)
  {
    points.push_back({ 0.5 + i % 16, 0.5 + i / 16 });
  }
  const ObservationWindow window = ObservationWindow::Rectangle({ 0.0, 0.0 }, { 16.0, 16.0 });
  const DistanceRange range{ 1.2, 12 };
  for (const DistanceCorrection correction : AllCorrections)
  {
    const DistanceFunctions found = FindDistanceFunctions(points, window, range, correction, 800);
    EXPECT_EQ(found.G[9], 0.0);
    EXPECT_NEAR(found.G[10], 1.0, 1e-12);
    EXPECT_EQ(found.F[0], 0.0);
    EXPECT_NEAR(found.F[2], Pi * 0.04, correction == DistanceCorrection::None ? 2e-3 : 0.02);
    EXPECT_NEAR(found.F[8], 1.0, 1e-12);
    EXPECT_GT(found.J[5], 3.0);
    EXPECT_TRUE(std::isnan(found.J[12]));
  }
}

TEST(DistanceFunctions, HaveTheSameBytesOnAnyThreads)
{
  const ObservationWindow window = SyntheticPatterns().back().Window;
  const std::vector<PlanePosition> points = UniformPattern(window, 3000, 5, 0);
  const DistanceRange range = DefaultNearestDistances(window, points.size(), 64);
  const DistanceFunctions serial = FindDistanceFunctions(points, window, range, DistanceCorrection::KaplanMeier);
  const DistanceFunctions other =
    FindDistanceFunctions(points, window, range, DistanceCorrection::KaplanMeier, 128, OnThreads(7));
  EXPECT_EQ(serial.G, other.G);
  EXPECT_EQ(serial.F, other.F);
  EXPECT_NEAR(serial.G[64], 1.0, 1e-3);
}

TEST(DistanceFunctions, ChooseDistancesUpToWhichTheyRise)
{
  const ObservationWindow window = ObservationWindow::Rectangle({ 0.0, 0.0 }, { 30.0, 40.0 });
  EXPECT_DOUBLE_EQ(DefaultNearestDistances(window, 1).Maximum, 25.0);
  EXPECT_DOUBLE_EQ(DefaultNearestDistances(window, 1200).Maximum, std::sqrt(std::log(1e5) / Pi));
}

}
