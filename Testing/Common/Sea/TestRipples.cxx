// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Short waves against their spectrum, the law of dispersion, and rays through one wave.
#include "Sea/Ripples.h"

#include "Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numeric>

namespace
{

using littoral::GatheredLight;
using littoral::Ripples;
using littoral::SurfaceSlope;
using littoral::TwoPi;

constexpr double Side = 6.4;
constexpr int Samples = 32;

/// Coefficients of the slopes for a number of waves along x and y, by their sums.
std::array<std::complex<double>, 2> WaveOf(const std::vector<SurfaceSlope>& slopes, int m, int n)
{
  std::array<std::complex<double>, 2> sums{};
  for (int row = 0; row < Samples; ++row)
  {
    for (int column = 0; column < Samples; ++column)
    {
      const SurfaceSlope& slope = slopes[row * Samples + column];
      const std::complex<double> turn =
        std::polar(1.0 / (Samples * Samples), -TwoPi * (m * column + n * row) / Samples);
      sums[0] += slope.X * turn;
      sums[1] += slope.Y * turn;
    }
  }
  return sums;
}

double VarianceOf(const std::vector<SurfaceSlope>& slopes)
{
  return std::accumulate(slopes.begin(), slopes.end(), 0.0,
           [](double sum, const SurfaceSlope& s) { return sum + s.X * s.X + s.Y * s.Y; }) /
    static_cast<double>(slopes.size());
}

TEST(Ripples, VarianceIsOneOnTheMeanOverTime)
{
  const Ripples ripples(Side, Samples, 3);
  double sum = 0.0;
  for (int step = 0; step < 100; ++step)
  {
    const double variance = VarianceOf(ripples.SlopesAt(0.73 * step));
    EXPECT_NEAR(variance, 1.0, 0.2);
    sum += variance / 100.0;
  }
  EXPECT_NEAR(sum, 1.0, 0.02);
}

TEST(Ripples, EachOctaveHasTheSameVariance)
{
  // 2 to 4, 4 to 8 and 8 to 16 waves along the side
  double octaves[3] = {};
  const int seeds = 16;
  for (int seed = 0; seed < seeds; ++seed)
  {
    const std::vector<SurfaceSlope> slopes = Ripples(Side, Samples, seed).SlopesAt(5.0);
    for (int m = -15; m < 16; ++m)
    {
      for (int n = 0; n < 16; ++n)
      {
        const double turns = std::hypot(m, n);
        if (turns >= 2.0 && turns < 16.0 && (n > 0 || m > 0))
        {
          const auto wave = WaveOf(slopes, m, n);
          octaves[static_cast<int>(std::log2(turns)) - 1] += 2.0 * (std::norm(wave[0]) + std::norm(wave[1])) / seeds;
        }
      }
    }
  }
  for (double octave : octaves)
  {
    EXPECT_NEAR(octave, 1.0 / 3.0, 0.05); // few waves in the first
  }
}

TEST(Ripples, WavesRunByTheLawOfDispersion)
{
  const Ripples ripples(Side, Samples, 7);
  const double step = 0.05;
  const auto before = ripples.SlopesAt(1e6 - step);
  const auto now = ripples.SlopesAt(1e6);
  const auto after = ripples.SlopesAt(1e6 + step);
  for (const auto& [m, n] : { std::pair{ 2, 0 }, std::pair{ 3, -4 }, std::pair{ 0, 9 }, std::pair{ 10, 10 } })
  {
    // s(t + h) + s(t - h) = 2 cos(omega h) s(t), whichever way waves run
    const double k = TwoPi * std::hypot(m, n) / Side;
    const double omega = std::sqrt(9.80665 * k + 0.0735 / 1000.0 * k * k * k);
    for (int axis = 0; axis < 2; ++axis)
    {
      const std::complex<double> both = WaveOf(before, m, n)[axis] + WaveOf(after, m, n)[axis];
      EXPECT_NEAR(std::abs(both - 2.0 * std::cos(omega * step) * WaveOf(now, m, n)[axis]), 0.0, 1e-9);
    }
    // Slopes are along the wave: those of a surface have no curl.
    const auto wave = WaveOf(now, m, n);
    EXPECT_NEAR(std::abs(wave[0] * double(n) - wave[1] * double(m)), 0.0, 1e-12);
  }
}

TEST(Ripples, RaysBelowOneWaveMeetUnderItsCrest)
{
  const int samples = 512;
  const double k = TwoPi * 4.0 / Side;
  const double steepness = 0.1;
  std::vector<SurfaceSlope> slopes(samples * samples);
  for (int row = 0; row < samples; ++row)
  {
    for (int column = 0; column < samples; ++column)
    {
      // Elevation cos(k x) steepness / k
      slopes[row * samples + column].X = -steepness * std::sin(k * column * Side / samples);
    }
  }
  const double arm = 0.5 / (k * steepness); // half of the way to the focus
  const std::vector<double> light = GatheredLight(slopes, samples, Side, arm);
  EXPECT_NEAR(std::accumulate(light.begin(), light.end(), 0.0) / static_cast<double>(light.size()), 1.0, 1e-12);
  double sum = 0.0;
  for (int column = 0; column < samples / 2; ++column)
  {
    const double found = light[100 * (samples / 2) + column];
    // Light I = dx / dx' = 1 / (1 - cos(k x) / 2) at x' = x - sin(k x) / (2 k), found by bisection
    const double place = column * 2.0 * Side / samples;
    double low = place - 1.0;
    double high = place + 1.0;
    for (int step = 0; step < 60; ++step)
    {
      const double x = 0.5 * (low + high);
      (x - 0.5 * std::sin(k * x) / k < place ? low : high) = x;
    }
    EXPECT_NEAR(found, 1.0 / (1.0 - 0.5 * std::cos(k * low)), 0.1) << place;
    // All light from 0 up to x' came down from 0 up to x
    EXPECT_NEAR(sum + 0.5 * found, low * samples / (2.0 * Side) + 0.5 * light[100 * (samples / 2)], 0.06) << place;
    sum += found;
  }
  for (double level : GatheredLight(slopes, samples, Side, 0.0))
  {
    ASSERT_NEAR(level, 1.0, 1e-12);
  }
}

}
