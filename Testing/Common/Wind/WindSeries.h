// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTestWindSeries_h
#define LittoralTestWindSeries_h

// Fields of wind, and what is measured in their lines.
#include "Wind/WindField.h"

#include <kissfft/kissfft.hh>

#include <cmath>
#include <complex>
#include <vector>

namespace littoral
{

inline WindGrid GridOf(int along, int across, int up, double spacing = 2.0)
{
  WindGrid grid;
  grid.Count = { along, across, up };
  grid.TimeStep = 0.05;
  grid.LateralSpacing = grid.VerticalSpacing = spacing;
  return grid;
}

inline std::vector<float> Wind(const WindGrid& grid, const WindSynthesis& synthesis = {}, const WindModel& model = {})
{
  return WindField(model, grid, synthesis).Make();
}

/// One-sided Fourier amplitudes in time of one component, line after line, across fastest.
inline std::vector<std::vector<std::complex<double>>> Spectra(
  const std::vector<float>& field, const WindGrid& grid, int component)
{
  const int length = grid.Count[0];
  kissfft<double> forward(length, false);
  std::vector<std::complex<double>> series(length);
  std::vector<std::complex<double>> spectrum(length);
  std::vector<std::vector<std::complex<double>>> spectra;
  for (std::size_t line = 0; line < grid.NumberOfLines(); ++line)
  {
    for (int time = 0; time < length; ++time)
    {
      const std::size_t index = line * length + (length - time) % length; // lines run against time
      series[time] = field[index * WindComponents + component];
    }
    forward.transform(series.data(), spectrum.data());
    spectra.emplace_back(spectrum.begin(), spectrum.begin() + length / 2 + 1);
  }
  return spectra;
}

/// A component of a line at a place between its samples, by the definition of its Fourier series.
inline double SumOfWaves(const float* line, int length, int component, double place)
{
  const double unit = 2.0 * std::acos(-1.0) / length;
  double sum = 0.0;
  for (int k = 0; 2 * k <= length; ++k)
  {
    std::complex<double> wave(0.0);
    for (int n = 0; n < length; ++n)
    {
      wave += static_cast<double>(line[3 * n + component]) * std::polar(1.0 / length, -unit * (k * n % length));
    }
    sum += (k == 0 || 2 * k == length ? 1.0 : 2.0) * (wave * std::polar(1.0, unit * k * place)).real();
  }
  return sum;
}

/// Variance over a period of a component of a line.
inline double Variance(const float* line, int length, int component)
{
  double sum = 0.0;
  double squares = 0.0;
  for (int n = 0; n < length; ++n)
  {
    sum += line[3 * n + component];
    squares += std::pow(line[3 * n + component], 2.0);
  }
  return squares / length - std::pow(sum / length, 2.0);
}

}

#endif
