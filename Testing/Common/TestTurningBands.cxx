// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TurningBands.h"

#include "Constants.h"

#include <gtest/gtest.h>

#include <cmath>
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

TurningBandsParameters Parameters(CovarianceModel model, double range)
{
  TurningBandsParameters parameters;
  parameters.Field.Model = model;
  parameters.Field.Range = range;
  parameters.Field.SecondRange = 0.25 * range;
  return parameters;
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
  const int runs = 150;
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
  [](const auto& info) { return CovarianceModelName(static_cast<CovarianceModel>(info.param)); });

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
    parameters.ShortestWavelength = 4.0;
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
    EXPECT_NEAR(variance * 16, 9.0, 1e-9); // rescaled for the cut tail
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

TEST(TurningBands, ACoarseGridHoldsEveryFourthValue)
{
  TurningBandsParameters parameters = Parameters(CovarianceModel::Bessel1, 30.0);
  parameters.ShortestWavelength = 6.0;
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
  expectNamed("ShortestWavelength", [&](auto& p, auto&) { p.ShortestWavelength = nan; });
  expectNamed("AnisotropyAngle", [&](auto& p, auto&) { p.AnisotropyAngle = nan; });
  expectNamed("Origin", [&](auto&, auto& g) { g.Origin[0] = nan; });
}
