// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralEarthGrid_h
#define LittoralEarthGrid_h

// Places on earth along the axes of models.

#include <array>
#include <vector>

namespace littoral
{

/// A longitude and a latitude [degrees].
using EarthPlace = std::array<double, 2>;

/// Grid of longitudes and latitudes whose north pole lies elsewhere, CF's rotated_latitude_longitude.
struct RotatedPole
{
  double Longitude = 180.0;   ///< grid_north_pole_longitude [degrees]
  double Latitude = 90.0;     ///< grid_north_pole_latitude [degrees]
  double GridLongitude = 0.0; ///< north_pole_grid_longitude, of the true pole in the grid [degrees]

  /// The place on earth of one on the grid.
  EarthPlace ToEarth(const EarthPlace& place) const;
};

/// Metres per radian on WGS 84 at a latitude [degrees], along a parallel and along the meridian.
std::array<double, 2> MetresPerRadian(double latitude);

/// Longitudes without jumps: each within 180 degrees of the one before it.
void Unwrap(std::vector<double>& longitudes);

/// The middle of places, on the sphere: the mean of their directions; where these cancel out, that of the first one.
EarthPlace MiddleOf(const std::vector<EarthPlace>& places);

/// Angle between two places on the sphere [degrees].
double AngleBetween(const EarthPlace& a, const EarthPlace& b);

}

#endif
