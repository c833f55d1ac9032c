// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/PlantWake.h"

#include "Numerics/Constants.h"

#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// Below it a plant counts as turning round, so that the strength has no jump [m/s].
constexpr double SlowSpeed = 0.02;

/// Core of the wake of the smallest plants [m].
constexpr double SmallestCore = 0.01;

FlowPrimitive SourceAt(const Vector3& place, double strength, double core, const Box& box, double margin)
{
  FlowPrimitive source;
  source.Type = FlowType::Source;
  source.Center = place;
  source.Strength = strength;
  source.CoreRadius = core;
  source.InfluenceBox = box;
  source.InfluenceMargin = margin;
  return source;
}

}

std::string WhyInvalid(const WakeOptions& options)
{
  ParameterCheck check;
  check.Range("Strength", options.Strength, 0.0, 1e6);
  check.Range("Margin", options.Margin, 1e-3, 1e3, "m");
  check.Range("CoreShare", options.CoreShare, 1e-3, 1.0);
  return check.Reason();
}

MovingPlant PlantOf(const std::vector<MovingPoint>& points)
{
  MovingPlant plant;
  plant.Bounds = { points.front().Place, points.front().Place };
  double weight = 0.0;
  for (const MovingPoint& point : points)
  {
    plant.Center += point.Weight * point.Place;
    plant.Velocity += point.Weight * point.Velocity;
    plant.Acceleration += point.Weight * point.Acceleration;
    plant.Volume += point.Volume;
    weight += point.Weight;
    plant.Bounds.Low = glm::min(plant.Bounds.Low, point.Place);
    plant.Bounds.High = glm::max(plant.Bounds.High, point.Place);
  }
  if (weight > 0.0)
  {
    plant.Center /= weight;
    plant.Velocity /= weight;
    plant.Acceleration /= weight;
  }
  else
  {
    plant.Center = 0.5 * (plant.Bounds.Low + plant.Bounds.High);
  }
  return plant;
}

std::vector<FlowPrimitive> WakeOf(const MovingPlant& plant, const WakeOptions& options)
{
  const double core =
    std::max(SmallestCore, options.CoreShare * 0.5 * glm::distance(plant.Bounds.Low, plant.Bounds.High));
  const auto sourceAt = [&](const Vector3& place, double strength) {
    return SourceAt(place, strength, core, plant.Bounds, options.Margin);
  };
  const double speed = glm::length(plant.Velocity);
  if (options.Kind == WakeKind::Source)
  {
    // Q = c a . v / (|v| + v_slow)
    const double along = glm::dot(plant.Acceleration, plant.Velocity) / (speed + SlowSpeed);
    return { sourceAt(plant.Center, options.Strength * along) };
  }
  // Doublet 2 pi R^3 v of a sphere of the plant's volume, as a source and a sink
  const double radius = std::cbrt(0.75 * plant.Volume / Pi);
  const double moment = options.Strength * TwoPi * radius * radius * radius * speed;
  const double apart = 0.5 * core;
  const Vector3 half = speed > 0.0 ? 0.5 * apart / speed * plant.Velocity : Vector3(0.0);
  return { sourceAt(plant.Center + half, moment / apart), sourceAt(plant.Center - half, -moment / apart) };
}

}
