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
constexpr int Lines = 8; ///< smoothed side by side

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

  /// Smooths lines side by side, mirrored at their ends: cell n of line c is at n Lines + c.
  void Apply(double* lines, int length)
  {
    const int reach = this->Radius + 1;
    this->Sums.resize((static_cast<std::size_t>(length) + 2 * reach + 1) * Lines);
    double* sums = this->Sums.data();
    std::fill_n(sums, Lines, 0.0);
    for (int n = 0; n < length + 2 * reach; ++n)
    {
      const double* line = lines + static_cast<std::size_t>(Mirrored(n - reach, length)) * Lines;
      for (int c = 0; c < Lines; ++c)
      {
        sums[Lines + c] = sums[c] + line[c];
      }
      sums += Lines;
    }
    const double scale = 1.0 / (2.0 * this->Radius + 1.0 + 2.0 * this->Part);
    const double part = this->Part;
    const std::size_t across = static_cast<std::size_t>(2 * reach) * Lines;
    sums = this->Sums.data();
    for (std::size_t n = 0; n < static_cast<std::size_t>(length) * Lines; ++n)
    {
      const double inner = sums[n + across] - sums[n + Lines];
      const double outer = sums[n + across + Lines] - sums[n];
      lines[n] = scale * (inner + part * (outer - inner));
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

/// Smooths lines of a length, each `apart` values from the last, with their cells `step` values from each other.
void SmoothLines(std::vector<double>& values, std::size_t count, std::size_t length, std::size_t apart,
  std::size_t step, double deviation, const ParallelFor& parallel)
{
  parallel((count + Lines - 1) / Lines, [&](std::size_t begin, std::size_t end) {
    MovingAverage average(deviation);
    std::vector<double> lines(Lines * length, 0.0);
    for (std::size_t group = begin; group < end; ++group)
    {
      double* first = values.data() + group * Lines * apart;
      const std::size_t present = std::min<std::size_t>(Lines, count - group * Lines);
      for (std::size_t n = 0; n < length; ++n)
      {
        for (std::size_t c = 0; c < present; ++c)
        {
          lines[n * Lines + c] = first[c * apart + n * step];
        }
      }
      for (int pass = 0; pass < Passes; ++pass)
      {
        average.Apply(lines.data(), static_cast<int>(length));
      }
      for (std::size_t n = 0; n < length; ++n)
      {
        for (std::size_t c = 0; c < present; ++c)
        {
          first[c * apart + n * step] = lines[n * Lines + c];
        }
      }
    }
  });
}

}

void SmoothGrid(std::vector<double>& values, int width, int height, double deviation, const ParallelFor& parallel)
{
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  SmoothLines(values, rows, columns, columns, 1, deviation, parallel);
  SmoothLines(values, columns, rows, 1, columns, deviation, parallel);
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
