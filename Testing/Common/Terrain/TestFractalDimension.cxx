// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Both estimators on surfaces that are made here, by Fourier transforms of their own covariance or power spectrum.
#include "Numerics/Constants.h"
#include "Numerics/FourierGrid.h"
#include "Terrain/FractalDimension.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <functional>
#include <limits>
#include <random>
#include <vector>

using namespace littoral;

namespace
{

/// Power at a wave number k [rad/cell].
using PowerSpectrum = std::function<double(double k)>;

/**
 * A Gaussian field of a power spectrum, periodic in 256 cells of which size are kept: it has detail down to half of
 * 1/finer of a cell, and its points sample it.
 */
GridSamples Field(const PowerSpectrum& power, unsigned seed, int size = 192, int finer = 4)
{
  const int length = 256 * finer;
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  FourierGrid grid(length, length);
  for (int j = 0; j < length; ++j)
  {
    for (int i = 0; i < length; ++i)
    {
      const double k = TwoPi / 256 * std::hypot(i <= length / 2 ? i : i - length, j <= length / 2 ? j : j - length);
      const double amplitude = k > 0.0 ? std::sqrt(power(k)) : 0.0;
      grid.At(i, j) = amplitude * std::complex<double>(normal(engine), normal(engine));
    }
  }
  grid.Backward();
  GridSamples samples;
  samples.Width = samples.Height = size;
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      samples.Values.push_back(grid.At(finer * i, finer * j).real());
    }
  }
  return samples;
}

/// A pair of fractional Brownian surfaces, but for a plane.
using Surfaces = std::array<GridSamples, 2>;

/**
 * Exact surfaces of size^2 points by Stein (2002): a stationary field of half the variogram r^(2H), r up to 1, less
 * c2 r^2, which is that of a plane at random. Its covariance, continued to 0 at R, is that of a torus of side 2 R.
 */
Surfaces FractionalBrownian(double dimension, unsigned seed, int size = 192)
{
  const double alpha = 2.0 * (3.0 - dimension);
  const double R = alpha <= 1.5 ? 1.0 : 2.0;
  const double beta = alpha <= 1.5 ? 0.0 : alpha * (2.0 - alpha) / (3.0 * R * (R * R - 1.0));
  const double c2 = 0.5 * (alpha - beta * std::pow(R - 1.0, 2) * (R + 2.0));
  const double c0 = beta * std::pow(R - 1.0, 3) + 1.0 - c2;
  const auto covariance = [&](double r) {
    return r <= 1.0 ? c0 - std::pow(r, alpha) + c2 * r * r : r <= R ? beta * std::pow(R - r, 3) / r : 0.0;
  };
  const int unit = NextFastLength(static_cast<int>(std::ceil(std::sqrt(2.0) * size))); // the diagonal is below 1
  const int length = static_cast<int>(2.0 * R) * unit;
  FourierGrid power(length, length);
  for (int j = 0; j < length; ++j)
  {
    for (int i = 0; i < length; ++i)
    {
      power.At(i, j) = covariance(std::hypot(std::min(i, length - i), std::min(j, length - j)) / unit);
    }
  }
  power.Forward();
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  for (int j = 0; j < length; ++j)
  {
    for (int i = 0; i < length; ++i)
    {
      EXPECT_GT(power.At(i, j).real(), -1e-6);
      const double amplitude = std::sqrt(std::max(power.At(i, j).real(), 0.0)) / length;
      power.At(i, j) = amplitude * std::complex<double>(normal(engine), normal(engine));
    }
  }
  power.Backward();
  Surfaces surfaces;
  for (GridSamples& samples : surfaces)
  {
    samples.Width = samples.Height = size;
  }
  for (int n = 0; n < size * size; ++n)
  {
    const std::complex<double> value = power.At(n % size, n / size);
    surfaces[0].Values.push_back(value.real());
    surfaces[1].Values.push_back(value.imag());
  }
  return surfaces;
}

struct Estimates
{
  DimensionEstimate Periodogram;
  DimensionEstimate Variogram;
};

Estimates Estimate(GridSamples samples)
{
  RemovePlane(samples);
  return { DimensionFromPeriodogram(samples),
    DimensionFromVariogram(ComputeVariogramMap(samples, 20.0 * samples.Spacing[0])) };
}

void ExpectNone(const Estimates& estimates, const char* what, double value)
{
  EXPECT_TRUE(std::isnan(estimates.Periodogram.Dimension))
    << what << " " << value << ": periodogram " << estimates.Periodogram.Dimension;
  EXPECT_TRUE(std::isnan(estimates.Variogram.Dimension))
    << what << " " << value << ": variogram " << estimates.Variogram.Dimension;
}

}

// Half the mean squared difference over a lag is r^(2H) - H r^2, the latter of the plane that is left out.
TEST(FractalDimension, SurfacesAreFractionalBrownian)
{
  constexpr int size = 96;
  constexpr unsigned seeds = 4;
  const double unit = NextFastLength(static_cast<int>(std::ceil(std::sqrt(2.0) * size)));
  for (const double dimension : { 2.3, 2.5, 2.9 })
  {
    for (const int lag : { 1, 4, 16 })
    {
      double squares = 0.0;
      for (unsigned seed = 1; seed <= seeds; ++seed)
      {
        for (const GridSamples& samples : FractionalBrownian(dimension, seed, size))
        {
          for (int n = 0; n < size * (size - lag); ++n) // along y, and along x
          {
            const int place = n % (size - lag) + n / (size - lag) * size;
            squares += std::pow(samples.Values[n + lag * size] - samples.Values[n], 2);
            squares += std::pow(samples.Values[place + lag] - samples.Values[place], 2);
          }
        }
      }
      const double mean = squares / (2.0 * 2.0 * 2.0 * seeds * size * (size - lag)); // half, two surfaces, two ways
      const double r = lag / unit;
      const double expected = std::pow(r, 2.0 * (3.0 - dimension)) - (3.0 - dimension) * r * r;
      EXPECT_NEAR(mean / expected, 1.0, lag < 16 ? 0.03 : 0.1) << "D = " << dimension << ", " << lag;
    }
  }
}

// The table of the guide, whose rows are of 32 surfaces; means of two scatter by 0.7 of one.
TEST(FractalDimension, OfFractalSurfacesIsTheirs)
{
  struct Row
  {
    double Dimension;
    double Periodogram, PeriodogramScatter;
    double Variogram, VariogramScatter;
  };
  for (const Row& row : { Row{ 2.1, 2.12, 0.06, 2.20, 0.03 }, { 2.3, 2.32, 0.07, 2.35, 0.03 },
         { 2.5, 2.52, 0.07, 2.52, 0.02 }, { 2.7, 2.72, 0.06, 2.71, 0.01 }, { 2.9, 2.91, 0.03, 2.90, 0.01 } })
  {
    double periodogram = 0.0;
    double variogram = 0.0;
    for (const GridSamples& samples : FractionalBrownian(row.Dimension, 2))
    {
      const Estimates estimates = Estimate(samples);
      periodogram += 0.5 * estimates.Periodogram.Dimension;
      variogram += 0.5 * estimates.Variogram.Dimension;
    }
    EXPECT_NEAR(periodogram, row.Periodogram, 2.0 * row.PeriodogramScatter);
    EXPECT_NEAR(variogram, row.Variogram, 2.0 * row.VariogramScatter);
    std::printf("D = %.1f: periodogram %.3f, variogram %.3f\n", row.Dimension, periodogram, variogram);
  }
}

namespace
{

/// Power at a wave number [rad/cell] of a fractal surface that is sampled at points: the sum over the lattice of the
/// sampling wave numbers, and an integral beyond.
double SampledPower(double x, double y, double dimension)
{
  constexpr int reach = 5;
  const double b = 8.0 - 2.0 * dimension;
  const double radius = TwoPi * (2.0 * reach + 1.0) / std::sqrt(Pi); // of a circle as large as the square
  double power = std::pow(radius, 2.0 - b) / ((b - 2.0) * TwoPi);
  for (int m = -reach; m <= reach; ++m)
  {
    for (int n = -reach; n <= reach; ++n)
    {
      power += std::pow(std::hypot(x + TwoPi * n, y + TwoPi * m), -b);
    }
  }
  return power;
}

}

// All waves in phase in the middle of the window, which is 1 there: a periodogram without chance.
TEST(FractalDimension, OfWavesInPhaseIsExact)
{
  constexpr int size = 256;
  for (const double dimension : { 2.1, 2.3, 2.5, 2.7, 2.85 })
  {
    FourierGrid grid(size, size);
    const auto place = [&](int wave) { return wave < 0 ? wave + size : wave; };
    for (int j = 0; j <= size / 2; ++j)
    {
      for (int i = 0; i <= size / 2; ++i)
      {
        const double x = TwoPi / size * i;
        const double y = TwoPi / size * j;
        const double amplitude = i + j > 0 ? std::sqrt(SampledPower(x, y, dimension)) : 0.0;
        const double middle = 0.5 * (size - 1);
        for (const int side : { -1, 1 }) // of i; the conjugates belong to -j
        {
          const std::complex<double> wave = std::polar(amplitude, -(side * x + y) * middle);
          grid.At(place(side * i), j) = wave;
          grid.At(place(-side * i), place(-j)) = std::conj(wave);
        }
      }
    }
    grid.Backward();
    GridSamples samples;
    samples.Width = samples.Height = size;
    for (int n = 0; n < size * size; ++n)
    {
      samples.Values.push_back(grid.At(n % size, n / size).real());
    }
    const double measured = DimensionFromPeriodogram(samples).Dimension;
    std::printf("D = %.2f: %.4f\n", dimension, measured);
    EXPECT_NEAR(measured, dimension, 0.01); // long waves do not fade in the window
  }
}

TEST(FractalDimension, OfSmoothFieldsIsNone)
{
  // Gaussian covariances exp(-(r/R)^2): before the slope was tested, these told -4 to 4.
  for (double range : { 1.0, 4.0, 5.0, 7.0, 10.0, 15.0, 20.0, 40.0 })
  {
    const auto gaussian = [=](double k) { return std::exp(-0.25 * k * k * range * range); };
    for (unsigned seed = 1; seed <= 2; ++seed)
    {
      ExpectNone(Estimate(Field(gaussian, seed, 192, 1)), "range", range);
    }
  }
}

TEST(FractalDimension, OfCutSpectraIsNone)
{
  for (double shortest : { 8.0, 12.0, 20.0, 30.0 })
  {
    const auto cut = [=](double k) { return k < TwoPi / shortest ? std::pow(k, -3.4) : 0.0; };
    for (unsigned seed = 1; seed <= 2; ++seed)
    {
      ExpectNone(Estimate(Field(cut, seed, 192, 1)), "shortest wavelength", shortest);
    }
  }
}

TEST(FractalDimension, OfNoiseIsNone)
{
  const auto white = [](double) { return 1.0; };
  for (int size : { 8, 24, 64, 192 })
  {
    for (unsigned seed = 1; seed <= 4; ++seed)
    {
      ExpectNone(Estimate(Field(white, seed, size, 1)), "size", size);
    }
  }
}

TEST(FractalDimension, OfWhatDoesNotVaryIsNone)
{
  GridSamples samples;
  samples.Width = samples.Height = 128;
  samples.Spacing = { 30.0, 20.0 };
  const auto fill = [&](const std::function<double(int, int)>& valueAt) {
    samples.Values.clear();
    for (int n = 0; n < 128 * 128; ++n)
    {
      samples.Values.push_back(valueAt(n % 128, n / 128));
    }
    return samples;
  };
  const Estimates constant = Estimate(fill([](int, int) { return 0.1; }));
  ExpectNone(constant, "constant", 0.1);
  ExpectNone(Estimate(fill([](int i, int j) { return 701.3 + 0.37 * i - 0.11 * j; })), "plane", 0.0);
  ExpectNone(Estimate(fill([](int, int) { return std::numeric_limits<double>::quiet_NaN(); })), "NaN", 0.0);
  // A plane that nobody removed is a smooth field.
  fill([](int i, int j) { return 0.37 * i - 0.11 * j; });
  ExpectNone(
    { DimensionFromPeriodogram(samples), DimensionFromVariogram(ComputeVariogramMap(samples, 500.0)) }, "tilt", 0);
}

TEST(FractalDimension, IsNeverOutsideTwoToThree)
{
  // Spectra between smooth and rough, on grids of all sizes: whatever is told lies in [2, 3].
  int told = 0;
  for (double slope : { 0.0, 1.0, 2.0, 2.2, 3.0, 4.0, 4.2, 5.0, 8.0 })
  {
    for (int size : { 16, 64, 128 })
    {
      const Estimates estimates = Estimate(Field([=](double k) { return std::pow(k, -slope); }, 7, size, 1));
      for (const DimensionEstimate& estimate : { estimates.Periodogram, estimates.Variogram })
      {
        told += !std::isnan(estimate.Dimension);
        EXPECT_FALSE(estimate.Dimension < 2.0 || estimate.Dimension > 3.0) << slope << " on " << size;
        EXPECT_EQ(std::isnan(estimate.Dimension), std::isnan(estimate.StandardError));
      }
    }
  }
  EXPECT_GT(told, 5);
}
