// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/WindStatistics.h"

#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/PeriodFourier.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace littoral
{

WindPlaces FindPlaces(const WindGrid& grid, double height, const std::array<double, 2>& separation)
{
  WindPlaces places;
  const double layer = std::round((height - grid.BottomHeight) / grid.VerticalSpacing);
  places.Layer = static_cast<int>(std::clamp(layer, 0.0, grid.Count[2] - 1.0));
  const double across = separation[0] / grid.LateralSpacing;
  const double up = separation[1] / grid.VerticalSpacing;
  double columns = std::round(across);
  double layers = std::round(up);
  if (columns == 0.0 && layers == 0.0 && across + up > 0.0)
  {
    (across >= up ? columns : layers) = 1.0; // a coherence needs two places
  }
  const bool isAbove = places.Layer + layers < grid.Count[2];
  if ((columns == 0.0 && layers == 0.0) || columns >= grid.Count[1] || !(isAbove || layers <= places.Layer))
  {
    Refuse("Separation is ", TextOf(separation[0]), ", ", TextOf(separation[1]),
      " m; it must not be 0, 0 and, rounded to spacings of ", TextOf(grid.LateralSpacing), ", ",
      TextOf(grid.VerticalSpacing), " m, lie within the wind.");
  }
  places.Columns = static_cast<int>(columns);
  places.Layers = static_cast<int>(isAbove ? layers : -layers);
  return places;
}

/// Sums over the frequencies of each band.
class WindStatistics::Bands
{
public:
  Bands(const WindGrid& grid, int bands)
    : Period(grid.Period())
    , Waves((grid.Count[0] - 1) / 2)
    , Number(bands)
  {
  }

  int NumberOfWaves() const { return this->Waves; }
  double Frequency(int wave) const { return wave / this->Period; }

  /// Mean over the waves of each band of measured(component, wave) and model(component, wave); waves are 1, 2 ...
  template <typename Measured, typename Model>
  std::vector<WindBand> Means(const Measured& measured, const Model& model) const
  {
    std::vector<WindBand> bands;
    for (int first = 1; first <= this->Waves;)
    {
      int last = first;
      while (last < this->Waves && this->BandOf(last + 1) == this->BandOf(first))
      {
        ++last;
      }
      WindBand band{};
      const double share = 1.0 / (last - first + 1);
      for (int wave = first; wave <= last; ++wave)
      {
        band.Frequency += share * this->Frequency(wave);
        for (int component = 0; component < WindComponents; ++component)
        {
          band.Model[component] += share * model(component, wave);
        }
      }
      for (int component = 0; component < WindComponents; ++component)
      {
        band.Measured[component] = measured(component, first, last);
      }
      bands.push_back(band);
      first = last + 1;
    }
    return bands;
  }

private:
  int BandOf(int wave) const
  {
    const double part = this->Waves > 1 ? std::log(wave) / std::log(this->Waves) : 0.0;
    return std::min(this->Number - 1, static_cast<int>(this->Number * part));
  }

  double Period;
  int Waves;
  int Number;
};

WindStatistics::WindStatistics(const float* velocities, const WindGrid& grid, const WindModel& model, Poll onLine)
  : Velocities(velocities)
  , Grid(grid)
  , Model(model)
  , OnLine(std::move(onLine))
{
}

double WindStatistics::At(int sample, int column, int layer, int component) const
{
  const std::size_t line = static_cast<std::size_t>(layer) * this->Grid.Count[1] + column;
  return this->Velocities[(line * this->Grid.Count[0] + sample) * WindComponents + component];
}

/// X_k, k = 0, 1 ... (N - 1) / 2, of a line.
WindStatistics::Amplitudes WindStatistics::AmplitudesOf(int column, int layer, int component) const
{
  this->OnLine();
  const int length = this->Grid.Count[0];
  PeriodFourier::Line line(length);
  for (int sample = 0; sample < length; ++sample)
  {
    line[sample] = this->At(sample, column, layer, component);
  }
  line = PeriodFourier(length).Forward(line);
  Amplitudes amplitudes;
  for (int wave = 0; wave <= (length - 1) / 2; ++wave)
  {
    amplitudes.push_back(line[wave].real());
    amplitudes.push_back(line[wave].imag());
  }
  return amplitudes;
}

std::vector<WindBand> WindStatistics::Spectra(int layer, int bands) const
{
  const Bands means(this->Grid, bands);
  std::array<std::vector<double>, WindComponents> powers; // sum over lines of |X_k|^2
  for (int component = 0; component < WindComponents; ++component)
  {
    powers[component].assign(means.NumberOfWaves() + 1, 0.0);
    for (int column = 0; column < this->Grid.Count[1]; ++column)
    {
      const Amplitudes x = this->AmplitudesOf(column, layer, component);
      for (int wave = 1; wave <= means.NumberOfWaves(); ++wave)
      {
        powers[component][wave] += x[2 * wave] * x[2 * wave] + x[2 * wave + 1] * x[2 * wave + 1];
      }
    }
  }
  // S(f_k) = 2 T / N^2 |X_k|^2, one-sided
  const double length = this->Grid.Count[0];
  const double unit = 2.0 * this->Grid.Period() / (length * length * this->Grid.Count[1]);
  const double height = this->Grid.Height(layer);
  return means.Means(
    [&](int component, int first, int last) {
      double sum = 0.0;
      for (int wave = first; wave <= last; ++wave)
      {
        sum += powers[component][wave];
      }
      return unit * sum / (last - first + 1);
    },
    [&](int component, int wave) { return SpectralDensity(this->Model, component, means.Frequency(wave), height); });
}

std::vector<WindBand> WindStatistics::Coherence(int layer, int columns, int layers, int bands) const
{
  const Bands means(this->Grid, bands);
  const std::size_t size = means.NumberOfWaves() + 1;
  // Sums over pairs of lines of Re X Y*, |X|^2 and |Y|^2.
  struct Sums
  {
    std::vector<double> Cross;
    std::vector<double> First;
    std::vector<double> Second;
  };
  std::array<Sums, WindComponents> sums;
  for (int component = 0; component < WindComponents; ++component)
  {
    Sums& sum = sums[component];
    sum = { std::vector<double>(size), std::vector<double>(size), std::vector<double>(size) };
    for (int column = 0; column + columns < this->Grid.Count[1]; ++column)
    {
      const Amplitudes x = this->AmplitudesOf(column, layer, component);
      const Amplitudes y = this->AmplitudesOf(column + columns, layer + layers, component);
      for (std::size_t wave = 1; wave < size; ++wave)
      {
        const std::size_t re = 2 * wave;
        const std::size_t im = re + 1;
        sum.Cross[wave] += x[re] * y[re] + x[im] * y[im];
        sum.First[wave] += x[re] * x[re] + x[im] * x[im];
        sum.Second[wave] += y[re] * y[re] + y[im] * y[im];
      }
    }
  }
  const double across = columns * this->Grid.LateralSpacing;
  const double up = std::abs(layers) * this->Grid.VerticalSpacing;
  return means.Means(
    [&](int component, int first, int last) {
      const Sums& sum = sums[component];
      double cross = 0.0;
      double squares[2] = { 0.0, 0.0 };
      for (int wave = first; wave <= last; ++wave)
      {
        cross += sum.Cross[wave];
        squares[0] += sum.First[wave];
        squares[1] += sum.Second[wave];
      }
      return cross / std::sqrt(squares[0] * squares[1]);
    },
    [&](int component, int wave) { return RootCoherence(this->Model, component, means.Frequency(wave), across, up); });
}

std::vector<WindLayer> WindStatistics::Profile() const
{
  const Bands waves(this->Grid, 1);
  const int samples = this->Grid.Count[0];
  std::vector<WindLayer> layers;
  for (int layer = 0; layer < this->Grid.Count[2]; ++layer)
  {
    WindLayer row{};
    row.Height = this->Grid.Height(layer);
    row.ModelSpeed = MeanSpeed(this->Model, row.Height);
    for (int component = 0; component < WindComponents; ++component)
    {
      double variance = 0.0;
      double total = 0.0;
      for (int column = 0; column < this->Grid.Count[1]; ++column)
      {
        this->OnLine();
        double sum = 0.0;
        for (int sample = 0; sample < samples; ++sample)
        {
          sum += this->At(sample, column, layer, component);
        }
        const double mean = sum / samples;
        for (int sample = 0; sample < samples; ++sample)
        {
          const double gust = this->At(sample, column, layer, component) - mean;
          variance += gust * gust / samples;
        }
        total += mean;
      }
      row.Speed = component == 0 ? total / this->Grid.Count[1] : row.Speed;
      row.Deviation[component] = std::sqrt(variance / this->Grid.Count[1]);
      // sigma^2 = sum over k of S(k / T) / T
      double modelVariance = 0.0;
      for (int wave = 1; wave <= waves.NumberOfWaves(); ++wave)
      {
        modelVariance +=
          SpectralDensity(this->Model, component, waves.Frequency(wave), row.Height) / this->Grid.Period();
      }
      row.ModelDeviation[component] = std::sqrt(modelVariance);
    }
    layers.push_back(row);
  }
  return layers;
}

}
