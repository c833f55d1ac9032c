// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/FlowArrows.h"

#include "Numerics/Constants.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace littoral
{
namespace
{

constexpr double CoresDrawn = 4.0;
constexpr double UniformRadius = 2.0;      ///< [m]
constexpr double LongestArrow = 1.0 / 3.0; ///< of the drawing radius
constexpr double ShortestArrow = 0.05;     ///< of the longest
constexpr int Directions = 26;             ///< of radii of a source
constexpr int AroundAxis = 12;

/// Two directions across an axis of length 1.
void Across(const Vector3& axis, Vector3& u, Vector3& v)
{
  const Vector3 other = std::abs(axis.z) < 0.9 ? Vector3(0.0, 0.0, 1.0) : Vector3(1.0, 0.0, 0.0);
  u = Normalised(glm::cross(other, axis));
  v = glm::cross(axis, u);
}

/// Directions spread evenly over a sphere, by the golden angle.
Vector3 SphereDirection(int index, int count)
{
  const double z = 1.0 - (2.0 * index + 1.0) / count;
  const double angle = Pi * (3.0 - std::sqrt(5.0)) * index;
  const double r = std::sqrt(1.0 - z * z);
  return { r * std::cos(angle), r * std::sin(angle), z };
}

/// Places where arrows have their middles, from the center.
std::vector<Vector3> Middles(const FlowPrimitive& primitive)
{
  const double radius = DrawingRadius(primitive);
  std::vector<Vector3> places;
  if (TraitsOf(primitive.Type).IsPoint)
  {
    for (double share : { 0.3, 0.7 })
    {
      for (int i = 0; i < Directions; ++i)
      {
        places.push_back(share * radius * SphereDirection(i, Directions));
      }
    }
    return places;
  }
  const bool isUniform = primitive.Type == FlowType::Uniform;
  const Vector3 axis = Normalised(primitive.Axis);
  Vector3 u, v;
  Across(axis, u, v);
  if (isUniform)
  {
    places.emplace_back(0.0);
  }
  for (double share : { 0.25, 0.5, 0.8 })
  {
    for (int i = 0; i < AroundAxis; ++i)
    {
      const double angle = TwoPi * i / AroundAxis;
      places.push_back(share * radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
  }
  return places;
}

}

double DrawingRadius(const FlowPrimitive& primitive)
{
  if (primitive.InfluenceRadius > 0.0)
  {
    return primitive.InfluenceRadius;
  }
  return TraitsOf(primitive.Type).HasCore ? CoresDrawn * primitive.CoreRadius : UniformRadius;
}

std::vector<FlowArrow> ArrowsOf(const FlowPrimitive& primitive)
{
  const FlowField flow({ primitive });
  std::vector<Vector3> places = Middles(primitive);
  std::vector<Vector3> velocities;
  double fastest = 0.0;
  for (Vector3& place : places)
  {
    place += primitive.Center;
    velocities.push_back(flow.Velocity(place));
    fastest = std::max(fastest, glm::length(velocities.back()));
  }
  const double longest = LongestArrow * DrawingRadius(primitive);
  std::vector<FlowArrow> arrows;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double speed = glm::length(velocities[i]);
    if (speed > ShortestArrow * fastest)
    {
      const Vector3 arm = longest / fastest * velocities[i];
      arrows.push_back({ places[i] - 0.5 * arm, arm, speed });
    }
  }
  return arrows;
}

std::vector<FlowArrow> ArrowsAt(const std::vector<FlowSample>& samples, int cellsAlong)
{
  if (samples.empty())
  {
    return {};
  }
  Vector3 low = samples[0].Place, high = low;
  for (const FlowSample& sample : samples)
  {
    low = glm::min(low, sample.Place);
    high = glm::max(high, sample.Place);
  }
  const double longer = std::max(high.x - low.x, high.y - low.y);
  const double side = longer > 0.0 ? longer / cellsAlong : 1.0;
  const auto cellOf = [&](double from) { return std::clamp(static_cast<int>(from / side), 0, cellsAlong - 1); };
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> chosen(static_cast<std::size_t>(cellsAlong) * cellsAlong, none);
  const auto distanceOf = [&](const Vector3& place, int i, int j) {
    return std::hypot(place.x - low.x - (i + 0.5) * side, place.y - low.y - (j + 0.5) * side);
  };
  double fastest = 0.0;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const Vector3& place = samples[n].Place;
    const int i = cellOf(place.x - low.x), j = cellOf(place.y - low.y);
    std::size_t& best = chosen[static_cast<std::size_t>(j) * cellsAlong + i];
    const double distance = distanceOf(place, i, j);
    const double before = best == none ? distance : distanceOf(samples[best].Place, i, j);
    const bool isBetter = best == none || distance < before || (distance == before && place.z > samples[best].Place.z);
    best = isBetter ? n : best;
  }
  for (const std::size_t n : chosen)
  {
    fastest = n == none ? fastest : std::max(fastest, glm::length(samples[n].Velocity));
  }
  std::vector<FlowArrow> arrows;
  for (const std::size_t n : chosen)
  {
    const double speed = n == none ? 0.0 : glm::length(samples[n].Velocity);
    if (speed > ShortestArrow * fastest)
    {
      const Vector3 arm = side / fastest * samples[n].Velocity;
      arrows.push_back({ samples[n].Place - 0.5 * arm, arm, speed });
    }
  }
  return arrows;
}

std::vector<FlowRing> RingsOf(const FlowPrimitive& primitive)
{
  std::vector<FlowRing> rings;
  const FlowTraits& traits = TraitsOf(primitive.Type);
  for (double radius : { traits.HasCore ? primitive.CoreRadius : 0.0, primitive.InfluenceRadius })
  {
    if (radius <= 0.0)
    {
      continue;
    }
    if (traits.HasAxis && traits.HasCore)
    {
      rings.push_back({ primitive.Center, Normalised(primitive.Axis), radius });
      continue;
    }
    for (int c = 0; c < 3; ++c)
    {
      Vector3 normal(0.0);
      normal[c] = 1.0;
      rings.push_back({ primitive.Center, normal, radius });
    }
  }
  return rings;
}

}
