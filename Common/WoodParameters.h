// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWoodParameters_h
#define LittoralWoodParameters_h

#include <string>

namespace littoral
{

/// Living wood as a beam.
struct WoodParameters
{
  double YoungModulus = 9e9;  ///< along the grain [Pa]
  double Density = 900.0;     ///< with its sap [kg/m3]
  double DampingRatio = 0.08; ///< of critical, of wood, leaves and air together
};

/// Kinds of wood with numbers of their own.
enum class WoodSpecies
{
  Custom = 0,
  Pine = 1,
  Oak = 2,
  Birch = 3,
  Shrub = 4,
};

/**
 * Moduli and densities of green wood follow the tables of the Wood Handbook (Forest Products Laboratory, 2010, chapters
 * 4 and 5): loblolly pine, white oak, paper birch; a shrub is taken as hardwood of middling stiffness. The damping
 * ratio is a middle value: wood alone has less than 0.05 (Moore and Maguire 2004), trees in leaf from 0.08 upwards
 * (Moore and Maguire 2005), most of it the leaves' drag.
 */
WoodParameters ParametersOf(WoodSpecies species);

/// Why there is no such wood, with the name of the parameter; empty when there is.
std::string WhyInvalid(const WoodParameters& wood);

}

#endif
