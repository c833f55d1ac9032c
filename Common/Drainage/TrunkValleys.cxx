// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/TrunkValleys.h"

#include "Drainage/CellLattice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

constexpr double RiverPart = 1.0 / 50.0; ///< of the map's cells
constexpr double HighPart = 0.25;
constexpr double ReachPart = 1.0 / 12.0; ///< of the shorter side
constexpr int MountainDirections = 6;

/// The height that a part of the cells are above.
double HeightOfHighest(std::vector<double> heights, double part)
{
  const auto rank = static_cast<std::ptrdiff_t>((1.0 - part) * static_cast<double>(heights.size()));
  std::nth_element(heights.begin(), heights.begin() + rank, heights.end());
  return heights[rank];
}

/// Whether there is ground of a height and more in a direction from a cell, within a reach [cells].
bool IsHighTowards(int direction, const GridSamples& ground, CellIndex cell, double high, double reach)
{
  const int stepX = CellLattice::StepX[direction];
  const int stepY = CellLattice::StepY[direction];
  const int steps = static_cast<int>(std::round(reach / std::hypot(stepX, stepY)));
  for (int n = 1; n <= steps; ++n)
  {
    const int i = cell % ground.Width + n * stepX;
    const int j = cell / ground.Width + n * stepY;
    if (i < 0 || j < 0 || i >= ground.Width || j >= ground.Height)
    {
      return false;
    }
    if (ground.At(i, j) >= high)
    {
      return true;
    }
  }
  return false;
}

int DirectionsWithin(const GridSamples& ground, CellIndex cell, double high, double reach)
{
  int directions = 0;
  for (int d = 0; d < CellLattice::Directions; ++d)
  {
    directions += IsHighTowards(d, ground, cell, high, reach) ? 1 : 0;
  }
  return directions;
}

}

double TrunkValleyLength(const GridSamples& ground, const std::vector<CellIndex>& accumulation)
{
  const auto count = static_cast<double>(ground.Values.size());
  const double high = HeightOfHighest(ground.Values, HighPart);
  const double reach = ReachPart * std::min(ground.Width, ground.Height);
  int cells = 0;
  for (std::size_t cell = 0; cell < accumulation.size(); ++cell)
  {
    cells += accumulation[cell] >= RiverPart * count &&
        DirectionsWithin(ground, static_cast<CellIndex>(cell), high, reach) >= MountainDirections
      ? 1
      : 0;
  }
  return cells / std::sqrt(count);
}

}
