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
  double YoungModulus = 5.1e9; ///< along the grain, of a trunk's section with its bark [Pa]
  double Density = 950.0;      ///< with its sap [kg/m3]
  double DampingRatio = 0.08;  ///< of critical, of wood, leaves and air together
};

/// Young's modulus of branches as part of the trunk's: with their bark, trunks had 2.4 to 7.5 GPa and branches 0.7 to
/// 4.6 GPa (spruce, pine, larch and birch; Cannell and Morgan 1987); by the middles of these, half.
inline constexpr double BranchModulus = 0.5;

/// Kinds of wood with numbers of their own.
enum class WoodSpecies
{
  Custom = 0,
  Pine = 1,
  Oak = 2,
  Birch = 3,
  Shrub = 4,
};

inline constexpr int NumberOfWoodSpecies = 5;

/**
 * Moduli are those of living wood in the Stuttgart catalogue of strengths (Wessolly and Erb 1998): Pinus
 * sylvestris 5.8, Quercus robur 6.9, Betula pendula 7.05 GPa, times 0.85 squared, since 15 % of a stem's volume is
 * bark, which bears next to nothing (volume tables have 10 to 20 %). Densities are those of green wood: specific
 * gravity times one and the moisture of the Wood Handbook (Forest Products Laboratory 2010, tables 4-1 and 5-3) for
 * white oak and paper birch, and that of HWIND (Peltola et al. 1999) for Scots pine. A shrub, and what is not known, is
 * taken as hardwood of the middle. The damping ratio is the lowest that was measured in unpruned Douglas firs, which
 * reach up to near critical (Moore and Maguire 2004); wood alone has less than 0.05, and most of it is the leaves'
 * drag.
 */
WoodParameters ParametersOf(WoodSpecies species);

/**
 * Wood of a tree that is s times as high as thick at breast height. Young's modulus grows with slenderness (Watt et al.
 * 2006): E = E_0 clamp((s / 90)^0.8, 0.57, 1.47), from the softest to the stiffest trunks of Cannell and Morgan (1987);
 * the power and the 90 bring stout and slender trees to the measured frequencies. Shrubs, and what is not known, have
 * E_0.
 */
WoodParameters ParametersOf(WoodSpecies species, double slenderness);

/// Why there is no such wood, with the name of the parameter; empty when there is.
std::string WhyInvalid(const WoodParameters& wood);

}

#endif
