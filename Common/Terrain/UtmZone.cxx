// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/UtmZone.h"

#include <cmath>

namespace littoral
{

UtmZone UtmZoneOf(double longitude, double latitude)
{
  if (!std::isfinite(longitude) || !(latitude >= -80.0 && latitude <= 84.0))
  {
    return {};
  }
  // lambda in [-180, 180); zone = floor((lambda + 180) / 6) + 1
  const double turned = longitude - 360.0 * std::floor((longitude + 180.0) / 360.0);
  int number = static_cast<int>(std::floor((turned + 180.0) / 6.0)) % 60 + 1;
  if (latitude >= 56.0 && latitude < 64.0 && turned >= 3.0 && turned < 12.0)
  {
    number = 32; // southern Norway
  }
  else if (latitude >= 72.0 && turned >= 0.0 && turned < 42.0)
  {
    number = turned < 9.0 ? 31 : turned < 21.0 ? 33 : turned < 33.0 ? 35 : 37; // Svalbard
  }
  return { number, latitude >= 0.0 };
}

}
