// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FractalDimension.h"

#include "Constants.h"
#include "FourierGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace littoral
{

namespace
{

/// Slope of y over x by least squares, each point with the same weight.
struct Slope
{
  double Value = std::numeric_limits<double>::quiet_NaN();
  double StandardError = std::numeric_limits<double>::quiet_NaN();
};

Slope FitSlope(const std::vector<double>& x, const std::vector<double>& y)
{
  Slope slope;
  const std::size_t n = x.size();
  if (n < 3)
  {
    return slope;
  }
  double meanX = 0.0;
  double meanY = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    meanX += x[i] / n;
    meanY += y[i] / n;
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    xx += (x[i] - meanX) * (x[i] - meanX);
    xy += (x[i] - meanX) * (y[i] - meanY);
    yy += (y[i] - meanY) * (y[i] - meanY);
  }
  slope.Value = xy / xx;
  slope.StandardError = std::sqrt(std::max(0.0, yy - slope.Value * xy) / ((n - 2) * xx));
  return slope;
}

double Hann(int index, int size)
{
  return 0.5 - 0.5 * std::cos(TwoPi * (index + 0.5) / size);
}

/// Rings of the periodogram, even in the logarithm of the wave number.
constexpr int NumberOfRings = 20;

}

DimensionEstimate DimensionFromPeriodogram(const GridSamples& samples, const ParallelFor& parallel)
{
  const double mean = Moments(samples).Mean;
  FourierGrid grid(NextFastLength(samples.Width), NextFastLength(samples.Height));
  for (int j = 0; j < samples.Height; ++j)
  {
    for (int i = 0; i < samples.Width; ++i)
    {
      const double value = samples.At(i, j) - mean;
      grid.At(i, j) = std::isnan(value) ? 0.0 : value * Hann(i, samples.Width) * Hann(j, samples.Height);
    }
  }
  grid.Forward(parallel);

  const double shortSide = std::min(samples.Width * samples.Spacing[0], samples.Height * samples.Spacing[1]);
  const double lowest = 6.0 * TwoPi / shortSide;
  const double highest = TwoPi / (5.0 * std::max(samples.Spacing[0], samples.Spacing[1]));
  std::vector<double> power(NumberOfRings);
  std::vector<double> logWaveNumber(NumberOfRings);
  std::vector<double> count(NumberOfRings);
  const auto waveNumber = [](int index, int length, double spacing) {
    return TwoPi * (index <= length / 2 ? index : index - length) / (length * spacing);
  };
  for (int j = 0; j < grid.GetHeight(); ++j)
  {
    const double ky = waveNumber(j, grid.GetHeight(), samples.Spacing[1]);
    for (int i = 0; i < grid.GetWidth(); ++i)
    {
      const double k = std::hypot(waveNumber(i, grid.GetWidth(), samples.Spacing[0]), ky);
      if (k < lowest || k >= highest)
      {
        continue;
      }
      const int ring = static_cast<int>(NumberOfRings * std::log(k / lowest) / std::log(highest / lowest));
      power[ring] += std::norm(grid.At(i, j));
      logWaveNumber[ring] += std::log(k);
      count[ring] += 1.0;
    }
  }
  std::vector<double> x;
  std::vector<double> y;
  for (int ring = 0; ring < NumberOfRings; ++ring)
  {
    if (power[ring] > 0.0)
    {
      x.push_back(logWaveNumber[ring] / count[ring]);
      y.push_back(std::log(power[ring] / count[ring]));
    }
  }
  const Slope slope = FitSlope(x, y);
  return { 4.0 + 0.5 * slope.Value, 0.5 * slope.StandardError };
}

DimensionEstimate DimensionFromVariogram(const VariogramMap& map)
{
  const double cell = std::max(map.Spacing[0], map.Spacing[1]);
  std::vector<double> x;
  std::vector<double> y;
  for (const LagBin& bin : BinVariogram(map, 16.5 * cell, 24, 1))
  {
    if (bin.Lag > 1.5 * cell && bin.Semivariance > 0.0)
    {
      x.push_back(std::log(bin.Lag));
      y.push_back(std::log(bin.Semivariance));
    }
  }
  const Slope slope = FitSlope(x, y);
  return { 3.0 - 0.5 * slope.Value, 0.5 * slope.StandardError };
}

}
