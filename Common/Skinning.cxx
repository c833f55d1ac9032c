// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Skinning.h"

namespace littoral
{

glm::dquat RotationBetween(const Vector3& from, const Vector3& to)
{
  const Vector3 axis = glm::cross(from, to);
  const double alike = glm::dot(from, to);
  if (axis == Vector3(0.0) && alike >= 0.0)
  {
    return { 1.0, 0.0, 0.0, 0.0 };
  }
  // (|a||b| + a.b, a x b) points along the rotation by the whole angle in half-angle form
  const double sizes = std::sqrt(glm::dot(from, from) * glm::dot(to, to));
  const double real = sizes + alike;
  if (real <= 1e-12 * sizes)
  {
    const Vector3 side = Perpendicular(Normalised(from));
    return { 0.0, side.x, side.y, side.z };
  }
  const double factor = 1.0 / std::sqrt(real * real + glm::dot(axis, axis));
  return { factor * real, factor * axis.x, factor * axis.y, factor * axis.z };
}

JointChange ChangeOf(const JointPose& pose, const Vector3& rest)
{
  const glm::dquat& q = pose.Rotation;
  JointChange change;
  change.Turn[0] = { -2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y) };
  change.Turn[1] = { 2.0 * (q.x * q.y - q.w * q.z), -2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z + q.w * q.x) };
  change.Turn[2] = { 2.0 * (q.x * q.z + q.w * q.y), 2.0 * (q.y * q.z - q.w * q.x), -2.0 * (q.x * q.x + q.y * q.y) };
  change.Shift = pose.Shift - change.Turn * rest;
  return change;
}

}
