// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTestCholeskyWind_h
#define LittoralTestCholeskyWind_h

#include "Wind/WindField.h"

#include <Eigen/Cholesky>

#include <kissfft/kissfft.hh>

#include <cmath>
#include <complex>
#include <vector>

namespace littoral
{

/// Lower factor of the coherence between all lines, across fastest.
inline Eigen::MatrixXd CoherenceRoot(const WindModel& model, const WindGrid& grid, int component, double hertz)
{
  const int lines = static_cast<int>(grid.NumberOfLines());
  const int width = grid.Count[1];
  Eigen::MatrixXd coherence(lines, lines);
  for (int a = 0; a < lines; ++a)
  {
    for (int b = 0; b < lines; ++b)
    {
      coherence(a, b) = RootCoherence(model, component, hertz, (a % width - b % width) * grid.LateralSpacing,
        (a / width - b / width) * grid.VerticalSpacing);
    }
  }
  // Nearly equal lines: what rounding takes from the smallest pivot is given back.
  coherence.diagonal().array() += 1e-12;
  return coherence.llt().matrixL();
}

/// Adds the waves of a frequency to the spectra of the lines, along which the frequencies run.
inline void AddWaves(const Eigen::MatrixXd& root, const std::vector<double>& powers, const WindSynthesis& synthesis,
  int component, int frequency, int length, std::vector<std::complex<double>>& spectra)
{
  const std::size_t lines = powers.size();
  std::vector<float> re(lines);
  std::vector<float> im(lines);
  WindFactors(synthesis, component, frequency, 0, lines, re.data(), im.data());
  Eigen::VectorXcd factors(lines);
  for (std::size_t line = 0; line < lines; ++line)
  {
    factors[line] = { re[line], im[line] };
  }
  const Eigen::VectorXcd amplitudes = root * factors;
  for (std::size_t line = 0; line < lines; ++line)
  {
    const std::complex<double> wave = std::sqrt(0.5 * powers[line]) * amplitudes[line];
    spectra[line * length + frequency] = wave;
    spectra[line * length + length - frequency] = std::conj(wave);
  }
}

/// Puts a component of a field together from the spectra of its lines.
inline void PutTogether(const WindModel& model, const WindGrid& grid, int component,
  const std::vector<std::complex<double>>& spectra, std::vector<float>& velocities)
{
  const int length = grid.Count[0];
  kissfft<double> backward(length, true);
  std::vector<std::complex<double>> series(length);
  for (std::size_t line = 0; line < grid.NumberOfLines(); ++line)
  {
    const double height = grid.Height(static_cast<int>(line) / grid.Count[1]);
    const double mean = component == 0 ? MeanSpeed(model, height) : 0.0;
    backward.transform(&spectra[line * length], series.data());
    for (int time = 0; time < length; ++time)
    {
      const std::size_t index = time == 0 ? 0 : length - time; // against time, as in WindField
      velocities[(line * length + index) * WindComponents + component] = static_cast<float>(mean + series[time].real());
    }
  }
}

/**
 * The same winds as WindField by the method of Veers (1988): at each frequency the matrix of coherence between all
 * lines is factored, once for all winds. Coherence is exact for any separations, at a cost that grows with the cube of
 * the number of lines: the reference for small grids, of some hundred lines. NormalizeVariance has no effect.
 */
inline std::vector<std::vector<float>> CholeskyWinds(
  const WindModel& model, const WindGrid& grid, const std::vector<WindSynthesis>& syntheses)
{
  const std::size_t lines = grid.NumberOfLines();
  const int length = grid.Count[0];
  const double step = 1.0 / grid.Period();
  std::vector<std::vector<float>> winds(syntheses.size(), std::vector<float>(lines * length * WindComponents));
  for (int component = 0; component < WindComponents; ++component)
  {
    std::vector<std::vector<std::complex<double>>> spectra(
      syntheses.size(), std::vector<std::complex<double>>(lines * length));
    for (int frequency = 1; frequency <= grid.Waves(); ++frequency)
    {
      const Eigen::MatrixXd root = CoherenceRoot(model, grid, component, frequency * step);
      std::vector<double> powers;
      for (std::size_t line = 0; line < lines; ++line)
      {
        const double height = grid.Height(static_cast<int>(line) / grid.Count[1]);
        powers.push_back(SpectralDensity(model, component, frequency * step, height) * step);
      }
      for (std::size_t wind = 0; wind < winds.size(); ++wind)
      {
        AddWaves(root, powers, syntheses[wind], component, frequency, length, spectra[wind]);
      }
    }
    for (std::size_t wind = 0; wind < winds.size(); ++wind)
    {
      PutTogether(model, grid, component, spectra[wind], winds[wind]);
    }
  }
  return winds;
}

}

#endif
