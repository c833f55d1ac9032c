// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWindLoads_h
#define LittoralWindLoads_h

#include "Numerics/Vector3.h"

#include <string>

namespace littoral
{

/// Laws of the drag of a cylinder in the wind U with the component U_perp across the cylinder.
enum class DragLaw
{
  Projection = 0, ///< along |U| U_perp: linear in the projection, so that loads on beams of any direction add up
  CrossFlow = 1   ///< along |U_perp| U_perp: the independence principle of long cylinders
};

/// Air and cylinder.
struct WindLoadParameters
{
  double AirDensity = 1.2;      ///< [kg/m3], positive
  double DragCoefficient = 1.1; ///< 1.0 to 1.2 for a cylinder; not negative
  double LiftCoefficient = 0.0; ///< of forces across wind and cylinder; not zero where a cylinder is not round
  DragLaw Law = DragLaw::Projection;
};

/// Why these are no parameters, in words for a user; empty when they are.
std::string WhyInvalid(const WindLoadParameters& parameters);

/// Drag on a unit of length of a cylinder [N/m] (eq. 15): its unit axis, its diameter [m], the wind [m/s].
Vector3 DragPerLength(const WindLoadParameters& parameters, const Vector3& axis, double diameter, const Vector3& wind);

/**
 * Lift on a unit of length of a cylinder [N/m] (eq. 16): 1/2 rho C_L D U^2 n_L, across the wind U and the axis e, with
 * n_L = U x e / |U x e|: to the right of the wind on an upright cylinder, up on one that points to the wind's left. As
 * of drag, U^2 is |U| |U_perp| by the law Projection and |U_perp|^2 by CrossFlow; both are that of eq. 16 where the
 * wind blows across the axis, and none is left where it blows along.
 */
Vector3 LiftPerLength(const WindLoadParameters& parameters, const Vector3& axis, double diameter, const Vector3& wind);

/// Weight of a unit of length [N/m]: mass per length [kg/m] times gravity, downwards.
Vector3 WeightPerLength(double massPerLength);

}

#endif
