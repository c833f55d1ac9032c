// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/Variogram.h"

#include "Numerics/Constants.h"
#include "Numerics/FourierGrid.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/**
 * Sums over all pairs of values, by lag: squared differences (real part) and numbers of pairs (imaginary part), times
 * the number of values of the grid. With m the mask of present values and z = 0 elsewhere, the squared differences are
 * corr(m z^2, m) + corr(m, m z^2) - 2 corr(z, z), and corr(m, m) counts them.
 */
FourierGrid PairSums(const GridSamples& samples, int width, int height, const ParallelFor& parallel)
{
  FourierGrid values(width, height); // z + i m: two real transforms in one
  FourierGrid squares(width, height);
  const double mean = Moments(samples).Mean;
  for (int j = 0; j < samples.Height; ++j)
  {
    for (int i = 0; i < samples.Width; ++i)
    {
      const double value = samples.At(i, j) - mean;
      if (!std::isnan(value))
      {
        values.At(i, j) = { value, 1.0 };
        squares.At(i, j) = value * value;
      }
    }
  }
  values.Forward(parallel);
  squares.Forward(parallel);

  // Power spectra are real and even, so that one transform back gives the squared differences and the counts. The
  // product is written over the squares, whose opposite wave numbers are not needed.
  parallel(height, [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        const std::complex<double> here = values.At(i, j);
        const std::complex<double> there =
          std::conj(values.At(FourierGrid::Opposite(i, width), FourierGrid::Opposite(j, height)));
        // V = Z + i M: Z = (V(k) + V*(-k)) / 2, M = (V(k) - V*(-k)) / 2i;  D = 2 Re(Q M*) - 2 |Z|^2, N = |M|^2
        const std::complex<double> z = 0.5 * (here + there);
        const std::complex<double> m = std::complex<double>(0.0, -0.5) * (here - there);
        const double crossed = 2.0 * std::real(squares.At(i, j) * std::conj(m));
        squares.At(i, j) = { crossed - 2.0 * std::norm(z), std::norm(m) };
      }
    }
  });
  squares.Backward(parallel);
  return squares;
}

}

VariogramMap ComputeVariogramMap(const GridSamples& samples, double maximumLag, const ParallelFor& parallel)
{
  VariogramMap map;
  map.Spacing = samples.Spacing;
  const auto lagsAlong = [&](int axis, int size) {
    return std::min(size - 1, static_cast<int>(std::min(maximumLag / samples.Spacing[axis], 1e9)));
  };
  map.LagWidth = lagsAlong(0, samples.Width);
  map.LagHeight = lagsAlong(1, samples.Height);
  const int width = NextFastLength(samples.Width + map.LagWidth);
  const int height = NextFastLength(samples.Height + map.LagHeight);
  const FourierGrid pairs = PairSums(samples, width, height, parallel);

  map.Semivariance.resize(static_cast<std::size_t>(2 * map.LagWidth + 1) * (map.LagHeight + 1));
  map.Pairs.resize(map.Semivariance.size());
  const double scale = 1.0 / (static_cast<double>(width) * height);
  for (int j = 0; j <= map.LagHeight; ++j)
  {
    for (int i = -map.LagWidth; i <= map.LagWidth; ++i)
    {
      const std::complex<double> sums = scale * pairs.At(i < 0 ? i + width : i, j);
      const std::size_t index = map.Index(i, j);
      // Matheron's estimate: gamma(h) = D(h) / (2 N(h))
      map.Pairs[index] = std::round(sums.imag());
      map.Semivariance[index] = map.Pairs[index] > 0.0 ? std::max(0.0, 0.5 * sums.real() / map.Pairs[index]) : 0.0;
    }
  }
  return map;
}

std::vector<LagBin> BinVariogram(const VariogramMap& map, double maximumLag, int rings, int directions)
{
  std::vector<LagBin> bins(static_cast<std::size_t>(rings) * directions);
  for (int j = 0; j <= map.LagHeight; ++j)
  {
    // Of row 0 only one half: the other holds the same pairs.
    for (int i = j == 0 ? 1 : -map.LagWidth; i <= map.LagWidth; ++i)
    {
      const double x = i * map.Spacing[0];
      const double y = j * map.Spacing[1];
      const double lag = std::hypot(x, y);
      const std::size_t index = map.Index(i, j);
      const double pairs = map.Pairs[index];
      if (lag > maximumLag || pairs == 0.0)
      {
        continue;
      }
      const int ring = std::min(rings - 1, static_cast<int>(std::sqrt(lag / maximumLag) * rings));
      const double turn = std::atan2(y, x) / Pi; // in [0, 1]
      const int sector = static_cast<int>(std::floor(turn * directions + 0.5)) % directions;
      LagBin& bin = bins[static_cast<std::size_t>(sector) * rings + ring];
      // Sector 0 lies about the x axis: its far half is met with the opposite sign.
      const double sign = sector == 0 && x < 0.0 && directions > 1 ? -1.0 : 1.0;
      bin.Lag += pairs * lag;
      bin.Separation[0] += pairs * sign * x;
      bin.Separation[1] += pairs * sign * y;
      bin.Semivariance += pairs * map.Semivariance[index];
      bin.Pairs += pairs;
      bin.Ring = ring;
      bin.Direction = sector;
    }
  }
  bins.erase(std::remove_if(bins.begin(), bins.end(), [](const LagBin& bin) { return bin.Pairs == 0.0; }), bins.end());
  for (LagBin& bin : bins)
  {
    bin.Lag /= bin.Pairs;
    bin.Semivariance /= bin.Pairs;
    const double length = std::hypot(bin.Separation[0], bin.Separation[1]);
    const double scale = length > 0.0 ? bin.Lag / length : 0.0;
    bin.Separation = { scale * bin.Separation[0], scale * bin.Separation[1] };
  }
  return bins;
}

}
