// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/SeaStatistics.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace littoral
{

namespace
{

/// Points of a curve over a turn, at least.
constexpr int SmoothCurve = 240;
/// Beyond this exponent all trains have one direction, to rounding.
constexpr double LargestSpreading = 1e6;

double EnergyOf(const WaveTrain& train)
{
  return 0.5 * train.Amplitude * train.Amplitude;
}

/// Logarithm of G(s), for which G cos^2s(angle / 2) integrates to 1 over a turn [rad]: Gamma(s+1) / (2 sqrt(pi)
/// Gamma(s+1/2)).
double LogNorm(double exponent)
{
  return std::lgamma(exponent + 1.0) - std::lgamma(exponent + 0.5) - std::log(2.0 * std::sqrt(Pi));
}

}

std::vector<FrequencyDensity> SpectrumOfTrains(
  const std::vector<WaveTrain>& trains, const std::vector<double>& edges, const std::vector<double>& densities)
{
  const std::size_t bins = edges.size() - 1;
  std::vector<double> energies(bins, 0.0);
  for (const WaveTrain& train : trains)
  {
    const double frequency = train.AngularFrequency / TwoPi;
    const auto above = std::upper_bound(edges.begin(), edges.end(), frequency) - edges.begin();
    energies[std::clamp<std::ptrdiff_t>(above - 1, 0, bins - 1)] += EnergyOf(train);
  }
  const std::size_t steps = (densities.size() - 1) / bins;
  std::vector<FrequencyDensity> curve;
  for (std::size_t bin = 0; bin < bins; ++bin)
  {
    const double width = edges[bin + 1] - edges[bin];
    for (std::size_t step = 0; step <= steps; ++step)
    {
      const double frequency = edges[bin] + width * static_cast<double>(step) / static_cast<double>(steps);
      curve.push_back({ frequency, densities[bin * steps + step], energies[bin] / width });
    }
  }
  return curve;
}

MeanVector MeanVectorOf(const std::vector<WaveTrain>& trains)
{
  double x = 0.0;
  double y = 0.0;
  double energy = 0.0;
  for (const WaveTrain& train : trains)
  {
    x += EnergyOf(train) * std::cos(train.Direction);
    y += EnergyOf(train) * std::sin(train.Direction);
    energy += EnergyOf(train);
  }
  return { std::atan2(y, x), energy > 0.0 ? std::min(1.0, std::hypot(x, y) / energy) : 0.0 };
}

std::vector<DirectionDensity> SpreadingOfTrains(const std::vector<WaveTrain>& trains, int sectors)
{
  const MeanVector mean = MeanVectorOf(trains);
  const double width = 360.0 / sectors;
  std::vector<double> energies(sectors, 0.0);
  for (const WaveTrain& train : trains)
  {
    const double angle = std::remainder(train.Direction - mean.Direction, TwoPi) * 180.0 / Pi;
    energies[std::clamp(static_cast<int>(std::floor((angle + 180.0) / width)), 0, sectors - 1)] += EnergyOf(train);
  }
  double energy = 0.0;
  for (const double part : energies)
  {
    energy += part;
  }
  // s from the mean cosine, s / (s + 1)
  const double exponent = mean.Length < 1.0 ? mean.Length / (1.0 - mean.Length) : LargestSpreading;
  const int steps = std::max(1, (SmoothCurve + sectors - 1) / sectors);
  std::vector<DirectionDensity> curve;
  for (int sector = 0; sector < sectors; ++sector)
  {
    for (int step = 0; step <= steps; ++step)
    {
      const double angle = -180.0 + width * (sector + static_cast<double>(step) / steps);
      // D = G(s) cos^2s(angle / 2)
      const double cosine = std::abs(std::cos(angle * Pi / 360.0));
      const double density =
        std::exp(LogNorm(exponent) + 2.0 * exponent * std::log(std::max(cosine, 1e-300))) * Pi / 180.0;
      curve.push_back({ mean.Direction * 180.0 / Pi + angle,
        exponent < LargestSpreading ? density : std::numeric_limits<double>::quiet_NaN(),
        energies[sector] / energy / width });
    }
  }
  return curve;
}

}
