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

/**
 * The same wind as WindField by the method of Veers (1988): at each frequency the matrix of coherence between all lines
 * is factored. Coherence is exact for any separations, at a cost that grows with the cube of the number of lines: the
 * reference for small grids, of some hundred lines. NormalizeVariance has no effect.
 */
inline std::vector<float> CholeskyWind(const WindModel& model, const WindGrid& grid, const WindSynthesis& synthesis)
{
  const std::size_t lines = grid.NumberOfLines();
  const int length = grid.Count[0];
  const double step = 1.0 / grid.Period();
  kissfft<double> backward(length, true);
  std::vector<float> velocities(lines * length * WindComponents);
  for (int component = 0; component < WindComponents; ++component)
  {
    std::vector<std::vector<std::complex<double>>> spectra(lines, std::vector<std::complex<double>>(length));
    for (int frequency = 1; frequency <= grid.Waves(); ++frequency)
    {
      std::vector<float> re(lines);
      std::vector<float> im(lines);
      WindFactors(synthesis, component, frequency, 0, lines, re.data(), im.data());
      Eigen::VectorXcd factors(lines);
      for (std::size_t line = 0; line < lines; ++line)
      {
        factors[line] = { re[line], im[line] };
      }
      const Eigen::VectorXcd amplitudes = CoherenceRoot(model, grid, component, frequency * step) * factors;
      for (std::size_t line = 0; line < lines; ++line)
      {
        const double height = grid.Height(static_cast<int>(line) / grid.Count[1]);
        const double power = SpectralDensity(model, component, frequency * step, height) * step;
        spectra[line][frequency] = std::sqrt(0.5 * power) * amplitudes[line];
        spectra[line][length - frequency] = std::conj(spectra[line][frequency]);
      }
    }
    for (std::size_t line = 0; line < lines; ++line)
    {
      const double height = grid.Height(static_cast<int>(line) / grid.Count[1]);
      const double mean = component == 0 ? MeanSpeed(model, height) : 0.0;
      std::vector<std::complex<double>> series(length);
      backward.transform(spectra[line].data(), series.data());
      for (int time = 0; time < length; ++time)
      {
        const std::size_t index = time == 0 ? 0 : length - time; // against time, as in WindField
        velocities[(line * length + index) * WindComponents + component] =
          static_cast<float>(mean + series[time].real());
      }
    }
  }
  return velocities;
}

}

#endif
