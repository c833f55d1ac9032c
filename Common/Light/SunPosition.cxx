// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/SunPosition.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double DynamicalLessUniversal = 69.0; // about the years 2000 to 2030 [s]

/// Days since noon of 2000-01-01, the epoch J2000.
double DaysOf(const UniversalTime& time)
{
  // Days of the Gregorian calendar, January and February as months 13 and 14 of the year before
  const bool isEarly = time.Month <= 2;
  const int year = time.Year - (isEarly ? 1 : 0);
  const int month = time.Month + (isEarly ? 12 : 0);
  const double century = std::floor(year / 100.0);
  const double leap = 2.0 - century + std::floor(century / 4.0);
  const double julianDay =
    std::floor(365.25 * (year + 4716)) + std::floor(30.6001 * (month + 1)) + time.Day + leap - 1524.5;
  return julianDay - 2451545.0 + time.Hours / 24.0;
}

/// Place on the celestial sphere.
struct Equatorial
{
  double RightAscension; // [degrees]
  double Declination;    // [degrees]
};

/// The apparent sun, seen from the center of the earth, T centuries after J2000.
Equatorial ApparentSun(double T)
{
  // Mean longitude L0 and mean anomaly M
  const double L0 = 280.46646 + T * (36000.76983 + T * 0.0003032);
  const double M = (357.52911 + T * (35999.05029 - T * 0.0001537)) * Degree;
  // Equation of the center C
  const double C = (1.914602 - T * (0.004817 + T * 0.000014)) * std::sin(M) +
    (0.019993 - 0.000101 * T) * std::sin(2.0 * M) + 0.000289 * std::sin(3.0 * M);
  // Longitude with aberration, and nutation by the node of the moon's orbit
  const double node = (125.04 - 1934.136 * T) * Degree;
  const double longitude = (L0 + C - 0.00569 - 0.00478 * std::sin(node)) * Degree;
  const double obliquity = (23.439291 - 0.0130042 * T + 0.00256 * std::cos(node)) * Degree;
  return { std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude)) / Degree,
    std::asin(std::sin(obliquity) * std::sin(longitude)) / Degree };
}

/// Apparent sidereal time at Greenwich [degrees].
double SiderealTime(double days)
{
  const double T = days / 36525.0;
  const double node = (125.04 - 1934.136 * T) * Degree;
  const double mean = 280.46061837 + 360.98564736629 * days + T * T * 0.000387933;
  return mean - 0.00478 * std::sin(node) * std::cos(23.44 * Degree);
}

/// Refraction lifts a true elevation by this much [degrees], R = 1.02' / tan(h + 10.3 / (h + 5.11)) (Saemundsson).
double Refraction(double elevation)
{
  const double h = std::max(elevation, -1.0);
  const double lift = 1.02 / 60.0 / std::tan((h + 10.3 / (h + 5.11)) * Degree);
  return elevation < -1.0 ? lift * std::max(0.0, 2.0 + elevation) : lift; // none is seen below the horizon
}

}

std::string WhyInvalid(const UniversalTime& time)
{
  ParameterCheck check;
  check.Count("Year", time.Year, 1600, 2400);
  check.Count("Month", time.Month, 1, 12);
  check.Count("Day", time.Day, 1, 31);
  check.Range("Hours", time.Hours, -24.0, 48.0, "h");
  return check.Reason();
}

Vector3 DirectionOf(const SunAngles& sun)
{
  const double up = sun.Elevation * Degree;
  const double around = sun.Azimuth * Degree;
  return { std::cos(up) * std::sin(around), std::cos(up) * std::cos(around), std::sin(up) };
}

SunAngles AnglesOf(const Vector3& direction)
{
  const double around = std::atan2(direction.x, direction.y) / Degree;
  return { std::atan2(direction.z, std::hypot(direction.x, direction.y)) / Degree,
    around < 0.0 ? around + 360.0 : around };
}

SunAngles SunAt(const UniversalTime& time, double latitude, double longitude)
{
  const double days = DaysOf(time);
  const Equatorial sun = ApparentSun((days + DynamicalLessUniversal / 86400.0) / 36525.0);
  // Hour angle H and declination delta, turned to the horizon of the latitude phi
  const double H = (SiderealTime(days) + longitude - sun.RightAscension) * Degree;
  const double delta = sun.Declination * Degree;
  const double phi = latitude * Degree;
  const Vector3 direction{ -std::cos(delta) * std::sin(H),
    std::cos(phi) * std::sin(delta) - std::sin(phi) * std::cos(delta) * std::cos(H),
    std::sin(phi) * std::sin(delta) + std::cos(phi) * std::cos(delta) * std::cos(H) };
  SunAngles seen = AnglesOf(direction);
  seen.Elevation += Refraction(seen.Elevation);
  return seen;
}

}
