// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLimbModes_h
#define LittoralLimbModes_h

#include "Plants/Skeleton.h"

#include <array>
#include <vector>

namespace littoral
{

/// Stiffness of round wood in twisting as part of that in bending, G J / (E I) = 2 G / E: G is 0.08 of E, as for pines,
/// oaks and birches in table 5-1 of the Wood Handbook.
inline constexpr double TwistPart = 0.16;

/// Deflections in which a limb gives way: one for each order of its branches, the last for all higher ones too.
inline constexpr int LimbShapes = 4;

/// Inertia of what a limb bears of one material.
struct LimbBurden
{
  std::array<double, LimbShapes * LimbShapes> Mass{}; ///< products of the deflections over the mass
  std::array<double, LimbShapes> Shift{};             ///< and of them and a shift of the foot across the trunk
  std::array<double, LimbShapes> Turn{};              ///< and of them and a turn of the foot by 1
};

/**
 * A branch on the trunk with all that grows on it, in the deflections by which it answers to being shaken: those of its
 * branches of each order under the inertia of all that they bear, clamped in the trunk, when this carries them along.
 * Bending and twisting in three dimensions, as a mean over the directions across the trunk's axis. The strain energy of
 * a deflection is half of Young's modulus times 1 m, and they share none.
 */
struct LimbMeasures
{
  double Part = 0.0; ///< of the trunk's length where it grows
  LimbBurden Wood;   ///< [m3 and so on]
  LimbBurden Leaves; ///< [m2 and so on]
};

/// Measures the limbs of a valid skeleton. Areas of leaves [m2] are those on each node; or empty.
std::vector<LimbMeasures> MeasureLimbs(const Skeleton& skeleton, const std::vector<double>& leafAreas);

}

#endif
