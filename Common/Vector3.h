// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVector3_h
#define LittoralVector3_h

#include <array>
#include <cmath>

namespace littoral
{

/// A point or direction of space.
using Vector3 = std::array<double, 3>;

inline Vector3 Add(const Vector3& a, const Vector3& b, double scale = 1.0)
{
  return { a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2] };
}

inline Vector3 Subtract(const Vector3& a, const Vector3& b)
{
  return Add(a, b, -1.0);
}

inline double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Length(const Vector3& a)
{
  return std::sqrt(Dot(a, a));
}

/// The direction of a vector; up for the zero vector.
inline Vector3 Normalised(const Vector3& a)
{
  const double length = Length(a);
  return length > 0.0 ? Vector3{ a[0] / length, a[1] / length, a[2] / length } : Vector3{ 0.0, 0.0, 1.0 };
}

/// A unit vector at a right angle to a unit vector.
inline Vector3 Perpendicular(const Vector3& a)
{
  return Normalised(Cross(a, std::abs(a[0]) < 0.8 ? Vector3{ 1.0, 0.0, 0.0 } : Vector3{ 0.0, 1.0, 0.0 }));
}

}

#endif
