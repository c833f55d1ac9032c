// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/WindLoads.h"

#include "Numerics/Constants.h"

#include "Numerics/ParameterCheck.h"

#include <cmath>

namespace littoral
{

std::string WhyInvalid(const WindLoadParameters& parameters)
{
  ParameterCheck check;
  check.Positive("AirDensity", parameters.AirDensity, "kg/m3");
  check.NotNegative("DragCoefficient", parameters.DragCoefficient);
  check.Finite("LiftCoefficient", parameters.LiftCoefficient);
  check.Choice("DragLaw", static_cast<int>(parameters.Law), 2);
  return check.Reason();
}

Vector3 DragPerLength(const WindLoadParameters& parameters, const Vector3& axis, double diameter, const Vector3& wind)
{
  // eq. 15: 1/2 rho C_D D |U| U_perp, or |U_perp| U_perp
  const Vector3 across = wind - glm::dot(wind, axis) * axis;
  const double speed = glm::length(parameters.Law == DragLaw::CrossFlow ? across : wind);
  return 0.5 * parameters.AirDensity * parameters.DragCoefficient * diameter * speed * across;
}

Vector3 LiftPerLength(const WindLoadParameters& parameters, const Vector3& axis, double diameter, const Vector3& wind)
{
  // eq. 16: 1/2 rho C_L D |U| U x e, or |U_perp| U x e
  const Vector3 side = glm::cross(wind, axis); // as long as the wind across the axis
  const double speed = parameters.Law == DragLaw::CrossFlow ? glm::length(side) : glm::length(wind);
  return 0.5 * parameters.AirDensity * parameters.LiftCoefficient * diameter * speed * side;
}

Vector3 WeightPerLength(double massPerLength)
{
  return { 0.0, 0.0, -Gravity * massPerLength };
}

}
