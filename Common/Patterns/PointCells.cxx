// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PointCells.h"

namespace littoral
{

namespace
{

/// Cells for each point, at most.
constexpr double CellsOfPoint = 4.0;

}

PointCells::PointCells(const std::vector<PlanePosition>& points, double size)
{
  PlanePosition high{ 0.0, 0.0 };
  if (!points.empty())
  {
    this->Low = high = points.front();
  }
  for (const PlanePosition& point : points)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  const double width = high[0] - this->Low[0];
  const double height = high[1] - this->Low[1];
  const double most = CellsOfPoint * static_cast<double>(points.size()) + 1.0;
  const double least = std::max(std::sqrt(width * height / most), std::max(width, height) / most);
  this->CellSize = std::max({ size, least, std::numeric_limits<double>::min() });
  this->Columns = 1 + static_cast<int>(width / this->CellSize);
  this->Rows = 1 + static_cast<int>(height / this->CellSize);
  // Sorted by counting.
  const std::size_t columns = static_cast<std::size_t>(this->Columns);
  const auto cellOf = [&](const PlanePosition& point) {
    return static_cast<std::size_t>(this->RowOf(point[1])) * columns +
      static_cast<std::size_t>(this->ColumnOf(point[0]));
  };
  this->Starts.assign(columns * static_cast<std::size_t>(this->Rows) + 1, 0);
  for (const PlanePosition& point : points)
  {
    ++this->Starts[cellOf(point) + 1];
  }
  for (std::size_t cell = 1; cell < this->Starts.size(); ++cell)
  {
    this->Starts[cell] += this->Starts[cell - 1];
  }
  this->X.resize(points.size());
  this->Y.resize(points.size());
  this->Order.resize(points.size());
  std::vector<std::size_t> next(this->Starts.begin(), this->Starts.end() - 1);
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    const std::size_t place = next[cellOf(points[n])]++;
    this->X[place] = points[n][0];
    this->Y[place] = points[n][1];
    this->Order[place] = n;
  }
}

double PointCells::NearestDistance(double x, double y, std::size_t except) const
{
  // Wider and wider until a point is found within the radius, which is then the nearest.
  const double farthest =
    this->CellSize * (this->Columns + this->Rows) + std::max(std::abs(x - this->Low[0]), std::abs(y - this->Low[1]));
  for (double radius = this->CellSize;; radius *= 2.0)
  {
    double square = std::numeric_limits<double>::infinity();
    this->ForRangesNear(x, y, radius, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t j = begin; j < end; ++j)
      {
        const double dx = this->X[j] - x;
        const double dy = this->Y[j] - y;
        square = j == except ? square : std::min(square, dx * dx + dy * dy);
      }
    });
    if (square <= radius * radius || radius > 2.0 * farthest)
    {
      return std::sqrt(square);
    }
  }
}

}
