// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WoodParameters.h"

#include <sstream>

namespace littoral
{

WoodParameters ParametersOf(WoodSpecies species)
{
  switch (species)
  {
    case WoodSpecies::Pine:
      return { 9.7e9, 850.0, 0.08 };
    case WoodSpecies::Oak:
      return { 8.6e9, 1000.0, 0.08 };
    case WoodSpecies::Birch:
      return { 8.1e9, 800.0, 0.08 };
    case WoodSpecies::Shrub:
      return { 7.0e9, 900.0, 0.1 };
    case WoodSpecies::Custom:
      break;
  }
  return {};
}

std::string WhyInvalid(const WoodParameters& wood)
{
  std::ostringstream reason;
  const auto check = [&](const char* name, double value, double low, double high) {
    if (reason.str().empty() && !(value >= low && value <= high))
    {
      reason << name << " is " << value << "; it must be from " << low << " to " << high << ".";
    }
  };
  check("YoungModulus", wood.YoungModulus, 1e5, 1e12);
  check("WoodDensity", wood.Density, 1.0, 1e5);
  check("Damping", wood.DampingRatio, 0.001, 0.95);
  return reason.str();
}

}
