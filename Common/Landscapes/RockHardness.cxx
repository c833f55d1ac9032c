// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/RockHardness.h"

#include "Drainage/GroundStatistics.h"
#include "Drainage/ValleySpreading.h"

#include <algorithm>
#include <cstddef>

namespace littoral
{

namespace
{

constexpr int Classes = 64;
constexpr int ClassesAside = 6;

/// Class of each cell, k = floor(64 r / n) with the rank r of its smoothed height.
std::vector<int> ClassesOfHeight(const GridSamples& terrain, double smoothing, const ParallelFor& parallel)
{
  std::vector<double> heights = terrain.Values;
  SmoothGrid(heights, terrain.Width, terrain.Height, smoothing, parallel);
  std::vector<double> sorted = heights;
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> classes;
  for (const double height : heights)
  {
    const auto rank = std::lower_bound(sorted.begin(), sorted.end(), height) - sorted.begin();
    classes.push_back(static_cast<int>(Classes * rank / static_cast<std::ptrdiff_t>(sorted.size())));
  }
  return classes;
}

/// Mean of `sums` over that of `counts` in a class and those aside.
double MeanAbout(int middle, const std::vector<double>& sums, const std::vector<double>& counts)
{
  double sum = 0.0;
  double count = 0.0;
  for (int k = std::max(0, middle - ClassesAside); k <= std::min(Classes - 1, middle + ClassesAside); ++k)
  {
    sum += sums[k];
    count += counts[k];
  }
  return count > 0.0 ? sum / count : 0.0;
}

}

std::vector<double> SlopesByHeight(const GridSamples& place, double smoothing, const ParallelFor& parallel)
{
  const std::vector<int> classes = ClassesOfHeight(place, smoothing, parallel);
  const std::vector<double> slopes = GradientsOf(place);
  const double mean = ShapeOf(slopes).Mean;
  std::vector<double> sums(Classes, 0.0);
  std::vector<double> counts(Classes, 0.0);
  const int columns = place.Width - 2;
  for (std::size_t n = 0; n < slopes.size(); ++n)
  {
    const std::size_t cell = (n / columns + 1) * place.Width + n % columns + 1;
    sums[classes[cell]] += slopes[n] / mean;
    ++counts[classes[cell]];
  }
  std::vector<double> profile;
  for (int k = 0; k < Classes; ++k)
  {
    profile.push_back(MeanAbout(k, sums, counts));
  }
  return profile;
}

std::vector<double> ProfileByHeight(
  const GridSamples& terrain, double smoothing, const std::vector<double>& profile, const ParallelFor& parallel)
{
  std::vector<double> values;
  for (const int k : ClassesOfHeight(terrain, smoothing, parallel))
  {
    values.push_back(profile[k]);
  }
  return values;
}

}
