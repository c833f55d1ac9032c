// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/FractalDimension.h"

#include "Numerics/Constants.h"
#include "Numerics/FourierGrid.h"
#include "Numerics/RealGridFourier.h"

#include <algorithm>
#include <array>
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
    meanX += x[i] / static_cast<double>(n);
    meanY += y[i] / static_cast<double>(n);
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
  slope.StandardError = std::sqrt(std::max(0.0, yy - slope.Value * xy) / (static_cast<double>(n - 2) * xx));
  return slope;
}

constexpr DimensionEstimate NoDimension{ std::numeric_limits<double>::quiet_NaN(),
  std::numeric_limits<double>::quiet_NaN() };

/// A dimension is told from data whose slope is sure to this standard error at most.
constexpr double LargestStandardError = 0.12;

/**
 * D = dimensionAtZero + slope / 2 of points on a line. None where D is not in [2, 3] or unsure, or where the two halves
 * of the points tell dimensions that differ by more than the bend and twice the standard error of the
 * difference: then they lie on no line.
 */
DimensionEstimate DimensionOfLine(
  const std::vector<double>& x, const std::vector<double>& y, double dimensionAtZero, double bend)
{
  if (x.size() < 6)
  {
    return NoDimension;
  }
  const Slope slope = FitSlope(x, y);
  const DimensionEstimate whole{ dimensionAtZero + 0.5 * slope.Value, 0.5 * slope.StandardError };
  const double middle = 0.5 * (x.front() + x.back());
  const auto half = std::lower_bound(x.begin(), x.end(), middle) - x.begin();
  const Slope first = FitSlope({ x.begin(), x.begin() + half }, { y.begin(), y.begin() + half });
  const Slope second = FitSlope({ x.begin() + half, x.end() }, { y.begin() + half, y.end() });
  const double difference = 0.5 * std::abs(second.Value - first.Value);
  const double unsure = 0.5 * std::hypot(first.StandardError, second.StandardError);
  const bool straight = difference <= bend + 2.0 * unsure; // false where a half has too few points
  const bool fractal = whole.Dimension >= 2.0 && whole.Dimension <= 3.0;
  return straight && fractal && whole.StandardError <= LargestStandardError ? whole : NoDimension;
}

double Hann(int index, int size)
{
  return 0.5 - 0.5 * std::cos(TwoPi * (index + 0.5) / size);
}

/// Rings of the periodogram, even in the logarithm of the wave number.
constexpr int NumberOfRings = 20;
/// Dimensions that two halves of a periodogram tell may differ by this much: exponential fields of 10 cells do by 0.3.
constexpr double PeriodogramBend = 0.4;
/// A slope that without regard to folding is that of a higher dimension is that of noise: D = 2.9 tells 3.1.
constexpr double NoisySlope = 3.25;
/// Sampled at points, a surface of a higher dimension cannot be told from noise.
constexpr double RoughestDimension = 2.95;

/// Dimensions that two halves of a variogram tell may differ by this much: fractal fields of 256^2 cells do by 0.06.
constexpr double VariogramBend = 0.12;
/// A variogram that tells a lower dimension at short lags is a parabola: that of a smooth field.
constexpr double SmoothDimension = 2.05;
/// One that tells a higher dimension at short or long lags is level there: such values have nothing in common.
constexpr double LevelDimension = 2.97;

/**
 * A surface that is sampled at points folds the spectrum k^-b beyond the grid's own wave numbers back: the power
 * that is found at k over k^-b, averaged over directions. The sum over the lattice of the grid's sampling wave numbers,
 * out to a square, and an integral beyond.
 */
double FoldedOverOwn(double k, double b, const std::array<double, 2>& spacing)
{
  constexpr int reach = 2;
  constexpr int directions = 8;
  const double stepX = TwoPi / spacing[0];
  const double stepY = TwoPi / spacing[1];
  double sum = 0.0;
  for (int n = 0; n < directions; ++n)
  {
    const double angle = 0.5 * Pi * (n + 0.5) / directions;
    for (int j = -reach; j <= reach; ++j)
    {
      for (int i = -reach; i <= reach; ++i)
      {
        sum += std::pow(std::hypot(k * std::cos(angle) + i * stepX, k * std::sin(angle) + j * stepY), -b) / directions;
      }
    }
  }
  const double side = 2.0 * reach + 1.0;
  const double radius = side * std::sqrt(stepX * stepY / Pi);
  const double beyond = TwoPi * std::pow(radius, 2.0 - b) / ((b - 2.0) * stepX * stepY);
  return (sum + beyond) * std::pow(k, b);
}

/// Logarithms of the power, less what a surface of dimension D folds back.
std::vector<double> Unfolded(const std::vector<double>& logWaveNumber, const std::vector<double>& logPower,
  double dimension, const std::array<double, 2>& spacing)
{
  std::vector<double> own = logPower;
  for (std::size_t n = 0; n < own.size(); ++n)
  {
    own[n] -= std::log(FoldedOverOwn(std::exp(logWaveNumber[n]), 8.0 - 2.0 * dimension, spacing));
  }
  return own;
}

/// Transform of the samples less their mean, under a Hann window.
RealGridFourier WindowedTransform(const GridSamples& samples, std::array<int, 2> lengths, const ParallelFor& parallel)
{
  const double mean = Moments(samples).Mean;
  std::vector<double> across(samples.Width);
  for (int i = 0; i < samples.Width; ++i)
  {
    across[i] = Hann(i, samples.Width);
  }
  std::vector<double> values(samples.Values.size());
  for (int j = 0; j < samples.Height; ++j)
  {
    const double weight = Hann(j, samples.Height);
    for (int i = 0; i < samples.Width; ++i)
    {
      const double value = samples.At(i, j) - mean;
      values[static_cast<std::size_t>(j) * samples.Width + i] = std::isnan(value) ? 0.0 : value * across[i] * weight;
    }
  }
  return { values, { samples.Width, samples.Height }, lengths, parallel };
}

/// Sums over the waves of a ring, and their number.
struct RingSums
{
  double Power = 0.0;
  double LogWaveNumber = 0.0;
  double Count = 0.0;
};
using Rings = std::array<RingSums, NumberOfRings>;

/// Mean power of the rings that hold any, and their mean wave number, as logarithms.
struct RingPowers
{
  std::vector<double> LogWaveNumber;
  std::vector<double> LogPower;
};

/// Rings of a periodogram from six waves in the short side of the samples to a wave of five cells.
RingPowers PowersOfRings(const GridSamples& samples, const ParallelFor& parallel)
{
  const std::array<int, 2> lengths{ NextFastLength(samples.Width), NextFastLength(samples.Height) };
  const RealGridFourier grid = WindowedTransform(samples, lengths, parallel);
  const double shortSide = std::min(samples.Width * samples.Spacing[0], samples.Height * samples.Spacing[1]);
  const double lowest = 6.0 * TwoPi / shortSide;
  const double highest = TwoPi / (5.0 * std::max(samples.Spacing[0], samples.Spacing[1]));
  const auto waveNumber = [&](int index, int axis) {
    return TwoPi * std::min(index, lengths[axis] - index) / (lengths[axis] * samples.Spacing[axis]);
  };
  std::vector<Rings> packs(grid.NumberOfPacks());
  parallel(packs.size(), [&](std::size_t begin, std::size_t end) {
    DoubleLinePack rows(lengths[0]);
    for (std::size_t pack = begin; pack < end; ++pack)
    {
      grid.TransformRows(static_cast<int>(pack), rows);
      for (int n = 0; n < lengths[0] * FourierLanes; ++n)
      {
        const int j = static_cast<int>(pack) * FourierLanes + n % FourierLanes;
        const double kx = waveNumber(n / FourierLanes, 0);
        const double ky = waveNumber(j, 1);
        const double k2 = kx * kx + ky * ky;
        if (j >= grid.NumberOfRows() || k2 < lowest * lowest || k2 >= highest * highest)
        {
          continue;
        }
        const double logarithm = 0.5 * std::log(k2);
        const double place = (logarithm - std::log(lowest)) / std::log(highest / lowest);
        RingSums& ring = packs[pack][std::clamp(static_cast<int>(NumberOfRings * place), 0, NumberOfRings - 1)];
        const double waves = j == 0 || 2 * j == lengths[1] ? 1.0 : 2.0; // with the opposite one
        ring.Power += waves * (rows.Re[n] * rows.Re[n] + rows.Im[n] * rows.Im[n]);
        ring.LogWaveNumber += waves * logarithm;
        ring.Count += waves;
      }
    }
  });
  RingPowers powers;
  for (int n = 0; n < NumberOfRings; ++n)
  {
    RingSums sum;
    for (const Rings& rings : packs)
    {
      sum.Power += rings[n].Power;
      sum.LogWaveNumber += rings[n].LogWaveNumber;
      sum.Count += rings[n].Count;
    }
    if (sum.Power > 0.0)
    {
      powers.LogWaveNumber.push_back(sum.LogWaveNumber / sum.Count);
      powers.LogPower.push_back(std::log(sum.Power / sum.Count));
    }
  }
  return powers;
}

}

DimensionEstimate DimensionFromPeriodogram(const GridSamples& samples, const ParallelFor& parallel)
{
  const auto [x, y] = PowersOfRings(samples, parallel);
  if (!(4.0 + 0.5 * FitSlope(x, y).Value < NoisySlope))
  {
    return NoDimension;
  }
  // The D whose own folding leaves the slope of D: a higher one takes away more, so that halving finds it.
  double low = 2.0;
  double high = RoughestDimension;
  for (int step = 0; step < 30; ++step)
  {
    const double middle = 0.5 * (low + high);
    const double told = 4.0 + 0.5 * FitSlope(x, Unfolded(x, y, middle, samples.Spacing)).Value;
    (told > middle ? low : high) = middle;
  }
  return high < RoughestDimension ? DimensionOfLine(x, Unfolded(x, y, low, samples.Spacing), 4.0, PeriodogramBend)
                                  : NoDimension;
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
      y.push_back(-std::log(bin.Semivariance));
    }
  }
  const std::size_t third = x.size() / 3;
  const double atShort = 3.0 + 0.5 * FitSlope({ x.begin(), x.begin() + third }, { y.begin(), y.begin() + third }).Value;
  const double atLong = 3.0 + 0.5 * FitSlope({ x.end() - third, x.end() }, { y.end() - third, y.end() }).Value;
  const bool rises = atShort >= SmoothDimension && atShort <= LevelDimension &&
    atLong <= LevelDimension; // false where there are too few lags
  return rises ? DimensionOfLine(x, y, 3.0, VariogramBend) : NoDimension;
}

}
