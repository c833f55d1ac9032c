// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/EarthFrame.h"

#include "Numerics/Constants.h"

#include <cmath>

namespace littoral
{

namespace
{

constexpr double SemiMajor = 6378137.0; // [m]
constexpr double Flattening = 1.0 / 298.257223563;

}

Vector3 UpAt(const EarthPlace& place)
{
  const double longitude = place[0] * Pi / 180.0;
  const double latitude = place[1] * Pi / 180.0;
  return { std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude) };
}

Vector3 EarthCentred(const EarthPlace& place, double height)
{
  const Vector3 up = UpAt(place);
  // N = a / sqrt(1 - e^2 sin^2 phi), e^2 = f (2 - f)
  const double squared = Flattening * (2.0 - Flattening);
  const double normal = SemiMajor / std::sqrt(1.0 - squared * up.z * up.z);
  // ((N + h) cos phi cos lambda, (N + h) cos phi sin lambda, ((1 - e^2) N + h) sin phi)
  return { (normal + height) * up.x, (normal + height) * up.y, ((1.0 - squared) * normal + height) * up.z };
}

EarthFrame::EarthFrame(const Vector3& origin, const Vector3& up, const Vector3& ahead)
  : Origin(origin)
  , Up(up)
{
  const Vector3 way = ahead - origin;
  this->X = glm::normalize(way - glm::dot(way, up) * up);
  this->Y = glm::cross(up, this->X);
}

Vector3 EarthFrame::ToLocal(const Vector3& place) const
{
  const Vector3 way = place - this->Origin;
  return { glm::dot(way, this->X), glm::dot(way, this->Y), glm::dot(way, this->Up) };
}

Vector3 EarthFrame::ToEarth(const Vector3& local) const
{
  return this->Origin + local.x * this->X + local.y * this->Y + local.z * this->Up;
}

std::array<double, 16> EarthFrame::MatrixTo(const EarthFrame& other) const
{
  std::array<double, 16> matrix{};
  const Vector3 axes[3] = { this->X, this->Y, this->Up };
  const Vector3 others[3] = { other.X, other.Y, other.Up };
  const Vector3 origin = other.ToLocal(this->Origin);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix[4 * column + row] = glm::dot(axes[column], others[row]);
    }
    matrix[12 + row] = origin[row];
  }
  matrix[15] = 1.0;
  return matrix;
}

}
