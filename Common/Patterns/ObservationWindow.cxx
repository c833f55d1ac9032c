// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/ObservationWindow.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Patterns/WindowSections.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace littoral
{

namespace
{

/// Width of the edge, as a part of the size of the window: coordinates are rounded to single precision.
constexpr double EdgeTolerance = 1e-6;
/// Smallest area of a window, as a part of the bounding box.
constexpr double MinimumArea = 1e-9;

/// Twice the area of a triangle, above 0 if it turns counterclockwise.
double Turn(const PlanePosition& a, const PlanePosition& b, const PlanePosition& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double SquaredLength(double dx, double dy)
{
  return dx * dx + dy * dy;
}

/// Squared distance of a point to a segment from a to b [m2].
double SquaredDistance(const PlanePosition& p, const PlanePosition& a, const PlanePosition& b)
{
  const double dx = b[0] - a[0];
  const double dy = b[1] - a[1];
  const double along = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / SquaredLength(dx, dy);
  const double t = std::min(1.0, std::max(0.0, along));
  return SquaredLength(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

/// Whether a point on the line through a and b lies between them.
bool IsBetween(const PlanePosition& p, const PlanePosition& a, const PlanePosition& b)
{
  return std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) && std::min(a[1], b[1]) <= p[1] &&
    p[1] <= std::max(a[1], b[1]);
}

/// Whether two segments have a point in common.
bool DoMeet(const PlanePosition& a, const PlanePosition& b, const PlanePosition& c, const PlanePosition& d)
{
  const double turns[4] = { Turn(a, b, c), Turn(a, b, d), Turn(c, d, a), Turn(c, d, b) };
  const auto differ = [](double one, double other) { return (one > 0.0 && other < 0.0) || (one < 0.0 && other > 0.0); };
  return (differ(turns[0], turns[1]) && differ(turns[2], turns[3])) || (turns[0] == 0.0 && IsBetween(c, a, b)) ||
    (turns[1] == 0.0 && IsBetween(d, a, b)) || (turns[2] == 0.0 && IsBetween(a, c, d)) ||
    (turns[3] == 0.0 && IsBetween(b, c, d));
}

/// Whether an edge from b to c runs back on the one from a to b.
bool DoesFold(const PlanePosition& a, const PlanePosition& b, const PlanePosition& c)
{
  const double ahead = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]);
  return Turn(a, b, c) == 0.0 && ahead < 0.0;
}

/// Whether corners are those of a rectangle whose edges run along x and y in turn.
bool IsAlongAxes(const std::vector<PlanePosition>& corners)
{
  if (corners.size() != 4)
  {
    return false;
  }
  const int first = corners[0][0] == corners[1][0] ? 1 : 0; // the axis that edge 0 runs along
  for (int k = 0; k < 4; ++k)
  {
    const PlanePosition& a = corners[static_cast<std::size_t>(k)];
    const PlanePosition& b = corners[static_cast<std::size_t>((k + 1) % 4)];
    const int along = (first + k) % 2;
    if (a[along] == b[along] || a[1 - along] != b[1 - along])
    {
      return false;
    }
  }
  return true;
}

/// Half the angle of a circle that lies beyond a straight edge at a distance; 0 if none does.
double HalfAngleBeyond(double distance, double radius)
{
  return distance < radius ? std::acos(std::max(0.0, distance) / radius) : 0.0;
}

std::string WordsOf(const PlanePosition& point)
{
  return "(" + TextOf(point[0]) + ", " + TextOf(point[1]) + ")";
}

}

ObservationWindow ObservationWindow::Rectangle(const PlanePosition& low, const PlanePosition& high)
{
  return Polygon({ low, { high[0], low[1] }, high, { low[0], high[1] } });
}

ObservationWindow ObservationWindow::Polygon(std::vector<PlanePosition> corners)
{
  ObservationWindow window{ Empty() };
  if (corners.size() > 1 && corners.front() == corners.back())
  {
    corners.pop_back();
  }
  window.Corners = std::move(corners);
  window.Measure();
  return window;
}

void ObservationWindow::Measure()
{
  if (this->Corners.empty())
  {
    return;
  }
  this->Low = this->High = this->Corners.front();
  double twice = 0.0;
  for (std::size_t k = 0; k < this->Corners.size(); ++k)
  {
    const PlanePosition& corner = this->Corners[k];
    twice += Turn(this->Corners.front(), corner, this->Corners[(k + 1) % this->Corners.size()]);
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], corner[axis]);
      this->High[axis] = std::max(this->High[axis], corner[axis]);
    }
  }
  if (twice < 0.0)
  {
    std::reverse(this->Corners.begin(), this->Corners.end());
  }
  this->Area = 0.5 * std::abs(twice);
  this->Rectangular = IsAlongAxes(this->Corners);
}

std::string ObservationWindow::WhyInvalid() const
{
  const std::size_t count = this->Corners.size();
  const auto at = [&](std::size_t k) -> const PlanePosition& { return this->Corners[k % count]; };
  if (count < 3)
  {
    return "The window has " + std::to_string(count) + " corners; it must have at least 3.";
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    if (!IsSensible(at(k)[0]) || !IsSensible(at(k)[1]))
    {
      return "A corner of the window is not finite.";
    }
    if (at(k) == at(k + 1))
    {
      return "Two corners of the window in a row are at one place, " + WordsOf(at(k)) + ".";
    }
  }
  const double width = this->High[0] - this->Low[0];
  const double height = this->High[1] - this->Low[1];
  if (!(width > 0.0 && height > 0.0 && this->Area > MinimumArea * width * height))
  {
    return "The window has no area.";
  }
  if (this->Rectangular)
  {
    return "";
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    for (std::size_t m = k + 2; m < count && m - k < count - 1; ++m)
    {
      if (DoMeet(at(k), at(k + 1), at(m), at(m + 1)))
      {
        return "The window's polygon crosses or touches itself: its edges from " + WordsOf(at(k)) + " and from " +
          WordsOf(at(m)) + ".";
      }
    }
    if (DoesFold(at(k), at(k + 1), at(k + 2)))
    {
      return "The window's polygon runs back on itself at " + WordsOf(at(k + 1)) + ".";
    }
  }
  return "";
}

bool ObservationWindow::Contains(const PlanePosition& point) const
{
  const double slack = EdgeTolerance * std::max(this->High[0] - this->Low[0], this->High[1] - this->Low[1]);
  for (int axis = 0; axis < 2; ++axis)
  {
    if (!(point[axis] >= this->Low[axis] - slack && point[axis] <= this->High[axis] + slack))
    {
      return false;
    }
  }
  return this->Rectangular || this->Surrounds(point) || this->DistanceToEdge(point) <= slack;
}

/// Whether a point is within the polygon; it may be either on the edge.
bool ObservationWindow::Surrounds(const PlanePosition& point) const
{
  // Edges to the right of the point, crossed upwards or downwards: an odd number from inside.
  bool inside = false;
  for (std::size_t k = 0; k < this->Corners.size(); ++k)
  {
    const PlanePosition& a = this->Corners[k];
    const PlanePosition& b = this->Corners[(k + 1) % this->Corners.size()];
    if ((a[1] > point[1]) != (b[1] > point[1]))
    {
      inside ^= point[0] < a[0] + (b[0] - a[0]) * (point[1] - a[1]) / (b[1] - a[1]);
    }
  }
  return inside;
}

double ObservationWindow::DistanceToEdge(const PlanePosition& point) const
{
  if (this->Rectangular)
  {
    const double across = std::min(point[0] - this->Low[0], this->High[0] - point[0]);
    const double along = std::min(point[1] - this->Low[1], this->High[1] - point[1]);
    return std::max(0.0, std::min(across, along));
  }
  double least = SquaredDistance(point, this->Corners.back(), this->Corners.front());
  for (std::size_t k = 1; k < this->Corners.size(); ++k)
  {
    least = std::min(least, SquaredDistance(point, this->Corners[k - 1], this->Corners[k]));
  }
  return std::sqrt(least);
}

double ObservationWindow::CircleInside(const PlanePosition& center, double radius) const
{
  if (this->Rectangular)
  {
    // Angles beyond each edge, less what is beyond both edges of a corner.
    const double angles[4] = { HalfAngleBeyond(center[0] - this->Low[0], radius),
      HalfAngleBeyond(center[1] - this->Low[1], radius), HalfAngleBeyond(this->High[0] - center[0], radius),
      HalfAngleBeyond(this->High[1] - center[1], radius) };
    double beyond = 0.0;
    for (int k = 0; k < 4; ++k)
    {
      beyond += 2.0 * angles[k] - std::max(0.0, angles[k] + angles[(k + 1) % 4] - 0.5 * Pi);
    }
    return std::max(0.0, 1.0 - beyond / (2.0 * Pi));
  }
  // Where the circle meets the edges, as angles: |a + t (b - a) - c| = r.
  std::vector<double> angles;
  for (std::size_t k = 0; k < this->Corners.size(); ++k)
  {
    const PlanePosition& a = this->Corners[k];
    const PlanePosition& b = this->Corners[(k + 1) % this->Corners.size()];
    const double dx = b[0] - a[0];
    const double dy = b[1] - a[1];
    const double square = SquaredLength(dx, dy);
    const double half = (a[0] - center[0]) * dx + (a[1] - center[1]) * dy;
    const double rest = SquaredLength(a[0] - center[0], a[1] - center[1]) - radius * radius;
    const double root = half * half - square * rest;
    if (root <= 0.0)
    {
      continue;
    }
    for (const double sign : { -1.0, 1.0 })
    {
      const double t = (-half + sign * std::sqrt(root)) / square;
      if (t >= 0.0 && t <= 1.0)
      {
        angles.push_back(std::atan2(a[1] + t * dy - center[1], a[0] + t * dx - center[0]));
      }
    }
  }
  const auto isInside = [&](double angle) {
    return this->Surrounds({ center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle) });
  };
  if (angles.empty())
  {
    return isInside(0.0) ? 1.0 : 0.0;
  }
  // Each arc between them lies in the window as its middle does.
  std::sort(angles.begin(), angles.end());
  angles.push_back(angles.front() + 2.0 * Pi);
  double inside = 0.0;
  for (std::size_t k = 0; k + 1 < angles.size(); ++k)
  {
    const double length = angles[k + 1] - angles[k];
    inside += length > 0.0 && isInside(angles[k] + 0.5 * length) ? length : 0.0;
  }
  return inside / (2.0 * Pi);
}

double ObservationWindow::CommonArea(double dx, double dy) const
{
  if (this->Rectangular)
  {
    return std::max(0.0, this->High[0] - this->Low[0] - std::abs(dx)) *
      std::max(0.0, this->High[1] - this->Low[1] - std::abs(dy));
  }
  return CommonAreaOfRows(*this, dx, dy);
}

std::string WhyInvalid(
  const std::vector<PlanePosition>& points, const ObservationWindow& window, std::size_t minimum, bool mayCoincide)
{
  if (points.size() < minimum)
  {
    return "The pattern has " + std::to_string(points.size()) + " points; it must have at least " +
      std::to_string(minimum) + ".";
  }
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    if (!window.Contains(points[n]))
    {
      return "Point " + std::to_string(n) + ", at " + WordsOf(points[n]) + ", is outside the window.";
    }
  }
  if (mayCoincide)
  {
    return "";
  }
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  for (std::size_t n = 1; n < order.size(); ++n)
  {
    if (points[order[n - 1]] == points[order[n]])
    {
      return "Points " + std::to_string(order[n - 1]) + " and " + std::to_string(order[n]) + " are at one place, " +
        WordsOf(points[order[n]]) + ".";
    }
  }
  return "";
}

}
