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

using Vector = std::array<double, 3>;

/// Two directions closer than this (sine of the angle) span no plane.
constexpr double SmallestSine = 1e-9;

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double Length(const Vector& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

Vector Unit(const Vector& a)
{
  const double length = Length(a);
  return { a[0] / length, a[1] / length, a[2] / length };
}

/// a x + b y
Vector Combine(double a, const Vector& x, double b, const Vector& y)
{
  return { a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2] };
}

bool IsFinite(const Vector& a)
{
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

bool IsDirection(const Vector& a)
{
  const double length = Length(a);
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
  if (Length(Cross(Unit(view.Direction), Unit(view.Up))) < SmallestSine)
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

double Distance(const Box& box, const Vector& point)
{
  Vector away;
  for (int axis = 0; axis < 3; ++axis)
  {
    away[axis] = std::max({ box.Low[axis] - point[axis], 0.0, point[axis] - box.High[axis] });
  }
  return Length(away);
}

ViewFrustum::ViewFrustum(const View& view)
  : Seen(view)
{
  const Vector ahead = Unit(view.Direction);
  const Vector right = Unit(Cross(ahead, Unit(view.Up)));
  const Vector up = Cross(right, ahead);
  const double tangentY = std::tan(0.5 * view.Angle);
  const double tangentX = tangentY * view.AspectRatio;
  const auto add = [&](const Vector& normal, double distance) {
    const Vector unit = Unit(normal);
    this->Planes.push_back({ unit, -Dot(unit, view.Point) - distance });
  };
  add(Combine(tangentX, ahead, 1.0, right), 0.0);
  add(Combine(tangentX, ahead, -1.0, right), 0.0);
  add(Combine(tangentY, ahead, 1.0, up), 0.0);
  add(Combine(tangentY, ahead, -1.0, up), 0.0);
  add(ahead, view.Near);
  if (std::isfinite(view.Far))
  {
    add(Combine(-1.0, ahead, 0.0, up), -view.Far);
  }
}

bool ViewFrustum::Contains(const Vector& point) const
{
  return this->MayShow(point, 0.0);
}

bool ViewFrustum::MayShow(const Box& box) const
{
  return std::all_of(this->Planes.begin(), this->Planes.end(), [&](const Plane& plane) {
    Vector corner; // the one that is farthest inside
    for (int axis = 0; axis < 3; ++axis)
    {
      corner[axis] = plane.Normal[axis] > 0.0 ? box.High[axis] : box.Low[axis];
    }
    return Dot(plane.Normal, corner) + plane.Offset >= 0.0;
  });
}

bool ViewFrustum::MayShow(const Vector& centre, double radius) const
{
  return std::all_of(this->Planes.begin(), this->Planes.end(),
    [&](const Plane& plane) { return Dot(plane.Normal, centre) + plane.Offset >= -radius; });
}

double ViewFrustum::PixelsOf(double length, double distance) const
{
  return length == 0.0 ? 0.0 : length * this->Seen.Height / (2.0 * distance * std::tan(0.5 * this->Seen.Angle));
}

}
