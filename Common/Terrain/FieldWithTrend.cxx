// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/FieldWithTrend.h"

#include <algorithm>
#include <vector>

namespace littoral
{

namespace
{

/// Rows that one thread fills at a time: enough for long runs along the lines that are closer to y.
constexpr std::size_t RowsAtOnce = 128;

/// Number of columns or rows, 0 if the window is empty.
std::size_t PointsAlong(const GridWindow& window, int axis)
{
  return static_cast<std::size_t>(std::max(0ll, window.Last[axis] - static_cast<long long>(window.First[axis]) + 1));
}

FieldTrend Widened(FieldTrend trend, const PlaneGrid& grid, const GridWindow& whole)
{
  if (trend.Sides[0] > 0.0 && trend.Sides[1] > 0.0)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      const auto points = static_cast<double>(PointsAlong(whole, axis));
      trend.Sides[axis] = std::max(trend.Sides[axis], points * grid.Spacing[axis]);
    }
  }
  return trend;
}

}

FieldWithTrend::FieldWithTrend(const TurningBandsParameters& parameters, const FieldTrend& trend, const PlaneGrid& grid,
  const GridWindow& whole, const GridWindow& window)
  : Trend(Widened(trend, grid, whole))
  , Grid(grid)
  , Window(window)
  , Middle{ 0.5 * (whole.First[0] + static_cast<double>(whole.Last[0])),
    0.5 * (whole.First[1] + static_cast<double>(whole.Last[1])) }
  , Field(parameters, grid, window)
{
}

void FieldWithTrend::Tabulate(const ParallelFor& parallel)
{
  const bool isLevelled = this->Trend.Sides[0] > 0.0 && this->Trend.Sides[1] > 0.0;
  const std::array<double, 2> center{ this->Grid.Origin[0] + this->Middle[0] * this->Grid.Spacing[0],
    this->Grid.Origin[1] + this->Middle[1] * this->Grid.Spacing[1] };
  std::vector<PlaneTrend> planes(isLevelled ? this->Field.GetNumberOfLines() : 0);
  parallel(this->Field.GetNumberOfLines(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t line = begin; line < end; ++line)
    {
      this->Field.TabulateLine(line);
      if (isLevelled)
      {
        planes[line] = this->Field.PlaneOfLine(line, center, this->Trend.Sides);
      }
    }
  });
  // The field's own plane makes room for the given one.
  for (const PlaneTrend& plane : planes)
  {
    this->Trend.Mean -= plane.Mean;
    this->Trend.Slope[0] -= plane.Slope[0];
    this->Trend.Slope[1] -= plane.Slope[1];
  }
}

void FieldWithTrend::Fill(float* values, const ParallelFor& parallel) const
{
  const std::size_t height = PointsAlong(this->Window, 1);
  parallel((height + RowsAtOnce - 1) / RowsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t piece = begin; piece < end; ++piece)
    {
      this->FillRows(piece * RowsAtOnce, std::min((piece + 1) * RowsAtOnce, height), values);
    }
  });
}

void FieldWithTrend::FillRows(std::size_t begin, std::size_t end, float* values) const
{
  const std::size_t width = PointsAlong(this->Window, 0);
  const std::array<int, 2>& first = this->Window.First;
  const std::array<double, 2>& slope = this->Trend.Slope;
  this->Field.FillRows(first[1] + static_cast<int>(begin), first[1] + static_cast<int>(end) - 1, 1.0, this->Trend.Mean,
    values + begin * width);
  const bool isTilted = slope[0] != 0.0 || slope[1] != 0.0;
  for (std::size_t j = begin; isTilted && j < end; ++j)
  {
    const double rise = slope[1] * this->Grid.Spacing[1] * (first[1] + static_cast<double>(j) - this->Middle[1]);
    for (std::size_t i = 0; i < width; ++i)
    {
      const double x = this->Grid.Spacing[0] * (first[0] + static_cast<double>(i) - this->Middle[0]);
      values[j * width + i] += static_cast<float>(slope[0] * x + rise);
    }
  }
}

}
