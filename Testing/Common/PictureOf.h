// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PictureOf_h
#define PictureOf_h

// Where places are in the picture of a view, by GLM's matrices of cameras, which the numerics do not use.
#include "Geometry/ViewFrustum.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

class PictureOf
{
public:
  explicit PictureOf(const littoral::View& view)
    : Seen(view)
    , Near(view.IsParallel ? view.Near : std::max(view.Near, 1e-9))
  {
    const double far = std::isfinite(view.Far) ? view.Far : 1e7;
    const double half = view.ParallelScale;
    const glm::dmat4 projection = view.IsParallel
      ? glm::ortho(-half * view.AspectRatio, half * view.AspectRatio, -half, half, this->Near, far)
      : glm::perspective(view.Angle, view.AspectRatio, this->Near, far);
    this->Matrix = projection * glm::lookAt(view.Point, view.Point + view.Direction, view.Up);
  }

  /// On the picture, and between the near and the far plane.
  bool Shows(const littoral::Vector3& place) const
  {
    const glm::dvec4 clip = this->Matrix * glm::dvec4(place, 1.0);
    return clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && std::abs(clip.z) <= clip.w;
  }

  /// How far apart two places are [pixels]; infinite where one is behind the eye.
  double PixelsBetween(const littoral::Vector3& a, const littoral::Vector3& b) const
  {
    const glm::dvec4 p = this->Matrix * glm::dvec4(a, 1.0);
    const glm::dvec4 q = this->Matrix * glm::dvec4(b, 1.0);
    if (p.w <= 0.0 || q.w <= 0.0)
    {
      return std::numeric_limits<double>::infinity();
    }
    const double half = 0.5 * this->Seen.Height;
    return std::hypot(half * this->Seen.AspectRatio * (p.x / p.w - q.x / q.w), half * (p.y / p.w - q.y / q.w));
  }

private:
  littoral::View Seen;
  double Near;
  glm::dmat4 Matrix;
};

/// A view of a place around the origin, in perspective of up to 120 degrees or parallel, from within a distance [m].
inline littoral::View AnyView(std::mt19937& random, double distance)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto vector = [&]() {
    const double x = uniform(random);
    const double y = uniform(random);
    return littoral::Vector3(2.0 * x - 1.0, 2.0 * y - 1.0, 2.0 * uniform(random) - 1.0);
  };
  littoral::View view;
  view.Point = distance * vector();
  view.Direction = 0.5 * distance * vector() - view.Point;
  view.Up = vector();
  view.Angle = glm::radians(5.0 + 115.0 * uniform(random));
  view.AspectRatio = 0.4 + 2.1 * uniform(random);
  view.Height = 200.0 + 1000.0 * uniform(random);
  view.IsParallel = uniform(random) < 0.5;
  view.ParallelScale = distance * (0.02 + uniform(random));
  return view;
}

#endif
