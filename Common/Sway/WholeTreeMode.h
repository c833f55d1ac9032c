// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWholeTreeMode_h
#define LittoralWholeTreeMode_h

#include "Sway/BeamModes.h"
#include "Sway/LimbModes.h"

#include <vector>

namespace littoral
{

/// The first mode of a trunk with rigid limbs.
struct RigidTreeMode
{
  ShapeMixture Mixture{};
  double Length = 1.0;    ///< of the trunk [m]
  double Frequency = 1.0; ///< angular [rad/s]
  double Mass = 1.0;      ///< modal [kg]
  double Load = 1.0;      ///< for an acceleration of all its mass across it [kg]
};

/// Materials of limbs, in the units of their measures.
struct LimbMaterial
{
  double Wood = 900.0;    ///< [kg/m3]
  double Leaves = 0.2;    ///< [kg/m2]
  double Stiffness = 4e9; ///< Young's modulus times 1 m [N/m]
};

/**
 * The angular frequency [rad/s] at which a tree answers most to a push on all its mass. The limbs are oscillators that
 * ride on the trunk's mode: its stiffness is k, its mass m, and a limb with the frequency w_i, by whose inertia the
 * trunk feels the mass m_i, adds w^4 m_i / (w_i^2 - w^2) to what w^2 m takes from k. Without a limb slower than the
 * trunk this is the first mode of the tree. A stout tree has many that are as slow as it is or slower, and no single
 * mode; then it is the middle of those in which the trunk goes along.
 */
double WholeTreeFrequency(
  const RigidTreeMode& rigid, const std::vector<LimbMeasures>& limbs, const LimbMaterial& material);

}

#endif
