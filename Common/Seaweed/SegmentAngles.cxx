// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/SegmentAngles.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// A local base: right-handed, Y along the segment.
struct Base
{
  Vector3 X{ 1.0, 0.0, 0.0 };
  Vector3 Y{ 0.0, 0.0, 1.0 };
  Vector3 Z{ 0.0, -1.0, 0.0 };
};

/// Turned by theta about Y and then by phi about the new X.
Base Turned(const Base& parent, double theta, double phi)
{
  Base base;
  base.X = std::cos(theta) * parent.X - std::sin(theta) * parent.Z;
  const Vector3 level = std::sin(theta) * parent.X + std::cos(theta) * parent.Z;
  base.Y = std::cos(phi) * parent.Y + std::sin(phi) * level;
  base.Z = std::cos(phi) * level - std::sin(phi) * parent.Y;
  return base;
}

/// The node at the foot of the segment that belongs to a node: its own, or for a tip the one before.
int FootOf(const Skeleton& skeleton, int node)
{
  const SkeletonBranch& branch = skeleton.Branches[skeleton.Nodes[node].Branch];
  return std::min(node, branch.First + branch.Count - 2);
}

/// The foot of the segment that carries the segment at a foot; -1 for the ground.
int ParentFoot(const Skeleton& skeleton, int foot)
{
  const int parent = skeleton.Nodes[foot].Parent;
  return parent < 0 ? -1 : FootOf(skeleton, parent);
}

}

std::vector<SegmentAngles> AnglesOf(const Skeleton& skeleton)
{
  std::vector<Base> bases(skeleton.Nodes.size());
  std::vector<SegmentAngles> angles(skeleton.Nodes.size());
  for (int node = 0; node < static_cast<int>(skeleton.Nodes.size()); ++node)
  {
    const int foot = FootOf(skeleton, node);
    if (foot != node)
    {
      angles[node] = angles[foot];
      bases[node] = bases[foot];
      continue;
    }
    const int parentFoot = ParentFoot(skeleton, foot);
    const Base parent = parentFoot < 0 ? Base{} : bases[parentFoot];
    const Vector3 along = glm::normalize(skeleton.Nodes[foot + 1].Position - skeleton.Nodes[foot].Position);
    const double sideways = glm::dot(along, parent.X);
    const double ahead = glm::dot(along, parent.Z);
    const double tilt = std::hypot(sideways, ahead);
    angles[node].Phi = std::atan2(tilt, glm::dot(along, parent.Y));
    angles[node].Theta = tilt > 1e-12 ? std::atan2(sideways, ahead) : 0.0;
    angles[node].Attachment =
      parentFoot < 0 ? 0.0 : glm::dot(skeleton.Nodes[foot].Position - skeleton.Nodes[parentFoot].Position, parent.Y);
    bases[node] = Turned(parent, angles[node].Theta, angles[node].Phi);
  }
  return angles;
}

}
