// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/PlaceMatching.h"

#include "Landscapes/HeightMatching.h"
#include "Numerics/PolledMemory.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace littoral
{

namespace
{

/// Steps of the part of the matching of heights that is not linear, the errors of hypsometric integral and skewness at
/// which a part is enough, and the limits of the linear one.
constexpr double PartStep = 0.125;
constexpr double IntegralTolerance = 0.028;
constexpr double SkewTolerance = 0.14;
constexpr double LeastScale = 0.85;
constexpr double GreatestScale = 1.15;

}

PlaceMatching::PlaceMatching(const GridSamples& place, const CarvingTarget& target)
  : Quantiles(target.Heights)
  , Measures(target.Measures)
  , Heights(ShapeOf(place.Values))
{
}

void PlaceMatching::Match(GridSamples& ground, double most, const ParallelFor& parallel, const Poll& poll) const
{
  std::vector<double> matched = CopyOf(ground.Values, poll);
  MatchHeights(matched, this->Quantiles, parallel, poll);
  const SampleShape is = ShapeOf(ground.Values, poll);
  const double mean = this->Heights.Mean;
  const auto scaleAbout = [&](double from, double scale) {
    parallel(ground.Values.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        ground.Values[n] = mean + scale * (ground.Values[n] - from);
      }
    });
  };
  scaleAbout(is.Mean, this->Heights.StandardDeviation / is.StandardDeviation);
  const std::vector<double> line = CopyOf(ground.Values, poll);
  for (double part = most * PartStep; part <= 1.0; part += PartStep)
  {
    parallel(line.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        ground.Values[n] = line[n] + part * (matched[n] - line[n]);
      }
    });
    if (part >= most || this->HasHypsometry(ShapeOf(ground.Values, poll)))
    {
      break;
    }
  }
  // geometric mean of what is over what is wanted
  double sum = 0.0;
  const std::vector<double> ratios = this->SemivarianceRatios(ground, parallel);
  for (const double ratio : ratios)
  {
    sum += std::log(1.0 / ratio);
  }
  const double missing = ratios.empty() ? 1.0 : std::exp(sum / static_cast<double>(ratios.size()));
  scaleAbout(mean, std::clamp(std::sqrt(missing), LeastScale, GreatestScale));
}

double PlaceMatching::SemivarianceError(const GridSamples& ground, const ParallelFor& parallel) const
{
  double most = 0.0;
  for (const double ratio : this->SemivarianceRatios(ground, parallel))
  {
    most = std::max(most, std::abs(ratio - 1.0));
  }
  return most;
}

/// Semivariances over the place's, of the lags at which it has one above 0.
std::vector<double> PlaceMatching::SemivarianceRatios(const GridSamples& ground, const ParallelFor& parallel) const
{
  const std::vector<int> lags = SemivarianceLags(ground.Width, ground.Height);
  const std::vector<double> semivariance = SemivarianceAlongAxes(ground, lags, parallel);
  std::vector<double> ratios;
  for (std::size_t n = 0; n < lags.size(); ++n)
  {
    const double wanted = this->Measures.SemivarianceAt(lags[n] * 0.5 * (ground.Spacing[0] + ground.Spacing[1]));
    if (wanted > 0.0)
    {
      ratios.push_back(semivariance[n] / wanted);
    }
  }
  return ratios;
}

bool PlaceMatching::HasHypsometry(const SampleShape& is) const
{
  const auto integral = [](const SampleShape& of) { return (of.Mean - of.Minimum) / (of.Maximum - of.Minimum); };
  return std::abs(integral(is) - integral(this->Heights)) < IntegralTolerance &&
    std::abs(is.Skew - this->Heights.Skew) < SkewTolerance;
}

}
