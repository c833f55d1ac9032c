// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/UpliftSteering.h"

#include "Drainage/ValleySpreading.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// Largest change of ln U at once.
constexpr double LargestChange = 0.3;

}

void SteerUplift(const UpliftSteering& steering, const std::vector<double>& heights, const GridSamples& longWaves,
  std::vector<double>& uplift, const ParallelFor& parallel)
{
  std::vector<double> errors(heights.size());
  for (std::size_t n = 0; n < errors.size(); ++n)
  {
    errors[n] = longWaves.Values[n] - heights[n];
  }
  SmoothGrid(errors, longWaves.Width, longWaves.Height, steering.Smoothing, parallel);
  // U' = U exp(g e / s)
  const double gain = steering.Gain / std::sqrt(Moments(longWaves).Variance);
  for (std::size_t n = 0; n < errors.size(); ++n)
  {
    const double change = std::clamp(gain * errors[n], -LargestChange, LargestChange);
    uplift[n] = std::clamp(uplift[n] * std::exp(change), steering.Minimum, steering.Maximum);
  }
}

}
