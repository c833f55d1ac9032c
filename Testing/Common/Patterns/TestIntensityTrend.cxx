// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Trends of the intensity: the equations of the likelihood, what was simulated is found again, K and g of weighted
// points.
#include "Numerics/Constants.h"
#include "Patterns/IntensityTrend.h"
#include "Patterns/PairFunctions.h"
#include "Patterns/PatternVerdict.h"
#include "Patterns/ProcessFit.h"
#include "Patterns/ProcessPattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace littoral;

namespace
{

ObservationWindow Wide()
{
  return ObservationWindow::Rectangle({ 3.0, -2.0 }, { 7.0, 0.0 });
}

/// ln intensity = 3 + u - v, over a window of 4 x 2 m.
IntensityTrend Slope()
{
  IntensityTrend trend;
  trend.Degree = 1;
  trend.Coefficients = { 3.0, 1.0, -1.0 };
  return trend;
}

/// Points of a process with a trend, whose mean intensity is that of the trend.
std::vector<PlanePosition> Simulate(
  PointProcessParameters process, const IntensityTrend& trend, const ObservationWindow& window, int seed)
{
  const IntensityRaster raster = RasterOf(trend, window);
  process.Intensity = raster.Mean();
  ProcessOptions options;
  options.Seed = seed;
  options.Raster = &raster;
  return SimulateProcess(process, options, window).Points;
}

}

// The integral of exp(3 + u - v) is 8 exp(3) sinh(1)^2 on 8 m2, and its value at a corner exp(3 + 1 + 1).
TEST(IntensityTrend, IsAnExponentialOfAPolynomial)
{
  EXPECT_NEAR(Slope().At(Wide(), { 5.0, -1.0 }), std::exp(3.0), 1e-12);
  EXPECT_NEAR(Slope().At(Wide(), { 7.0, -2.0 }), std::exp(5.0), 1e-9);
  const double mean = std::exp(3.0) * std::sinh(1.0) * std::sinh(1.0);
  const IntensityRaster raster = RasterOf(Slope(), Wide());
  EXPECT_EQ(WhyInvalid(raster), "");
  EXPECT_NEAR(raster.Mean(), mean, 1e-4 * mean);
  EXPECT_NEAR(raster.Values[static_cast<std::size_t>(raster.CellOf(6.99, -1.99))], std::exp(5.0), 0.02 * std::exp(5.0));
  IntensityTrend cubic;
  cubic.Degree = 3;
  cubic.Coefficients = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0 }; // u^2 v
  EXPECT_NEAR(cubic.At(Wide(), { 6.0, -0.5 }), std::exp(0.5 * 0.5 * 0.5), 1e-12);
}

// At the maximum, sums over the points of the terms are the integrals of these with the intensity, here of 400 x 400
// places and in a polygon too; the number of points is the integral of the intensity.
TEST(IntensityTrend, MeetsTheEquationsOfTheLikelihood)
{
  const ObservationWindow triangle = ObservationWindow::Polygon({ { 3.0, -2.0 }, { 7.0, -2.0 }, { 3.0, 0.0 } });
  for (const ObservationWindow& window : { Wide(), triangle })
  {
    PointProcessParameters random;
    random.Process = PointProcess::Poisson;
    const std::vector<PlanePosition> points = Simulate(random, Slope(), window, 5);
    for (const int degree : { 1, 2, 3 })
    {
      const IntensityTrend trend = FitTrend(points, window, degree);
      ASSERT_TRUE(trend.Exists());
      double integrals[3] = { 0.0, 0.0, 0.0 };
      const int steps = 400;
      for (int n = 0; n < steps * steps; ++n)
      {
        const int row = n / steps;
        const PlanePosition place = { 3.0 + 4.0 * (n % steps + 0.5) / steps, -2.0 + 2.0 * (row + 0.5) / steps };
        const double expected = window.Contains(place) ? 8.0 / (steps * steps) * trend.At(window, place) : 0.0;
        integrals[0] += expected;
        integrals[1] += expected * place[0];
        integrals[2] += expected * place[0] * place[1];
      }
      double sums[3] = { static_cast<double>(points.size()), 0.0, 0.0 };
      for (const PlanePosition& point : points)
      {
        sums[1] += point[0];
        sums[2] += point[0] * point[1];
      }
      EXPECT_NEAR(integrals[0], sums[0], 0.005 * sums[0]) << degree;
      EXPECT_NEAR(integrals[1], sums[1], 0.005 * sums[1]) << degree;
      if (degree > 1)
      {
        EXPECT_NEAR(integrals[2], sums[2], 0.005 * std::abs(sums[2])) << degree;
      }
    }
  }
}

// Of random points, and of clusters, of which it is a composite likelihood: means of 100 fits within three standard
// errors. With the intensity of the window, clusters keep their size where the intensity is the mean one.
TEST(IntensityTrend, WhatWasSimulatedIsFoundAgain)
{
  PointProcessParameters process;
  process.ClusterSize = 4.0;
  process.ClusterScale = 0.04;
  for (const PointProcess id : { PointProcess::Poisson, PointProcess::Thomas })
  {
    process.Process = id;
    constexpr int seeds = 300;
    double sums[3] = {};
    double squares[3] = {};
    for (int seed = 1; seed <= seeds; ++seed)
    {
      const IntensityTrend found = FitTrend(Simulate(process, Slope(), Wide(), seed), Wide(), 1);
      ASSERT_TRUE(found.Exists());
      for (int term = 1; term < 3; ++term)
      {
        sums[term] += found.Coefficients[static_cast<std::size_t>(term)];
        squares[term] += std::pow(found.Coefficients[static_cast<std::size_t>(term)], 2);
      }
    }
    for (int term = 1; term < 3; ++term)
    {
      const double mean = sums[term] / seeds;
      const double error = std::sqrt((squares[term] / seeds - mean * mean) / (seeds - 1));
      EXPECT_NEAR(mean, term == 1 ? 1.0 : -1.0, 3.0 * error) << PointProcessName(id);
      EXPECT_LT(error, 0.03); // the test sees 10 %
    }
  }
}

// K of random points with a trend, weighted by 1 / intensity, is pi r^2, and g is 1, where those of the same points
// without weights are larger; equal weights change nothing.
TEST(IntensityTrend, WeightsTakeTheTrendOutOfPairs)
{
  PointProcessParameters random;
  random.Process = PointProcess::Poisson;
  PairOptions options;
  options.Distances = { 0.4, 8 };
  constexpr int seeds = 100;
  for (const EdgeCorrection correction : { EdgeCorrection::Isotropic, EdgeCorrection::Translation })
  {
    options.Correction = correction;
    double k = 0.0;
    double squares = 0.0;
    double g = 0.0;
    double unweighted = 0.0;
    for (int seed = 1; seed <= seeds; ++seed)
    {
      const std::vector<PlanePosition> points = Simulate(random, Slope(), Wide(), seed);
      options.Weights.clear();
      unweighted += FindPairFunctions(points, Wide(), options).K[8] / seeds;
      for (const PlanePosition& point : points)
      {
        options.Weights.push_back(1.0 / Slope().At(Wide(), point));
      }
      const PairFunctions functions = FindPairFunctions(points, Wide(), options);
      k += functions.K[8] / seeds;
      squares += functions.K[8] * functions.K[8] / seeds;
      g += functions.PairCorrelation[6] / seeds;
    }
    const double random4 = Pi * 0.4 * 0.4;
    const double error = std::sqrt((squares - k * k) / (seeds - 1));
    EXPECT_NEAR(k, random4, 3.0 * error);
    EXPECT_LT(error, 0.02 * random4);
    EXPECT_NEAR(g, 1.0, 0.05);
    EXPECT_GT(unweighted, 1.2 * random4);
  }
  const std::vector<PlanePosition> points = Simulate(random, Slope(), Wide(), 1);
  options.Weights.clear();
  const PairFunctions plain = FindPairFunctions(points, Wide(), options);
  options.Weights.assign(points.size(), 7.0);
  const PairFunctions equal = FindPairFunctions(points, Wide(), options);
  for (std::size_t step = 1; step < plain.K.size(); ++step)
  {
    EXPECT_NEAR(equal.K[step], plain.K[step], 1e-12);
    EXPECT_NEAR(equal.PairCorrelation[step], plain.PairCorrelation[step], 1e-9);
  }
}

// The clusters of a process with a trend are found, where the trend alone would be taken for clusters without it.
TEST(IntensityTrend, ClustersAreFoundUnderATrend)
{
  PointProcessParameters thomas;
  thomas.Process = PointProcess::Thomas;
  thomas.ClusterSize = 5.0;
  thomas.ClusterScale = 0.04;
  IntensityTrend steep = Slope();
  steep.Coefficients = { 4.0, 1.0, -1.0 };
  constexpr int seeds = 30;
  double size[2] = { 0.0, 0.0 };
  for (int seed = 1; seed <= seeds; ++seed)
  {
    const std::vector<PlanePosition> points = Simulate(thomas, steep, Wide(), seed);
    for (const int degree : { 0, 1 })
    {
      ContrastOptions options;
      options.TrendDegree = degree;
      const ProcessFit fit = FitProcess(PointProcess::Thomas, points, Wide(), options);
      ASSERT_TRUE(fit.Exists);
      EXPECT_EQ(fit.Trend.Exists(), degree > 0);
      size[degree] += std::log(fit.Process.ClusterSize / 5.0) / seeds;
    }
  }
  EXPECT_NEAR(size[1], 0.0, 0.15);
  EXPECT_GT(size[0], 1.0);
}

// Matern's points that are thinned by a trend have their distance still, and the trend of the points that are left.
TEST(IntensityTrend, PointsAtADistanceHaveATrend)
{
  PointProcessParameters inhibited;
  inhibited.Process = PointProcess::MaternII;
  inhibited.Distance = 0.04;
  const std::vector<PlanePosition> points = Simulate(inhibited, Slope(), Wide(), 4);
  ContrastOptions options;
  options.TrendDegree = 1;
  const ProcessFit fit = FitProcess(PointProcess::MaternII, points, Wide(), options);
  ASSERT_TRUE(fit.Exists);
  EXPECT_EQ(fit.Trend.Coefficients, FitTrend(points, Wide(), 1).Coefficients);
  EXPECT_NEAR(fit.Process.Distance, 0.04, 0.002);
  // Regrown with it, and judged.
  VerdictOptions verdict;
  verdict.Simulations = 39;
  verdict.Contrast.TrendDegree = 1;
  const PatternJudgement judgement = JudgePattern(points, Wide(), verdict);
  const auto row = std::find_if(judgement.Laws.begin(), judgement.Laws.end(),
    [](const JudgedLaw& law) { return law.IsProcess && law.Process.Process.Process == PointProcess::MaternII; });
  EXPECT_TRUE(row->Process.Trend.Exists());
  EXPECT_FALSE(row->Envelope.IsRejected) << row->Envelope.PValue;
  verdict.Contrast.TrendDegree = 0;
  for (const JudgedLaw& law : JudgePattern(points, Wide(), verdict).Laws)
  {
    EXPECT_FALSE(law.Process.Trend.Exists());
    EXPECT_TRUE(!law.Exists() || law.Envelope.IsRejected || law.Process.Process.Process != PointProcess::MaternII);
  }
}

// Fewer points than coefficients, and points on a line, have no trend; neither have Strauss processes and soft cores.
TEST(IntensityTrend, WhatHasNoTrend)
{
  const ObservationWindow window;
  EXPECT_FALSE(FitTrend({ { 0.1, 0.2 }, { 0.5, 0.7 }, { 0.6, 0.1 }, { 0.9, 0.8 }, { 0.3, 0.4 } }, window, 2).Exists());
  std::vector<PlanePosition> line;
  std::vector<PlanePosition> even;
  for (int n = 0; n < 100; ++n)
  {
    line.push_back({ 0.005 + 0.01 * n, 0.25 });
    const int row = n / 10;
    even.push_back({ 0.05 + 0.1 * (n % 10), 0.05 + 0.1 * row });
  }
  EXPECT_FALSE(FitTrend(line, window, 2).Exists());
  ContrastOptions options;
  options.TrendDegree = 2;
  EXPECT_FALSE(FitProcess(PointProcess::Poisson, line, window, options).Exists);
  EXPECT_FALSE(FitProcess(PointProcess::Thomas, line, window, options).Exists);
  EXPECT_FALSE(FitProcess(PointProcess::MaternII, line, window, options).Exists);
  EXPECT_FALSE(FitProcess(PointProcess::Strauss, even, window, options).Trend.Exists());
  EXPECT_FALSE(FitProcess(PointProcess::SoftCore, even, window, options).Trend.Exists());
  const IntensityTrend level = FitTrend(even, window, 2);
  // Of a lattice of 10 x 10 points, u^2 has the mean 0.33 in place of 1/3, hence a coefficient of -0.0033 / (4 / 45).
  EXPECT_NEAR(level.At(window, { 0.5, 0.5 }), 100.0 * (1.0 + 2.0 / 3.0 * 0.0375), 0.1);
  options.TrendDegree = 4;
  EXPECT_NE(WhyInvalid(options).find("TrendDegree"), std::string::npos);
  options.TrendDegree = 1;
  options.Correction = EdgeCorrection::Border;
  EXPECT_NE(WhyInvalid(options).find("border"), std::string::npos);
}
