// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/ValleySpreading.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr int Passes = 3;
constexpr int ColumnsAtOnce = 16;

/// A moving average over 2 Radius + 1 cells and a part of the next cell at each end.
class MovingAverage
{
public:
  explicit MovingAverage(double deviation)
  {
    // The variance of weights 1 at -r ... r and p at +-(r + 1) is (r (r + 1) (2r + 1) / 3 + 2 p (r + 1)^2) / (2r + 1 +
    // 2p).
    const double variance = deviation * deviation / Passes;
    const auto whole = [](double r) { return r * (r + 1.0) / 3.0; };
    while (whole(this->Radius + 1) <= variance)
    {
      ++this->Radius;
    }
    const double r = this->Radius;
    const double count = 2.0 * r + 1.0;
    this->Part = (variance - whole(r)) * count / (2.0 * ((r + 1.0) * (r + 1.0) - variance));
  }

  /// Smooths one line, mirrored at its ends.
  void Apply(double* line, int length)
  {
    const int reach = this->Radius + 1;
    this->Sums.resize(static_cast<std::size_t>(length) + 2 * reach + 1);
    this->Sums[0] = 0.0;
    for (int n = 0; n < length + 2 * reach; ++n)
    {
      this->Sums[n + 1] = this->Sums[n] + line[Mirrored(n - reach, length)];
    }
    const double scale = 1.0 / (2.0 * this->Radius + 1.0 + 2.0 * this->Part);
    for (int n = 0; n < length; ++n)
    {
      const double inner = this->Sums[n + 2 * reach] - this->Sums[n + 1];
      const double outer = this->Sums[n + 2 * reach + 1] - this->Sums[n];
      line[n] = scale * (inner + this->Part * (outer - inner));
    }
  }

private:
  static int Mirrored(int n, int length)
  {
    while (n < 0 || n >= length)
    {
      n = n < 0 ? -1 - n : 2 * length - 1 - n;
    }
    return n;
  }

  int Radius = 0;
  double Part;
  std::vector<double> Sums;
};

}

void SmoothGrid(std::vector<double>& values, int width, int height, double deviation, const ParallelFor& parallel)
{
  parallel(height, [&](std::size_t begin, std::size_t end) {
    MovingAverage average(deviation);
    for (std::size_t row = begin; row < end; ++row)
    {
      for (int pass = 0; pass < Passes; ++pass)
      {
        average.Apply(&values[row * width], width);
      }
    }
  });
  parallel((width + ColumnsAtOnce - 1) / ColumnsAtOnce, [&](std::size_t begin, std::size_t end) {
    MovingAverage average(deviation);
    std::vector<double> columns(static_cast<std::size_t>(ColumnsAtOnce) * height);
    for (std::size_t group = begin; group < end; ++group)
    {
      const std::size_t first = group * ColumnsAtOnce;
      const std::size_t count = std::min<std::size_t>(ColumnsAtOnce, width - first);
      for (std::size_t j = 0; j < static_cast<std::size_t>(height); ++j)
      {
        for (std::size_t c = 0; c < count; ++c)
        {
          columns[c * height + j] = values[j * width + first + c];
        }
      }
      for (std::size_t c = 0; c < count; ++c)
      {
        for (int pass = 0; pass < Passes; ++pass)
        {
          average.Apply(&columns[c * height], height);
        }
      }
      for (std::size_t j = 0; j < static_cast<std::size_t>(height); ++j)
      {
        for (std::size_t c = 0; c < count; ++c)
        {
          values[j * width + first + c] = columns[c * height + j];
        }
      }
    }
  });
}

void SpreadChanges(std::vector<double>& changes, std::vector<double>& weights, int width, int height, double deviation,
  const ParallelFor& parallel)
{
  parallel(changes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      changes[n] *= weights[n];
    }
  });
  SmoothGrid(changes, width, height, deviation, parallel);
  SmoothGrid(weights, width, height, deviation, parallel);
  const double least = 0.3 / (std::sqrt(2.0 * Pi) * deviation);
  parallel(changes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      changes[n] /= std::max(weights[n], least);
    }
  });
}

}
