// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/CanopyCells.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace littoral
{

namespace
{

/// Lowest and highest coordinate along an axis.
std::array<double, 2> RangeOf(const CutPolygon& polygon, int axis)
{
  std::array<double, 2> range{ polygon.Corners[0][axis], polygon.Corners[0][axis] };
  for (int corner = 1; corner < polygon.Size; ++corner)
  {
    range[0] = std::min(range[0], polygon.Corners[corner][axis]);
    range[1] = std::max(range[1], polygon.Corners[corner][axis]);
  }
  return range;
}

/// Cuts a polygon at a plane across an axis into what is below it and what is not.
void CutAt(const CutPolygon& polygon, int axis, double plane, CutPolygon& below, CutPolygon& above)
{
  below.Size = 0;
  above.Size = 0;
  for (int corner = 0; corner < polygon.Size; ++corner)
  {
    const Vector3& from = polygon.Corners[corner];
    const Vector3& to = polygon.Corners[corner + 1 < polygon.Size ? corner + 1 : 0];
    const bool isBelow = from[axis] < plane;
    CutPolygon& side = isBelow ? below : above;
    side.Corners[side.Size++] = from;
    if (isBelow != (to[axis] < plane))
    {
      // the corner that both parts share, on the plane
      Vector3 cut = from + (plane - from[axis]) / (to[axis] - from[axis]) * (to - from);
      cut[axis] = plane;
      below.Corners[below.Size++] = cut;
      above.Corners[above.Size++] = cut;
    }
  }
}

/// Cuts along an axis, and each part along the next one.
void CutAlong(
  const CanopyGrid& grid, const CutPolygon& polygon, int axis, std::array<int, 3>& cell, const TakePart& take)
{
  if (axis == 3)
  {
    take(grid.IndexOf(cell[0], cell[1], cell[2]), polygon);
    return;
  }
  const std::array<double, 2> range = RangeOf(polygon, axis);
  const double origin = grid.Origin[axis];
  const double side = grid.Spacing[axis];
  const int count = grid.Count[axis];
  if (range[1] < origin || range[0] >= origin + count * side)
  {
    take(OutsideCells, polygon);
    return;
  }
  const auto indexOf = [&](double place) {
    return static_cast<int>(std::clamp(std::floor((place - origin) / side), -1.0, static_cast<double>(count)));
  };
  const int last = indexOf(range[1]);
  int index = indexOf(range[0]);
  CutPolygon parts[2];
  CutPolygon below;
  const CutPolygon* rest = &polygon;
  for (int turn = 0; rest->Size > 0; ++index, turn = 1 - turn)
  {
    const CutPolygon* part = rest;
    if (index < last)
    {
      CutAt(*rest, axis, origin + (index + 1) * side, below, parts[turn]);
      part = &below;
      rest = &parts[turn];
    }
    if (part->Size > 2 && (index < 0 || index >= count))
    {
      take(OutsideCells, *part);
    }
    else if (part->Size > 2)
    {
      cell[axis] = index;
      const CutPolygon own = *part;
      CutAlong(grid, own, axis + 1, cell, take);
    }
    if (index >= last)
    {
      return;
    }
  }
}

}

void OrderFreeSums::AddUp(const WorkShare& share)
{
  if (share.Ranks < 2)
  {
    return;
  }
  std::vector<double> own; // what is not 0, by places
  const auto add = [&own](std::size_t place, std::int64_t units) {
    if (units != 0)
    {
      own.insert(own.end(), { static_cast<double>(place), static_cast<double>(units) });
    }
  };
  for (std::size_t place = 0; place < this->Size(); ++place)
  {
    // two numbers for one that a double does not hold
    const std::int64_t units = this->Units[place];
    const std::int64_t rest = units % LargestInDouble;
    add(place, units - rest);
    add(place, rest);
  }
  const NumberRows rows = share.Gather(std::move(own));
  for (std::size_t rank = 0; rank < rows.size(); ++rank)
  {
    for (std::size_t n = 0; rank != share.Rank && n < rows[rank].size(); n += 2)
    {
      this->Units[static_cast<std::size_t>(rows[rank][n])] += static_cast<std::int64_t>(rows[rank][n + 1]);
    }
  }
}

double CutPolygon::Area() const
{
  // A = |sum (c_i - c_0) x (c_i+1 - c_0)| / 2
  Vector3 sum(0.0);
  for (int corner = 2; corner < this->Size; ++corner)
  {
    sum += glm::cross(this->Corners[corner - 1] - this->Corners[0], this->Corners[corner] - this->Corners[0]);
  }
  return 0.5 * glm::length(sum);
}

Vector3 CutPolygon::Center() const
{
  Vector3 sum(0.0);
  double area = 0.0;
  for (int corner = 2; corner < this->Size; ++corner)
  {
    const Vector3& a = this->Corners[0];
    const Vector3& b = this->Corners[corner - 1];
    const Vector3& c = this->Corners[corner];
    const double own = glm::length(glm::cross(b - a, c - a));
    sum += own / 3.0 * (a + b + c);
    area += own;
  }
  return area > 0.0 ? sum / area : this->Corners[0];
}

CutPolygon TriangleOf(const Vector3& a, const Vector3& b, const Vector3& c)
{
  CutPolygon triangle;
  triangle.Corners[0] = a;
  triangle.Corners[1] = b;
  triangle.Corners[2] = c;
  triangle.Size = 3;
  return triangle;
}

void CutToCells(const CanopyGrid& grid, const CutPolygon& polygon, const TakePart& take)
{
  std::array<int, 3> cell{ 0, 0, 0 };
  CutAlong(grid, polygon, 0, cell, take);
}

}
