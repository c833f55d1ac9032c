// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The spectral wind against its own model: spectra, coherence, profile, the reference method, bytes, bad input.
#include "../OnThreads.h"
#include "../ProcessTeam.h"
#include "CholeskyWind.h"
#include "Wind/WindLines.h"
#include "WindSeries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <iostream>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

using namespace littoral;
using littoral::testing::OnThreads;

namespace
{

const double NotANumber = std::numeric_limits<double>::quiet_NaN();

/// Mean over the plane of the one-sided density that a field has, and of what the model says, frequency by frequency.
struct PlaneSpectrum
{
  std::vector<double> Has;
  std::vector<double> Wants;
};

PlaneSpectrum PlaneMean(
  const std::vector<float>& field, const WindGrid& grid, int component, const WindModel& model = {})
{
  const auto spectra = Spectra(field, grid, component);
  const double factor = 2.0 * grid.Period() / std::pow(grid.Count[0], 2.0) / static_cast<double>(grid.NumberOfLines());
  PlaneSpectrum mean{ std::vector<double>(spectra[0].size(), 0.0), std::vector<double>(spectra[0].size(), 0.0) };
  for (std::size_t k = 1; k < spectra[0].size(); ++k)
  {
    for (const auto& line : spectra)
    {
      mean.Has[k] += factor * std::norm(line[k]);
    }
    for (int layer = 0; layer < grid.Count[2]; ++layer)
    {
      mean.Wants[k] +=
        SpectralDensity(model, component, static_cast<double>(k) / grid.Period(), grid.Height(layer)) / grid.Count[2];
    }
  }
  return mean;
}

/// The largest difference of the means over third-octave bands from low to high [Hz], in decibels.
double WorstBand(const PlaneSpectrum& spectrum, const WindGrid& grid, double low, double high)
{
  double worst = 0.0;
  for (double begin = low; begin < high; begin *= std::pow(2.0, 1.0 / 3.0))
  {
    const double end = std::min(high, begin * std::pow(2.0, 1.0 / 3.0));
    double has = 0.0;
    double wants = 0.0;
    for (std::size_t k = 1; k < spectrum.Has.size(); ++k)
    {
      const double hertz = static_cast<double>(k) / grid.Period();
      if (hertz >= begin && hertz < end)
      {
        has += spectrum.Has[k];
        wants += spectrum.Wants[k];
      }
    }
    if (wants > 0.0)
    {
      worst = std::max(worst, std::abs(10.0 * std::log10(has / wants)));
    }
  }
  return worst;
}

/// Slope of a density over frequency, both logarithmic, by least squares.
double Slope(const std::vector<double>& density, const WindGrid& grid, double low, double high)
{
  double n = 0.0;
  double x1 = 0.0;
  double y1 = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  for (std::size_t k = 1; k < density.size(); ++k)
  {
    const double hertz = static_cast<double>(k) / grid.Period();
    if (hertz >= low && hertz <= high)
    {
      const double x = std::log(hertz);
      const double y = std::log(density[k]);
      n += 1.0;
      x1 += x;
      y1 += y;
      xx += x * x;
      xy += x * y;
    }
  }
  return (n * xy - x1 * y1) / (n * xx - x1 * x1);
}

/// Root coherence of pairs of lines a number of columns and layers apart, in bands of an octave.
struct CoherenceBands
{
  static constexpr int Bands = 10;
  static constexpr double Lowest = 0.01; // [Hz]
  std::array<double, Bands> Cross{};
  std::array<double, Bands> Auto{};
  std::array<double, Bands> Wants{};
  std::array<double, Bands> Count{};

  /// The spectra must be scaled to mean squares of 1.
  void Add(const std::vector<std::vector<std::complex<double>>>& spectra, const WindGrid& grid, int component,
    int across, int up)
  {
    const int columns = grid.Count[1] - across;
    const int layers = grid.Count[2] - up;
    const std::vector<int> bands = BandsOf(spectra[0].size(), grid);
    for (std::size_t k = 0; k < bands.size(); ++k)
    {
      if (bands[k] >= 0)
      {
        const double hertz = static_cast<double>(k) / grid.Period();
        this->Wants[bands[k]] += columns * layers *
          RootCoherence({}, component, hertz, across * grid.LateralSpacing, up * grid.VerticalSpacing);
        this->Count[bands[k]] += columns * layers;
      }
    }
    for (int pair = 0; pair < columns * layers; ++pair)
    {
      const int line = pair / columns * grid.Count[1] + pair % columns;
      this->AddPair(bands, spectra[line].data(), spectra[line + up * grid.Count[1] + across].data());
    }
  }

  /// Largest difference from the model over the bands from a frequency [Hz] on.
  double Worst(double low) const
  {
    double worst = 0.0;
    for (int band = 0; band < Bands; ++band)
    {
      if (Lowest * std::pow(2.0, band) >= low && this->Count[band] > 0.0)
      {
        worst = std::max(worst, std::abs(this->Has(band) - this->Wants[band] / this->Count[band]));
      }
    }
    return worst;
  }

  double Has(int band) const { return this->Cross[band] / this->Auto[band]; }

private:
  /// The band of each frequency; -1 outside of them, for the mean and for the fastest wave.
  static std::vector<int> BandsOf(std::size_t frequencies, const WindGrid& grid)
  {
    std::vector<int> bands(frequencies, -1);
    for (std::size_t k = 1; k + 1 < frequencies; ++k)
    {
      const int band = static_cast<int>(std::floor(std::log2(static_cast<double>(k) / grid.Period() / Lowest)));
      bands[k] = band < Bands ? std::max(band, -1) : -1;
    }
    return bands;
  }

  void AddPair(const std::vector<int>& bands, const std::complex<double>* a, const std::complex<double>* b)
  {
    for (std::size_t k = 0; k < bands.size(); ++k)
    {
      if (bands[k] >= 0)
      {
        this->Cross[bands[k]] += a[k].real() * b[k].real() + a[k].imag() * b[k].imag();
        this->Auto[bands[k]] += 0.5 * (std::norm(a[k]) + std::norm(b[k]));
      }
    }
  }
};

/// The spectra of all lines, each divided by the root of what the model says at its height.
std::vector<std::vector<std::complex<double>>> ScaledSpectra(
  const std::vector<float>& field, const WindGrid& grid, int component)
{
  auto spectra = Spectra(field, grid, component);
  const double unit = std::sqrt(2.0 * grid.Period()) / grid.Count[0];
  for (int layer = 0; layer < grid.Count[2]; ++layer)
  {
    for (std::size_t k = 1; k < spectra[0].size(); ++k)
    {
      const double scale =
        unit / std::sqrt(SpectralDensity({}, component, static_cast<double>(k) / grid.Period(), grid.Height(layer)));
      for (int column = 0; column < grid.Count[1]; ++column)
      {
        spectra[layer * grid.Count[1] + column][k] *= scale;
      }
    }
  }
  return spectra;
}

}

TEST(WindField, SpectraOfOneRun)
{
  const WindGrid grid = GridOf(12000, 32, 32);
  const std::vector<float> field = Wind(grid);
  for (int component = 0; component < WindComponents; ++component)
  {
    const PlaneSpectrum spectrum = PlaneMean(field, grid, component);
    const double worst = WorstBand(spectrum, grid, 0.2, 9.0);
    const double has = Slope(spectrum.Has, grid, 1.0, 8.0);
    const double wants = Slope(spectrum.Wants, grid, 1.0, 8.0);
    std::cout << "component " << component << ": third-octave bands 0.2-9 Hz within " << worst
              << " dB; slope at 1-8 Hz " << has << ", of the model " << wants << "\n";
    EXPECT_LT(worst, 0.15);
    EXPECT_NEAR(has, wants, 0.01);
  }
}

TEST(WindField, MeanIsTheLogarithmicLaw)
{
  const WindGrid grid = GridOf(8192, 8, 16);
  const std::vector<float> field = Wind(grid);
  double worst = 0.0;
  for (int layer = 0; layer < grid.Count[2]; ++layer)
  {
    const std::size_t count = static_cast<std::size_t>(grid.Count[0]) * grid.Count[1];
    double sum[3] = { 0.0, 0.0, 0.0 };
    for (std::size_t n = 0; n < count; ++n)
    {
      for (int component = 0; component < 3; ++component)
      {
        sum[component] += field[(layer * count + n) * 3 + component] / static_cast<float>(count);
      }
    }
    const double law = MeanSpeed({}, grid.Height(layer));
    worst = std::max({ worst, std::abs(sum[0] / law - 1.0), std::abs(sum[1]) / law, std::abs(sum[2]) / law });
  }
  std::cout << "mean off the logarithmic law by " << worst << " at most\n";
  EXPECT_LT(worst, 1e-6);
}

TEST(WindField, MeanIsThePowerLaw)
{
  WindModel model;
  model.ReferenceSpeed = 12.0;
  model.ReferenceHeight = 90.0;
  model.ShearExponent = 0.2;
  EXPECT_EQ(WhyInvalid(model), "");
  EXPECT_DOUBLE_EQ(MeanSpeed(model, 90.0), 12.0);
  EXPECT_NEAR(MeanSpeed(model, 180.0) / 12.0, 1.148698, 1e-6); // 2^0.2
  WindGrid grid = GridOf(16, 2, 3, 30.0);
  grid.BottomHeight = 60.0;
  const std::vector<float> field = Wind(grid, {}, model);
  for (int layer = 0; layer < 3; ++layer)
  {
    double mean = 0.0;
    for (int n = 0; n < 32; ++n)
    {
      mean += field[3 * (32 * layer + n)] / 32.0;
    }
    EXPECT_NEAR(mean, 12.0 * std::pow(grid.Height(layer) / 90.0, 0.2), 1e-5);
  }
  model.ShearExponent = 1.5;
  EXPECT_NE(WhyInvalid(model).find("ShearExponent"), std::string::npos);
}

TEST(WindField, CoherenceOfSixRuns)
{
  const WindGrid grid = GridOf(12000, 32, 32);
  std::array<std::array<CoherenceBands, 8>, 3> bands;
  const int steps[] = { 1, 2, 4, 8 };
  CoherenceBands wrap;
  for (int seed = 1; seed <= 6; ++seed)
  {
    WindSynthesis synthesis;
    synthesis.Seed = seed;
    const std::vector<float> field = Wind(grid, synthesis);
    for (int component = 0; component < 3; ++component)
    {
      const auto spectra = ScaledSpectra(field, grid, component);
      for (int n = 0; n < 4; ++n)
      {
        bands[component][n].Add(spectra, grid, component, steps[n], 0);
        bands[component][4 + n].Add(spectra, grid, component, 0, steps[n]);
      }
      wrap.Add(spectra, grid, component, 0, grid.Count[2] - 1);
    }
  }
  double worst = 0.0;
  double fast = 0.0;
  for (const auto& component : bands)
  {
    for (const CoherenceBands& one : component)
    {
      worst = std::max(worst, one.Worst(0.0));
      fast = std::max(fast, one.Worst(0.2));
    }
  }
  std::cout << "root coherence over 6 runs, 2 to 16 m apart, octaves from 0.01 Hz: within " << worst
            << "; above 0.2 Hz within " << fast << "\n";
  EXPECT_LT(worst, 0.06);
  EXPECT_LT(fast, 0.01);

  // On a circle without padding, top and bottom would be one spacing apart: a coherence of 0.55 at 0.3 Hz.
  const double leak = wrap.Worst(0.2);
  std::cout << "top and bottom layer, above 0.2 Hz: root coherence " << leak << " off the model\n";
  EXPECT_LT(leak, 0.01);
}

/// Sums over k of c(k) f(k) cos(pi k n / N), n = 0 ... N, of even functions given from 0 to N along both axes of a
/// quarter (c is 1 at 0 and N, else 2), by the matrix of those factors.
std::vector<double> EvenTransform(const std::vector<double>& quarter)
{
  const auto side = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(quarter.size()))));
  std::vector<double> factors;
  for (std::size_t n = 0; n < side * side; ++n)
  {
    const std::size_t k = n % side;
    factors.push_back((k % (side - 1) == 0 ? 1.0 : 2.0) *
      std::cos(std::acos(-1.0) * static_cast<double>(k * (n / side)) / static_cast<double>(side - 1)));
  }
  std::vector<double> turned = quarter;
  std::vector<double> sums(quarter.size());
  for (int axis = 0; axis < 2; ++axis)
  {
    for (std::size_t n = 0; n < sums.size(); ++n)
    {
      // transposed, so that the second pass goes along the other axis
      const auto row = turned.begin() + static_cast<std::ptrdiff_t>(n % side * side);
      sums[n] = std::inner_product(row, row + static_cast<std::ptrdiff_t>(side),
        factors.begin() + static_cast<std::ptrdiff_t>(n / side * side), 0.0);
    }
    turned = sums;
  }
  return sums;
}

/// The root coherence of a field of `cells` squared at a frequency, by cosine sums over twice as many: the power of its
/// waves, without what is negative, transformed back. Separations across are fastest, cells + 1 a row.
std::vector<double> CoherenceOfField(const WindModel& model, const WindGrid& grid, int component, double hertz)
{
  const auto side = static_cast<std::size_t>(grid.Count[1]) + 1;
  std::vector<double> quarter;
  for (std::size_t n = 0; n < side * side; ++n)
  {
    quarter.push_back(RootCoherence(model, component, hertz, static_cast<double>(n % side) * grid.LateralSpacing,
      static_cast<double>(n / side) * grid.VerticalSpacing));
  }
  quarter = EvenTransform(quarter);
  std::transform(quarter.begin(), quarter.end(), quarter.begin(), [](double power) { return std::max(power, 0.0); });
  quarter = EvenTransform(quarter);
  const double whole = quarter[0];
  std::transform(quarter.begin(), quarter.end(), quarter.begin(), [whole](double sum) { return sum / whole; });
  return quarter;
}

TEST(WindField, CoherenceIsTheModelWithinTheReportedError)
{
  const WindGrid grid = GridOf(2000, 16, 16);
  WindField field({}, grid, {});
  field.Make();
  double worst = 0.0;
  double fast = 0.0;
  double topBottom = 0.0;
  for (int component = 0; component < 3; ++component)
  {
    for (int frequency = 1; frequency <= 1000; ++frequency)
    {
      const double hertz = frequency / grid.Period();
      const std::vector<double> implied = CoherenceOfField({}, grid, component, hertz);
      for (int k = 0; k < grid.Count[2]; ++k)
      {
        for (int j = 0; j < grid.Count[1]; ++j)
        {
          const double error = std::abs(implied[k * (grid.Count[1] + 1) + j] -
            RootCoherence({}, component, hertz, j * grid.LateralSpacing, k * grid.VerticalSpacing));
          worst = std::max(worst, error);
          if (hertz > 0.2)
          {
            fast = std::max(fast, error);
            topBottom = k == grid.Count[2] - 1 ? std::max(topBottom, error) : topBottom;
          }
        }
      }
    }
  }
  std::cout << "implied root coherence within " << worst << " (reported " << field.GetCoherenceError()
            << "), above 0.2 Hz within " << fast << ", of top and bottom there within " << topBottom << "\n";
  EXPECT_NEAR(worst, field.GetCoherenceError(), 1e-4);
  EXPECT_LT(worst, 0.03);
  EXPECT_LT(fast, 1e-4);
}

TEST(WindField, AgreesWithCholesky)
{
  const WindGrid grid = GridOf(2000, 8, 8);
  std::vector<WindSynthesis> syntheses(12);
  std::vector<std::vector<float>> winds[2]; // by method
  for (std::size_t run = 0; run < syntheses.size(); ++run)
  {
    syntheses[run].Seed = static_cast<int>(run) + 1;
    winds[0].push_back(Wind(grid, syntheses[run]));
  }
  winds[1] = CholeskyWinds({}, grid, syntheses);
  for (int component = 0; component < 3; ++component)
  {
    PlaneSpectrum both{ std::vector<double>(1001, 0.0), std::vector<double>(1001, 0.0) };
    std::array<std::array<CoherenceBands, 2>, 2> bands; // by method, then across and up
    for (std::size_t run = 0; run < syntheses.size(); ++run)
    {
      for (int method = 0; method < 2; ++method)
      {
        const PlaneSpectrum spectrum = PlaneMean(winds[method][run], grid, component);
        std::vector<double>& sum = method == 0 ? both.Has : both.Wants;
        std::transform(sum.begin(), sum.end(), spectrum.Has.begin(), sum.begin(), std::plus<double>());
        const auto spectra = ScaledSpectra(winds[method][run], grid, component);
        bands[method][0].Add(spectra, grid, component, 2, 0);
        bands[method][1].Add(spectra, grid, component, 0, 2);
      }
    }
    const double decibels = WorstBand(both, grid, 1.0, 9.0);
    double apart = 0.0;
    for (int band = 5; band < CoherenceBands::Bands - 1; ++band) // from 0.32 Hz
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        apart = std::max(apart, std::abs(bands[0][axis].Has(band) - bands[1][axis].Has(band)));
      }
    }
    std::cout << "component " << component << ", 8 x 8, 12 runs: spectra of the two methods at 1-9 Hz within "
              << decibels << " dB, root coherence from 0.32 Hz within " << apart << "\n";
    EXPECT_LT(decibels, 0.15);
    EXPECT_LT(apart, 0.02);
  }
}

// Numbers of the guide: what a minute has no frequencies for, and the error of coherence and the divergence of a box.
TEST(WindField, NumbersOfTheDefaultField)
{
  const WindGrid grid;
  const auto missing = [&grid](int component, double height) {
    double sum = 0.0;
    for (int frequency = 1; frequency <= grid.Waves(); ++frequency)
    {
      sum += SpectralDensity({}, component, frequency / grid.Period(), height) / grid.Period();
    }
    return 100.0 * (1.0 - std::sqrt(sum / Variance({}, component)));
  };
  const double percent[2][3] = { { 13.0, 6.0, 6.0 }, { 29.0, 10.0, 5.0 } };
  for (int component = 0; component < 3; ++component)
  {
    EXPECT_NEAR(missing(component, 10.0), percent[0][component], 0.5);
    EXPECT_NEAR(missing(component, 47.0), percent[1][component], 0.5);
  }
  WindField wind({}, grid, {});
  const std::vector<float> field = wind.Make();
  EXPECT_NEAR(wind.GetCoherenceError(), 0.0153, 0.0001);
  const auto at = [&](int i, int j, int k, int component) {
    const std::size_t line = static_cast<std::size_t>(k) * grid.Count[1] + j;
    return static_cast<double>(field[3 * (line * grid.Count[0] + i) + component]);
  };
  std::array<double, 4> squares{}; // of gradients along, across and up, and of their sum
  for (int k = 0; k + 1 < grid.Count[2]; ++k)
  {
    for (int j = 0; j + 1 < grid.Count[1]; ++j)
    {
      for (int i = 0; i + 1 < grid.Count[0]; ++i)
      {
        const double gradients[] = { at(i + 1, j, k, 0) - at(i, j, k, 0), (at(i, j + 1, k, 1) - at(i, j, k, 1)) / 4.0,
          (at(i, j, k + 1, 2) - at(i, j, k, 2)) / 2.0 };
        const double sum = gradients[0] + gradients[1] + gradients[2];
        const double values[] = { gradients[0], gradients[1], gradients[2], sum };
        for (std::size_t n = 0; n < 4; ++n)
        {
          squares[n] += values[n] * values[n] / (23.0 * 63.0 * 599.0);
        }
      }
    }
  }
  const double roots[] = { 0.46, 0.24, 0.37, 0.64 };
  for (std::size_t n = 0; n < 4; ++n)
  {
    EXPECT_NEAR(std::sqrt(squares[n]), roots[n], 0.006);
  }
}

// IEC Kaimal: 0.15, 0.8 x 0.15 and 0.5 x 0.15 of the mean; eqs. 9.a and 9.b: 6 and 15 x 1.5 / 9.5 u*^2, as integrals
// from 0.
TEST(WindField, NormalizedVarianceIsThatOfAllFrequencies)
{
  WindModel iec;
  iec.Spectrum = WindSpectrumModel::IECKaimal;
  iec.ReferenceSpeed = 23.0;
  iec.TurbulenceIntensity = 0.15;
  const double friction = 0.4 * 10.0 / std::log(10.0 / 0.03);
  const std::pair<WindModel, std::array<double, 2>> asked[] = { { iec, { 0.15 * 23.0, 0.12 * 23.0 } },
    { WindModel(), { std::sqrt(6.0) * friction, std::sqrt(15.0 * 1.5 / 9.5) * friction } } };
  WindSynthesis synthesis;
  synthesis.NormalizeVariance = true;
  for (const auto& [model, deviations] : asked)
  {
    for (const int length : { 60, 1000 })
    {
      for (WindPhases phases : { WindPhases::Uniform, WindPhases::GaussianAmplitudes })
      {
        synthesis.Phases = phases;
        const WindGrid grid = GridOf(length, 8, 4);
        const std::vector<float> field = WindField(model, grid, synthesis).Make();
        for (std::size_t layer = 0; layer < 4; ++layer)
        {
          for (std::size_t component = 0; component < 2; ++component)
          {
            const std::size_t samples = 8 * static_cast<std::size_t>(length);
            const double mean = component == 0 ? MeanSpeed(model, grid.Height(static_cast<int>(layer))) : 0.0;
            double has = 0.0;
            for (std::size_t n = 0; n < samples; ++n)
            {
              has += std::pow(field[(layer * samples + n) * 3 + component] - mean, 2.0) / static_cast<double>(samples);
            }
            EXPECT_NEAR(std::sqrt(has) / deviations[component], 1.0, 1e-5) << length << " " << layer;
          }
        }
      }
    }
  }
}

TEST(WindField, DoesNotPulseBetweenItsTimes)
{
  // A straight line between samples has 0.54 to 0.97 of the variance half-way, and 0.5 or 0 of the fastest waves.
  for (const int length : { 4, 60, 600 })
  {
    for (const double step : { 0.025, 0.1, 1.0 })
    {
      WindGrid grid;
      grid.Count = { length, 11, 2 }; // a whole pack of lines and a part of one
      grid.TimeStep = step;
      const std::vector<float> field = Wind(grid);
      const WindCarrier carrier(length);
      WindCarrier::Room room(length);
      double worst = 0.0;
      double off = 0.0;
      for (int part = 1; part < 16; ++part)
      {
        for (int first : { 0, FourierLanes })
        {
          const int lines = std::min(FourierLanes, 11 - first);
          carrier.Carry(&field[std::size_t(3) * length * first], lines, part / 16.0, room);
          for (int line = 0; line < lines; ++line)
          {
            const float* was = &field[std::size_t(3) * length * (first + line)];
            const float* is = &room.Velocities[std::size_t(3) * length * line];
            for (int component = 0; component < 3; ++component)
            {
              worst =
                std::max(worst, std::abs(Variance(is, length, component) / Variance(was, length, component) - 1.0));
            }
            for (int n = 0; n < length && part % 5 == 3 && line % 5 == 2; n += length / 4)
            {
              off = std::max(off, std::abs(is[3 * n + 1] - SumOfWaves(was, length, 1, n - part / 16.0)));
            }
          }
        }
      }
      std::cout << length << " samples of " << step << " s: at 15 times between steps the variance is within " << worst
                << " of that at them, the wind within " << off << " m/s of its Fourier series\n";
      EXPECT_LT(worst, 1e-4); // single precision, with the mean wind in it
      EXPECT_LT(off, 2e-5);
    }
  }
}

TEST(WindField, IECCoherenceOfTheField)
{
  WindModel model;
  model.Spectrum = WindSpectrumModel::IECKaimal;
  model.Coherence = WindCoherenceModel::IEC;
  const WindGrid grid = GridOf(1200, 16, 16);
  WindField field(model, grid, {});
  field.Make();
  double worst = 0.0;
  for (int frequency = 1; frequency < 600; ++frequency)
  {
    const std::vector<double> implied = CoherenceOfField(model, grid, 0, frequency / grid.Period());
    for (int k = 0; k < 16; ++k)
    {
      for (int j = 0; j < 16; ++j)
      {
        const double distance = 2.0 * std::hypot(j, k);
        const double wants = std::exp(-12.0 * std::hypot(frequency / 60.0 * distance / 10.0, 0.12 * distance / 56.7));
        worst = std::max(worst, std::abs(implied[k * 17 + j] - wants));
      }
    }
  }
  std::cout << "IEC root coherence of the field within " << worst << " (reported " << field.GetCoherenceError()
            << " for all components)\n";
  EXPECT_LT(worst, field.GetCoherenceError() + 1e-4);
  EXPECT_LT(worst, 0.03);
}

TEST(WindField, GaussianAmplitudesHaveUnitPower)
{
  WindSynthesis synthesis;
  synthesis.Phases = WindPhases::GaussianAmplitudes;
  std::vector<float> re(100000);
  std::vector<float> im(re.size());
  WindFactors(synthesis, 1, 7, 0, re.size(), re.data(), im.data());
  double power = 0.0;
  double fourth = 0.0;
  for (std::size_t n = 0; n < re.size(); ++n)
  {
    const double square = static_cast<double>(re[n]) * re[n] + static_cast<double>(im[n]) * im[n];
    power += square / static_cast<double>(re.size());
    fourth += square * square / static_cast<double>(re.size());
  }
  EXPECT_NEAR(power, 1.0, 0.02);
  EXPECT_NEAR(fourth, 2.0, 0.1);
}

namespace
{

/// Power and co-spectrum of the components along and up over a band of frequencies [Hz], the mean over lines.
struct BandStress
{
  double Along = 0.0;
  double Up = 0.0;
  double Both = 0.0;
};

BandStress StressIn(const std::vector<float>& field, const WindGrid& grid, double low, double high)
{
  const auto along = Spectra(field, grid, 0);
  const auto up = Spectra(field, grid, 2);
  const double factor = 2.0 / std::pow(grid.Count[0], 2.0) / static_cast<double>(grid.NumberOfLines());
  BandStress sum;
  for (std::size_t line = 0; line < along.size(); ++line)
  {
    for (std::size_t k = 1; k < along[line].size(); ++k)
    {
      const double hertz = static_cast<double>(k) / grid.Period();
      const double part = hertz >= low && hertz < high ? factor : 0.0;
      sum.Along += part * std::norm(along[line][k]);
      sum.Up += part * std::norm(up[line][k]);
      sum.Both += part * (along[line][k] * std::conj(up[line][k])).real();
    }
  }
  return sum;
}

/// Integral of Kaimal's co-spectrum over u_*^2 from 0 to a frequency: -14/(9.6 x 1.4) (1 - (1 + 9.6 n)^-1.4).
double KaimalStress(double hertz, double height)
{
  const double n = hertz * height / MeanSpeed({}, height);
  return -14.0 / (9.6 * 1.4) * (1.0 - std::pow(1.0 + 9.6 * n, -1.4));
}

}

TEST(WindField, ShearStressIsThatOfTheCospectrumAndSpectraStay)
{
  WindGrid grid;
  grid.Count = { 24000, 32, 1 }; // lines so far apart that each is a run of its own
  grid.TimeStep = 0.25;
  grid.LateralSpacing = 1000.0;
  grid.BottomHeight = 10.0;
  WindSynthesis synthesis;
  const std::vector<float> without = Wind(grid, synthesis);
  synthesis.ShearStress = true;
  const std::vector<float> with = Wind(grid, synthesis);
  const double unit = std::pow(FrictionVelocity({}), 2.0);
  EXPECT_NEAR(StressIn(with, grid, 0.0, 9.0).Both / unit, -1.0, 0.05);
  EXPECT_NEAR(StressIn(without, grid, 0.0, 9.0).Both / unit, 0.0, 0.02);
  for (const auto& [low, high] : { std::pair(1e-9, 0.06), std::pair(0.06, 0.3), std::pair(0.3, 1.99) })
  {
    const BandStress before = StressIn(without, grid, low, high);
    const BandStress after = StressIn(with, grid, low, high);
    EXPECT_EQ(after.Along, before.Along);
    EXPECT_LT(std::abs(10.0 * std::log10(after.Up / before.Up)), 0.1) << low;
    EXPECT_NEAR(after.Both / unit, KaimalStress(high, 10.0) - KaimalStress(low, 10.0), 0.02) << low;
  }
}

TEST(WindField, ShearStressOfComponentsThatAreNotCoherentAlike)
{
  WindGrid grid;
  grid.Count = { 24000, 16, 1 };
  grid.TimeStep = 0.25;
  grid.BottomHeight = 10.0;
  WindModel model;
  model.Decay = { { { 2.0, 2.0 }, { 10.0, 10.0 }, { 30.0, 30.0 } } };
  WindSynthesis synthesis;
  synthesis.ShearStress = true;
  const BandStress stress = StressIn(Wind(grid, synthesis, model), grid, 0.1, 1.0);
  const double unit = std::pow(FrictionVelocity(model), 2.0);
  EXPECT_NEAR(stress.Both / unit, KaimalStress(1.0, 10.0) - KaimalStress(0.1, 10.0), 0.02);
}

TEST(WindField, ShearStressHardlyMovesCoherence)
{
  // Of two heights the coherence is multiplied by g g' + ((1 - g^2) (1 - g'^2))^(1/2); g by another formula.
  const auto part = [](double f, double z) {
    const double n = f * z / MeanSpeed({}, z);
    return 14.0 * std::pow(1.0 + 9.6 * n, -2.4) /
      std::sqrt(200.0 * std::pow(1.0 + 50.0 * n, -5.0 / 3.0) * 3.36 / (1.0 + 10.0 * std::pow(n, 5.0 / 3.0)));
  };
  double worst = 0.0;
  for (double f = 1e-3; f < 10.0; f *= 1.1)
  {
    for (double z = 1.0; z <= 60.0; z += 1.0)
    {
      EXPECT_NEAR(part(f, z),
        -ShearDensity({}, f, z) / std::sqrt(SpectralDensity({}, 0, f, z) * SpectralDensity({}, 2, f, z)), 1e-9);
      EXPECT_LT(part(f, z), 0.7);
      for (double other = z; other <= 60.0; other += 1.0)
      {
        const double g = part(f, z);
        const double h = part(f, other);
        const double factor = g * h + std::sqrt((1.0 - g * g) * (1.0 - h * h));
        worst = std::max(worst, (1.0 - factor) * RootCoherence({}, 2, f, 0.0, other - z));
      }
    }
  }
  EXPECT_LT(worst, 0.011);
}

TEST(WindField, SameBytesForAnyThreads)
{
  const WindGrid grid = GridOf(600, 10, 6);
  WindField one({}, grid, {});
  WindField two({}, grid, {});
  WindField five({}, grid, {});
  const std::vector<float> field = one.Make();
  EXPECT_EQ(field, two.Make(OnThreads(2)));
  EXPECT_EQ(field, five.Make(OnThreads(5)));
  WindSynthesis other;
  other.Seed = 2;
  EXPECT_NE(field, Wind(grid, other));
}

// Three processes, one with the last columns, one with a border in common, one with none at all: all samples of each
// are those of one process, and so is what is said of the coherence.
TEST(WindField, ProcessesShareTheBytesOfOne)
{
  const WindGrid grid = GridOf(600, 10, 6);
  WindSynthesis synthesis;
  synthesis.ShearStress = true;
  synthesis.NormalizeVariance = true;
  WindField alone({}, grid, synthesis);
  const std::vector<float> whole = alone.Make();
  const std::vector<WindColumns> columns{ { 4, 10 }, { 0, 5 }, {} };
  littoral::testing::ProcessTeam(columns.size()).Run([&](const WorkShare& share) {
    const WindColumns& own = columns[share.Rank];
    WindField shared({}, grid, synthesis, own);
    const std::vector<float> part = shared.MakeShared(share);
    EXPECT_EQ(shared.GetCoherenceError(), alone.GetCoherenceError());
    const auto line = static_cast<std::size_t>(3 * grid.Count[0]);
    const auto width = static_cast<std::size_t>(own.Count());
    ASSERT_EQ(part.size(), line * width * grid.Count[2]);
    for (std::size_t n = 0; width > 0 && n < width * grid.Count[2]; ++n)
    {
      const std::size_t from = n / width * grid.Count[1] + own.First + n % width;
      EXPECT_TRUE(std::equal(&part[n * line], &part[n * line] + line, &whole[from * line])) << share.Rank << " " << n;
    }
  });
}

TEST(WindField, SaysWhatIsWrong)
{
  const auto says = [](const char* word, const WindModel& model, const WindGrid& grid) {
    const std::string reason = WhyInvalid(model, grid);
    EXPECT_NE(reason.find(word), std::string::npos) << word << ": " << reason;
  };
  EXPECT_EQ(WhyInvalid({}, {}), "");
  WindGrid grid;
  grid.Count[0] = 601;
  says("640", {}, grid);
  grid.Count[0] = 14;
  says("16", {}, grid);
  grid.Count[0] = 0;
  says("Dimensions", {}, grid);
  for (double bad : { 0.0, -1.0, NotANumber, std::numeric_limits<double>::infinity() })
  {
    grid = {};
    grid.TimeStep = bad;
    says("TimeStep", {}, grid);
    grid = {};
    grid.LateralSpacing = bad;
    says("LateralSpacing", {}, grid);
    grid = {};
    grid.VerticalSpacing = bad;
    says("VerticalSpacing", {}, grid);
    grid = {};
    grid.BottomHeight = bad;
    says("BottomHeight", {}, grid);
    WindModel model;
    model.ReferenceSpeed = bad;
    says("ReferenceSpeed", model, {});
    model = {};
    model.ReferenceHeight = bad;
    says("ReferenceHeight", model, {});
    model = {};
    model.RoughnessLength = bad;
    says("RoughnessLength", model, {});
    model = {};
    model.Coherence = static_cast<WindCoherenceModel>(2);
    says("Coherence", model, {});
    model = {};
    model.Decay[1].Vertical = bad;
    says("LateralDecay", model, {});
  }
  WindModel rough;
  rough.RoughnessLength = 1.5;
  says("RoughnessLength of 1.5", rough, {});
}
