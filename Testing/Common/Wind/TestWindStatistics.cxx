// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Statistics of winds whose spectra, coherence and profile are known in closed form, and of a synthesized one.
#include "Wind/WindStatistics.h"

#include "Numerics/InvalidInput.h"
#include "WindSeries.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace littoral;

namespace
{

const double Pi = std::acos(-1.0);

/// A wave of amplitude 2 m/s and 5 periods along the wind in one component, over a mean of 7 m/s; each column is a
/// sixth of a turn behind the last one.
std::vector<float> OneWave(const WindGrid& grid, int component)
{
  std::vector<float> velocities(grid.NumberOfLines() * grid.Count[0] * WindComponents, 0.0f);
  for (std::size_t line = 0; line < grid.NumberOfLines(); ++line)
  {
    for (int sample = 0; sample < grid.Count[0]; ++sample)
    {
      const double phase = 2.0 * Pi * (5.0 * sample / grid.Count[0] + static_cast<double>(line % grid.Count[1]) / 6.0);
      float* velocity = velocities.data() + (line * grid.Count[0] + sample) * WindComponents;
      velocity[0] = 7.0f;
      velocity[component] += static_cast<float>(2.0 * std::cos(phase));
    }
  }
  return velocities;
}

}

TEST(WindStatistics, OneWaveHasItsVarianceAtItsFrequency)
{
  const WindGrid grid = GridOf(60, 6, 2);
  for (int component = 0; component < WindComponents; ++component)
  {
    const std::vector<float> wind = OneWave(grid, component);
    const WindStatistics statistics(wind.data(), grid, WindModel());
    // So many bands that each holds one frequency: density times the step of frequency is the variance, 2^2 / 2.
    const std::vector<WindBand> bands = statistics.Spectra(1, 1000);
    ASSERT_EQ(bands.size(), 29u);
    for (std::size_t k = 0; k < bands.size(); ++k)
    {
      EXPECT_NEAR(bands[k].Frequency, static_cast<double>(k + 1) / 3.0, 1e-12); // a period of 3 s
      EXPECT_NEAR(bands[k].Measured[component] / 3.0, k == 4 ? 2.0 : 0.0, 1e-5);
    }
    const WindLayer layer = statistics.Profile()[1];
    EXPECT_NEAR(layer.Height, 3.0, 1e-12);
    EXPECT_NEAR(layer.Speed, 7.0, 1e-6);
    EXPECT_NEAR(layer.Deviation[component], std::sqrt(2.0), 1e-6);
  }
}

TEST(WindStatistics, BandsKeepTheVariance)
{
  const WindGrid grid = GridOf(64, 3, 1);
  const std::vector<float> wind = OneWave(grid, 2);
  const WindStatistics statistics(wind.data(), grid, WindModel());
  const std::vector<WindBand> bands = statistics.Spectra(0, 5);
  ASSERT_EQ(bands.size(), 5u);
  // Waves 1, 2-3, 4-7, 8-15, 16-31: five waves a period are in the third band.
  const double widths[] = { 1.0, 2.0, 4.0, 8.0, 16.0 };
  double variance = 0.0;
  for (std::size_t k = 0; k < bands.size(); ++k)
  {
    variance += bands[k].Measured[2] * widths[k] / grid.Period();
  }
  EXPECT_NEAR(bands[2].Measured[2] * 4.0 / grid.Period(), 2.0, 1e-5);
  EXPECT_NEAR(variance, 2.0, 1e-5);
}

TEST(WindStatistics, CoherenceIsTheCosineOfTheDelay)
{
  const WindGrid grid = GridOf(60, 7, 2);
  const std::vector<float> wind = OneWave(grid, 1);
  const WindStatistics statistics(wind.data(), grid, WindModel());
  for (const int columns : { 1, 2, 3 })
  {
    EXPECT_NEAR(statistics.Coherence(0, columns, 0, 1000)[4].Measured[1], std::cos(columns * Pi / 3.0), 1e-6);
    EXPECT_NEAR(statistics.Coherence(0, columns, 1, 1000)[4].Measured[1], std::cos(columns * Pi / 3.0), 1e-6);
  }
  EXPECT_NEAR(statistics.Coherence(0, 0, 1, 1000)[4].Measured[1], 1.0, 1e-6);
}

TEST(WindStatistics, CalmAirHasNoCoherence)
{
  const WindGrid grid = GridOf(60, 7, 2);
  const std::vector<float> calm(OneWave(grid, 1).size(), 0.0f);
  const WindStatistics statistics(calm.data(), grid, WindModel());
  EXPECT_TRUE(std::isnan(statistics.Coherence(0, 1, 0, 10).front().Measured[0]));
  EXPECT_EQ(statistics.Spectra(0, 10).front().Measured[0], 0.0);
  EXPECT_EQ(statistics.Profile().front().Deviation[0], 0.0);
}

TEST(WindStatistics, ModelIsThatOfTheFormulas)
{
  const WindGrid grid = GridOf(60, 6, 2);
  WindModel model;
  model.RoughnessLength = 0.1;
  const std::vector<float> wind = OneWave(grid, 0);
  const WindStatistics statistics(wind.data(), grid, model);
  const double friction = 0.4 * 10.0 / std::log(10.0 / 0.1);
  const double speed = friction / 0.4 * std::log(3.0 / 0.1);
  const double frequency = 2.0;
  // Simiu and Scanlan: S_u = 200 u*^2 z / U (1 + 50 f z / U)^(-5/3)
  const double density =
    200.0 * friction * friction * 3.0 / speed * std::pow(1.0 + 50.0 * frequency * 3.0 / speed, -5.0 / 3.0);
  EXPECT_NEAR(statistics.Spectra(1, 1000)[5].Model[0], density, 1e-9);
  EXPECT_NEAR(statistics.Profile()[1].ModelSpeed, speed, 1e-9);
  // exp(-C f d / U_10), three columns of 2 m
  EXPECT_NEAR(statistics.Coherence(0, 3, 0, 1000)[5].Model[0], std::exp(-10.0 * frequency * 6.0 / 10.0), 1e-9);
}

TEST(WindStatistics, CoherenceIsThatOfTheDistancesOfColumnsAndLayers)
{
  WindGrid grid = GridOf(60, 6, 3);
  grid.LateralSpacing = 1.5;
  grid.VerticalSpacing = 4.0;
  const std::vector<float> wind = OneWave(grid, 0);
  const WindStatistics statistics(wind.data(), grid, WindModel());
  const double frequency = 1.0;
  const auto model = [&](int layer, int columns, int layers) {
    return statistics.Coherence(layer, columns, layers, 1000)[2].Model[0];
  };
  // exp(-C f d / U_10) of 3 m across, 8 m up or down, and both
  EXPECT_NEAR(model(1, 2, 0), std::exp(-10.0 * frequency * 3.0 / 10.0), 1e-9);
  EXPECT_NEAR(model(0, 0, 2), std::exp(-10.0 * frequency * 8.0 / 10.0), 1e-9);
  EXPECT_NEAR(model(2, 0, -2), std::exp(-10.0 * frequency * 8.0 / 10.0), 1e-9);
  EXPECT_NEAR(model(0, 2, 2), std::exp(-10.0 * frequency * std::hypot(3.0, 8.0) / 10.0), 1e-9);
}

/// What is measured in a synthesized wind is its model, within the scatter of a wide field.
TEST(WindStatistics, SynthesizedWindFollowsItsModel)
{
  WindGrid grid = GridOf(1200, 64, 4);
  const std::vector<float> wind = Wind(grid);
  const WindStatistics statistics(wind.data(), grid, WindModel());
  const std::vector<WindBand> spectra = statistics.Spectra(2, 8);
  const std::vector<WindBand> coherence = statistics.Coherence(2, 1, 0, 8);
  for (int component = 0; component < WindComponents; ++component)
  {
    for (std::size_t k = 4; k < spectra.size(); ++k) // slower gusts are too few
    {
      EXPECT_NEAR(spectra[k].Measured[component] / spectra[k].Model[component], 1.0, 0.15) << component << " " << k;
      EXPECT_NEAR(coherence[k].Measured[component], coherence[k].Model[component], 0.06) << component << " " << k;
    }
  }
  for (const WindLayer& layer : statistics.Profile())
  {
    EXPECT_NEAR(layer.Speed / layer.ModelSpeed, 1.0, 1e-5);
    for (int component = 0; component < WindComponents; ++component)
    {
      EXPECT_NEAR(layer.Deviation[component] / layer.ModelDeviation[component], 1.0, 0.15);
    }
  }
}

// Layers 1, 3, 5 ... 15 m high and 2 m apart, columns 4 m apart: the nearest ones, downwards where there is none above.
TEST(WindStatistics, PlacesNearestToWhatIsAskedFor)
{
  WindGrid grid;
  grid.Count = { 60, 6, 8 };
  WindPlaces places = FindPlaces(grid, 6.1, { 7.9, 4.2 });
  EXPECT_EQ(places.Layer, 3); // 7 m
  EXPECT_EQ(places.Columns, 2);
  EXPECT_EQ(places.Layers, 2);
  places = FindPlaces(grid, 100.0, { 0.0, 4.0 });
  EXPECT_EQ(places.Layer, 7);
  EXPECT_EQ(places.Layers, -2);
  EXPECT_EQ(FindPlaces(grid, -5.0, { 4.0, 0.0 }).Layer, 0);
  // Less than half a spacing is one spacing, along the axis of which it is more.
  places = FindPlaces(grid, 6.1, { 1.9, 0.9 });
  EXPECT_EQ(places.Columns, 1);
  EXPECT_EQ(places.Layers, 0);
  places = FindPlaces(grid, 6.1, { 0.5, 0.9 });
  EXPECT_EQ(places.Columns, 0);
  EXPECT_EQ(places.Layers, 1);
  for (const std::array<double, 2>& separation : { std::array{ 0.0, 0.0 }, { 24.0, 0.0 }, { 0.0, 16.0 } })
  {
    const std::string why = WhyRefused([&] { FindPlaces(grid, 6.0, separation); });
    EXPECT_NE(why.find("Separation is"), std::string::npos) << separation[0] << separation[1];
  }
}
