// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/EarthGrid.h"

#include "Numerics/Constants.h"
#include "Numerics/Vector3.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

constexpr double Radians = Pi / 180.0; ///< of a degree
constexpr double SemiMajor = 6378137.0;
constexpr double Flattening = 1.0 / 298.257223563;

Vector3 DirectionOf(const EarthPlace& place)
{
  const double longitude = place[0] * Radians;
  const double latitude = place[1] * Radians;
  return { std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude) };
}

EarthPlace PlaceOf(const Vector3& direction)
{
  return { std::atan2(direction.y, direction.x) / Radians,
    std::atan2(direction.z, std::hypot(direction.x, direction.y)) / Radians };
}

}

EarthPlace RotatedPole::ToEarth(const EarthPlace& place) const
{
  // in the grid's frame with the true pole on the meridian of x, at the latitude of the grid's pole
  const Vector3 grid = DirectionOf({ place[0] - this->GridLongitude, place[1] });
  const double sine = std::sin(this->Latitude * Radians);
  const double cosine = std::cos(this->Latitude * Radians);
  // z along the true pole (cos, 0, sin), x across it, away from the grid's pole
  const Vector3 earth(sine * grid.x - cosine * grid.z, grid.y, cosine * grid.x + sine * grid.z);
  const EarthPlace turned = PlaceOf(earth);
  return { std::remainder(turned[0] + this->Longitude + 180.0, 360.0), turned[1] };
}

std::array<double, 2> MetresPerRadian(double latitude)
{
  constexpr double e2 = Flattening * (2.0 - Flattening);
  const double sine = std::sin(latitude * Radians);
  const double w2 = 1.0 - e2 * sine * sine;
  // N cos(phi) and M, N = a/w, M = a (1 - e^2)/w^3
  return { SemiMajor * std::cos(latitude * Radians) / std::sqrt(w2), SemiMajor * (1.0 - e2) / (w2 * std::sqrt(w2)) };
}

void Unwrap(std::vector<double>& longitudes)
{
  for (std::size_t i = 1; i < longitudes.size(); ++i)
  {
    longitudes[i] = longitudes[i - 1] + std::remainder(longitudes[i] - longitudes[i - 1], 360.0);
  }
}

EarthPlace MiddleOf(const std::vector<EarthPlace>& places)
{
  Vector3 sum(0.0);
  for (const EarthPlace& place : places)
  {
    sum += DirectionOf(place);
  }
  const bool isSomewhere = glm::length(sum) > 1e-6 * static_cast<double>(places.size());
  return isSomewhere || places.empty() ? PlaceOf(sum) : places.front();
}

double AngleBetween(const EarthPlace& a, const EarthPlace& b)
{
  const Vector3 u = DirectionOf(a);
  const Vector3 v = DirectionOf(b);
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)) / Radians;
}

}
