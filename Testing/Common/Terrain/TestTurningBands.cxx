// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/TurningBands.h"

#include "Numerics/Constants.h"
#include "Numerics/FourierGrid.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/bessel.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>
#include <limits>
#include <vector>

using namespace littoral;

namespace
{

std::vector<float> Grow(const TurningBandsParameters& parameters, const PlaneGrid& grid, const GridWindow& window)
{
  TurningBandsField field(parameters, grid, window);
  for (std::size_t line = 0; line < field.GetNumberOfLines(); ++line)
  {
    field.TabulateLine(line);
  }
  const int width = window.Last[0] - window.First[0] + 1;
  const int height = window.Last[1] - window.First[1] + 1;
  std::vector<float> values(static_cast<std::size_t>(width) * height);
  field.FillRows(window.First[1], window.Last[1], 1.0, 0.0, values.data());
  return values;
}

std::vector<float> Grow(const TurningBandsParameters& parameters, int size)
{
  GridWindow window;
  window.Last = { size - 1, size - 1 };
  return Grow(parameters, PlaneGrid{}, window);
}

/// The covariance of the short waves at points i columns and j rows apart.
double ShortCovariance(const TurningBandsField& field, int i, int j)
{
  return field.GetShortWaves() ? field.GetShortWaves()->Covariance(i, j) : 0.0;
}

TurningBandsParameters Parameters(CovarianceModel model, double range)
{
  TurningBandsParameters parameters;
  parameters.Field.Model = model;
  parameters.Field.Range = range;
  parameters.Field.SecondRange = 0.25 * range;
  return parameters;
}

/// All models, and fractal fields of several dimensions.
std::vector<TurningBandsParameters> ManyFields(double range)
{
  std::vector<TurningBandsParameters> fields;
  for (int model = 1; model < NumberOfCovarianceModels; ++model)
  {
    fields.push_back(Parameters(static_cast<CovarianceModel>(model), range));
  }
  for (double dimension : { 2.1, 2.5, 2.8, 2.95 })
  {
    fields.push_back(Parameters(CovarianceModel::Fractal, range));
    fields.back().Field.FractalDimension = dimension;
  }
  return fields;
}

std::string NameOf(const TurningBandsParameters& parameters)
{
  const CovarianceParameters& field = parameters.Field;
  const bool fractal = field.Model == CovarianceModel::Fractal;
  return CovarianceModelName(field.Model) + (fractal ? " D " + std::to_string(field.FractalDimension) : "") +
    " range " + std::to_string(field.Range);
}

double MeanSquare(const std::vector<float>& values)
{
  double sum = 0.0;
  for (float value : values)
  {
    sum += static_cast<double>(value) * value;
  }
  return sum / static_cast<double>(values.size());
}

class StationaryModels : public testing::TestWithParam<int>
{
};

}

// The ensemble: variance, and covariance along both axes and the diagonal, at lags over the whole decay.
TEST_P(StationaryModels, EnsembleCovarianceIsTheModels)
{
  const CovarianceModel model = static_cast<CovarianceModel>(GetParam());
  TurningBandsParameters parameters = Parameters(model, model == CovarianceModel::Spherical ? 30.0 : 8.0);
  const int size = 128;
  const int runs = 100;
  const std::vector<int> lags = { 0, 1, 2, 4, 8, 12, 16, 24, 32 };
  std::vector<std::vector<double>> covariance(3, std::vector<double>(lags.size(), 0.0));
  for (int run = 0; run < runs; ++run)
  {
    parameters.Seed = 1000 + run;
    const std::vector<float> z = Grow(parameters, size);
    for (std::size_t l = 0; l < lags.size(); ++l)
    {
      const int h = lags[l];
      const int steps[3] = { h, h * size, h * (size + 1) };
      for (int direction = 0; direction < 3; ++direction)
      {
        const int nx = direction == 1 ? size : size - h;
        const int ny = direction == 0 ? size : size - h;
        double sum = 0.0;
        for (int j = 0; j < ny; ++j)
        {
          for (int i = 0; i < nx; ++i)
          {
            sum += z[j * size + i] * static_cast<double>(z[j * size + i + steps[direction]]);
          }
        }
        covariance[direction][l] += sum / (runs * static_cast<double>(nx) * ny);
      }
    }
  }
  for (std::size_t l = 0; l < lags.size(); ++l)
  {
    for (int direction = 0; direction < 3; ++direction)
    {
      const double r = lags[l] * (direction == 2 ? std::sqrt(2.0) : 1.0);
      EXPECT_NEAR(covariance[direction][l], Covariance(parameters.Field, r), 0.05)
        << "lag " << lags[l] << ", direction " << direction;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(TurningBands, StationaryModels, testing::Range(1, NumberOfCovarianceModels),
  [](const auto& one) { return CovarianceModelName(static_cast<CovarianceModel>(one.param)); });

// The covariance of the method itself, without chance: a harmonic on a line of any direction has A^2/2 J0(w r), short
// waves that of their average. The truth is each model's closed form over distance, of which the method uses the
// spectrum. Semivariances of neighbours were 7 % low when harmonics beyond the tables' reach were folded into them.
TEST(TurningBands, CovarianceOfLinesAndShortWavesIsTheModels)
{
  for (double across : { 1.0, 4.0 })
  {
    PlaneGrid grid;
    grid.Spacing = { 1.0, across };
    for (double range : { 1.0, 3.0, 10.0, 30.0, 100.0 })
    {
      for (TurningBandsParameters& parameters : ManyFields(range))
      {
        parameters.NumberOfLines = 4;
        const TurningBandsField field(parameters, grid, GridWindow{});
        // Where the sharp edge of a fractal spectrum is among the short waves, the average is too short for its rings.
        const bool rings = parameters.Field.Model == CovarianceModel::Fractal && range < 16.0 * across;
        const std::vector<std::array<int, 2>> lags = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 }, { 2, 0 }, { 0, 5 },
          { 10, 0 }, { 30, 40 } };
        double variance = 0.0;
        for (const auto& lag : lags)
        {
          const double r = std::hypot(lag[0], across * lag[1]);
          double covariance = ShortCovariance(field, lag[0], lag[1]);
          for (std::size_t line = 0; line < field.GetNumberOfLines(); ++line)
          {
            const auto harmonics = field.GetHarmonics(line);
            for (std::size_t k = 0; k < harmonics.WaveNumber.size(); ++k)
            {
              covariance += 0.5 * harmonics.Amplitude[k] * harmonics.Amplitude[k] *
                boost::math::cyl_bessel_j(0, harmonics.WaveNumber[k] * r);
            }
          }
          variance = r == 0.0 ? covariance : variance;
          const double truth = Semivariance(parameters.Field, r);
          EXPECT_NEAR(variance, 1.0, 1e-3) << NameOf(parameters);
          EXPECT_NEAR(variance - covariance, truth, (rings ? 0.03 : 0.01) * truth + 1e-9)
            << NameOf(parameters) << ", lag " << lag[0] << ", " << lag[1] << ", spacing " << across;
        }
      }
    }
  }
}

// As measured, on grids large enough that chance has a standard deviation of 0.2 %; 0.952, 0.93 and 0.94 before.
TEST(TurningBands, MeasuredVarianceIsTheModels)
{
  struct Case
  {
    CovarianceModel Model;
    double Range;
    double Across;
  };
  for (const Case& one : { Case{ CovarianceModel::SimpleExponential, 1.0, 1.0 },
         Case{ CovarianceModel::Fractal, 12.0, 1.0 }, Case{ CovarianceModel::Spherical, 4.0, 4.0 } })
  {
    TurningBandsParameters parameters = Parameters(one.Model, one.Range);
    parameters.Field.FractalDimension = 2.9;
    parameters.NumberOfLines = 32;
    parameters.NumberOfHarmonics = 100;
    PlaneGrid grid;
    grid.Spacing = { 1.0, one.Across };
    GridWindow window;
    window.Last = { 255, 255 };
    double sum = 0.0;
    const int runs = 40;
    for (int run = 0; run < runs; ++run)
    {
      parameters.Seed = 50 + run;
      sum += MeanSquare(Grow(parameters, grid, window)) / runs;
    }
    EXPECT_NEAR(sum, 1.0, 0.005) << NameOf(parameters);
  }
}

// Short waves alone are nearly white here. Bounds are four standard deviations of chance.
TEST(TurningBands, NoiseIsNormal)
{
  TurningBandsParameters parameters = Parameters(CovarianceModel::Fractal, 1.0);
  parameters.Field.FractalDimension = 2.99;
  const std::vector<float> z = Grow(parameters, 1024);
  const double n = static_cast<double>(z.size());
  double moments[5] = {};
  const std::vector<double> levels = { -3.0, -2.0, -1.0, -0.1, 0.5, 1.5, 2.5, 3.5 };
  std::vector<double> below(levels.size(), 0.0);
  for (double value : z)
  {
    for (int k = 1; k <= 4; ++k)
    {
      moments[k] += std::pow(value, k) / n;
    }
    for (std::size_t l = 0; l < levels.size(); ++l)
    {
      below[l] += value < levels[l] ? 1.0 / n : 0.0;
    }
  }
  EXPECT_NEAR(moments[1], 0.0, 4.0 / std::sqrt(n));
  EXPECT_NEAR(moments[2], 1.0, 4.0 * std::sqrt(2.0 / n));
  EXPECT_NEAR(moments[3], 0.0, 4.0 * std::sqrt(15.0 / n));
  EXPECT_NEAR(moments[4], 3.0, 4.0 * std::sqrt(96.0 / n));
  for (std::size_t l = 0; l < levels.size(); ++l)
  {
    const double p = 0.5 * std::erfc(-levels[l] / std::sqrt(2.0));
    EXPECT_NEAR(below[l], p, 4.0 * std::sqrt(p * (1.0 - p) / n) + 2e-4 * std::exp(-0.5 * levels[l] * levels[l]));
  }
}

// Tables lose no power, also of waves as short as they take: against the harmonics summed one by one.
TEST(TurningBands, TablesKeepThePowerOfTheShortestWaves)
{
  TurningBandsParameters parameters = Parameters(CovarianceModel::SimpleExponential, 0.5);
  parameters.MinimumWavelength = 2.0;
  parameters.NumberOfLines = 24;
  parameters.NumberOfHarmonics = 40;
  const int size = 64;
  const std::vector<float> z = Grow(parameters, size);
  TurningBandsField field(parameters, PlaneGrid{}, GridWindow{});
  double exact = 0.0;
  for (int n = 0; n < size * size; ++n)
  {
    exact += std::pow(field.ValueAt(n % size, n / size), 2) / (size * size);
  }
  EXPECT_NEAR(MeanSquare(z) / exact, 1.0, 0.002);
}

namespace
{

/// Relative standard deviation over directions of a field's power in a ring of its spectrum, in sectors of 1.5 bins.
double RingUnevenness(const std::vector<float>& z, int size, double wavelength)
{
  FourierGrid grid(size, size);
  const auto hann = [size](int i) { return 1.0 - std::cos(TwoPi * (i + 0.5) / size); };
  for (int n = 0; n < size * size; ++n)
  {
    grid.At(n % size, n / size) = z[n] * hann(n % size) * hann(n / size);
  }
  grid.Forward();
  const double ring = size / wavelength;
  const int sectors = static_cast<int>(Pi * ring / 1.5);
  std::vector<double> power(sectors, 0.0);
  std::vector<double> count(sectors, 0.0);
  for (int j = -size / 2; j < size / 2; ++j)
  {
    for (int i = -size / 2; i < size / 2; ++i)
    {
      const double k = std::hypot(i, j);
      if (k > 0.88 * ring && k < 1.12 * ring)
      {
        const double angle = std::fmod(std::atan2(j, i) + TwoPi, Pi);
        const int sector = std::min(sectors - 1, static_cast<int>(sectors * angle / Pi));
        power[sector] += std::norm(grid.At((i + size) % size, (j + size) % size)) * k * k * k;
        ++count[sector];
      }
    }
  }
  double mean = 0.0;
  double square = 0.0;
  for (int s = 0; s < sectors; ++s)
  {
    mean += power[s] / count[s] / sectors;
    square += std::pow(power[s] / count[s], 2) / sectors;
  }
  return std::sqrt(square / (mean * mean) - 1.0);
}

/// A field made otherwise: white noise colored wave by wave, on a torus of twice the size, of which a quarter is
/// taken.
std::vector<float> ColoredNoise(const CovarianceParameters& field, int size, int seed)
{
  const int whole = 2 * size;
  FourierGrid grid(whole, whole);
  const RandomStream random(seed, RandomPurpose::QuadratCounts);
  for (int n = 0; n < whole * whole; ++n)
  {
    const int i = n % whole;
    const int j = n / whole;
    const double w = TwoPi / whole * std::hypot(i > size ? i - whole : i, j > size ? j - whole : j);
    const auto pair = random.NormalPair(j, i);
    grid.At(i, j) = w > 0.0 ? std::sqrt(RadialSpectrum(field, w) / w) * std::complex<double>(pair[0], pair[1]) : 0.0;
  }
  grid.Forward();
  std::vector<float> values;
  for (int n = 0; n < size * size; ++n)
  {
    values.push_back(static_cast<float>(grid.At(n % size, n / size).real()));
  }
  return values;
}

}

// No direction stands out in any ring of the spectrum that has power: as even as exact noise. Unevenness of exact noise
// is 0.23 to 0.55 here; fields of 64 lines that reach to the shortest waves have 0.9 at wavelengths of 5 cells.
TEST(TurningBands, SpectrumIsAsEvenAsThatOfExactNoise)
{
  const int size = 256;
  GridWindow window;
  window.Last = { size - 1, size - 1 };
  const std::vector<double> wavelengths = { 4.0, 5.0, 6.0, 8.0, 12.0, 16.0 };
  for (CovarianceModel model : { CovarianceModel::SimpleExponential, CovarianceModel::Bessel1 })
  {
    std::vector<double> ours(wavelengths.size(), 0.0);
    std::vector<double> exact(wavelengths.size(), 0.0);
    for (int run = 1; run <= 4; ++run)
    {
      TurningBandsParameters parameters = Parameters(model, 20.0);
      parameters.Seed = run;
      parameters.NumberOfLines = EnoughLines(parameters, PlaneGrid{}, window);
      const std::vector<float> grown = Grow(parameters, size);
      const std::vector<float> colored = ColoredNoise(parameters.Field, size, run);
      for (std::size_t n = 0; n < wavelengths.size(); ++n)
      {
        ours[n] += RingUnevenness(grown, size, wavelengths[n]);
        exact[n] += RingUnevenness(colored, size, wavelengths[n]);
      }
    }
    for (std::size_t n = 0; n < wavelengths.size(); ++n)
    {
      EXPECT_LT(ours[n], 1.2 * exact[n]) << CovarianceModelName(model) << ", wavelength " << wavelengths[n];
    }
  }
}

TEST(TurningBands, LinesAreCountedByGridAndSpectrum)
{
  const auto lines = [](const TurningBandsParameters& parameters, double spacing, int size) {
    PlaneGrid grid;
    grid.Spacing = { spacing, spacing };
    GridWindow window;
    window.First = { -17, 5 };
    window.Last = { -17 + size, 5 + size / 2 };
    return EnoughLines(parameters, grid, window);
  };
  const TurningBandsParameters rough = Parameters(CovarianceModel::SimpleExponential, 50.0);
  const int once = lines(rough, 1.0, 1000);
  EXPECT_GT(once, 250); // a quarter of the grid's points along a side, times the wave number, 1.2 a spacing
  EXPECT_LT(once, 350);
  EXPECT_NEAR(lines(rough, 1.0, 2000), 2.0 * once, 2.0);
  EXPECT_EQ(lines(rough, 1.0, 20000), 1024);
  EXPECT_EQ(lines(rough, 1.0, 10), 64);
  // Lengths have no unit.
  EXPECT_NEAR(lines(Parameters(CovarianceModel::SimpleExponential, 50.0e3), 1000.0, 1000), once, 1.0);
  // A smooth field needs no more lines on a finer grid; 95 % of its slopes' variance are
  // below the wave number 4.36 / range, by the gamma distribution of order 2 in (range w / 2)^2.
  const TurningBandsParameters smooth = Parameters(CovarianceModel::DoubleExponential, 10.0);
  EXPECT_EQ(lines(smooth, 1.0, 2000), lines(smooth, 0.5, 4000));
  EXPECT_NEAR(lines(smooth, 1.0, 2000), 0.25 * 2000.0 * 0.436, 5.0);
  // Nothing short is nothing to count.
  TurningBandsParameters cut = rough;
  cut.MinimumWavelength = 20.0;
  EXPECT_LT(lines(cut, 1.0, 1000), 0.3 * once);
}

TEST(TurningBands, UniformBinsOfThePaperKeepVarianceAndCovariance)
{
  TurningBandsParameters parameters = Parameters(CovarianceModel::SimpleExponential, 8.0);
  parameters.Bins = HarmonicBins::Uniform;
  double variance = 0.0;
  double lagged = 0.0;
  const int size = 128;
  const int runs = 60;
  for (int run = 0; run < runs; ++run)
  {
    parameters.Seed = run;
    const std::vector<float> z = Grow(parameters, size);
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i + 8 < size; ++i)
      {
        variance += z[j * size + i] * z[j * size + i] / (runs * size * (size - 8.0));
        lagged += z[j * size + i] * z[j * size + i + 8] / (runs * size * (size - 8.0));
      }
    }
  }
  EXPECT_NEAR(variance, 1.0, 0.05);
  EXPECT_NEAR(lagged, std::exp(-1.0), 0.05);
}

TEST(TurningBands, TablesAgreeWithTheSumOfHarmonics)
{
  for (double ratio : { 1.0, 3.0 })
  {
    TurningBandsParameters parameters = Parameters(CovarianceModel::SimpleExponential, 20.0);
    parameters.MinimumWavelength = 4.0;
    parameters.AnisotropyRatio = ratio;
    parameters.AnisotropyAngle = 0.4;
    PlaneGrid grid;
    grid.Origin = { -31.5, 1000.25 };
    grid.Spacing = { 2.0, 1.5 };
    GridWindow window;
    window.First = { -5, 7 };
    window.Last = { 300, 90 };
    const std::vector<float> z = Grow(parameters, grid, window);
    TurningBandsField field(parameters, grid, window);
    for (int n = 0; n < 40; ++n)
    {
      const int i = -5 + (n * 97) % 306;
      const int j = 7 + (n * 31) % 84;
      const double exact = field.ValueAt(grid.Origin[0] + i * 2.0, grid.Origin[1] + j * 1.5);
      EXPECT_NEAR(z[static_cast<std::size_t>(j - 7) * 306 + i + 5], exact, 0.01);
    }
  }
}

// The value of a point is one of its place: tiles meet, by the origin as by the window.
TEST(TurningBands, TilesByTheOriginAreThoseByTheWindow)
{
  for (const CovarianceModel model : { CovarianceModel::SimpleExponential, CovarianceModel::Spherical })
  {
    TurningBandsParameters parameters = Parameters(model, 30.0);
    parameters.AnisotropyRatio = 2.0;
    parameters.AnisotropyAngle = 0.4;
    PlaneGrid grid;
    grid.Spacing = { 2.0, 1.5 };
    const std::vector<float> byWindow = Grow(parameters, grid, GridWindow{ { 35, -1007 }, { 98, -970 } });
    grid.Origin = { 35 * 2.0, -1000 * 1.5 };
    const std::vector<float> byOrigin = Grow(parameters, grid, GridWindow{ { 0, -7 }, { 63, 30 } });
    ASSERT_EQ(byOrigin.size(), byWindow.size());
    for (std::size_t n = 0; n < byOrigin.size(); ++n)
    {
      ASSERT_NEAR(byOrigin[n], byWindow[n], 1e-5);
    }
  }
}

TEST(TurningBands, EveryLineHasItsFullVarianceAndLiesOnAHalfCircle)
{
  TurningBandsParameters parameters = Parameters(CovarianceModel::Spherical, 500.0);
  parameters.Field.Variance = 9.0;
  parameters.NumberOfLines = 16;
  const TurningBandsField field(parameters, PlaneGrid{}, GridWindow{});
  for (std::size_t line = 0; line < 16; ++line)
  {
    double variance = 0.0;
    for (double amplitude : field.GetHarmonics(line).Amplitude)
    {
      variance += 0.5 * amplitude * amplitude;
    }
    EXPECT_NEAR(variance * 16 + ShortCovariance(field, 0, 0), 9.0, 1e-6); // what is not short is long
    const auto a = field.GetDirection(line);
    const auto b = field.GetDirection((line + 1) % 16);
    EXPECT_NEAR(std::abs(a[0] * b[1] - a[1] * b[0]), std::sin(Pi / 16), 1e-12); // as lines, evenly spread
    EXPECT_GE(a[1], std::sin(Pi * (1.0 - 1.0 / 16)) * -1.0);                    // and each line once
  }
}

// Equally spaced harmonics would repeat a line after 2 pi / dw; the jitter of each harmonic prevents it.
TEST(TurningBands, LinesDoNotRepeat)
{
  TurningBandsParameters parameters = Parameters(CovarianceModel::DoubleExponential, 5.0);
  parameters.NumberOfLines = 1;
  parameters.NumberOfHarmonics = 100;
  parameters.Bins = HarmonicBins::Uniform;
  const TurningBandsField field(parameters, PlaneGrid{}, GridWindow{});
  const auto harmonics = field.GetHarmonics(0);
  const double highest = WaveNumberAtTail(parameters.Field, 1e-6);
  const double period = TwoPi / (highest / 100);
  const auto process = [&](double x) {
    double sum = 0.0;
    for (std::size_t k = 0; k < harmonics.WaveNumber.size(); ++k)
    {
      sum += harmonics.Amplitude[k] * std::cos(harmonics.WaveNumber[k] * x + harmonics.Phase[k]);
    }
    return sum;
  };
  double correlation = 0.0;
  for (int n = 0; n < 2000; ++n)
  {
    correlation += process(n * 1.0) * process(n * 1.0 + period) / 2000;
  }
  EXPECT_LT(std::abs(correlation), 0.35); // 1 for a line that repeats
}

TEST(TurningBands, AWindowHoldsTheBytesOfTheWhole)
{
  for (int model = 0; model < NumberOfCovarianceModels; ++model)
  {
    TurningBandsParameters parameters = Parameters(static_cast<CovarianceModel>(model), 50.0);
    const std::vector<float> whole = Grow(parameters, 1024);
    GridWindow window;
    window.First = { 333, 700 };
    window.Last = { 396, 763 };
    const std::vector<float> part = Grow(parameters, PlaneGrid{}, window);
    for (int j = 0; j < 64; ++j)
    {
      ASSERT_EQ(std::memcmp(&part[j * 64], &whole[(700 + j) * 1024 + 333], 64 * sizeof(float)), 0) << "row " << j;
    }
  }
}

TEST(TurningBands, AWindowOfAStretchedGridHoldsTheBytesOfTheWhole)
{
  TurningBandsParameters parameters = Parameters(CovarianceModel::SimpleExponential, 12.0);
  parameters.AnisotropyRatio = 7.0;
  parameters.AnisotropyAngle = 0.5;
  parameters.NumberOfLines = 30; // no multiple of the lines of a pass
  PlaneGrid grid;
  grid.Spacing = { 1.0, 3.0 };
  grid.Origin = { 1e4, -77.7 };
  GridWindow whole;
  whole.First = { -300, -200 };
  whole.Last = { 299, 99 };
  const std::vector<float> all = Grow(parameters, grid, whole);
  GridWindow window;
  window.First = { -31, -45 };
  window.Last = { 8, 1 };
  const std::vector<float> part = Grow(parameters, grid, window);
  for (int j = 0; j < 47; ++j)
  {
    ASSERT_EQ(std::memcmp(&part[j * 40], &all[(155 + j) * 600 + 269], 40 * sizeof(float)), 0) << "row " << j;
  }
}

TEST(TurningBands, ACoarseGridHoldsEveryFourthValue)
{
  TurningBandsParameters parameters = Parameters(CovarianceModel::Bessel1, 30.0);
  parameters.MinimumWavelength = 6.0;
  PlaneGrid fine;
  fine.Spacing = { 3.0, 3.0 };
  fine.Origin = { 17.0, -4.0 };
  GridWindow fineWindow;
  fineWindow.Last = { 256, 256 };
  PlaneGrid coarse = fine;
  coarse.Spacing = { 12.0, 12.0 };
  GridWindow coarseWindow;
  coarseWindow.Last = { 64, 64 };
  const std::vector<float> a = Grow(parameters, fine, fineWindow);
  const std::vector<float> b = Grow(parameters, coarse, coarseWindow);
  for (int j = 0; j <= 64; ++j)
  {
    for (int i = 0; i <= 64; ++i)
    {
      ASSERT_EQ(a[4 * j * 257 + 4 * i], b[j * 65 + i]) << i << ", " << j;
    }
  }
}

TEST(TurningBands, BadParametersAreNamed)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const PlaneGrid grid;
  const TurningBandsParameters good = Parameters(CovarianceModel::Bessel2, 10.0);
  EXPECT_EQ(WhyInvalid(good, grid), "");
  const auto expectNamed = [&](const char* name, auto spoil) {
    TurningBandsParameters bad = good;
    PlaneGrid badGrid = grid;
    spoil(bad, badGrid);
    EXPECT_NE(WhyInvalid(bad, badGrid).find(name), std::string::npos) << name << ": " << WhyInvalid(bad, badGrid);
  };
  for (double bad : { 0.0, -2.0, nan })
  {
    expectNamed("Range", [&](auto& p, auto&) { p.Field.Range = bad; });
    expectNamed("AnisotropyRatio", [&](auto& p, auto&) { p.AnisotropyRatio = bad; });
    expectNamed("Spacing", [&](auto&, auto& g) { g.Spacing[1] = bad; });
  }
  for (int bad : { 0, -5 })
  {
    expectNamed("NumberOfLines", [&](auto& p, auto&) { p.NumberOfLines = bad; });
    expectNamed("NumberOfHarmonics", [&](auto& p, auto&) { p.NumberOfHarmonics = bad; });
  }
  expectNamed("MinimumWavelength", [&](auto& p, auto&) { p.MinimumWavelength = nan; });
  expectNamed("AnisotropyAngle", [&](auto& p, auto&) { p.AnisotropyAngle = nan; });
  expectNamed("Origin", [&](auto&, auto& g) { g.Origin[0] = nan; });
}
