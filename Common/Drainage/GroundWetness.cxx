// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/GroundWetness.h"

#include "Drainage/ValleySpreading.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

/// Tangent of the slope that level ground is taken to have.
constexpr double LeastSlope = 1e-3;

/// Standard deviation of the ground that a stream wets [cells].
constexpr double WetCells = 2.0;

/// Cells from which on the index is reduced to theirs: the area of a cell alone raises it by the logarithm of its side [m].
constexpr double ReferenceCell = 10.0;

/// Difference of the heights of neighbours along an axis, central within the grid [m/m].
double Difference(const HeightGrid& ground, int i, int j, int axis)
{
  int low[2] = { i, j };
  int high[2] = { i, j };
  low[axis] = std::max(0, low[axis] - 1);
  high[axis] = std::min(ground.Count[axis] - 1, high[axis] + 1);
  const auto heightAt = [&](const int(&at)[2]) {
    return ground.HeightOf(at[1] * static_cast<long long>(ground.Count[0]) + at[0]);
  };
  const int steps = std::max(1, high[axis] - low[axis]);
  return (heightAt(high) - heightAt(low)) / (steps * ground.Spacing[axis]);
}

/// Slope at a point, from level ground [rad]; 0 beside holes.
double SlopeAt(const HeightGrid& ground, int i, int j)
{
  const double slope = std::atan(std::hypot(Difference(ground, i, j, 0), Difference(ground, i, j, 1)));
  return std::isfinite(slope) ? slope : 0.0;
}

}

double WetnessOf(double drainageArea, double cellWidth, double slope)
{
  return std::log(drainageArea / (cellWidth * std::max(LeastSlope, std::tan(slope))));
}

std::vector<double> SpreadWetness(
  const HeightGrid& ground, const std::function<double(long long)>& areaOf, const ParallelFor& parallel)
{
  const int width = ground.Count[0];
  const int height = ground.Count[1];
  const double cell = std::sqrt(ground.Spacing[0] * ground.Spacing[1]);
  const double coarse = std::log(std::max(1.0, cell / ReferenceCell));
  std::vector<double> wetness(static_cast<std::size_t>(width) * height);
  parallel(height, [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        const long long point = static_cast<long long>(j) * width + i;
        wetness[point] = WetnessOf(areaOf(point), cell, SlopeAt(ground, i, j)) - coarse;
      }
    }
  });
  SmoothGrid(wetness, width, height, WetCells, parallel);
  return wetness;
}

}
