// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralEarthFrame_h
#define LittoralEarthFrame_h

// Places around the middle of the earth, on the ellipsoid of WGS 84: x to longitude 0, z to the north pole [m].

#include "Geometry/EarthGrid.h"
#include "Numerics/Vector3.h"

#include <array>

namespace littoral
{

/// The place around the middle of the earth of a longitude and a latitude, at a height above the ellipsoid [m].
Vector3 EarthCentred(const EarthPlace& place, double height);

/// Up at a longitude and a latitude, of unit length.
Vector3 UpAt(const EarthPlace& place);

/// Level axes at a place around the middle of the earth, with z up.
struct EarthFrame
{
  Vector3 Origin{ 0.0, 0.0, 0.0 };
  Vector3 X{ 1.0, 0.0, 0.0 };
  Vector3 Y{ 0.0, 1.0, 0.0 };
  Vector3 Up{ 0.0, 0.0, 1.0 };

  EarthFrame() = default;
  /// The frame at an origin with a direction up, of unit length; x is what is level of the way to another place.
  EarthFrame(const Vector3& origin, const Vector3& up, const Vector3& ahead);

  Vector3 ToLocal(const Vector3& place) const;
  Vector3 ToEarth(const Vector3& local) const;
  /// The matrix, column by column, that takes places of this frame into another one.
  std::array<double, 16> MatrixTo(const EarthFrame& other) const;
  /// The matrix that takes them around the middle of the earth.
  std::array<double, 16> Matrix() const { return this->MatrixTo(EarthFrame()); }
};

}

#endif
