// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/JointReduction.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double Unit = 32767.0;  // of a part of a quaternion
constexpr double Rounding = 5e-5; // of positions in single precision [m]

/// Where a joint is.
struct Pose
{
  glm::dquat Rotation{ 1.0, 0.0, 0.0, 0.0 };
  Vector3 Position{ 0.0, 0.0, 0.0 };

  /// Where it takes a place that is at an offset from it at rest.
  Vector3 Of(const Vector3& offset) const { return this->Position + this->Rotation * offset; }
};

Pose PoseOf(const JointFrame& frame, int joint)
{
  return { glm::normalize(glm::dquat(frame.Rotations[joint])), Vector3(frame.Positions[joint]) };
}

std::array<std::int16_t, 4> Rounded(const glm::dquat& turn)
{
  const auto part = [](double number) { return static_cast<std::int16_t>(std::lround(number * Unit)); };
  return { part(turn.x), part(turn.y), part(turn.z), part(turn.w) };
}

glm::dquat RotationOf(const std::array<std::int16_t, 4>& parts)
{
  return glm::normalize(glm::dquat(parts[3] / Unit, parts[0] / Unit, parts[1] / Unit, parts[2] / Unit));
}

/// Keeps joints one after the other, and knows where those that are kept will be.
class Reduction
{
public:
  Reduction(const JointTree& tree, const std::vector<std::vector<JointFrame>>& plants, double tolerance)
    : Tree(tree)
    , Plants(plants)
    , Tolerance(tolerance)
    , Frames(plants.empty() ? 0 : plants[0].size())
  {
    this->Result.Tracks.resize(plants.size());
  }

  ReducedJoints Reduce()
  {
    for (int joint = 0; joint < static_cast<int>(this->Tree.Parents.size()); ++joint)
    {
      const int parent = this->Tree.Parents[joint];
      const int kept = parent < 0 ? -1 : this->Result.Follows[parent];
      const bool isEnough = kept >= 0 && this->Tolerance > 0.0 && this->IsCarriedBy(joint, kept);
      if (!isEnough)
      {
        this->Keep(joint, kept);
      }
      this->Result.Follows.push_back(isEnough ? kept : static_cast<int>(this->Result.Kept.size()) - 1);
    }
    return std::move(this->Result);
  }

private:
  const JointTree& Tree;
  const std::vector<std::vector<JointFrame>>& Plants;
  double Tolerance;
  std::size_t Frames;
  ReducedJoints Result;
  std::vector<std::vector<Pose>> Poses; // of kept joints as they will be, by plants and frames

  Vector3 RestOf(int kept) const { return this->Tree.Rests[this->Result.Kept[kept]]; }

  /// Whether a kept joint takes the box of another one, and its foot, to where they belong.
  bool IsCarriedBy(int joint, int kept) const
  {
    const Vector3 own = this->Tree.Rests[joint];
    const Vector3 other = this->RestOf(kept);
    const JointTree::Box& box = this->Tree.Boxes[joint];
    std::vector<Vector3> corners = { own };
    for (int corner = 0; corner < 8 && !box.IsEmpty(); ++corner)
    {
      corners.emplace_back(
        corner & 1 ? box.High.x : box.Low.x, corner & 2 ? box.High.y : box.Low.y, corner & 4 ? box.High.z : box.Low.z);
    }
    // The error is an affine function of the place, so that it is largest in a corner.
    for (std::size_t plant = 0; plant < this->Plants.size(); ++plant)
    {
      for (std::size_t frame = 0; frame < this->Frames; ++frame)
      {
        const Pose right = PoseOf(this->Plants[plant][frame], joint);
        const Pose& carrier = this->Poses[kept][plant * this->Frames + frame];
        for (const Vector3& corner : corners)
        {
          if (glm::length(right.Of(corner - own) - carrier.Of(corner - other)) > this->Tolerance)
          {
            return false;
          }
        }
      }
    }
    return true;
  }

  /// The tracks of a joint are relative to where the kept one will be, so that errors do not add up.
  void Keep(int joint, int kept)
  {
    const Vector3 rest = this->Tree.Rests[joint];
    std::vector<Pose> poses;
    poses.reserve(this->Plants.size() * this->Frames);
    for (std::size_t plant = 0; plant < this->Plants.size(); ++plant)
    {
      JointTrack track;
      bool isHeld = true;
      for (std::size_t frame = 0; frame < this->Frames; ++frame)
      {
        const Pose right = PoseOf(this->Plants[plant][frame], joint);
        const Pose below = kept < 0 ? Pose() : this->Poses[kept][plant * this->Frames + frame];
        const Vector3 foot = kept < 0 ? Vector3(0.0) : this->RestOf(kept);
        track.Rotations.push_back(Rounded(glm::normalize(glm::conjugate(below.Rotation) * right.Rotation)));
        track.Translations.emplace_back(glm::conjugate(below.Rotation) * (right.Position - below.Position));
        isHeld =
          isHeld && glm::length(right.Position - below.Of(rest - foot)) <= std::max(Rounding, 0.25 * this->Tolerance);
        poses.push_back({ below.Rotation * RotationOf(track.Rotations.back()), right.Position });
      }
      if (isHeld)
      {
        track.Translations.clear();
        for (std::size_t frame = 0; frame < this->Frames; ++frame)
        {
          const Vector3 foot = kept < 0 ? Vector3(0.0) : this->RestOf(kept);
          const Pose below = kept < 0 ? Pose() : this->Poses[kept][plant * this->Frames + frame];
          poses[plant * this->Frames + frame].Position = below.Of(rest - foot);
        }
      }
      this->Result.Tracks[plant].push_back(std::move(track));
    }
    this->Result.Kept.push_back(joint);
    this->Result.Parents.push_back(kept);
    this->Poses.push_back(std::move(poses));
  }
};

}

void JointTree::Box::Add(const Vector3& place)
{
  const bool isFirst = this->IsEmpty();
  this->Low = isFirst ? place : glm::min(this->Low, place);
  this->High = isFirst ? place : glm::max(this->High, place);
}

ReducedJoints ReduceJoints(const JointTree& tree, const std::vector<std::vector<JointFrame>>& plants, double tolerance)
{
  return Reduction(tree, plants, tolerance).Reduce();
}

}
