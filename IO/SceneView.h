// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneView_h
#define LittoralSceneView_h

#include "Numerics/Vector3.h"

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cmath>

namespace littoral
{

/// The rotation, as a quaternion x, y, z, w, of a camera or light that looks along its -z from one place to another,
/// with y up; any other direction is up where `up` is along the view.
inline std::array<double, 4> ViewRotation(
  const std::array<double, 3>& from, const std::array<double, 3>& to, const std::array<double, 3>& up)
{
  const auto vector = [](const std::array<double, 3>& a) { return Vector3(a[0], a[1], a[2]); };
  const Vector3 back = Normalised(vector(from) - vector(to));
  Vector3 right = glm::cross(vector(up), back);
  if (!(glm::length(right) > 1e-12 * glm::length(vector(up))))
  {
    right = glm::cross(std::abs(back.x) < 0.5 ? Vector3(1.0, 0.0, 0.0) : Vector3(0.0, 1.0, 0.0), back);
  }
  right = Normalised(right);
  const glm::dquat turn = glm::normalize(glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back)));
  return { { turn.x, turn.y, turn.z, turn.w } };
}

}

#endif
