// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/RingSpectrum.h"

#include "Numerics/Constants.h"
#include "Numerics/PeriodFourier.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace littoral
{

namespace
{

/// Columns that are gathered together, so that each cache line that is touched is used whole.
constexpr int ColumnsAtOnce = 16;

/// The cosine transform of lines by one complex transform for two of them (Makhoul 1980).
class CosineLines
{
public:
  explicit CosineLines(int length)
    : Length(length)
    , Fourier(length)
    , Work(length)
  {
    for (int k = 0; k < length; ++k)
    {
      // orthonormal: sqrt((2 - [k = 0]) / N) e^(-i pi k / 2N)
      const double size = std::sqrt((k == 0 ? 1.0 : 2.0) / length);
      this->Turns.push_back(std::polar(size, -Pi * k / (2.0 * length)));
    }
  }

  void Forward(double* a, double* b)
  {
    // v_n = x_2n, v_(N-1-n) = x_(2n+1);  X_k = Re(turn_k V_k)
    for (int n = 0; n < this->Length; ++n)
    {
      const int from = 2 * n < this->Length ? 2 * n : 2 * (this->Length - 1 - n) + 1;
      this->Work[n] = { a[from], b[from] };
    }
    const PeriodFourier::Line sums = this->Fourier.Forward(this->Work);
    for (int k = 0; k < this->Length; ++k)
    {
      const std::complex<double> here = sums[k];
      const std::complex<double> there = std::conj(sums[k == 0 ? 0 : this->Length - k]);
      a[k] = (this->Turns[k] * (0.5 * (here + there))).real();
      b[k] = (this->Turns[k] * (std::complex<double>(0.0, -0.5) * (here - there))).real();
    }
  }

  void Backward(double* a, double* b)
  {
    for (int k = 0; k < this->Length; ++k)
    {
      this->Work[k] = this->LineCoefficient(a, k) + std::complex<double>(0.0, 1.0) * this->LineCoefficient(b, k);
    }
    const PeriodFourier::Line values = this->Fourier.Backward(this->Work);
    for (int n = 0; n < this->Length; ++n)
    {
      const int to = 2 * n < this->Length ? 2 * n : 2 * (this->Length - 1 - n) + 1;
      a[to] = values[n].real();
      b[to] = values[n].imag();
    }
  }

private:
  /// V_k = e^(i pi k / 2N) (X_k - i X_(N-k)) / N of coefficients that are not normalized, X_N = 0.
  std::complex<double> LineCoefficient(const double* line, int k) const
  {
    const double norm = k == 0 ? std::sqrt(1.0 / this->Length) : std::sqrt(0.5 / this->Length);
    const double opposite = k == 0 ? 0.0 : line[this->Length - k];
    const std::complex<double> turn = std::conj(this->Turns[k]) / std::abs(this->Turns[k]);
    return norm * turn * std::complex<double>(line[k], -opposite);
  }

  int Length;
  PeriodFourier Fourier;
  PeriodFourier::Line Work;
  std::vector<std::complex<double>> Turns;
};

/// Transforms all rows, then all columns; lines two by two.
template <typename Transform>
void TransformLines(GridSamples& grid, const ParallelFor& parallel, const Transform& transform)
{
  const int width = grid.Width;
  const int height = grid.Height;
  parallel((height + 1) / 2, [&](std::size_t begin, std::size_t end) {
    CosineLines lines(width);
    std::vector<double> none(width, 0.0);
    for (std::size_t pair = begin; pair < end; ++pair)
    {
      double* row = &grid.Values[2 * pair * width];
      const bool hasNext = 2 * pair + 1 < static_cast<std::size_t>(height);
      std::fill(none.begin(), none.end(), 0.0);
      transform(lines, row, hasNext ? row + width : none.data());
    }
  });
  parallel((width + ColumnsAtOnce - 1) / ColumnsAtOnce, [&](std::size_t begin, std::size_t end) {
    CosineLines lines(height);
    std::vector<double> columns(static_cast<std::size_t>(ColumnsAtOnce) * height);
    for (std::size_t group = begin; group < end; ++group)
    {
      const int first = static_cast<int>(group) * ColumnsAtOnce;
      const int count = std::min(ColumnsAtOnce, width - first);
      std::fill(columns.begin(), columns.end(), 0.0);
      for (int j = 0; j < height; ++j)
      {
        for (int c = 0; c < count; ++c)
        {
          columns[static_cast<std::size_t>(c) * height + j] = grid.At(first + c, j);
        }
      }
      for (int c = 0; c < count; c += 2)
      {
        double* column = &columns[static_cast<std::size_t>(c) * height];
        transform(lines, column, column + height);
      }
      for (int j = 0; j < height; ++j)
      {
        for (int c = 0; c < count; ++c)
        {
          grid.At(first + c, j) = columns[static_cast<std::size_t>(c) * height + j];
        }
      }
    }
  });
}

/// Wave number of a coefficient [cycles/m].
double WaveNumber(const GridSamples& grid, int i, int j)
{
  return std::hypot(i / (2.0 * grid.Width * grid.Spacing[0]), j / (2.0 * grid.Height * grid.Spacing[1]));
}

}

double RingSpectrum::At(double waveNumber) const
{
  const auto last = this->Power.size() - 1;
  const double position = waveNumber / this->Step;
  if (position >= static_cast<double>(last))
  {
    return this->Power[last];
  }
  const double ring = std::max(position, 1.0);
  const auto lower = std::min(static_cast<std::size_t>(ring), last);
  const auto upper = std::min(lower + 1, last);
  const double part = ring - static_cast<double>(lower);
  return this->Power[lower] + part * (this->Power[upper] - this->Power[lower]);
}

void CosineTransform(GridSamples& values, const ParallelFor& parallel)
{
  TransformLines(values, parallel, [](CosineLines& lines, double* a, double* b) { lines.Forward(a, b); });
}

void InverseCosineTransform(GridSamples& values, const ParallelFor& parallel)
{
  TransformLines(values, parallel, [](CosineLines& lines, double* a, double* b) { lines.Backward(a, b); });
}

RingSpectrum SpectrumOfCoefficients(const GridSamples& coefficients, const ParallelFor& parallel)
{
  RingSpectrum spectrum;
  const double shorter =
    std::min(coefficients.Width * coefficients.Spacing[0], coefficients.Height * coefficients.Spacing[1]);
  spectrum.Step = 0.5 / shorter;
  const double highest = WaveNumber(coefficients, coefficients.Width - 1, coefficients.Height - 1);
  const auto rings = static_cast<std::size_t>(highest / spectrum.Step + 0.5) + 1;
  // Sums of blocks of rows, then over the blocks in order: whatever the threads.
  const auto height = static_cast<std::size_t>(coefficients.Height);
  constexpr std::size_t rowsAtOnce = 64;
  const std::size_t blocks = (height + rowsAtOnce - 1) / rowsAtOnce;
  std::vector<std::vector<double>> sums(blocks);
  std::vector<std::vector<double>> counts(blocks);
  parallel(blocks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block)
    {
      sums[block].assign(rings, 0.0);
      counts[block].assign(rings, 0.0);
      for (std::size_t j = block * rowsAtOnce; j < std::min(height, (block + 1) * rowsAtOnce); ++j)
      {
        for (int i = 0; i < coefficients.Width; ++i)
        {
          const double c = coefficients.At(i, static_cast<int>(j));
          const auto ring =
            static_cast<std::size_t>(WaveNumber(coefficients, i, static_cast<int>(j)) / spectrum.Step + 0.5);
          sums[block][ring] += c * c;
          counts[block][ring] += 1.0;
        }
      }
    }
  });
  spectrum.Power.assign(rings, 0.0);
  std::vector<double> count(rings, 0.0);
  for (std::size_t block = 0; block < blocks; ++block)
  {
    for (std::size_t ring = 0; ring < rings; ++ring)
    {
      spectrum.Power[ring] += sums[block][ring];
      count[ring] += counts[block][ring];
    }
  }
  const double area = coefficients.Spacing[0] * coefficients.Spacing[1];
  for (std::size_t ring = 0; ring < rings; ++ring)
  {
    spectrum.Power[ring] *= count[ring] > 0.0 ? area / count[ring] : 0.0;
  }
  return spectrum;
}

void MultiplyRings(
  GridSamples& coefficients, double step, const std::vector<double>& gains, const ParallelFor& parallel)
{
  parallel(coefficients.Height, [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
    {
      for (int i = 0; i < coefficients.Width; ++i)
      {
        const double ring = std::min(WaveNumber(coefficients, i, j) / step, static_cast<double>(gains.size() - 1));
        const auto lower = static_cast<std::size_t>(ring);
        const auto upper = std::min(lower + 1, gains.size() - 1);
        const double part = ring - static_cast<double>(lower);
        coefficients.At(i, j) *= gains[lower] + part * (gains[upper] - gains[lower]);
      }
    }
  });
}

}
