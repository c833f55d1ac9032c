// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSunPosition_h
#define LittoralSunPosition_h

#include "Numerics/Vector3.h"

#include <string>

namespace littoral
{

/// A moment of Universal Time in the Gregorian calendar.
struct UniversalTime
{
  int Year = 2026;
  int Month = 6;      ///< 1 to 12
  int Day = 21;       ///< 1 to 31
  double Hours = 9.0; ///< since midnight, also below 0 and above 24
};

/// Reason why a moment is none; empty if it is one.
std::string WhyInvalid(const UniversalTime& time);

/// Place of the center of the sun's disk in the sky.
struct SunAngles
{
  double Elevation; ///< above the horizon [degrees]
  double Azimuth;   ///< clockwise from north, 0 to 360 [degrees]
};

/// Unit vector towards a place in the sky; x to the east, y to the north, z up.
Vector3 DirectionOf(const SunAngles& sun);

/// The angles of a direction.
SunAngles AnglesOf(const Vector3& direction);

/**
 * The sun as it is seen from a latitude [degrees north] and a longitude [degrees east], lifted by refraction in an
 * atmosphere of 1010 hPa and 283 K. The formulas of low accuracy of Meeus, Astronomical Algorithms, chapters 12, 13, 16
 * and 25, between the years 1800 and 2200 within 0.01 degrees.
 */
SunAngles SunAt(const UniversalTime& time, double latitude, double longitude);

}

#endif
