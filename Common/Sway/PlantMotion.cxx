// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/PlantMotion.h"

#include "Numerics/SimdRotation.h"
#include "Sway/BeamModes.h"

#include <algorithm>

namespace littoral
{

namespace
{

using FourVectors = glm::vec<3, SimdDouble4>;

/// The rotations of segments, each alone, by the amplitudes of its branch; four segments at a time.
LITTORAL_SIMD_CLONES void Bend(const std::vector<BendingSegment>& segments, const double* rises, std::size_t modes,
  const Vector3* amplitudes, JointPose* poses)
{
  const std::size_t count = segments.size();
  for (std::size_t first = 0; first < count; first += LaneCount)
  {
    LaneIndices at;
    LaneIndices rise;
    LaneIndices amplitude;
    for (std::size_t lane = 0; lane < LaneCount; ++lane)
    {
      at[lane] = std::min(first + lane, count - 1);
      rise[lane] = modes * at[lane];
      amplitude[lane] = modes * static_cast<std::size_t>(segments[at[lane]].Branch);
    }
    const FourVectors along = GatherVector(segments.data(), at, &BendingSegment::Along);
    // a segment goes to d + sum over modes of Y_n (shape above - shape below)
    FourVectors bent = along;
    for (std::size_t mode = 0; mode < modes; ++mode)
    {
      const double* own = rises + mode;
      const Vector3* of = amplitudes + mode;
      bent += SimdDouble4(own[rise[0]], own[rise[1]], own[rise[2]], own[rise[3]]) *
        InLanes(of[amplitude[0]], of[amplitude[1]], of[amplitude[2]], of[amplitude[3]]);
    }
    const glm::qua<SimdDouble4> turn = RotationBetween(along, bent);
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      poses[segments[at[lane]].Joint].Rotation = LaneOf(turn, lane);
    }
  }
}

}

PlantMotion::PlantMotion(const Skeleton& rest, int numberOfModes, const std::vector<TrunkMode>& trunk)
  : Modes(numberOfModes)
  , Joints(rest.Nodes.size())
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
      this->Segments.push_back({ segment, node, index });
      for (int mode = 1; mode <= this->Modes; ++mode)
      {
        this->Rises.push_back(shape(mode, above) - shape(mode, below));
      }
      below = above;
    }
  }
}

void PlantMotion::Pose(const Vector3* amplitudes, JointPose* poses) const
{
  Bend(this->Segments, this->Rises.data(), static_cast<std::size_t>(this->Modes), amplitudes, poses);
  const BendingSegment* segment = this->Segments.data();
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
    for (int node = branch.First; node < tip; ++node, ++segment)
    {
      pose.Rotation = frame * poses[node].Rotation;
      poses[node] = pose;
      pose.Shift += RotationOffset(pose.Rotation, segment->Along);
    }
    poses[tip] = pose;
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
