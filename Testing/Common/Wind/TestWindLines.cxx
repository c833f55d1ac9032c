// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The wind between lines and layers of the field: waves, variance, spectrum, mean.
#include "Wind/WindLines.h"
#include "WindSeries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <iostream>
#include <vector>

using namespace littoral;

namespace
{

/// What the waves of a grid carry by the spectrum at a height.
double VarianceOfWaves(const WindGrid& grid, int component, double height)
{
  double sum = 0.0;
  for (int frequency = 1; frequency < grid.Count[0] / 2; ++frequency)
  {
    sum += SpectralDensity({}, component, frequency / grid.Period(), height) / grid.Period();
  }
  return sum;
}

/// A field whose layers have the variance of their waves by the spectrum.
std::vector<float> WindOfItsWaves(const WindGrid& grid)
{
  std::vector<float> field = Wind(grid, {});
  const std::size_t samples = static_cast<std::size_t>(grid.Count[0]) * static_cast<std::size_t>(grid.Count[1]);
  for (int layer = 0; layer < grid.Count[2]; ++layer)
  {
    float* const values = &field[3 * samples * static_cast<std::size_t>(layer)];
    for (int component = 0; component < 3; ++component)
    {
      const double mean = component == 0 ? MeanSpeed({}, grid.Height(layer)) : 0.0;
      double has = 0.0;
      for (std::size_t n = 0; n < samples; ++n)
      {
        has += std::pow(values[3 * n + component] - mean, 2) / static_cast<double>(samples);
      }
      const double factor = std::sqrt(VarianceOfWaves(grid, component, grid.Height(layer)) / has);
      for (std::size_t n = 0; n < samples; ++n)
      {
        float& value = values[3 * n + component];
        value = static_cast<float>(mean + factor * (value - mean));
      }
    }
  }
  return field;
}

/// Variances at 16 places between lines over the spectrum's, and that of waves of 1 to 5 Hz half-way.
struct BetweenLines
{
  std::array<double, 3> Low{ 2.0, 2.0, 2.0 };
  std::array<double, 3> High{};
  std::array<double, 3> Fast{};
};

BetweenLines SamplesBetween(const WindLines& lines, const WindGrid& grid)
{
  BetweenLines between;
  std::vector<Vector3> series(600);
  for (int part = 0; part < 16; ++part)
  {
    const double up = 1.0 + 0.0625 * (7 * part % 16);
    std::array<double, 3> has{};
    for (int column = 0; column < 64; ++column)
    {
      lines.Sample({ 0.37 * column, column + part / 16.0, up }, 0.5, 600, series.data());
      std::vector<float> values(1800);
      for (int n = 0; n < 1800; ++n)
      {
        values[n] = static_cast<float>(series[n / 3][n % 3]);
      }
      for (int component = 0; component < 3; ++component)
      {
        has[component] += Variance(values.data(), 600, component) / 64.0;
      }
      if (part == 8)
      {
        for (int component = 0; component < 3; ++component)
        {
          const auto waves = Spectra(values, GridOf(600, 1, 1), component).front();
          for (int k = 60; k < 300; ++k)
          {
            between.Fast[component] += 2.0 * std::norm(waves[k] / 600.0) / 64.0;
          }
        }
      }
    }
    for (int component = 0; component < 3; ++component)
    {
      const double wants = VarianceOfWaves(grid, component, grid.BottomHeight + up * grid.VerticalSpacing);
      between.Low[component] = std::min(between.Low[component], has[component] / wants);
      between.High[component] = std::max(between.High[component], has[component] / wants);
    }
  }
  return between;
}

/// Variance of waves of 1 to 5 Hz of the lines of both layers, brought from their heights to half-way.
std::array<double, 3> FastWavesOfLines(const std::vector<float>& field, const WindGrid& grid)
{
  std::array<double, 3> fast{};
  for (int component = 0; component < 3; ++component)
  {
    const auto spectra = Spectra(field, grid, component);
    const auto density = [&](int k, double layer) {
      return SpectralDensity({}, component, k / 60.0, grid.BottomHeight + layer * grid.VerticalSpacing);
    };
    double sum = 0.0;
    for (int k = 60; k < 300; ++k)
    {
      for (int line = 0; line < 130; ++line)
      {
        const int layer = 1 + line / 65;
        sum += 2.0 * std::norm(spectra[65 + line][k] / 600.0) / 130.0 * density(k, 1.5) / density(k, layer);
      }
    }
    fast[component] = sum;
  }
  return fast;
}

}

TEST(WindLines, AlongTheWindTheSumOfWaves)
{
  // Of lengths that are and are not a product of 2, 3 and 5.
  for (const int length : { 60, 61, 62 })
  {
    std::vector<float> field(std::size_t(3) * length * 6);
    for (std::size_t n = 0; n < field.size(); ++n)
    {
      field[n] = static_cast<float>(std::sin(0.7 * static_cast<double>(n * n % 1009)));
    }
    const WindLines lines(field.data(), { length, 2, 3 });
    std::vector<Vector3> velocities(2 * length);
    for (const double first : { 0.0, -7.0, 100.5, 1e6 + 0.125 })
    {
      lines.Sample({ 13.3, 1.0, 2.0 }, first, velocities.size(), velocities.data());
      const float* line = &field[std::size_t(3) * length * 5];
      for (int n = 0; n < 2 * length; n += 7)
      {
        const double place = std::fmod(13.3 - first - n, length);
        for (int component = 0; component < 3; ++component)
        {
          ASSERT_NEAR(velocities[n][component], SumOfWaves(line, length, component, place), 2e-6) << length;
        }
      }
    }
    // At a sample the sample, beyond the edges those of the edge.
    lines.Sample({ 5.0, -1.0, 7.0 }, 0.0, 2, velocities.data());
    EXPECT_NEAR(velocities[0].x, field[3 * (5 + length * 4)], 1e-6);
    EXPECT_NEAR(velocities[1].z, field[3 * (4 + length * 4) + 2], 1e-6);
  }
}

TEST(WindLines, VarianceAndSpectrumBetweenLines)
{
  // Half-way between four lines a bilinear mean has 0.3 to 0.9 of the variance, and a quarter of that of short waves.
  // One run is brought to its spectrum's variance layer by layer; of places that repeat with the lines only the edges
  // of the plane do not cancel, hence 1 %.
  for (const double spacing : { 1.0, 4.0, 16.0 })
  {
    WindGrid grid;
    grid.Count = { 600, 65, 4 };
    grid.LateralSpacing = spacing;
    grid.VerticalSpacing = 0.5 * spacing;
    grid.BottomHeight = 4.0;
    const std::vector<float> field = WindOfItsWaves(grid);
    const WindLines lines(field.data(), grid.Count);
    const BetweenLines between = SamplesBetween(lines, grid);
    const std::array<double, 3> ofLines = FastWavesOfLines(field, grid);
    for (int component = 0; component < 3; ++component)
    {
      std::cout << "lines " << spacing << " m apart, component " << component << ": at 16 places between them "
                << between.Low[component] << " to " << between.High[component]
                << " of the spectrum's variance, half-way " << between.Fast[component] / ofLines[component]
                << " of the lines' from 1 to 5 Hz\n";
      EXPECT_GT(between.Low[component], 0.99);
      EXPECT_LT(between.High[component], 1.01);
      // The mean of the densities of layers 8 m apart is 2 % above that half-way, as it falls with the height.
      EXPECT_NEAR(between.Fast[component] / ofLines[component], 1.0, 0.03);
    }
  }
}

TEST(WindLines, MeanAndVarianceBetweenTheLowestLayers)
{
  // The layers of the default grid at 1 and 3 m. By the height itself, half-way, the mean is 3.6 % and the variance up
  // to 3.3 % too small.
  WindGrid grid;
  grid.Count = { 600, 65, 2 };
  const std::vector<float> field = WindOfItsWaves(grid);
  const WindLines lines(field.data(), grid.Count);
  std::vector<Vector3> series(600);
  double worst = 0.0;
  for (int part = 0; part < 16; ++part)
  {
    const double height = 1.0 + part / 8.0;
    std::array<double, 3> has{};
    for (int column = 0; column < 65; ++column)
    {
      lines.Sample({ 0.0, 1.0 * column, LayerPlace(height, 1.0, 2.0) }, 0.5, 600, series.data());
      Vector3 mean(0.0);
      Vector3 square(0.0);
      for (const Vector3& velocity : series)
      {
        mean += velocity / 600.0;
        square += velocity * velocity / 600.0;
      }
      EXPECT_NEAR(mean.x / MeanSpeed({}, height), 1.0, 1e-6);
      for (int component = 0; component < 3; ++component)
      {
        has[component] += (square[component] - mean[component] * mean[component]) / 65.0;
      }
    }
    for (int component = 0; component < 3; ++component)
    {
      worst = std::max(worst, std::abs(has[component] / VarianceOfWaves(grid, component, height) - 1.0));
    }
  }
  std::cout << "at 16 heights from 1 to 3 m the variance is within " << worst << " of the spectrum's\n";
  EXPECT_LT(worst, 0.01);
  // Below the ground there is no logarithm; beyond the layers the place is beyond.
  EXPECT_DOUBLE_EQ(LayerPlace(1.0, 0.0, 2.0), 0.5);
  EXPECT_LT(LayerPlace(0.5, 1.0, 2.0), 0.0);
  EXPECT_GT(LayerPlace(9.0, 1.0, 2.0), 4.0 - 1e-12);
}
