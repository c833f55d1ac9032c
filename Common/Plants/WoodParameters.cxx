// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/WoodParameters.h"

#include "Numerics/ParameterCheck.h"

#include <iterator>

namespace littoral
{

namespace
{

/// Second moment of area of a stem without its bark over that with it: bark is 15 % of its volume and bears next to
/// nothing.
constexpr double StiffPart = 0.85 * 0.85;

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

std::string WhyInvalid(const WoodParameters& wood)
{
  ParameterCheck check;
  check.Range("YoungModulus", wood.YoungModulus, 1e5, 1e12, "Pa");
  check.Range("WoodDensity", wood.Density, 1.0, 1e5, "kg/m3");
  check.Range("DampingRatio", wood.DampingRatio, 0.001, 0.95);
  return check.Reason();
}

}
