// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/PlantMotion.h"

#include "Sway/BeamModes.h"

#include <algorithm>

namespace littoral
{

PlantMotion::PlantMotion(const Skeleton& rest, int numberOfModes, const std::vector<TrunkMode>& trunk)
  : Modes(numberOfModes)
  , Joints(rest.Nodes.size())
  , Rises(rest.Nodes.size() * static_cast<std::size_t>(numberOfModes), 0.0)
{
  for (int index = 0; index < static_cast<int>(rest.Branches.size()); ++index)
  {
    const SkeletonBranch& branch = rest.Branches[index];
    const int parent = rest.Nodes[branch.First].Parent;
    const Vector3 foot = parent < 0 ? Vector3(0.0) : rest.Nodes[branch.First].Position - rest.Nodes[parent].Position;
    this->Branches.push_back({ branch.First, branch.Count, parent, foot });
    const double length = rest.BranchLength(index);
    const bool isTrunk = index == 0 && static_cast<int>(trunk.size()) >= numberOfModes;
    const auto shape = [&](int mode, double part) {
      return isTrunk ? ShapeOf(trunk[mode - 1].Mixture, part) : ModeShape(mode, part);
    };
    double below = 0.0;
    for (int node = branch.First; node < rest.Tip(index); ++node)
    {
      const Vector3 segment = rest.Nodes[node + 1].Position - rest.Nodes[node].Position;
      const double above = std::min(1.0, below + glm::length(segment) / length);
      this->Joints[node].Segment = segment;
      for (int mode = 1; mode <= this->Modes; ++mode)
      {
        this->Rises[static_cast<std::size_t>(node) * this->Modes + mode - 1] = shape(mode, above) - shape(mode, below);
      }
      below = above;
    }
  }
}

void PlantMotion::Pose(const Vector3* amplitudes, JointPose* poses) const
{
  for (const Branch& branch : this->Branches)
  {
    JointPose pose;
    if (branch.Parent >= 0)
    {
      pose = poses[branch.Parent];
      pose.Shift += RotationOffset(pose.Rotation, branch.Foot);
    }
    const glm::dquat frame = pose.Rotation;
    const int tip = branch.First + branch.Count - 1;
    for (int node = branch.First; node < tip; ++node)
    {
      const Vector3& segment = this->Joints[node].Segment;
      const double* rise = &this->Rises[static_cast<std::size_t>(node) * this->Modes];
      Vector3 bent = segment;
      for (int mode = 0; mode < this->Modes; ++mode)
      {
        bent += rise[mode] * amplitudes[mode];
      }
      pose.Rotation = frame * RotationBetween(segment, bent);
      poses[node] = pose;
      pose.Shift += RotationOffset(pose.Rotation, segment);
    }
    poses[tip] = pose;
    amplitudes += this->Modes;
  }
}

Skeleton Moved(const Skeleton& rest, const std::vector<JointPose>& poses)
{
  Skeleton moved = rest;
  for (std::size_t node = 0; node < moved.Nodes.size(); ++node)
  {
    moved.Nodes[node].Position += poses[node].Shift;
  }
  return moved;
}

Vector3 BranchAxis(const Skeleton& skeleton, int branch)
{
  const Vector3& foot = skeleton.Nodes[skeleton.Branches[branch].First].Position;
  return Normalised(skeleton.Nodes[skeleton.Tip(branch)].Position - foot);
}

}
