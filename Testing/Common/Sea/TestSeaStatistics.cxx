// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Spectrum and directions of wave trains against closed forms.
#include "Sea/SeaStatistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace littoral;

namespace
{

const double Pi = std::acos(-1.0);

/// Integral of a curve by trapezoids; steps have points at both sides, so that it is exact for them.
template <typename Curve, typename X, typename Y>
double Integral(const Curve& curve, X x, Y y)
{
  double sum = 0.0;
  for (std::size_t k = 1; k < curve.size(); ++k)
  {
    sum += 0.5 * (curve[k].*x - curve[k - 1].*x) * (curve[k].*y + curve[k - 1].*y);
  }
  return sum;
}

WaveTrain Train(double amplitude, double hertz, double degrees)
{
  return { amplitude, 2.0 * Pi * hertz, 1.0, degrees * Pi / 180.0, 0.0 };
}

}

TEST(SeaStatistics, StepsHoldTheEnergyOfTheirTrains)
{
  const std::vector<WaveTrain> trains = { Train(2.0, 0.15, 0.0), Train(1.0, 0.35, 0.0) };
  // A spectrum that falls from 3 to 0 along a line; three bins with two steps each.
  const std::vector<double> edges = { 0.1, 0.2, 0.3, 0.6 };
  const auto curve = SpectrumOfTrains(trains, edges, { 3.0, 2.7, 2.4, 2.1, 1.8, 0.9, 0.0 });
  ASSERT_EQ(curve.size(), 9u);
  EXPECT_DOUBLE_EQ(curve[1].Trains, 20.0); // 2^2 / 2 over 0.1 Hz
  EXPECT_DOUBLE_EQ(curve[4].Trains, 0.0);
  EXPECT_NEAR(curve[7].Trains, 0.5 / 0.3, 1e-12);
  EXPECT_DOUBLE_EQ(curve[7].Frequency, 0.45);
  EXPECT_DOUBLE_EQ(curve[7].Spectrum, 0.9);
  EXPECT_NEAR(Integral(curve, &FrequencyDensity::Frequency, &FrequencyDensity::Trains), 2.5, 1e-12);
}

/// The spectrum of a sea integrates to Hs^2 / 16, and so do its trains, both over the range of the bins.
TEST(SeaStatistics, SeaOfGivenHeightHasItsEnergy)
{
  SpectrumParameters given;
  given.FromWind = false;
  given.SignificantHeight = 3.0;
  given.PeakPeriod = 9.0;
  TrainParameters cut;
  cut.Lowest = 0.3;
  cut.Highest = 20.0;
  cut.Count = 400;
  for (const bool equal : { false, true })
  {
    cut.EqualSpacing = equal;
    const SeaSpectrum spectrum(given);
    std::vector<double> edges = BinEdges(spectrum, cut);
    std::vector<double> densities;
    for (double& edge : edges)
    {
      densities.push_back(2.0 * Pi * spectrum.Density(edge));
      edge /= 2.0 * Pi;
    }
    const auto trains = TrainsOf(spectrum, 1e9, cut);
    const auto curve = SpectrumOfTrains(trains, edges, densities);
    EXPECT_NEAR(Integral(curve, &FrequencyDensity::Frequency, &FrequencyDensity::Trains), 9.0 / 16.0, 2e-4);
    EXPECT_NEAR(Integral(curve, &FrequencyDensity::Frequency, &FrequencyDensity::Spectrum), 9.0 / 16.0, 2e-4);
    // Pierson and Moskowitz: the largest density lies at the peak.
    const auto largest = *std::max_element(
      curve.begin(), curve.end(), [](const auto& a, const auto& b) { return a.Spectrum < b.Spectrum; });
    EXPECT_NEAR(largest.Frequency, 1.0 / 9.0, 0.005);
    for (const FrequencyDensity& row : curve)
    {
      EXPECT_NEAR(row.Trains, row.Spectrum, 1.0); // of 12 at the peak
    }
  }
}

TEST(SeaStatistics, SpreadingIsTheCosinePower)
{
  // Two trains 2 a apart have the mean cosine cos a, hence s = cos a / (1 - cos a).
  const double half = 40.0;
  const std::vector<WaveTrain> trains = { Train(1.0, 0.2, 100.0 - half), Train(1.0, 0.2, 100.0 + half) };
  const double cosine = std::cos(half * Pi / 180.0);
  const double exponent = cosine / (1.0 - cosine);
  EXPECT_NEAR(MeanVectorOf(trains).Direction, 100.0 * Pi / 180.0, 1e-12);
  EXPECT_NEAR(MeanVectorOf(trains).Length, cosine, 1e-12);
  const auto curve = SpreadingOfTrains(trains, 24);
  EXPECT_NEAR(curve.front().Direction, -80.0, 1e-9);
  EXPECT_NEAR(curve.back().Direction, 280.0, 1e-9);
  EXPECT_NEAR(Integral(curve, &DirectionDensity::Direction, &DirectionDensity::Spreading), 1.0, 1e-6);
  EXPECT_NEAR(Integral(curve, &DirectionDensity::Direction, &DirectionDensity::Trains), 1.0, 1e-12);
  double largest = 0.0;
  double at = 0.0;
  for (const DirectionDensity& row : curve)
  {
    at = row.Spreading > largest ? row.Direction : at;
    largest = std::max(largest, row.Spreading);
  }
  EXPECT_NEAR(at, 100.0, 1e-9);
  for (const DirectionDensity& row : curve)
  {
    EXPECT_NEAR(
      row.Spreading / largest, std::pow(std::cos((row.Direction - 100.0) * Pi / 360.0), 2.0 * exponent), 1e-9);
    const double angle = std::abs(row.Direction - 100.0);
    if (std::abs(angle - 37.5) < 7.4)
    {
      EXPECT_NEAR(row.Trains, 0.5 / 15.0, 1e-12);
    }
    else if (std::abs(angle - 37.5) > 7.6)
    {
      EXPECT_EQ(row.Trains, 0.0);
    }
  }
}

TEST(SeaStatistics, LongCrestedSeaHasNoModel)
{
  const auto curve = SpreadingOfTrains({ Train(1.0, 0.2, 170.0), Train(2.0, 0.3, 170.0) }, 36);
  for (const DirectionDensity& row : curve)
  {
    EXPECT_TRUE(std::isnan(row.Spreading));
  }
  EXPECT_NEAR(Integral(curve, &DirectionDensity::Direction, &DirectionDensity::Trains), 1.0, 1e-12);
}
