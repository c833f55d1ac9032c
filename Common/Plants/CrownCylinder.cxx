// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/CrownCylinder.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// Cells from the first to the last along an axis that a range touches, within the grid.
std::array<int, 2> CellsOf(const CanopyGrid& grid, int axis, double low, double high)
{
  const auto indexOf = [&](double place) { return std::floor((place - grid.Origin[axis]) / grid.Spacing[axis]); };
  const double last = grid.Count[axis] - 1.0;
  return { static_cast<int>(std::clamp(indexOf(low), 0.0, last + 1.0)),
    static_cast<int>(std::clamp(indexOf(high), -1.0, last)) };
}

}

double CircleWithin(double radius, double x, double y)
{
  const double sign = (x < 0.0 ? -1.0 : 1.0) * (y < 0.0 ? -1.0 : 1.0);
  const double a = std::min(std::abs(x), radius);
  const double b = std::min(std::abs(y), radius);
  const double square = radius * radius;
  if (a * a + b * b <= square)
  {
    return sign * a * b;
  }
  // b up to where the circle sinks below b, then the area under sqrt(r^2 - t^2) up to a
  const double from = std::sqrt(square - b * b);
  const auto under = [&](double t) {
    return 0.5 * (t * std::sqrt(std::max(0.0, square - t * t)) + square * std::asin(std::min(1.0, t / radius)));
  };
  return sign * (b * from + under(a) - under(from));
}

void ShareBetweenCells(
  const CanopyGrid& grid, const CrownCylinder& crown, const CanopyProfile& profile, const TakeShare& take)
{
  const double radius = 0.5 * crown.Diameter;
  const auto columns = CellsOf(grid, 0, crown.Foot.x - radius, crown.Foot.x + radius);
  const auto rows = CellsOf(grid, 1, crown.Foot.y - radius, crown.Foot.y + radius);
  const auto layers = CellsOf(grid, 2, crown.Foot.z, crown.Foot.z + crown.Height);
  std::vector<double> ofLayer;
  for (int k = layers[0]; k <= layers[1]; ++k)
  {
    const double low = (grid.Origin.z + k * grid.Spacing.z - crown.Foot.z) / crown.Height;
    const double high = (grid.Origin.z + (k + 1) * grid.Spacing.z - crown.Foot.z) / crown.Height;
    ofLayer.push_back(profile.ShareBelow(high) - profile.ShareBelow(low));
  }
  double within = 0.0;
  for (int j = rows[0]; j <= rows[1]; ++j)
  {
    const double y = grid.Origin.y + j * grid.Spacing.y - crown.Foot.y;
    for (int i = columns[0]; i <= columns[1]; ++i)
    {
      const double x = grid.Origin.x + i * grid.Spacing.x - crown.Foot.x;
      const double farX = x + grid.Spacing.x;
      const double farY = y + grid.Spacing.y;
      // share of the circle in the rectangle of the column
      const double across = (CircleWithin(radius, farX, farY) - CircleWithin(radius, x, farY) -
                              CircleWithin(radius, farX, y) + CircleWithin(radius, x, y)) /
        (Pi * radius * radius);
      for (std::size_t layer = 0; across > 0.0 && layer < ofLayer.size(); ++layer)
      {
        const double share = across * ofLayer[layer];
        within += share;
        take(grid.IndexOf(i, j, layers[0] + static_cast<int>(layer)), share);
      }
    }
  }
  take(OutsideCells, std::max(0.0, 1.0 - within));
}

}
