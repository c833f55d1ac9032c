// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWindLoads_h
#define LittoralWindLoads_h

#include "Vector3.h"

#include <string>

namespace littoral
{

/// How the drag of a cylinder follows from the wind U and its part across the cylinder, U_perp.
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
  double LiftCoefficient = 0.0; ///< of forces across wind and cylinder; any sign
  DragLaw Law = DragLaw::Projection;
};

/// Why these are no parameters, in words for a user; empty when they are.
std::string WhyInvalid(const WindLoadParameters& parameters);

/// Drag on a unit of length of a cylinder [N/m] (eq. 15): its unit axis, its diameter [m], the wind [m/s].
Vector3 DragPerLength(const WindLoadParameters& parameters, const Vector3& axis, double diameter, const Vector3& wind);

/**
 * Lift on a unit of length of a cylinder [N/m] (eq. 16): across the wind and the axis, to the side of wind x axis; none
 * where the wind blows along the axis.
 */
Vector3 LiftPerLength(const WindLoadParameters& parameters, const Vector3& axis, double diameter, const Vector3& wind);

/// Weight of a unit of length [N/m]: mass per length [kg/m] times gravity, downwards.
Vector3 WeightPerLength(double massPerLength);

}

#endif
