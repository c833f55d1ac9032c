// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/WoodParameters.h"

#include "Numerics/ParameterCheck.h"

namespace littoral
{

namespace
{

/// Of the second moment of area of a stem with its bark, which is 15 % of its volume and bears next to nothing.
constexpr double StiffPart = 0.85 * 0.85;

}

WoodParameters ParametersOf(WoodSpecies species)
{
  switch (species)
  {
    case WoodSpecies::Pine:
      return { StiffPart * 5.8e9, 850.0, 0.08 };
    case WoodSpecies::Oak:
      return { StiffPart * 6.9e9, 1020.0, 0.08 };
    case WoodSpecies::Birch:
      return { StiffPart * 7.05e9, 870.0, 0.08 };
    case WoodSpecies::Shrub:
      return { StiffPart * 7.05e9, 950.0, 0.1 };
    case WoodSpecies::Custom:
      break;
  }
  return {};
}

std::string WhyInvalid(const WoodParameters& wood)
{
  ParameterCheck check;
  check.Range("YoungModulus", wood.YoungModulus, 1e5, 1e12, "Pa");
  check.Range("WoodDensity", wood.Density, 1.0, 1e5, "kg/m3");
  check.Range("Damping", wood.DampingRatio, 0.001, 0.95);
  return check.Reason();
}

}
