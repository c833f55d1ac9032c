// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Statistics of surfaces whose moments, slopes, curvatures, depressions and profiles are known in closed form.
#include "Drainage/GroundStatistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

using namespace littoral;

namespace
{

/// Heights of a function of the place [m].
GridSamples Surface(int width, int height, double dx, double dy, const std::function<double(double, double)>& at)
{
  GridSamples heights;
  heights.Width = width;
  heights.Height = height;
  heights.Spacing = { dx, dy };
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      heights.Values.push_back(at(i * dx, j * dy));
    }
  }
  return heights;
}

GroundStatistics Measure(const GridSamples& heights, CellIndex least = 100)
{
  return DescribeGround(heights, BorderOutlets(heights.Width, heights.Height), least);
}

}

/// 0, 0, 0, 4: mean 1, variance 3, third moment 6.
TEST(GroundStatistics, Shape)
{
  const SampleShape shape = ShapeOf({ 0.0, 4.0, 0.0, 0.0 });
  EXPECT_DOUBLE_EQ(shape.Mean, 1.0);
  EXPECT_DOUBLE_EQ(shape.StandardDeviation, std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(shape.Skew, 6.0 / std::pow(3.0, 1.5));
  EXPECT_DOUBLE_EQ(shape.Minimum, 0.0);
  EXPECT_DOUBLE_EQ(shape.Maximum, 4.0);
  EXPECT_TRUE(std::isnan(ShapeOf({ 2.0, 2.0 }).Skew));
}

/// Skew and integral of exponential values: 2, and low; moments far from 0 keep their digits.
TEST(GroundStatistics, ShapeOfALargeSample)
{
  std::mt19937_64 engine(1);
  std::exponential_distribution<double> exponential(0.5);
  std::vector<double> values(400000);
  for (double& value : values)
  {
    value = 8000.0 + exponential(engine);
  }
  const SampleShape shape = ShapeOf(values);
  EXPECT_NEAR(shape.Mean, 8002.0, 4.0 * 2.0 / std::sqrt(4e5));
  EXPECT_NEAR(shape.StandardDeviation, 2.0, 0.02);
  EXPECT_NEAR(shape.Skew, 2.0, 0.08);
}

TEST(GroundStatistics, PlaneHasOneSlope)
{
  const GridSamples plane = Surface(9, 7, 2.0, 5.0, [](double x, double y) { return 0.3 * x - 0.4 * y + 12.0; });
  const std::vector<double> slopes = GradientsOf(plane);
  ASSERT_EQ(slopes.size(), 35u);
  for (const double slope : slopes)
  {
    EXPECT_NEAR(slope, 0.5, 1e-13);
  }
  for (const double curvature : LaplaciansOf(plane))
  {
    EXPECT_NEAR(curvature, 0.0, 1e-13);
  }
}

/// Central differences and the Laplacian are exact for a polynomial of second order.
TEST(GroundStatistics, ParaboloidHasOneCurvature)
{
  const GridSamples bowl =
    Surface(12, 9, 3.0, 4.0, [](double x, double y) { return 0.02 * x * x + 0.005 * y * y - 0.01 * x * y; });
  for (const double curvature : LaplaciansOf(bowl))
  {
    EXPECT_NEAR(curvature, 2.0 * (0.02 + 0.005), 1e-13);
  }
  const std::vector<double> slopes = GradientsOf(bowl);
  for (std::size_t n = 0; n < slopes.size(); ++n)
  {
    const double x = 3.0 * static_cast<double>(n % 10 + 1);
    const double y = 4.0 * static_cast<double>(n / 10 + 1);
    EXPECT_NEAR(slopes[n], std::hypot(0.04 * x - 0.01 * y, 0.01 * y - 0.01 * x), 1e-13);
  }
}

/// Slots have a curvature of positive skew, dykes of negative, and a wave of none.
TEST(GroundStatistics, SkewOfCurvature)
{
  const auto slot = [](double sign) { return [=](double x, double) { return x == 20.0 ? -5.0 * sign : 0.0; }; };
  EXPECT_GT(ShapeOf(LaplaciansOf(Surface(41, 41, 1.0, 1.0, slot(1.0)))).Skew, 1.0);
  EXPECT_LT(ShapeOf(LaplaciansOf(Surface(41, 41, 1.0, 1.0, slot(-1.0)))).Skew, -1.0);
  const GridSamples wave =
    Surface(42, 10, 1.0, 1.0, [](double x, double) { return std::sin(2.0 * 3.14159265358979 * (x - 0.5) / 8.0); });
  EXPECT_NEAR(ShapeOf(LaplaciansOf(wave)).Skew, 0.0, 1e-9);
}

TEST(GroundStatistics, Quantiles)
{
  EXPECT_EQ(EvenQuantiles({ 3.0, 1.0, 2.0, 5.0, 4.0 }, 5), (std::vector<double>{ 1.0, 2.0, 3.0, 4.0, 5.0 }));
  EXPECT_EQ(EvenQuantiles({ 10.0, 0.0 }, 3), (std::vector<double>{ 0.0, 5.0, 10.0 }));
  EXPECT_TRUE(EvenQuantiles({}, 3).empty());
}

TEST(GroundStatistics, SmallGridsTellNoConcavity)
{
  const GridSamples hill = Surface(20, 20, 1.0, 1.0, [](double x, double y) { return x + 0.1 * y; });
  const GroundStatistics ground = Measure(hill);
  EXPECT_TRUE(std::isnan(ground.Measures.Concavity));
  EXPECT_TRUE(std::isnan(ground.Steepness));
  EXPECT_TRUE(std::isnan(ground.Hack));
  EXPECT_TRUE(ground.Streams.empty());
}

TEST(GroundStatistics, HacksLaw)
{
  std::vector<double> lengths;
  std::vector<CellIndex> cells;
  for (CellIndex n = 1; n < 5000; ++n)
  {
    cells.push_back(n);
    lengths.push_back(n < 100 ? 1.0 : 1.7 * std::pow(n, 0.57));
  }
  EXPECT_NEAR(HackExponent(lengths, cells), 0.57, 1e-12);
}

/// A block of 4 x 3 cells sunk by 2 m in a plain: 12 cells, 24 cell metres of fill.
TEST(GroundStatistics, SunkBlock)
{
  const GridSamples plain = Surface(
    16, 10, 3.0, 7.0, [](double x, double y) { return x >= 15.0 && x < 27.0 && y >= 28.0 && y < 49.0 ? 8.0 : 10.0; });
  const GroundStatistics ground = Measure(plain);
  const double share = 12.0 / 160.0;
  EXPECT_DOUBLE_EQ(ground.Measures.DepressionFraction, share);
  EXPECT_NEAR(ground.Measures.RelativeFillDepth, 2.0 * share / (2.0 * std::sqrt(share * (1.0 - share))), 1e-12);
  EXPECT_NEAR(ground.Measures.HypsometricIntegral, 1.0 - share, 1e-12);
}

/// Heights of a ramp are uniform: integral 1/2, no skew; its square has the integral 1/3 and Beta(1/2, 1)'s skew.
TEST(GroundStatistics, Hypsometry)
{
  const GridSamples ramp = Surface(2001, 5, 1.0, 1.0, [](double x, double) { return 300.0 + x; });
  EXPECT_NEAR(Measure(ramp).Measures.HypsometricIntegral, 0.5, 1e-12);
  EXPECT_NEAR(Measure(ramp).Measures.ElevationSkewness, 0.0, 1e-9);
  const GridSamples square = Surface(2001, 5, 1.0, 1.0, [](double x, double) { return x * x; });
  EXPECT_NEAR(Measure(square).Measures.HypsometricIntegral, 1.0 / 3.0, 5e-4);
  EXPECT_NEAR(Measure(square).Measures.ElevationSkewness, 2.0 * std::sqrt(5.0) / 7.0, 2e-3);
}

/// A valley whose floor falls as a stream of a given concavity does, with straight slopes to it: S = k A^-theta.
TEST(GroundStatistics, GradedValley)
{
  constexpr int Width = 31;
  constexpr int Height = 401;
  constexpr double Theta = 0.4;
  std::vector<double> floor{ 0.0 };
  for (int j = 1; j < Height; ++j)
  {
    const double area = static_cast<double>(Width) * (Height - j); // whole rows, from this one up
    floor.push_back(floor.back() + 5.0 * std::pow(area, -Theta));
  }
  const GridSamples valley = Surface(Width, Height, 1.0, 1.0,
    [&](double x, double y) { return floor[static_cast<int>(y)] + 20.0 * std::abs(x - 15.0); });
  GridSamples walled = valley;
  for (int j = 0; j < Height; ++j)
  {
    walled.At(0, j) = walled.At(Width - 1, j) = 1e4;
  }
  OutletMask outlets(walled.Values.size(), 0);
  outlets[15] = 1;
  const GroundStatistics ground = DescribeGround(walled, outlets);
  EXPECT_NEAR(ground.Measures.Concavity, Theta, 1e-3);
  EXPECT_NEAR(ground.Steepness, 5.0, 0.05);
  EXPECT_EQ(ground.Streams.size(), 1u);
  EXPECT_EQ(ground.Streams[0].Streams, 1);
}

/// The relation of slope and area of rough ground, whose pits have slopes below 0, from its definition.
TEST(GroundStatistics, SlopesByArea)
{
  std::mt19937_64 engine(3);
  std::normal_distribution<double> normal;
  const GridSamples rough =
    Surface(160, 120, 2.0, 3.0, [&](double x, double y) { return 0.2 * x + 0.1 * y + normal(engine); });
  const OutletMask outlets = BorderOutlets(160, 120);
  const GroundMeasures measures = MeasureGround(rough, outlets);
  const FlowRouting routing = RouteFlow(rough, outlets);
  const std::vector<CellIndex> cells = FlowAccumulation(routing);
  std::vector<double> counts(20, 0.0);
  std::vector<double> areas(20, 0.0);
  std::vector<double> falls(20, 0.0);
  double sum = 0.0;
  double count = 0.0;
  int pits = 0;
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    const auto receiver = static_cast<std::size_t>(routing.Receiver[n]);
    if (outlets[n] || cells[n] < 100)
    {
      continue;
    }
    const double across = n % 160 == receiver % 160 ? 0.0 : 2.0;
    const double along = n / 160 == receiver / 160 ? 0.0 : 3.0;
    const double slope = (rough.Values[n] - rough.Values[receiver]) / std::hypot(across, along);
    pits += slope < 0.0;
    for (int bin = 0; bin < 20; ++bin)
    {
      const auto edge = [](int k) { return 100.0 * std::pow(1920.0 / 100.0, k / 20.0); };
      if (cells[n] >= edge(bin) && cells[n] < edge(bin + 1))
      {
        counts[bin] += 1.0;
        areas[bin] += cells[n];
        falls[bin] += slope > 0.0 ? slope : 0.0;
      }
    }
    if (cells[n] <= 200 && slope > 0.0)
    {
      sum += slope;
      count += 1.0;
    }
  }
  EXPECT_GT(pits, 50);
  EXPECT_NEAR(measures.ChannelSlope, sum / count, 1e-12);
  std::size_t next = 0;
  for (int bin = 0; bin < 20; ++bin)
  {
    if (falls[bin] > 0.0)
    {
      ASSERT_LT(next, measures.SlopeArea.size());
      const SlopeAreaBin& found = measures.SlopeArea[next++];
      EXPECT_EQ(found.Count, counts[bin]) << bin;
      EXPECT_NEAR(found.Cells, areas[bin] / counts[bin], 1e-9) << bin;
      EXPECT_NEAR(found.Slope, falls[bin] / counts[bin], 1e-12) << bin;
    }
  }
  EXPECT_EQ(next, measures.SlopeArea.size());
  EXPECT_NEAR(measures.CurvatureSkewness, ShapeOf(LaplaciansOf(rough)).Skew, 1e-12);
}

/// A power law is itself between its lags, and there is none beyond them.
TEST(GroundStatistics, SemivarianceBetweenLags)
{
  GroundMeasures measures;
  for (const double lag : { 2.0, 4.0, 10.0, 30.0 })
  {
    measures.Lags.push_back(lag);
    measures.Semivariance.push_back(3.0 * std::pow(lag, 1.3));
  }
  for (const double lag : { 2.0, 2.3, 3.9, 4.0, 7.0, 25.0, 30.0 })
  {
    EXPECT_NEAR(measures.SemivarianceAt(lag), 3.0 * std::pow(lag, 1.3), 1e-12 * 300.0) << lag;
  }
  EXPECT_EQ(measures.SemivarianceAt(0.5), measures.Semivariance.front());
  EXPECT_TRUE(std::isnan(measures.SemivarianceAt(0.0)));
  EXPECT_TRUE(std::isnan(measures.SemivarianceAt(30.1)));
}

/// Threads change no byte.
TEST(GroundStatistics, AnyThreads)
{
  std::mt19937_64 engine(4);
  std::normal_distribution<double> normal;
  const GridSamples rough = Surface(70, 60, 2.0, 2.0, [&](double x, double) { return 0.1 * x + normal(engine); });
  const ParallelFor backwards = [](std::size_t count, const RangeTask& task) {
    for (std::size_t n = count; n-- > 0;)
    {
      task(n, n + 1);
    }
  };
  const OutletMask outlets = BorderOutlets(70, 60);
  const GroundStatistics one = DescribeGround(rough, outlets, 10);
  const GroundStatistics other = DescribeGround(rough, outlets, 10, backwards);
  EXPECT_EQ(one.Measures.Concavity, other.Measures.Concavity);
  EXPECT_EQ(one.Hack, other.Hack);
  EXPECT_EQ(one.Horton.Length, other.Horton.Length);
  EXPECT_EQ(one.Measures.RelativeFillDepth, other.Measures.RelativeFillDepth);
  EXPECT_GT(one.Measures.DepressionFraction, 0.1);
}

/// A frame of missing heights changes no statistic.
TEST(GroundStatistics, MissingHeightsAreLeftOut)
{
  std::mt19937_64 engine(7);
  std::normal_distribution<double> normal;
  const GridSamples rough = Surface(70, 60, 2.0, 3.0, [&](double x, double) { return 0.1 * x + normal(engine); });
  GridSamples framed = rough;
  framed.Width = 90;
  framed.Height = 71;
  framed.Values.assign(static_cast<std::size_t>(framed.Width) * framed.Height, std::nan(""));
  for (int j = 0; j < 60; ++j)
  {
    for (int i = 0; i < 70; ++i)
    {
      framed.At(i + 13, j + 4) = rough.At(i, j);
    }
  }
  const GroundStatistics own = DescribeGround(rough, RimOutlets(rough), 10);
  const GroundStatistics other = DescribeGround(framed, RimOutlets(framed), 10);
  const auto same = [](double a, double b) { EXPECT_NEAR(a, b, 1e-12 * std::abs(a)); };
  same(own.Measures.DepressionFraction, other.Measures.DepressionFraction);
  same(own.Measures.RelativeFillDepth, other.Measures.RelativeFillDepth);
  same(own.Measures.StandardDeviation, other.Measures.StandardDeviation);
  same(own.Measures.HypsometricIntegral, other.Measures.HypsometricIntegral);
  same(own.Measures.ElevationSkewness, other.Measures.ElevationSkewness);
  same(own.Measures.CurvatureSkewness, other.Measures.CurvatureSkewness);
  same(own.Measures.Concavity, other.Measures.Concavity);
  same(own.Measures.MaximumArea, other.Measures.MaximumArea);
  same(own.Measures.ChannelSlope, other.Measures.ChannelSlope);
  same(own.Steepness, other.Steepness);
  same(own.Slopes.Mean, other.Slopes.Mean);
  same(own.Slopes.Skew, other.Slopes.Skew);
  same(own.Curvature.StandardDeviation, other.Curvature.StandardDeviation);
  same(own.Hack, other.Hack);
  same(own.Horton.Length, other.Horton.Length);
  ASSERT_EQ(own.Streams.size(), other.Streams.size());
  for (std::size_t n = 0; n + 1 < own.Measures.Lags.size(); ++n) // the last lag is half the shorter side
  {
    EXPECT_EQ(own.Measures.Lags[n], other.Measures.Lags[n]);
    same(own.Measures.Semivariance[n], other.Measures.Semivariance[n]);
  }
}
