// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTrunkModes_h
#define LittoralTrunkModes_h

#include "Plants/Skeleton.h"
#include "Sway/BeamModes.h"
#include "Sway/LimbModes.h"

#include <array>
#include <vector>

namespace littoral
{

/// Drag of branches and leaves in a crown as part of what they have in the open: they stand in each other's lee.
inline constexpr double CrownShelter = 1.0 / 3.0;

/// The value of a mixture at a part of the length.
double ShapeOf(const ShapeMixture& mixture, double part);

/// Products of these shapes over a trunk, by rows.
using ShapeProducts = std::array<double, MaximumModes * MaximumModes>;

/// Mass and drag of what is made of one material: of wood by its volume [m3] and its breadth, of leaves by their area.
struct TrunkBurden
{
  ShapeProducts Mass{};   ///< mean products of the shapes over the mass, with its turning [m3 or m2]
  ShapeProducts Weight{}; ///< of their slopes over the mass above: what weight takes from the stiffness [m2 or m]
  ShapeMixture Load{};    ///< of the shapes over the mass [m3 or m2]
  ShapeMixture Drag{};    ///< and over the area that meets the wind [m2]
  double Amount = 0.0;    ///< [m3 or m2]
  double Area = 0.0;      ///< area that meets the wind, in the lee of others [m2]
};

/// Stiffness of a trunk and masses that it bears, in numbers that scale with the plant.
struct TrunkMeasures
{
  double Length = 1.0;        ///< [m]
  double BendingRadius = 0.1; ///< of the uniform trunk that gives way as much at the tip under a uniform load [m]
  Vector3 Axis{ 0.0, 0.0, 1.0 };
  ShapeProducts Stiffness{}; ///< of the curvatures over the second moment of area [m]
  TrunkBurden Wood;
  TrunkBurden Leaves;
  std::vector<LimbMeasures> Limbs; ///< without them, limbs are rigid
};

/**
 * The areas of leaves [m2] by nodes that a tree can feed: as those that are drawn, times what makes their sum the
 * trunk's section at the crown's base, where its lowest branch grows, times the ratio (the pipe model, Shinozaki et al.
 * 1964: as many leaves as pipes). As drawn where the ratio is 0, or there are none.
 */
std::vector<double> FedLeafAreas(const Skeleton& skeleton, const std::vector<double>& leafAreas, double ratio);

/**
 * Measures the first branch of a valid skeleton as a tapered cantilever. What grows on it moves with the place it grows
 * from, and turns with it; how its limbs give way is measured besides. Areas of leaves [m2] are those on each node; or
 * empty. Without what it carries, a trunk is measured alone.
 */
TrunkMeasures MeasureTrunk(const Skeleton& skeleton, const std::vector<double>& leafAreas, bool carries = true);

/// Material of a trunk.
struct TrunkMaterial
{
  double YoungModulus = 9e9; ///< [Pa]
  double Density = 900.0;    ///< of wood [kg/m3]
  double LeafMass = 0.35;    ///< with twigs [kg/m2]
  double LeafDrag = 0.05;    ///< drag of an area of leaves as part of that of a bare cylinder's
  bool Weighs = true;        ///< whether its weight makes it softer
};

/// A mode of a trunk.
struct TrunkMode
{
  double Frequency = 1.0; ///< angular, without damping [rad/s]
  double Load = 0.0;      ///< acceleration of the amplitude for a mean load per length [m/kg]
  double Weight = 0.0;    ///< for an acceleration of all its mass across it
  ShapeMixture Mixture{}; ///< of length 1, mostly the uniform cantilever's of the same number in a like trunk
};

/**
 * The modes of a trunk that was scaled, slowest first, by Ritz's method with the shapes of the uniform cantilever
 * (eq. 18 of Setas et al.): kinetic energy of trunk, branches and leaves; strain energy of the tapered trunk, less what
 * their weight gives when it leans. Weight takes 3/4 of the stiffness at most, so that a trunk which would buckle
 * stands. The first mode is that of the whole tree, whose limbs give way (WholeTreeFrequency); in others they are
 * rigid.
 */
std::array<TrunkMode, MaximumModes> ModesOf(const TrunkMeasures& trunk, double scale, const TrunkMaterial& material);

}

#endif
