// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlowPrimitives.h"

#include "Constants.h"

#include <glm/common.hpp>

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

bool IsBox(const Box& box)
{
  return IsFinite(box.Low) && IsFinite(box.High) && box.Low.x <= box.High.x && box.Low.y <= box.High.y &&
    box.Low.z <= box.High.z;
}

bool HasEnd(const FlowPrimitive& primitive)
{
  return primitive.InfluenceRadius > 0.0 || primitive.InfluenceMargin > 0.0;
}

/// A box outside of which there is no flow: the common part of that about the sphere and that about the influence box.
Box ReachOf(const FlowPrimitive& primitive)
{
  const double margin = primitive.InfluenceMargin;
  const double radius = primitive.InfluenceRadius;
  const Box box{ primitive.InfluenceBox.Low - margin, primitive.InfluenceBox.High + margin };
  const Box ball{ primitive.Centre - radius, primitive.Centre + radius };
  if (radius == 0.0 || margin == 0.0)
  {
    return margin == 0.0 ? ball : box;
  }
  const Vector3 low = glm::max(box.Low, ball.Low);
  return { low, glm::max(low, glm::min(box.High, ball.High)) }; // a point of no flow if they do not meet
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
  else if (!(primitive.InfluenceMargin >= 0.0 && std::isfinite(primitive.InfluenceMargin)))
  {
    reason << "InfluenceMargin is " << primitive.InfluenceMargin << " m; it must be positive, or 0 for none.";
  }
  else if (primitive.InfluenceMargin > 0.0 && !IsBox(primitive.InfluenceBox))
  {
    reason << "InfluenceBox must be finite, with lower ends that are not above the upper ones.";
  }
  return reason.str();
}

FlowField::FlowField(const std::vector<FlowPrimitive>& primitives)
  : Count(primitives.size())
{
  std::vector<Box> reaches;
  const auto inverseSquare = [](double length) { return length > 0.0 ? 1.0 / (length * length) : 0.0; };
  for (const FlowPrimitive& primitive : primitives)
  {
    const Vector3 axis = Normalised(primitive.Axis);
    const double core = primitive.CoreRadius * primitive.CoreRadius;
    Local local{ primitive.Type, primitive.Centre, axis, primitive.Strength, core, 1.0 / core,
      inverseSquare(primitive.InfluenceRadius), primitive.InfluenceBox, inverseSquare(primitive.InfluenceMargin) };
    switch (primitive.Type)
    {
      case FlowType::Uniform:
        if (!HasEnd(primitive))
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
    if (HasEnd(primitive))
    {
      this->Ending.push_back(local);
      reaches.push_back(ReachOf(primitive));
    }
    else
    {
      this->Around.push_back(local);
    }
  }
  this->Cells = BoxCells(reaches);
}

inline Vector3 FlowField::Local::Flow(const Vector3& arm, double squaredArm, double factor) const
{
  switch (this->Type)
  {
    case FlowType::Uniform:
      return factor * this->Axis;
    case FlowType::Source:
    case FlowType::Sink:
    {
      const double softened = squaredArm + this->CoreSquared;
      return (factor / (softened * std::sqrt(softened))) * arm;
    }
    case FlowType::Vortex:
    {
      const Vector3 around = glm::cross(this->Axis, arm);
      const double x = glm::dot(around, around) * this->InverseCore;
      return (factor * this->InverseCore * CoreShare(x)) * around;
    }
  }
  return Vector3(0.0);
}

inline double FlowField::Local::Share(const Vector3& place, double squaredArm) const
{
  double share = 1.0;
  if (this->InverseMargin > 0.0)
  {
    const Vector3 away = glm::max(glm::max(this->Whole.Low - place, place - this->Whole.High), 0.0);
    const double inside = std::max(0.0, 1.0 - glm::dot(away, away) * this->InverseMargin);
    share = inside * inside;
  }
  if (this->InverseInfluence > 0.0)
  {
    const double inside = std::max(0.0, 1.0 - squaredArm * this->InverseInfluence);
    share *= inside * inside;
  }
  return share;
}

Vector3 FlowField::Velocity(const Vector3& place) const
{
  Vector3 sum = this->Everywhere;
  for (const Local& local : this->Around)
  {
    const Vector3 arm = place - local.Centre;
    sum += local.Flow(arm, glm::dot(arm, arm), local.Factor);
  }
  if (this->Ending.empty())
  {
    return sum;
  }
  for (const int near : this->Cells.Near(place))
  {
    const Local& local = this->Ending[near];
    const Vector3 arm = place - local.Centre;
    const double squaredArm = glm::dot(arm, arm);
    const double share = local.Share(place, squaredArm);
    if (share > 0.0)
    {
      sum += local.Flow(arm, squaredArm, share * local.Factor);
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
