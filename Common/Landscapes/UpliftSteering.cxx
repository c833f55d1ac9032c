// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/UpliftSteering.h"

#include "Drainage/ValleySpreading.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace littoral
{

namespace
{

/// L - z about its mean, after the Gauss filter.
std::vector<double> LongErrors(
  const std::vector<double>& heights, const GridSamples& longWaves, double smoothing, const ParallelFor& parallel)
{
  GridSamples errors = longWaves;
  for (std::size_t n = 0; n < heights.size(); ++n)
  {
    errors.Values[n] -= heights[n];
  }
  const double mean = Moments(errors).Mean;
  for (double& error : errors.Values)
  {
    error -= mean;
  }
  SmoothGrid(errors.Values, errors.Width, errors.Height, smoothing, parallel);
  return errors.Values;
}

}

void SteerUplift(const UpliftSteering& steering, const std::vector<double>& heights, const GridSamples& longWaves,
  const std::vector<double>& rock, std::vector<double>& hardness, const ParallelFor& parallel)
{
  const std::vector<double> errors = LongErrors(heights, longWaves, steering.Smoothing, parallel);
  const double range = std::log(steering.Range);
  const double gain = steering.Gain / (range * std::sqrt(Moments(longWaves).Variance));
  parallel(errors.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      // h' = h (r / h e^(ln R x / sqrt(1 + x^2)))^q
      const double x = gain * errors[n];
      const double wanted = std::log(rock[n] / hardness[n]) + range * x / std::sqrt(1.0 + x * x);
      hardness[n] = std::clamp(hardness[n] * std::exp(steering.Rate * wanted), steering.Minimum, steering.Maximum);
    }
  });
}

void KeepSteepness(const std::vector<double>& logSteepness, std::vector<double>& hardness)
{
  const double count = static_cast<double>(hardness.size());
  const double mean = std::accumulate(logSteepness.begin(), logSteepness.end(), 0.0) / count;
  double covariance = 0.0;
  double variance = 0.0;
  for (std::size_t n = 0; n < hardness.size(); ++n)
  {
    const double aside = logSteepness[n] - mean;
    covariance += aside * std::log(hardness[n]);
    variance += aside * aside;
  }
  constexpr double least = 1e-12; // a deviation of 1e-6 is rounding
  if (variance < least * count)
  {
    return;
  }
  for (std::size_t n = 0; n < hardness.size(); ++n)
  {
    // h' = h (q / q_mean)^-b
    hardness[n] *= std::exp(-covariance / variance * (logSteepness[n] - mean));
  }
}

}
