// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "Drainage/ChannelGrading.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/DrainageCarving.h"
#include "Drainage/SemivarianceBands.h"
#include "Drainage/StreamPower.h"
#include "Drainage/ValleySpreading.h"
#include "Numerics/Constants.h"
#include "RandomGround.h"
#include "RiverGround.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

using namespace littoral;
using namespace littoral::testing;

namespace
{

GridSamples NormalNoise(int width, int height, std::array<double, 2> spacing, int seed)
{
  const RandomStream random(seed, RandomPurpose::ElevationLines);
  int n = 0;
  return Ground(width, height, spacing, [&](double, double) { return random.NormalPair(n++, 0)[0]; });
}

/// A place with valleys: rough ground that rises under rivers of a concavity.
GridSamples RiverGround(int width, int height, double concavity, int seed)
{
  GridSamples ground = RandomGround(width, height, { 50.0, 50.0 }, seed);
  StreamPowerLaw law;
  law.AreaExponent = concavity;
  law.Erodibility = 1e-4;
  GrowByStreamPower(ground, BorderOutlets(width, height), law, 4e6, 40);
  return ground;
}

/// Gaussian ground with the spectrum and the plane of a place.
GridSamples TwinOf(const GridSamples& place, const CarvingTarget& target, int seed)
{
  GridSamples twin = NormalNoise(place.Width, place.Height, place.Spacing, seed);
  std::vector<double> sizes;
  for (const double power : target.Spectrum.Power)
  {
    sizes.push_back(std::sqrt(power / (place.Spacing[0] * place.Spacing[1])));
  }
  MultiplyRings(twin, target.Spectrum.Step, sizes);
  InverseCosineTransform(twin);
  return twin;
}

double SumOfSquares(const GridSamples& grid)
{
  double sum = 0.0;
  for (const double value : grid.Values)
  {
    sum += value * value;
  }
  return sum;
}

}

TEST(RingSpectrum, TheCosineTransformIsOrthonormal)
{
  for (const auto& size : { std::array<int, 2>{ 13, 9 }, { 16, 24 }, { 31, 7 } })
  {
    const GridSamples noise = NormalNoise(size[0], size[1], { 1.0, 1.0 }, 3);
    GridSamples coefficients = noise;
    CosineTransform(coefficients);
    EXPECT_NEAR(SumOfSquares(coefficients), SumOfSquares(noise), 1e-10 * SumOfSquares(noise));
    // by its definition at one wave number
    const int p = 3;
    const int q = 2;
    double sum = 0.0;
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        sum += noise.At(i, j) * std::cos(Pi * p * (i + 0.5) / size[0]) * std::cos(Pi * q * (j + 0.5) / size[1]);
      }
    }
    EXPECT_NEAR(coefficients.At(p, q), 2.0 * sum / std::sqrt(1.0 * size[0] * size[1]), 1e-10);
    InverseCosineTransform(coefficients, OnThreads(3));
    for (std::size_t n = 0; n < noise.Values.size(); ++n)
    {
      EXPECT_NEAR(coefficients.Values[n], noise.Values[n], 1e-12);
    }
  }
}

TEST(RingSpectrum, WhiteNoiseHasOnePower)
{
  GridSamples noise = NormalNoise(96, 80, { 2.0, 3.0 }, 5);
  CosineTransform(noise);
  const RingSpectrum spectrum = SpectrumOfCoefficients(noise);
  EXPECT_DOUBLE_EQ(spectrum.Step, 0.5 / 192.0);
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t ring = 20; ring < spectrum.Power.size() - 20; ++ring)
  {
    sum += spectrum.Power[ring];
    count += 1.0;
  }
  EXPECT_NEAR(sum / count, 6.0, 0.3); // variance times the area of a cell
  EXPECT_EQ(spectrum.Power, SpectrumOfCoefficients(noise, OnThreads(3)).Power);
}

TEST(RingSpectrum, GainsOfRingsMultiplyTheirPower)
{
  GridSamples noise = NormalNoise(40, 50, { 2.0, 2.0 }, 5);
  const RingSpectrum before = SpectrumOfCoefficients(noise);
  MultiplyRings(noise, before.Step, std::vector<double>(before.Power.size(), 1.5));
  const RingSpectrum after = SpectrumOfCoefficients(noise);
  for (std::size_t ring = 0; ring < before.Power.size(); ++ring)
  {
    EXPECT_NEAR(after.Power[ring], 2.25 * before.Power[ring], 1e-12 + 1e-12 * before.Power[ring]);
  }
}

TEST(SemivarianceBands, AWaveOrAPlaneAloneHasItsOwnSemivariance)
{
  const double step = 0.5 / 66.0;
  for (const auto& wave : { std::array<int, 2>{ 1, 0 }, { 0, 2 }, { 2, 1 }, { 5, 3 }, { 0, 11 } })
  {
    GridSamples coefficients = Ground(40, 22, { 2.0, 3.0 }, [](double, double) { return 0.0; });
    coefficients.At(wave[0], wave[1]) = 7.0;
    const SemivarianceBands bands(coefficients, step, 60, {}, OnThreads(3));
    GridSamples field = coefficients;
    InverseCosineTransform(field);
    const std::vector<int> lags = SemivarianceLags(40, 22);
    const std::vector<double> semivariance = SemivarianceAlongAxes(field, lags);
    double variance = 0.0;
    for (std::size_t band = 0; band < bands.Count(); ++band)
    {
      variance += bands.VarianceOf(band);
    }
    EXPECT_NEAR(variance, SumOfSquares(field) / 880.0, 1e-12);
    for (std::size_t n = 0; n < lags.size(); ++n)
    {
      double sum = 0.0;
      for (std::size_t band = 0; band < bands.Count(); ++band)
      {
        sum += bands.PartOf(band, lags[n]);
      }
      EXPECT_NEAR(sum, semivariance[n], 1e-12) << wave[0] << " " << wave[1] << " " << lags[n];
    }
  }
  const GridSamples none = Ground(40, 22, { 2.0, 3.0 }, [](double, double) { return 0.0; });
  GridSamples plane = Ground(40, 22, { 2.0, 3.0 }, [](double x, double y) { return 0.3 * x - 0.1 * y; });
  const double semivariance = SemivarianceAlongAxes(plane, { 5 })[0];
  const double variance = Moments(plane).Variance;
  const SemivarianceBands bands(none, step, 60, RemovePlane(plane));
  EXPECT_NEAR(bands.PartOf(bands.Count() - 1, 5), semivariance, 1e-12);
  EXPECT_NEAR(bands.VarianceOf(bands.Count() - 1), variance, 1e-10);
}

TEST(SemivarianceBands, GainsGiveBackWhatAChangeOfPowerTook)
{
  const GridSamples field = NormalNoise(48, 48, { 1.0, 1.0 }, 4);
  const std::vector<int> lags = SemivarianceLags(48, 48);
  const double step = 0.5 / 48.0;
  GridSamples changed = field;
  CosineTransform(changed);
  std::vector<double> less(68, 1.0);
  std::fill(less.begin() + 30, less.end(), 0.9);
  MultiplyRings(changed, step, less);
  const SemivarianceBands bands(changed, step, less.size(), {});
  InverseCosineTransform(changed);
  // Against variance, so that the heights' own does not matter.
  const std::vector<double> before = SemivarianceAlongAxes(field, lags);
  const std::vector<double> after = SemivarianceAlongAxes(changed, lags);
  const double scale = SumOfSquares(changed) / SumOfSquares(field);
  std::vector<double> wanted;
  for (std::size_t n = 0; n < lags.size(); ++n)
  {
    wanted.push_back(before[n] * scale / after[n]);
  }
  const BandGains gains = bands.GainsFor(lags, wanted);
  EXPECT_GT(gains.Rings[55], gains.Rings[10]);
  for (const double gain : bands.GainsFor(lags, std::vector<double>(lags.size(), 1.0)).Rings)
  {
    EXPECT_EQ(gain, 1.0);
  }
  for (const double gain : bands.GainsFor(lags, std::vector<double>(lags.size(), std::nan(""))).Rings)
  {
    EXPECT_EQ(gain, 1.0); // no lag in common
  }
}

TEST(HeightQuantiles, RanksTakeTheTargetsHeights)
{
  const GridSamples place = RandomGround(20, 15, { 1.0, 1.0 }, 2);
  GridSamples ground = NormalNoise(20, 15, { 1.0, 1.0 }, 9);
  const std::vector<double> before = ground.Values;
  MapQuantiles(ground.Values, QuantilesOf(place.Values));
  std::vector<double> sorted = place.Values;
  std::vector<double> mapped = ground.Values;
  std::sort(sorted.begin(), sorted.end());
  std::sort(mapped.begin(), mapped.end());
  for (std::size_t n = 0; n < sorted.size(); ++n)
  {
    EXPECT_NEAR(mapped[n], sorted[n], 1e-9);
  }
  for (std::size_t n = 1; n < before.size(); ++n)
  {
    EXPECT_EQ(before[n] < before[0], ground.Values[n] < ground.Values[0]);
  }
}

TEST(HeightQuantiles, WholeMetresMakeNoSteps)
{
  std::vector<double> heights;
  heights.reserve(1000);
  for (int n = 0; n < 1000; ++n)
  {
    heights.push_back(std::floor(0.01 * n));
  }
  const HeightQuantiles quantiles = QuantilesOf(heights);
  std::vector<double> mapped(heights.size(), 5.0); // all equal: by their index
  MapQuantiles(mapped, quantiles, OnThreads(2));
  for (std::size_t n = 1; n < mapped.size(); ++n)
  {
    EXPECT_GT(mapped[n], mapped[n - 1]);
  }
  EXPECT_NEAR(mapped[500], 4.505, 1e-9); // the middle of 4 m is at rank 450, that of 5 m at 550
}

TEST(HeightQuantiles, LognormalHasTheGivenNumbers)
{
  for (const auto& [integral, skew] : { std::array<double, 2>{ 0.36, 0.6 }, { 0.5, 0.0 }, { 0.62, -0.4 } })
  {
    const HeightQuantiles quantiles = LognormalQuantiles(300.0, 20.0, integral, skew);
    const int count = 200000;
    double mean = 0.0;
    for (int n = 0; n < count; ++n)
    {
      mean += quantiles.At((n + 0.5) / count) / count;
    }
    double second = 0.0;
    double third = 0.0;
    for (int n = 0; n < count; ++n)
    {
      const double less = quantiles.At((n + 0.5) / count) - mean;
      second += less * less / count;
      third += less * less * less / count;
    }
    const double low = quantiles.Heights.front();
    const double high = quantiles.Heights.back();
    EXPECT_NEAR(mean, 300.0, 0.02);
    EXPECT_NEAR(std::sqrt(second), 20.0, 0.05);
    EXPECT_NEAR(third / std::pow(second, 1.5), skew, 0.01);
    EXPECT_NEAR((mean - low) / (high - low), integral, 0.002);
  }
}

// Ground upside down has the opposite skew, and what is above its mean was below it.
TEST(HeightQuantiles, IntegralsOfANegativeSkewAreThoseOfGroundUpsideDown)
{
  for (const double skew : { 0.3, 1.0 })
  {
    const auto [least, most] = HypsometricIntegralRange(skew);
    const auto [mirroredLeast, mirroredMost] = HypsometricIntegralRange(-skew);
    EXPECT_LT(least, most);
    EXPECT_LT(most, 0.5);
    EXPECT_DOUBLE_EQ(mirroredLeast, 1.0 - most);
    EXPECT_DOUBLE_EQ(mirroredMost, 1.0 - least);
  }
}

// Borders are mirrors: nothing is lost there.
TEST(ValleySpreading, KeepsTheSum)
{
  for (const double deviation : { 0.6, 2.5, 6.0 })
  {
    const GridSamples noise = RandomGround(14, 9, { 1.0, 1.0 }, 3);
    std::vector<double> smooth = noise.Values;
    SmoothGrid(smooth, 14, 9, deviation);
    const double sum = std::accumulate(noise.Values.begin(), noise.Values.end(), 0.0);
    EXPECT_NEAR(std::accumulate(smooth.begin(), smooth.end(), 0.0), sum, 1e-12 * sum);
  }
}

TEST(ValleySpreading, SmoothsByAGaussFunction)
{
  for (const double deviation : { 0.5, 1.0, 3.0, 4.7 })
  {
    std::vector<double> values(61 * 61, 0.0);
    values[30 * 61 + 30] = 1.0;
    SmoothGrid(values, 61, 61, deviation);
    double sum = 0.0;
    double along = 0.0;
    double across = 0.0;
    for (int j = 0; j < 61; ++j)
    {
      for (int i = 0; i < 61; ++i)
      {
        sum += values[j * 61 + i];
        along += values[j * 61 + i] * (i - 30) * (i - 30);
        across += values[j * 61 + i] * (j - 30) * (j - 30);
      }
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_NEAR(along, deviation * deviation, 1e-9);
    EXPECT_NEAR(across, deviation * deviation, 1e-9);
  }
}

TEST(ValleySpreading, AValleyKeepsItsFloorAndFades)
{
  std::vector<double> changes(81 * 40, 99.0);
  std::vector<double> weights(changes.size(), 0.0);
  for (int j = 0; j < 40; ++j)
  {
    changes[j * 81 + 40] = -7.0;
    weights[j * 81 + 40] = 1.0;
  }
  SpreadChanges(changes, weights, 81, 40, 3.0);
  const double* row = &changes[20 * 81];
  EXPECT_NEAR(row[40], -7.0, 1e-9);
  EXPECT_NEAR(row[43], -7.0, 1e-9); // a floor as wide as the valley
  EXPECT_NEAR(row[34], row[46], 1e-9);
  EXPECT_GT(row[50], -3.5);
  EXPECT_NEAR(row[60], 0.0, 1e-9);
}

// Where a Gauss function is 0.3 and 0.15 of its height, x = 1.55 and 1.95; three moving averages, 1.62 and 2.02.
TEST(ValleySpreading, WidthsOfAValley)
{
  constexpr int Width = 401;
  for (const double deviation : { 6.0, 20.0 })
  {
    std::vector<double> changes(Width, -1.0);
    std::vector<double> weights(Width, 0.0);
    weights[Width / 2] = 1.0;
    SpreadChanges(changes, weights, Width, 1, deviation);
    const auto below = [&](double depth) {
      return static_cast<double>(
        std::count_if(changes.begin(), changes.end(), [=](double change) { return change < -depth; }));
    };
    EXPECT_NEAR(below(0.999) / deviation, 3.2, 1.5 / deviation);
    EXPECT_NEAR(below(0.5) / deviation, 4.0, 1.5 / deviation);
  }
}

TEST(GroundMeasures, OfAPlane)
{
  const GridSamples plane = Ground(41, 31, { 2.0, 2.0 }, [](double x, double) { return 0.3 * x; });
  const GroundMeasures measures = MeasureGround(plane, BorderOutlets(41, 31));
  EXPECT_EQ(measures.DepressionFraction, 0.0);
  EXPECT_NEAR(measures.HypsometricIntegral, 0.5, 1e-12);
  EXPECT_NEAR(measures.ElevationSkewness, 0.0, 1e-9);
  EXPECT_NEAR(measures.Highest - measures.Lowest, 24.0, 1e-12);
  // half the square of 0.6 k for the pairs along x, 0 for those along y
  ASSERT_EQ(measures.Lags[4], 10.0);
  const double along = 36.0 * 31.0;
  const double across = 41.0 * 26.0;
  EXPECT_NEAR(measures.SemivarianceAt(10.0), 0.5 * 9.0 * along / (along + across), 1e-9);
  EXPECT_TRUE(std::isnan(measures.SemivarianceAt(1e4)));
}

TEST(GroundMeasures, FindsTheConcavityOfRivers)
{
  for (const double concavity : { 0.35, 0.5 })
  {
    const GridSamples ground = RiverGround(96, 80, concavity, 1);
    EXPECT_NEAR(MeasureGround(ground, BorderOutlets(96, 80)).Concavity, concavity, 0.03);
  }
}

TEST(GroundMeasures, TheConcavityEndsAtAnAreaThatIsAskedFor)
{
  const GridSamples ground = RiverGround(160, 140, 0.4, 1);
  const OutletMask outlets = BorderOutlets(160, 140);
  const double cell = 50.0 * 50.0;
  const GroundMeasures whole = MeasureGround(ground, outlets);
  EXPECT_DOUBLE_EQ(whole.MaximumArea, 2240.0 * cell);
  const GroundMeasures part = MeasureGround(ground, outlets, SerialFor, NoPoll, 1500.0 * cell);
  EXPECT_DOUBLE_EQ(part.MaximumArea, 1500.0 * cell);
  ASSERT_FALSE(part.SlopeArea.empty());
  EXPECT_LT(part.SlopeArea.back().Cells, 1500.0);
  EXPECT_GT(whole.SlopeArea.back().Cells, 1500.0);
  EXPECT_NEAR(part.Concavity, 0.4, 0.05);
  const GroundMeasures same = MeasureGround(ground, outlets, SerialFor, NoPoll, whole.MaximumArea);
  EXPECT_EQ(same.Concavity, whole.Concavity);
  const GroundMeasures none = MeasureGround(ground, outlets, SerialFor, NoPoll, 900.0 * cell); // less than a decade
  EXPECT_TRUE(std::isnan(none.Concavity) && none.SlopeArea.empty());
}

TEST(ChannelLaw, FallsFasterBeyondTheAreasThatAreKnown)
{
  ChannelLaw law;
  law.Steepness = 0.02;
  law.Concavity = 0.5;
  EXPECT_DOUBLE_EQ(law.SlopeAt(100.0), 0.02);
  EXPECT_DOUBLE_EQ(law.SlopeAt(1e4), 0.002);
  EXPECT_DOUBLE_EQ(law.SlopeAt(10.0), 0.1 * law.SlopeAt(50.0));
  law.MaximumCells = 2500.0;
  EXPECT_DOUBLE_EQ(law.SlopeAt(2500.0), 0.004);
  EXPECT_DOUBLE_EQ(law.SlopeAt(1e4), 0.0005); // and a fourth of it
}

TEST(GroundMeasures, CountsWhatIsSunk)
{
  GridSamples ground = Ground(12, 10, { 2.0, 3.0 }, [](double, double) { return 5.0; });
  ground.At(4, 4) = 1.0;
  ground.At(5, 4) = 2.0;
  const GroundMeasures measures = MeasureGround(ground, BorderOutlets(12, 10));
  EXPECT_DOUBLE_EQ(measures.DepressionFraction, 2.0 / 120.0);
  EXPECT_NEAR(measures.RelativeFillDepth, 7.0 / 120.0 / measures.StandardDeviation, 1e-12);
}

TEST(DrainageCarving, MeetsThePlacesMeasures)
{
  const GridSamples place = RiverGround(128, 112, 0.4, 7);
  const CarvingTarget target = TargetOf(place);
  for (int seed = 1; seed <= 3; ++seed)
  {
    GridSamples twin = TwinOf(place, target, seed);
    const CarvingReport report = CarveDrainage(twin, target, {});
    EXPECT_GT(report.Before.DepressionFraction, 0.05) << seed;
    EXPECT_TRUE(report.HasConverged) << seed << ": " << report.UnmetTargets;
    // The report is of the ground that is given back.
    const GroundMeasures measures = MeasureGround(twin, BorderOutlets(128, 112));
    EXPECT_EQ(measures.DepressionFraction, 0.0);
    EXPECT_NEAR(measures.HypsometricIntegral, target.Measures.HypsometricIntegral, 0.03);
    EXPECT_NEAR(measures.ElevationSkewness, target.Measures.ElevationSkewness, 0.15);
    EXPECT_NEAR(measures.Concavity, target.Measures.Concavity, 0.1);
    EXPECT_LT(std::abs(measures.CurvatureSkewness), 1.0);
    for (std::size_t n = 0; n < measures.Lags.size(); ++n)
    {
      EXPECT_NEAR(measures.Semivariance[n] / target.Measures.Semivariance[n], 1.0, 0.1) << seed << " " << n;
    }
    EXPECT_EQ(Misfit(measures, target), Misfit(report.After, target));
  }
}

TEST(DrainageCarving, GroundMuchLargerThanItsPlaceDrainsWithThePlacesHeights)
{
  // 25 times the area: carved at a quarter and half the resolution before
  const GridSamples place = RiverGround(112, 104, 0.4, 7);
  const CarvingTarget target = TargetOf(place);
  GridSamples wide = NormalNoise(560, 520, place.Spacing, 3);
  std::vector<double> sizes(800);
  const double step = 0.5 / (520 * place.Spacing[1]);
  for (std::size_t ring = 0; ring < sizes.size(); ++ring)
  {
    sizes[ring] = std::sqrt(target.Spectrum.At(static_cast<double>(ring) * step) / target.CellArea);
  }
  MultiplyRings(wide, step, sizes);
  InverseCosineTransform(wide);
  CarvingParameters parameters;
  parameters.MaximumIterations = 2;
  const CarvingReport report = CarveDrainage(wide, target, parameters, OnThreads(2));
  EXPECT_GT(report.Before.DepressionFraction, 0.05);
  EXPECT_EQ(report.After.DepressionFraction, 0.0);
  EXPECT_NEAR(report.After.HypsometricIntegral, target.Measures.HypsometricIntegral, 0.03);
  EXPECT_NEAR(report.After.ElevationSkewness, target.Measures.ElevationSkewness, 0.15);
  EXPECT_LT(std::abs(report.After.CurvatureSkewness), 1.0);
  EXPECT_DOUBLE_EQ(report.After.MaximumArea, target.Measures.MaximumArea); // the concavity of the place's own areas
}

TEST(DrainageCarving, TargetsInNumbers)
{
  GridSamples place = RiverGround(96, 80, 0.4, 3);
  GridSamples terrain = TwinOf(place, TargetOf(place), 2);
  TargetStatistics numbers;
  numbers.KeepsHypsometry = false;
  numbers.HypsometricIntegral = 0.38;
  numbers.ElevationSkewness = 0.5;
  const CarvingTarget target = TargetOf(terrain, numbers);
  CarvingParameters parameters;
  parameters.MaximumIterations = 2;
  CarveDrainage(terrain, target, parameters);
  const GroundMeasures measures = MeasureGround(terrain, BorderOutlets(96, 80));
  EXPECT_EQ(measures.DepressionFraction, 0.0);
  EXPECT_NEAR(measures.HypsometricIntegral, 0.38, 0.01);
  EXPECT_NEAR(measures.ElevationSkewness, 0.5, 0.05);
}

TEST(DrainageCarving, OutletsAtTheSeaAndChosenOnes)
{
  const GridSamples place = RiverGround(64, 56, 0.4, 3);
  for (const OutletChoice choice : { OutletChoice::SeaLevel, OutletChoice::Chosen })
  {
    CarvingParameters parameters;
    parameters.MaximumIterations = 2;
    parameters.Outlets.Choice = choice;
    const GroundMeasures own = MeasureGround(place, BorderOutlets(64, 56));
    parameters.Outlets.SeaLevel = own.Lowest + 0.2 * (own.Highest - own.Lowest);
    parameters.Outlets.Cells.assign(place.Values.size(), 0);
    parameters.Outlets.Cells[30] = 1;
    const CarvingTarget target = TargetOf(place, parameters.Outlets);
    GridSamples twin = TwinOf(place, target, 4);
    EXPECT_EQ(WhyInvalid(twin, parameters), "");
    CarveDrainage(twin, target, parameters);
    EXPECT_EQ(FloodDepressions(twin, parameters.Outlets.Of(twin)).DepressionCells, 0u);
  }
}

TEST(DrainageCarving, SameForAnyThreads)
{
  const GridSamples place = RiverGround(64, 56, 0.4, 3);
  const CarvingTarget target = TargetOf(place);
  GridSamples one = TwinOf(place, target, 6);
  GridSamples three = one;
  CarvingParameters parameters;
  parameters.MaximumIterations = 2;
  CarveDrainage(one, target, parameters);
  CarveDrainage(three, TargetOf(place, {}, OnThreads(3)), parameters, OnThreads(3));
  EXPECT_EQ(one.Values, three.Values);
}

TEST(DrainageCarving, ReportsProgressAndEndsWhenAsked)
{
  const GridSamples place = RiverGround(64, 56, 0.4, 3);
  const CarvingTarget target = TargetOf(place);
  GridSamples twin = TwinOf(place, target, 6);
  GridSamples other = twin;
  double last = 0.0;
  CarveDrainage(twin, target, {}, SerialFor, [&](double done) {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1.0);
    last = done;
  });
  EXPECT_EQ(last, 1.0);
  const auto stop = [](double done) {
    if (done > 0.2)
    {
      throw std::runtime_error("enough");
    }
  };
  EXPECT_THROW(CarveDrainage(other, target, {}, SerialFor, stop), std::runtime_error);
}

TEST(DrainageCarving, AnotherGridMaySetTheTarget)
{
  const GridSamples place = RiverGround(96, 80, 0.4, 3);
  const CarvingTarget target = TargetOf(place);
  GridSamples terrain = RandomGround(70, 130, { 40.0, 60.0 }, 2);
  CarvingParameters parameters;
  parameters.MaximumIterations = 2;
  CarveDrainage(terrain, target, parameters);
  const GroundMeasures measures = MeasureGround(terrain, BorderOutlets(70, 130));
  EXPECT_EQ(measures.DepressionFraction, 0.0);
  EXPECT_NEAR(measures.HypsometricIntegral, target.Measures.HypsometricIntegral, 0.03);
}

TEST(DrainageCarving, RefusesBadInput)
{
  GridSamples ground = RandomGround(20, 20, { 1.0, 1.0 }, 1);
  CarvingParameters parameters;
  EXPECT_EQ(WhyInvalid(ground, parameters), "");
  EXPECT_EQ(WhyNoTarget(ground), "");
  parameters.MaximumIterations = 0;
  EXPECT_EQ(WhyInvalid(ground, parameters), "MaximumIterations is 0; it must be from 1 to 100.");
  parameters = {};
  parameters.ValleyWidth = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(WhyInvalid(ground, parameters), "ValleyWidth is nan; it must be from 0.5 to 50.");
  parameters = {};
  parameters.Outlets.Choice = OutletChoice::Chosen;
  EXPECT_EQ(WhyInvalid(ground, parameters), "Outlets must have one value for each height.");
  const GridSamples flat = Ground(20, 20, { 1.0, 1.0 }, [](double, double) { return 3.0; });
  EXPECT_EQ(WhyInvalid(flat, {}), "The terrain has one height everywhere; there is nothing to carve.");
  EXPECT_EQ(WhyNoTarget(flat), "The target has one height everywhere; there is nothing to carve.");
  const GridSamples row = RandomGround(20, 1, { 1.0, 1.0 }, 1);
  EXPECT_EQ(WhyInvalid(row, {}), "The terrain has 20 by 1 heights; water needs at least 3 by 3 to flow.");
  ground.At(2, 3) = 1e300;
  EXPECT_EQ(WhyInvalid(ground, {}), "The terrain has 1 of 400 heights beyond all numbers of metres.");
}

TEST(DrainageCarving, RefusesNumbersThatContradictEachOther)
{
  TargetStatistics numbers;
  EXPECT_EQ(WhyInvalid(numbers), "");
  numbers.KeepsHypsometry = false;
  EXPECT_EQ(WhyInvalid(numbers), "");
  numbers.HypsometricIntegral = 0.6; // with a skew above 0 most of the ground is low
  numbers.ElevationSkewness = 0.8;
  const std::string reason = WhyInvalid(numbers);
  EXPECT_EQ(reason.find("HypsometricIntegral is 0.6; it must be from 0."), 0u) << reason;
  EXPECT_NE(reason.find("with an ElevationSkewness of 0.8."), std::string::npos) << reason;
  numbers.Concavity = 1.5;
  EXPECT_EQ(WhyInvalid(numbers), "Concavity is 1.5; it must be from 0 to 1.");
}

TEST(DrainageCarving, TheBorderIsNoWall)
{
  const GridSamples place = RiverGround(64, 56, 0.4, 3);
  const CarvingTarget target = TargetOf(place);
  GridSamples twin = TwinOf(place, target, 1);
  CarvingParameters parameters;
  parameters.MaximumIterations = 1;
  CarveDrainage(twin, target, parameters);
  double rise = 0.0;
  for (int i = 1; i < 63; ++i)
  {
    rise += twin.At(i, 0) - twin.At(i, 1) + twin.At(i, 55) - twin.At(i, 54);
  }
  for (int j = 1; j < 55; ++j)
  {
    rise += twin.At(0, j) - twin.At(1, j) + twin.At(63, j) - twin.At(62, j);
  }
  EXPECT_NEAR(rise / 232.0, 0.0, 0.1 * target.Measures.StandardDeviation);
}

// Channels keep the least slope of the place's law, a fifth of it, at the same area in square metres: on cells of a
// quarter of the size, too.
TEST(DrainageCarving, ChannelsFallByTheAreaOfThePlaceNotByItsCells)
{
  const CarvingTarget target = TargetOf(RiverGround(80, 72, 0.4, 3));
  GridSamples twin = NormalNoise(160, 144, { 25.0, 25.0 }, 2);
  const double step = 0.5 / (160 * 25.0);
  std::vector<double> sizes;
  for (int ring = 0; ring < 320; ++ring)
  {
    sizes.push_back(std::sqrt(target.Spectrum.At(ring * step)) / 25.0);
  }
  MultiplyRings(twin, step, sizes);
  InverseCosineTransform(twin);
  CarvingParameters parameters;
  parameters.MaximumIterations = 1;
  CarveDrainage(twin, target, parameters);
  const OutletMask outlets = BorderOutlets(160, 144);
  const FlowRouting routing = RouteFlow(twin, outlets);
  const std::vector<CellIndex> cells = FlowAccumulation(routing);
  const std::vector<double> slopes = SlopesToReceivers(twin, routing);
  double channels = 0.0;
  double flat = 0.0;
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    const double area = cells[n] * 25.0 * 25.0;
    if (!outlets[n] && area > 4e5 && area < 2e6 && slopes[n] > 0.0)
    {
      const double law = target.Measures.ChannelSlope * std::pow(area / (100.0 * 2500.0), -0.4);
      channels += 1.0;
      flat += slopes[n] < 0.15 * law ? 1.0 : 0.0;
    }
  }
  EXPECT_GT(channels, 200.0);
  EXPECT_LT(flat / channels, 0.25);
}
