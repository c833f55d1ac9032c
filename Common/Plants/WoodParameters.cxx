// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/WoodParameters.h"

#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace littoral
{

namespace
{

/// Second moment of area of a stem without its bark over that with it: bark is 15 % of its volume and bears next to
/// nothing.
constexpr double StiffPart = 0.85 * 0.85;

/// Height over diameter of a tree of E_0, and the power of it that Young's modulus grows with.
constexpr double UsualSlenderness = 90.0;
constexpr double PowerOfSlenderness = 0.8;
/// Bounds of it, from the 2.4 GPa of the softest trunks that were measured to the 7.5 of the stiffest.
constexpr double SoftestPart = 0.57;
constexpr double StiffestPart = 1.47;

/// Rows in the order of the enumeration.
constexpr WoodParameters Rows[] = {
  // Young's modulus, density, damping ratio
  {},                                  // Custom
  { StiffPart * 5.8e9, 850.0, 0.08 },  // Pine
  { StiffPart * 6.9e9, 1020.0, 0.08 }, // Oak
  { StiffPart * 7.05e9, 870.0, 0.08 }, // Birch
  { StiffPart * 7.05e9, 950.0, 0.1 },  // Shrub
};
static_assert(std::size(Rows) == NumberOfWoodSpecies, "a row a species");

}

WoodParameters ParametersOf(WoodSpecies species)
{
  return Rows[static_cast<int>(species)];
}

WoodParameters ParametersOf(WoodSpecies species, double slenderness)
{
  WoodParameters wood = ParametersOf(species);
  if (species == WoodSpecies::Pine || species == WoodSpecies::Oak || species == WoodSpecies::Birch)
  {
    // E = E_0 clamp((s / s_0)^p, SoftestPart, StiffestPart)
    wood.YoungModulus *=
      std::clamp(std::pow(slenderness / UsualSlenderness, PowerOfSlenderness), SoftestPart, StiffestPart);
  }
  return wood;
}

std::string WhyInvalid(const WoodParameters& wood)
{
  ParameterCheck check;
  check.Range("YoungModulus", wood.YoungModulus, 1e5, 1e12, "Pa");
  check.Range("WoodDensity", wood.Density, 1.0, 1e5, "kg/m3");
  check.Range("DampingRatio", wood.DampingRatio, 0.001, 0.95);
  return check.Reason();
}

}
