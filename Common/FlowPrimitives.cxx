// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlowPrimitives.h"

#include "Constants.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace littoral
{

namespace
{

/// (1 - exp(-x))/x, 1 at 0. Beyond 40 the exponential is less than the last digit of 1.
double CoreShare(double x)
{
  if (x > 40.0)
  {
    return 1.0 / x;
  }
  return x > 1e-8 ? -std::expm1(-x) / x : 1.0 - 0.5 * x;
}

}

std::string WhyInvalid(const FlowPrimitive& primitive)
{
  std::ostringstream reason;
  const bool hasCore = primitive.Type != FlowType::Uniform;
  const bool hasAxis = primitive.Type == FlowType::Uniform || primitive.Type == FlowType::Vortex;
  if (primitive.Type < FlowType::Uniform || primitive.Type > FlowType::Vortex)
  {
    reason << "FlowType is " << static_cast<int>(primitive.Type) << "; it must be 0 to 3.";
  }
  else if (!std::isfinite(primitive.Strength))
  {
    reason << "Strength must be finite.";
  }
  else if (!IsFinite(primitive.Centre))
  {
    reason << "Center must be finite.";
  }
  else if (hasAxis && !(IsFinite(primitive.Axis) && glm::length(primitive.Axis) > 0.0))
  {
    reason << "Axis must be finite and not of length 0.";
  }
  else if (hasCore && !(primitive.CoreRadius > 0.0 && std::isfinite(primitive.CoreRadius)))
  {
    reason << "CoreRadius is " << primitive.CoreRadius << " m; it must be positive.";
  }
  else if (!(primitive.InfluenceRadius >= 0.0 && std::isfinite(primitive.InfluenceRadius)))
  {
    reason << "InfluenceRadius is " << primitive.InfluenceRadius << " m; it must be positive, or 0 for none.";
  }
  return reason.str();
}

FlowField::FlowField(const std::vector<FlowPrimitive>& primitives)
  : Count(primitives.size())
{
  for (const FlowPrimitive& primitive : primitives)
  {
    const Vector3 axis = Normalised(primitive.Axis);
    const double core = primitive.CoreRadius * primitive.CoreRadius;
    const double reach = primitive.InfluenceRadius;
    Local local{ primitive.Type, primitive.Centre, axis, primitive.Strength, core, 1.0 / core,
      reach > 0.0 ? 1.0 / (reach * reach) : 0.0 };
    switch (primitive.Type)
    {
      case FlowType::Uniform:
        if (reach == 0.0)
        {
          this->Everywhere += primitive.Strength * axis;
          continue;
        }
        break;
      case FlowType::Source:
        local.Factor /= 4.0 * Pi;
        break;
      case FlowType::Sink:
        local.Factor /= -4.0 * Pi;
        this->Sinks.push_back({ primitive.Centre, core });
        break;
      case FlowType::Vortex:
        local.Factor /= TwoPi;
        break;
    }
    this->Around.push_back(local);
  }
}

Vector3 FlowField::Velocity(const Vector3& place) const
{
  Vector3 sum = this->Everywhere;
  for (const Local& local : this->Around)
  {
    const Vector3 arm = place - local.Centre;
    const double squared = glm::dot(arm, arm);
    const double inside = 1.0 - squared * local.InverseInfluence;
    if (inside <= 0.0)
    {
      continue;
    }
    const double factor = local.InverseInfluence > 0.0 ? local.Factor * inside * inside : local.Factor;
    switch (local.Type)
    {
      case FlowType::Uniform:
        sum += factor * local.Axis;
        break;
      case FlowType::Source:
      case FlowType::Sink:
      {
        const double softened = squared + local.CoreSquared;
        sum += (factor / (softened * std::sqrt(softened))) * arm;
        break;
      }
      case FlowType::Vortex:
      {
        const Vector3 around = glm::cross(local.Axis, arm);
        const double x = glm::dot(around, around) * local.InverseCore;
        sum += (factor * local.InverseCore * CoreShare(x)) * around;
        break;
      }
    }
  }
  return sum;
}

bool FlowField::Capture(const Vector3& from, Vector3& to) const
{
  for (const Ball& sink : this->Sinks)
  {
    const Vector3 way = to - from;
    const double length = glm::dot(way, way);
    const double part = length > 0.0 ? std::clamp(glm::dot(sink.Centre - from, way) / length, 0.0, 1.0) : 0.0;
    const Vector3 nearest = from + part * way;
    const Vector3 arm = nearest - sink.Centre;
    if (glm::dot(arm, arm) <= sink.RadiusSquared)
    {
      to = nearest;
      return true;
    }
  }
  return false;
}

}
