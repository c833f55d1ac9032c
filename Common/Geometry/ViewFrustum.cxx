// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/ViewFrustum.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// Two directions closer than this (sine of the angle) span no plane.
constexpr double SmallestSine = 1e-9;

bool IsDirection(const Vector3& a)
{
  const double length = glm::length(a);
  return IsFinite(a) && std::isfinite(length) && length > 1e-150;
}

/// Components rounded to multiples of a step; as they are for a step of 0.
Vector3 RoundedTo(const Vector3& a, double step)
{
  return step > 0.0 ? step * glm::round(a / step) : a;
}

/// z x p with the vertical z: |a x (z x p)| is the shift of a place p on the screen by a rise of 1 m, times its squared
/// depth, for a view along a.
Vector3 Swept(const Vector3& place)
{
  return { -place.y, place.x, 0.0 };
}

Vector3 CornerOf(const Box& box, int index)
{
  return { index & 1 ? box.High.x : box.Low.x, index & 2 ? box.High.y : box.Low.y, index & 4 ? box.High.z : box.Low.z };
}

/// More than this cannot be told apart by rounding the components of a unit vector.
constexpr double LargestAngleStep = 0.25;

}

bool AreTheSame(const View& a, const View& b)
{
  return a.Point == b.Point && a.Direction == b.Direction && a.Up == b.Up && a.Angle == b.Angle &&
    a.AspectRatio == b.AspectRatio && a.Height == b.Height && a.IsParallel == b.IsParallel &&
    a.DetailFactor == b.DetailFactor && (!a.IsParallel || a.ParallelScale == b.ParallelScale);
}

View Rounded(const View& view, double lengthStep, double angleStep)
{
  View rounded = view;
  const double length = lengthStep / view.DetailFactor;
  rounded.Point = RoundedTo(view.Point, length);
  rounded.Margin += 0.5 * std::sqrt(3.0) * length;
  const double step = std::min(angleStep, LargestAngleStep);
  rounded.Direction = RoundedTo(glm::normalize(view.Direction), step);
  // Only the part of Up across the direction counts, so that is what is rounded.
  const Vector3 up = glm::normalize(glm::cross(glm::cross(view.Direction, view.Up), view.Direction));
  rounded.Up = RoundedTo(up, step);
  // Each of the two unit vectors turns by at most half the diagonal of a cell of the grid, a little more as an angle.
  rounded.AngleMargin += 2.0 * step;
  return rounded;
}

std::string WhyInvalid(const View& view)
{
  ParameterCheck check;
  check.Require(IsFinite(view.Point), "ViewPoint must be finite.");
  check.Require(IsDirection(view.Direction), "ViewDirection must be finite and not zero.");
  check.Require(IsDirection(view.Up), "ViewUp must be finite and not zero.");
  check.Require(
    !check.IsGood() || glm::length(glm::cross(glm::normalize(view.Direction), glm::normalize(view.Up))) >= SmallestSine,
    "ViewUp lies along ViewDirection.");
  check.Within("ViewAngle", view.Angle * 180.0 / Pi, ValueInterval::Between(0.0, 180.0), "degrees");
  check.Positive("AspectRatio", view.AspectRatio);
  check.Positive("ViewHeight", view.Height, "pixels");
  check.Positive("DetailFactor", view.DetailFactor, "", 1.0);
  if (view.IsParallel)
  {
    check.Positive("ParallelScale", view.ParallelScale);
  }
  check.Require(view.Near >= 0.0 && view.Far > view.Near,
    "The near and far planes are at " + TextOf(view.Near) + " and " + TextOf(view.Far) +
      "; near must not be negative, and far must be beyond it.");
  return check.Reason();
}

double LevelDistance(const View& view, const Vector3& place)
{
  const double distance =
    view.IsParallel ? view.ParallelScale / std::tan(0.5 * view.Angle) : glm::distance(place, view.Point);
  return distance / view.DetailFactor;
}

double SightDistance(const View& view, const Vector3& place)
{
  return view.IsParallel ? std::max(0.0, glm::dot(glm::normalize(view.Direction), place - view.Point))
                         : glm::distance(place, view.Point);
}

double Distance(const Box& box, const Vector3& point)
{
  Vector3 away;
  for (int axis = 0; axis < 3; ++axis)
  {
    away[axis] = std::max({ box.Low[axis] - point[axis], 0.0, point[axis] - box.High[axis] });
  }
  return glm::length(away);
}

double SightDistance(const View& view, const Box& box)
{
  if (!view.IsParallel)
  {
    return Distance(box, view.Point);
  }
  double least = std::numeric_limits<double>::infinity();
  for (int index = 0; index < 8; ++index)
  {
    least = std::min(least, SightDistance(view, CornerOf(box, index)));
  }
  return least;
}

double FarthestSight(const View& view, const Box& box)
{
  double most = 0.0;
  for (int index = 0; index < 8; ++index)
  {
    most = std::max(most, SightDistance(view, CornerOf(box, index)));
  }
  return most;
}

Distances LevelDistances(const View& view, const Box& box)
{
  if (view.IsParallel)
  {
    const double all = LevelDistance(view, box.Low);
    return { all, all };
  }
  return { Distance(box, view.Point) / view.DetailFactor, FarthestSight(view, box) / view.DetailFactor };
}

ViewFrustum::ViewFrustum(const View& view)
  : Seen(view)
  , Ahead(glm::normalize(view.Direction))
  , Right(glm::normalize(glm::cross(this->Ahead, glm::normalize(view.Up))))
  , Up(glm::cross(this->Right, this->Ahead))
{
  this->Tangents[1] = std::tan(0.5 * view.Angle);
  this->Tangents[0] = this->Tangents[1] * view.AspectRatio;
  view.IsParallel ? this->AddParallelSides() : this->AddPerspectiveSides();
}

void ViewFrustum::AddPlane(const Vector3& normal, double distance)
{
  const double margin = this->Seen.Margin;
  this->Planes.push_back({ normal, margin - glm::dot(normal, this->Seen.Point) - distance });
}

void ViewFrustum::AddPerspectiveSides()
{
  const View& view = this->Seen;
  const auto addSides = [&](int axis, const Vector3& across) {
    // A turn by d moves an edge ray at an angle o out of the plane of the axes by as much as one in it by e,
    // sin e = sin d / cos o, tan o = tan(half the other angle) cos(half angle).
    const double halfAngle = std::atan(this->Tangents[axis]);
    const double tangent = this->Tangents[1 - axis] * std::cos(halfAngle);
    const double sine = std::sin(std::min(view.AngleMargin, 0.5 * Pi)) * std::hypot(1.0, tangent);
    const double angle = halfAngle + std::asin(std::min(1.0, sine));
    if (angle < 0.5 * Pi)
    {
      this->AddPlane(std::sin(angle) * this->Ahead + std::cos(angle) * across, 0.0);
      this->AddPlane(std::sin(angle) * this->Ahead - std::cos(angle) * across, 0.0);
    }
  };
  addSides(0, this->Right);
  addSides(1, this->Up);
  if (view.AngleMargin > 0.0)
  {
    return;
  }
  this->AddPlane(this->Ahead, view.Near);
  if (std::isfinite(view.Far))
  {
    this->AddPlane(-this->Ahead, -view.Far);
  }
}

void ViewFrustum::AddParallelSides()
{
  // A turn by d moves the foot of a ray, at most half the width and height from the view point, out of its plane by the
  // sine of d times that, and the ray itself out of a side by d.
  const View& view = this->Seen;
  const double turn = std::min(view.AngleMargin, 0.5 * Pi);
  const double half[2] = { view.AspectRatio * view.ParallelScale, view.ParallelScale };
  const auto addSides = [&](int axis, const Vector3& across) {
    const double reach = half[axis] + std::sin(turn) * half[1 - axis];
    this->AddPlane(std::sin(turn) * this->Ahead + std::cos(turn) * across, -reach);
    this->AddPlane(std::sin(turn) * this->Ahead - std::cos(turn) * across, -reach);
  };
  addSides(0, this->Right);
  addSides(1, this->Up);
  this->AddPlane(this->Ahead, std::cos(turn) * view.Near - std::sin(turn) * std::hypot(half[0], half[1]));
  if (std::isfinite(view.Far) && view.AngleMargin == 0.0)
  {
    this->AddPlane(-this->Ahead, -view.Far);
  }
}

bool ViewFrustum::MayShow(const Box& box) const
{
  return std::all_of(this->Planes.begin(), this->Planes.end(), [&](const Plane& plane) {
    Vector3 corner; // the one that is farthest inside
    for (int axis = 0; axis < 3; ++axis)
    {
      corner[axis] = plane.Normal[axis] > 0.0 ? box.High[axis] : box.Low[axis];
    }
    return glm::dot(plane.Normal, corner) + plane.Offset >= 0.0;
  });
}

bool ViewFrustum::Holds(const Box& box, double distance) const
{
  return std::all_of(this->Planes.begin(), this->Planes.end(), [&](const Plane& plane) {
    Vector3 corner; // the one that is least inside
    for (int axis = 0; axis < 3; ++axis)
    {
      corner[axis] = plane.Normal[axis] > 0.0 ? box.Low[axis] : box.High[axis];
    }
    return glm::dot(plane.Normal, corner) + plane.Offset >= distance;
  });
}

bool ViewFrustum::MayShow(const Vector3& center, double radius) const
{
  return std::all_of(this->Planes.begin(), this->Planes.end(),
    [&](const Plane& plane) { return glm::dot(plane.Normal, center) + plane.Offset >= -radius; });
}

double ViewFrustum::PixelsOfRise(double rise, const Box& box) const
{
  if (rise == 0.0)
  {
    return 0.0;
  }
  const View& view = this->Seen;
  const double turn = 2.0 * std::sin(0.5 * std::min(view.AngleMargin, Pi)); // of the end of a unit vector
  const auto across = [&](const Vector3& place) { return glm::length(glm::cross(this->Ahead, Swept(place))); };
  if (view.IsParallel)
  {
    const double seen = std::min(1.0, std::hypot(this->Ahead.x, this->Ahead.y) + turn);
    return rise * seen * view.Height / (2.0 * view.ParallelScale);
  }
  // |a x (z x p)| / p_d, no more than at a corner of the picture.
  double slope = 0.0;
  const double corner = std::hypot(1.0, this->Tangents[0], this->Tangents[1]);
  for (const double x : { -this->Tangents[0], this->Tangents[0] })
  {
    for (const double y : { -this->Tangents[1], this->Tangents[1] })
    {
      slope = std::max(slope, across(this->Ahead + x * this->Right + y * this->Up) + turn * corner);
    }
  }
  // p_d, no less than at a corner of the box; |a x (z x p)|, no more.
  double depth = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (int index = 0; index < 8; ++index)
  {
    const Vector3 place = CornerOf(box, index) - view.Point;
    const double aside = glm::length(glm::cross(this->Ahead, place));
    const double own = std::cos(view.AngleMargin) * glm::dot(this->Ahead, place) - std::sin(view.AngleMargin) * aside;
    depth = std::min(depth, own - view.Margin);
    largest = std::max(largest, across(place) + turn * glm::length(Swept(place)) + view.Margin);
  }
  // What is on the picture is no less deep than the distance times the cosine of the angle of a corner.
  const double shown = std::max(0.0, Distance(box, view.Point) - view.Margin) / corner - rise;
  depth = std::max(depth, shown);
  if (!(depth > 0.0))
  {
    return std::numeric_limits<double>::infinity();
  }
  slope = std::min(slope, largest / depth);
  return rise * slope / depth * view.Height / (2.0 * this->Tangents[1]);
}

}
