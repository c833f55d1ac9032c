// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaweedPlant_h
#define LittoralSeaweedPlant_h

#include "Plants/SeaweedSegment.h"
#include "Plants/Skeleton.h"

#include <glm/gtc/quaternion.hpp>

#include <string>
#include <vector>

namespace littoral
{

/// The axes about which a joint of a seaweed turns. Values are those of a property: never renumber.
enum class SeaweedJoint
{
  Bending = 0, ///< two axes at a right angle to the segment, no twist
  Tilting = 1, ///< azimuth about the parent segment, then tilt (Coulais et al., figure 7)
};

/// Loads of the water on a seaweed.
enum class SeaweedLoad
{
  Morison = 0, ///< drag by the relative velocity, inertia of water and plant, buoyancy
  Direct = 1,  ///< a factor times acceleration (physical) or displacement (procedural) of the water, and current
};

/// Time integrators of the motion of a seaweed.
enum class SeaweedIntegrator
{
  Implicit = 0,      ///< implicit midpoint rule, of second order, with sub-steps
  ExplicitEuler = 1, ///< eq. 10 of Coulais et al.
};

/// The water around seaweeds, and what it does to them.
struct SeaweedOptions
{
  SeaweedJoint Joint = SeaweedJoint::Bending;
  SeaweedLoad Load = SeaweedLoad::Morison;
  SeaweedIntegrator Integrator = SeaweedIntegrator::Implicit;
  double WaterDensity = 1025.0;      ///< [kg/m3]
  double SeaLevel = 0.0;             ///< above it nothing floats [m]
  double DragCoefficient = 1.95;     ///< of the flow across a blade, by the width of the side that it meets, as of a
                                     ///< plate; round stipes and floats have half of it
  double FrictionCoefficient = 0.02; ///< of the flow along a segment, by its surface
  double AddedMassCoefficient = 1.0; ///< of the motion across a segment, by the circle around the side that it meets
  double DampingFactor = 1.0;        ///< of all damping ratios
  double ForceFactor = 1.0;          ///< Direct: [N/m] for a m/s2, a metre or a m/s
  double LeverArm = 0.5;             ///< procedural: where the load acts, as part of the segment; the paper's is 1
  double MaximumAngle = 1.0;         ///< procedural: of a joint [rad]
};

/// Why there are no such options, with the name of the property; empty when there are.
std::string WhyInvalid(const SeaweedOptions& options);

/// A stiff segment of a seaweed and the joint at its foot (Real = double), or some of them, a lane each (SimdDoubles).
template <typename Real>
struct LinkBody
{
  using Vector = glm::vec<3, Real>;
  Vector Foot{ Real(0.0) };                                          ///< at rest [m]
  Vector Axis{ Real(0.0), Real(0.0), Real(1.0) };                    ///< at rest, of length 1
  Vector Side{ Real(1.0), Real(0.0), Real(0.0) };                    ///< at rest, at a right angle to it
  Vector Arm{ Real(0.0) };                                           ///< from the parent's foot to the own, at rest [m]
  glm::qua<Real> Base{ Real(1.0), Real(0.0), Real(0.0), Real(0.0) }; ///< local base of the paper, at rest
  Real Theta{ 0.0 };                                                 ///< of the paper, at rest [rad]
  Real Phi{ 0.0 };                                                   ///< of the paper, at rest [rad]
  Real Length{ 1.0 };                                                ///< [m]
  Real Mass{ 1.0 };                                                  ///< of the tissue [kg]
  Real FaceMass{ 0.0 };         ///< added mass of the water in motion normal to the face [kg]
  Real EdgeMass{ 0.0 };         ///< added mass of the water in motion along the width, Side [kg]
  Real AxialInertia{ 1e-3 };    ///< about its own axis, with that of the water [kg m2]
  Real WaterMass{ 1.0 };        ///< displaced water [kg]
  Real Buoyancy{ 0.0 };         ///< in water, less weight [N]
  Real Weight{ 0.0 };           ///< in air [N]
  Real FrontalArea{ 0.01 };     ///< of a plate with the drag of the face: width times length; if round, half of it [m2]
  Real EdgeFrontalArea{ 0.01 }; ///< the same of the edge: thickness times length; if round, half of it [m2]
  Real WettedArea{ 0.03 };      ///< wetted area [m2]
  Real Stiffness{ 1.0 };        ///< of the joint [N m/rad]
  Real Damping{ 0.0 };          ///< of the joint [N m s/rad]
  Real StopStiffness{ 0.0 };    ///< of what keeps the joint from folding flat [N m/rad]
  Real StopDamping{ 0.0 };      ///< [N m s/rad]
  Real Bed{ -1e300 };           ///< height of the ground below the plant [m]
};

/// A stiff segment of a seaweed and where it stands in its plant.
struct SeaweedLink : LinkBody<double>
{
  int Parent = -1;                ///< link that it grows on, before it; -1: the ground
  bool IsFirst = true;            ///< of its branch
  int Node = 0;                   ///< of the skeleton, at the foot
  double MeanLength = 0.0;        ///< of the links of its tissue in its branch [m]; 0: its own
  double BuoyancyStiffness = 0.0; ///< stiffness upright by the buoyancy beyond the joint [N m/rad]
};

/**
 * The links of a skeleton, which must be valid, one for each node that is no tip and no holdfast. A joint between two
 * segments bends as half of either does, one at the foot of a branch as half a segment, so that a chain of them bends
 * as a beam does. Damping ratios hold for a joint that bears all beyond it, held stiff.
 */
std::vector<SeaweedLink> LinksOf(
  const Skeleton& skeleton, const std::vector<SeaweedSegment>& segments, const SeaweedOptions& options);

/**
 * The Cauchy number Ca = rho C_D b U2 l3 / (2 E I) up to which a blade of a length [m] has its drag in a current within
 * 5 %, by its first link [m]: (0.52 l / l_1)^3. A limp blade bends within some 0.9 l Ca^(-1/3) of its foot (Luhar and
 * Nepf 2011), of which a link can be a half.
 */
double ResolvedCauchyNumber(double length, double firstLink);

/// The least resolved Cauchy number of the blades of a skeleton whose first link is more than twice as long as
/// BladeSteps (SeaweedGrowth.h) has it; infinite where there is none.
double UngradedCauchyNumber(const Skeleton& skeleton, const std::vector<SeaweedSegment>& segments);

/// The damping [N m s/rad] of each joint for damping ratios of the links; also finds BuoyancyStiffness.
void SetDamping(std::vector<SeaweedLink>& links, const std::vector<double>& ratios);

/// The longest step [s] with which explicit Euler does not blow up a plant in still water.
double ExplicitLimit(const std::vector<SeaweedLink>& links);

}

#endif
