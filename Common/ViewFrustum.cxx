// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFrustum.h"

#include "Constants.h"

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
  const double tangentY = std::tan(0.5 * view.Angle);
  const double tangentX = tangentY * view.AspectRatio;
  const auto add = [&](const Vector3& normal, double distance) {
    const Vector3 unit = glm::normalize(normal);
    this->Planes.push_back({ unit, -glm::dot(unit, view.Point) - distance });
  };
  add(tangentX * ahead + right, 0.0);
  add(tangentX * ahead - right, 0.0);
  add(tangentY * ahead + up, 0.0);
  add(tangentY * ahead - up, 0.0);
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
