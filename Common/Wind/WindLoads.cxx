// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/WindLoads.h"

#include <cmath>
#include <sstream>

namespace littoral
{

namespace
{
constexpr double Gravity = 9.80665; // [m/s2]
}

std::string WhyInvalid(const WindLoadParameters& parameters)
{
  std::ostringstream reason;
  if (!(parameters.AirDensity > 0.0) || !std::isfinite(parameters.AirDensity))
  {
    reason << "AirDensity is " << parameters.AirDensity << " kg/m3; it must be positive.";
  }
  else if (!(parameters.DragCoefficient >= 0.0) || !std::isfinite(parameters.DragCoefficient))
  {
    reason << "DragCoefficient is " << parameters.DragCoefficient << "; it must not be negative.";
  }
  else if (!std::isfinite(parameters.LiftCoefficient))
  {
    reason << "LiftCoefficient is " << parameters.LiftCoefficient << "; it must be finite.";
  }
  else if (parameters.Law != DragLaw::Projection && parameters.Law != DragLaw::CrossFlow)
  {
    reason << "DragLaw is " << static_cast<int>(parameters.Law) << "; it must be 0 or 1.";
  }
  return reason.str();
}

Vector3 DragPerLength(const WindLoadParameters& parameters, const Vector3& axis, double diameter, const Vector3& wind)
{
  const Vector3 across = wind - glm::dot(wind, axis) * axis;
  const double speed = glm::length(parameters.Law == DragLaw::CrossFlow ? across : wind);
  return 0.5 * parameters.AirDensity * parameters.DragCoefficient * diameter * speed * across;
}

Vector3 LiftPerLength(const WindLoadParameters& parameters, const Vector3& axis, double diameter, const Vector3& wind)
{
  const Vector3 side = glm::cross(wind, axis); // as long as the wind across the axis
  const double speed = parameters.Law == DragLaw::CrossFlow ? glm::length(side) : glm::length(wind);
  return 0.5 * parameters.AirDensity * parameters.LiftCoefficient * diameter * speed * side;
}

Vector3 WeightPerLength(double massPerLength)
{
  return { 0.0, 0.0, -Gravity * massPerLength };
}

}
