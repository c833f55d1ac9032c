// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/GapFraction.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace littoral
{

namespace
{

constexpr int MostAlong = 64; ///< places along a side
constexpr int Azimuths = 16;

/// Integral of the density along a line from the middle of a lowest face up through the grid.
double IntegralAlong(const CanopyGrid& grid, const float* density, std::array<int, 3> cell, const Vector3& direction)
{
  double next[3];
  double step[3];
  int turn[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    // lengths along the line to the next face and between faces
    const double speed = std::abs(direction[axis]);
    step[axis] = speed > 1e-12 ? grid.Spacing[axis] / speed : 1e30;
    next[axis] = axis == 2 ? step[axis] : 0.5 * step[axis];
    turn[axis] = direction[axis] < 0.0 ? -1 : 1;
  }
  double sum = 0.0;
  double place = 0.0;
  while (cell[2] < grid.Count[2])
  {
    const int axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    sum += (next[axis] - place) * static_cast<double>(density[grid.IndexOf(cell[0], cell[1], cell[2])]);
    place = next[axis];
    next[axis] += step[axis];
    cell[axis] += turn[axis];
    if (axis < 2)
    {
      cell[axis] = (cell[axis] + grid.Count[axis]) % grid.Count[axis];
    }
  }
  return sum;
}

}

double GapFraction(const CanopyGrid& grid, const float* density, double zenith, double projection,
  const ParallelFor& parallel, const WorkShare& share)
{
  const int along[2] = { std::min(grid.Count[0], MostAlong), std::min(grid.Count[1], MostAlong) };
  NumberRows sums(static_cast<std::size_t>(along[1]), { 0.0 });
  parallel(share.OwnOf(sums.size()), [&](std::size_t begin, std::size_t end) {
    for (std::size_t own = begin; own < end; ++own)
    {
      const std::size_t row = share.RowOf(own);
      const auto j = static_cast<int>((2 * static_cast<long long>(row) + 1) * grid.Count[1] / (2 * along[1]));
      for (int n = 0; n < along[0]; ++n)
      {
        const auto i = static_cast<int>((2LL * n + 1) * grid.Count[0] / (2 * along[0]));
        for (int turn = 0; turn < Azimuths; ++turn)
        {
          const double azimuth = 2.0 * Pi * (turn + 0.5) / Azimuths;
          const Vector3 direction(
            std::sin(zenith) * std::cos(azimuth), std::sin(zenith) * std::sin(azimuth), std::cos(zenith));
          // P = exp(-G integral of a ds)
          sums[row][0] += std::exp(-projection * IntegralAlong(grid, density, { i, j, 0 }, direction));
        }
      }
    }
  });
  share.Complete(sums);
  const auto add = [](double sum, const std::vector<double>& row) { return sum + row[0]; };
  return std::accumulate(sums.begin(), sums.end(), 0.0, add) / (static_cast<double>(along[0]) * along[1] * Azimuths);
}

}
