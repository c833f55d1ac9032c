// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Skinning.h"

namespace littoral
{

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
