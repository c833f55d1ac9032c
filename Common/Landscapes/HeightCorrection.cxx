// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/HeightCorrection.h"

#include "Drainage/ValleySpreading.h"
#include "Numerics/Constants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

constexpr double WidestPart = 0.25; ///< widest function over the shorter side
constexpr double LeastWeight = 0.3; ///< over the height of the function of one datum

/// Height that is missing at a datum; 0 where it has no number.
double MissingAt(const GridSamples& ground, const GivenHeight& given)
{
  return std::isnan(given.Height) ? 0.0 : given.Height - HeightAt(ground, given.Place);
}

/// Cell of a place, at the border for those beyond it.
std::size_t CellOf(const GridSamples& ground, const std::array<double, 2>& place)
{
  const double i = std::clamp(std::floor(place[0] / ground.Spacing[0] + 0.5), 0.0, ground.Width - 1.0);
  const double j = std::clamp(std::floor(place[1] / ground.Spacing[1] + 0.5), 0.0, ground.Height - 1.0);
  return static_cast<std::size_t>(j) * ground.Width + static_cast<std::size_t>(i);
}

/// One correction by a function of a deviation [cells].
void CorrectBy(
  double deviation, GridSamples& ground, const std::vector<GivenHeight>& heights, const ParallelFor& parallel)
{
  std::vector<double> missing(ground.Values.size(), 0.0);
  std::vector<double> count(ground.Values.size(), 0.0);
  for (const GivenHeight& given : heights)
  {
    const std::size_t cell = CellOf(ground, given.Place);
    missing[cell] += MissingAt(ground, given);
    count[cell] += std::isnan(given.Height) ? 0.0 : 1.0;
  }
  SmoothGrid(missing, ground.Width, ground.Height, deviation, parallel);
  SmoothGrid(count, ground.Width, ground.Height, deviation, parallel);
  // c = G(sum r) / max(G(n), 0.3 / (2 pi s^2))
  const double least = LeastWeight / (2.0 * Pi * deviation * deviation);
  for (std::size_t n = 0; n < missing.size(); ++n)
  {
    ground.Values[n] += missing[n] / std::max(count[n], least);
  }
}

}

double HeightAt(const GridSamples& grid, const std::array<double, 2>& place)
{
  const double x = std::clamp(place[0] / grid.Spacing[0], 0.0, grid.Width - 1.0);
  const double y = std::clamp(place[1] / grid.Spacing[1], 0.0, grid.Height - 1.0);
  const int i = std::min(static_cast<int>(x), grid.Width - 2);
  const int j = std::min(static_cast<int>(y), grid.Height - 2);
  const double low = grid.At(i, j) + (x - i) * (grid.At(i + 1, j) - grid.At(i, j));
  const double high = grid.At(i, j + 1) + (x - i) * (grid.At(i + 1, j + 1) - grid.At(i, j + 1));
  return low + (y - j) * (high - low);
}

void CorrectHeights(
  GridSamples& ground, const std::vector<GivenHeight>& heights, double least, const ParallelFor& parallel, int passes)
{
  double sum = 0.0;
  double count = 0.0;
  for (const GivenHeight& given : heights)
  {
    sum += MissingAt(ground, given);
    count += std::isnan(given.Height) ? 0.0 : 1.0;
  }
  if (count == 0.0)
  {
    return;
  }
  for (double& height : ground.Values)
  {
    height += sum / count;
  }
  for (double deviation = WidestPart * std::min(ground.Width, ground.Height); deviation > least; deviation *= 0.5)
  {
    CorrectBy(deviation, ground, heights, parallel);
  }
  for (int pass = 0; pass < passes; ++pass)
  {
    CorrectBy(least, ground, heights, parallel);
  }
}

}
