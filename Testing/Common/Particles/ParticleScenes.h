// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Seas, particles and views of the tests of particles.

#include "Geometry/ViewFrustum.h"
#include "Numerics/Constants.h"
#include "Sea/WaveOrbits.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace littoral::testing
{

inline SeaState Sea(double depth, double wind = 10.0)
{
  SpectrumParameters parameters;
  parameters.WindSpeed = wind;
  return { TrainsOf(SeaSpectrum(parameters), depth, TrainParameters{}), depth, 0.0 };
}

inline std::vector<Vector3> Places(int count, const Box& box, unsigned int seed = 1)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vector3> places(count);
  for (Vector3& place : places)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] = box.Low[axis] + unit(engine) * (box.High[axis] - box.Low[axis]);
    }
  }
  return places;
}

/// Moved by their first trains; counts empty: by all.
inline std::vector<Vector3> Moved(
  const SeaState& sea, double time, const std::vector<Vector3>& places, std::vector<int> counts)
{
  if (counts.empty())
  {
    counts.assign(places.size(), static_cast<int>(sea.Trains.size()));
  }
  std::vector<double> centers(3 * places.size());
  std::vector<double> shift(3 * places.size());
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    std::copy_n(&places[n].x, 3, &centers[3 * n]);
  }
  OrbitRequest<double> request;
  request.Centers = centers.data();
  request.TrainCounts = counts.data();
  request.Displacement = shift.data();
  WaveOrbits(sea, {}, time).Evaluate(request, 0, places.size());
  std::vector<Vector3> moved(places.size());
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    moved[n] = places[n] + Vector3(shift[3 * n], shift[3 * n + 1], shift[3 * n + 2]);
  }
  return moved;
}

inline View Look(const Vector3& eye, const Vector3& direction, double angle = 45.0, double aspect = 4.0 / 3.0)
{
  View view;
  view.Point = eye;
  view.Direction = direction;
  view.Angle = angle * Pi / 180.0;
  view.AspectRatio = aspect;
  view.Height = 480.0;
  return view;
}

/// Pixels of a point from the center of the picture; false if the picture does not show it.
inline bool Project(const View& view, const Vector3& point, std::array<double, 2>& pixel)
{
  const Vector3 ahead = glm::normalize(view.Direction);
  const Vector3 right = glm::normalize(glm::cross(ahead, view.Up));
  const Vector3 up = glm::cross(right, ahead);
  const Vector3 seen = point - view.Point;
  const double depth = glm::dot(seen, ahead);
  const double scale = view.Height / (2.0 * std::tan(0.5 * view.Angle)) / depth;
  pixel = { scale * glm::dot(seen, right), scale * glm::dot(seen, up) };
  return depth > 0.0 && std::abs(pixel[0]) <= 0.5 * view.Height * view.AspectRatio &&
    std::abs(pixel[1]) <= 0.5 * view.Height;
}

/// A view of frame n on a way through the water, looking about.
inline View FrameView(int frame)
{
  const double t = 0.05 * frame;
  return Look({ 12.0 * std::cos(t), 9.0 * std::sin(1.3 * t), -6.0 + 5.0 * std::sin(0.7 * t) },
    { std::cos(2.1 * t), std::sin(2.1 * t), 0.5 * std::sin(3.0 * t) });
}

}
