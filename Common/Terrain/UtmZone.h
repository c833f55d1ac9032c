// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralUtmZone_h
#define LittoralUtmZone_h

namespace littoral
{

/// A zone of the Universal Transverse Mercator system; number 0 is none.
struct UtmZone
{
  int Number = 0; ///< 1 to 60
  bool IsNorth = true;
};

/**
 * Zone of a place, longitude and latitude in degrees. Zones are 6 degrees wide and begin at 180 degrees west; those of
 * southern Norway and Svalbard are wider or narrower. None beyond 84 degrees north and 80 degrees south, and for
 * numbers that are not finite.
 */
UtmZone UtmZoneOf(double longitude, double latitude);

}

#endif
