// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFrustum.h"

#include "Constants.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

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

/// More than this cannot be told apart by rounding the components of a unit vector.
constexpr double LargestAngleStep = 0.25;

}

bool AreTheSame(const View& a, const View& b)
{
  return a.Point == b.Point && a.Direction == b.Direction && a.Up == b.Up && a.Angle == b.Angle &&
    a.AspectRatio == b.AspectRatio && a.Height == b.Height;
}

View Rounded(const View& view, double lengthStep, double angleStep)
{
  View rounded = view;
  rounded.Point = RoundedTo(view.Point, lengthStep);
  rounded.Margin += 0.5 * std::sqrt(3.0) * lengthStep;
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
  std::ostringstream text;
  if (!IsFinite(view.Point))
  {
    return "ViewPoint must be finite.";
  }
  if (!IsDirection(view.Direction))
  {
    return "ViewDirection must be finite and not zero.";
  }
  if (!IsDirection(view.Up))
  {
    return "ViewUp must be finite and not zero.";
  }
  if (glm::length(glm::cross(glm::normalize(view.Direction), glm::normalize(view.Up))) < SmallestSine)
  {
    return "ViewUp lies along ViewDirection.";
  }
  if (!(view.Angle > 0.0 && view.Angle < Pi))
  {
    text << "ViewAngle is " << view.Angle * 180.0 / Pi << " degrees; it must be above 0 and below 180.";
  }
  else if (!(view.AspectRatio > 0.0 && std::isfinite(view.AspectRatio)))
  {
    text << "AspectRatio is " << view.AspectRatio << "; it must be finite and positive.";
  }
  else if (!(view.Height > 0.0 && std::isfinite(view.Height)))
  {
    text << "ViewHeight is " << view.Height << "; it must be finite and positive.";
  }
  else if (!(view.Near >= 0.0 && view.Far > view.Near))
  {
    text << "The near and far planes are at " << view.Near << " and " << view.Far
         << "; near must not be negative, and far must be beyond it.";
  }
  return text.str();
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

ViewFrustum::ViewFrustum(const View& view)
  : Seen(view)
{
  const Vector3 ahead = glm::normalize(view.Direction);
  const Vector3 right = glm::normalize(glm::cross(ahead, glm::normalize(view.Up)));
  const Vector3 up = glm::cross(right, ahead);
  const double halfHeight = 0.5 * view.Angle;
  const double halfWidth = std::atan(std::tan(halfHeight) * view.AspectRatio);
  const auto add = [&](const Vector3& normal, double distance) {
    this->Planes.push_back({ normal, view.Margin - glm::dot(normal, view.Point) - distance });
  };
  // A side turns about an axis of the picture. That moves its far corners less, the more the wider the picture is.
  const auto addSides = [&](double halfAngle, double otherHalf, const Vector3& across) {
    const double angle = halfAngle + view.AngleMargin / std::cos(otherHalf);
    if (angle < 0.5 * Pi)
    {
      add(std::sin(angle) * ahead + std::cos(angle) * across, 0.0);
      add(std::sin(angle) * ahead - std::cos(angle) * across, 0.0);
    }
  };
  addSides(halfWidth, halfHeight, right);
  addSides(halfHeight, halfWidth, up);
  if (view.AngleMargin > 0.0)
  {
    return;
  }
  add(ahead, view.Near);
  if (std::isfinite(view.Far))
  {
    add(-ahead, -view.Far);
  }
}

bool ViewFrustum::Contains(const Vector3& point) const
{
  return this->MayShow(point, 0.0);
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

bool ViewFrustum::MayShow(const Vector3& centre, double radius) const
{
  return std::all_of(this->Planes.begin(), this->Planes.end(),
    [&](const Plane& plane) { return glm::dot(plane.Normal, centre) + plane.Offset >= -radius; });
}

double ViewFrustum::PixelsOf(double length, double distance) const
{
  return length == 0.0 ? 0.0 : length * this->Seen.Height / (2.0 * distance * std::tan(0.5 * this->Seen.Angle));
}

}
