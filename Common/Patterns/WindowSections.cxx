// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/WindowSections.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// Sections over the height of a window.
constexpr int SectionRows = 1024;
/// Spacings of a table's nodes from 0 to its maximum distance.
constexpr int TableSteps = 128;

/// Length [m] that a section and another one, moved by dx [m], have in common.
double CommonLength(const std::vector<double>& one, const std::vector<double>& other, double dx)
{
  double length = 0.0;
  for (std::size_t a = 0, b = 0; a + 1 < one.size() && b + 1 < other.size();)
  {
    const double begin = std::max(one[a], other[b] + dx);
    const double end = std::min(one[a + 1], other[b + 1] + dx);
    length += std::max(0.0, end - begin);
    (one[a + 1] < other[b + 1] + dx ? a : b) += 2;
  }
  return length;
}

}

std::vector<double> SectionAt(const ObservationWindow& window, double y)
{
  const std::vector<PlanePosition>& corners = window.GetCorners();
  std::vector<double> section;
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    const PlanePosition& a = corners[k];
    const PlanePosition& b = corners[(k + 1) % corners.size()];
    if ((a[1] > y) != (b[1] > y))
    {
      section.push_back(a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]));
    }
  }
  std::sort(section.begin(), section.end());
  return section;
}

double CommonAreaOfRows(const ObservationWindow& window, double dx, double dy)
{
  const double low = window.GetLow()[1] + std::max(0.0, dy);
  const double step = (window.GetHigh()[1] + std::min(0.0, dy) - low) / SectionRows;
  double area = 0.0;
  for (int row = 0; row < SectionRows && step > 0.0; ++row)
  {
    const double y = low + (row + 0.5) * step;
    area += step * CommonLength(SectionAt(window, y), SectionAt(window, y - dy), dx);
  }
  return area;
}

CommonAreaTable::CommonAreaTable(const ObservationWindow& window, double maximumDistance, const ParallelFor& parallel)
  : Window(window)
  , MaximumDistance(maximumDistance)
{
  if (window.IsRectangle())
  {
    return;
  }
  const double step = (window.GetHigh()[1] - window.GetLow()[1]) / SectionRows;
  std::vector<std::vector<double>> sections(SectionRows);
  for (int row = 0; row < SectionRows; ++row)
  {
    sections[static_cast<std::size_t>(row)] = SectionAt(window, window.GetLow()[1] + (row + 0.5) * step);
  }
  // Nodes along y are whole rows apart.
  const std::size_t stride = static_cast<std::size_t>(std::max(1.0, std::ceil(maximumDistance / TableSteps / step)));
  this->Along = static_cast<double>(stride) * step;
  this->Across = maximumDistance / TableSteps;
  this->Columns = 2 * TableSteps + 2;
  const std::size_t rows = static_cast<std::size_t>(std::ceil(maximumDistance / this->Along)) + 2;
  this->Areas.assign(rows * this->Columns, 0.0);
  parallel(this->Areas.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
    {
      const std::size_t shift = node / this->Columns * stride;
      const double dx = this->Across * (static_cast<double>(node % this->Columns) - TableSteps);
      for (std::size_t row = shift; row < sections.size(); ++row)
      {
        this->Areas[node] += step * CommonLength(sections[row], sections[row - shift], dx);
      }
    }
  });
}

double CommonAreaTable::operator()(double dx, double dy) const
{
  if (this->Areas.empty())
  {
    return this->Window.CommonArea(dx, dy);
  }
  // A move and its reverse have the same area; bilinear between nodes.
  const double sign = dy < 0.0 ? -1.0 : 1.0;
  const double u = std::max(0.0, sign * dx / this->Across + TableSteps);
  const double v = sign * dy / this->Along;
  const std::size_t rows = this->Areas.size() / this->Columns;
  const std::size_t i = std::min(this->Columns - 2, static_cast<std::size_t>(u));
  const std::size_t j = std::min(rows - 2, static_cast<std::size_t>(v));
  const double s = u - static_cast<double>(i);
  const double t = v - static_cast<double>(j);
  const double* low = &this->Areas[j * this->Columns + i];
  const double* high = low + this->Columns;
  return (1.0 - t) * ((1.0 - s) * low[0] + s * low[1]) + t * ((1.0 - s) * high[0] + s * high[1]);
}

}
