// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/JointReduction.h"

#include "Plants/SampledCurve.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

constexpr double Unit = 32767.0;  // of a part of a quaternion
constexpr double Rounding = 5e-5; // of positions in single precision [m]

/// Shares of the tolerance: what follows a joint that is left out may be off by the first one, and the foot of a joint
/// on another one by the second one.
constexpr double LeftOutShare = 0.85;
constexpr double FootShare = 0.15;

/// Frames from a sample to the next one that are tried, besides the first and last frame alone. Where twigs sway twice
/// a second, the best cubic curves over 6 of 24 frames a second are closer than the best lines over 2, and keep as
/// much.
constexpr int Strides[] = { 60, 40, 30, 24, 20, 17, 15, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2 };

/// Position and rotation of a joint.
struct Pose
{
  glm::dquat Rotation{ 1.0, 0.0, 0.0, 0.0 };
  Vector3 Position{ 0.0, 0.0, 0.0 };

  /// Place of a point at an offset from the joint at rest.
  Vector3 Of(const Vector3& offset) const { return this->Position + this->Rotation * offset; }
};

Pose PoseOf(const JointFrame& frame, int joint)
{
  return { glm::normalize(glm::dquat(frame.Rotations[joint])), Vector3(frame.Positions[joint]) };
}

/// Numbers from -1 to 1, beyond which there are none: a slope may be too steep for them.
std::array<std::int16_t, 4> Rounded(const glm::dvec4& numbers)
{
  const auto part = [](double number) {
    return static_cast<std::int16_t>(std::lround(std::clamp(number, -1.0, 1.0) * Unit));
  };
  return { part(numbers.x), part(numbers.y), part(numbers.z), part(numbers.w) };
}

glm::dvec4 NumbersOf(const std::array<std::int16_t, 4>& parts)
{
  return glm::dvec4(parts[0], parts[1], parts[2], parts[3]) / Unit;
}

glm::dvec4 NumbersOf(const glm::dquat& turn)
{
  return { turn.x, turn.y, turn.z, turn.w };
}

glm::dquat RotationOf(const glm::dvec4& numbers)
{
  return glm::normalize(glm::dquat(numbers.w, numbers.x, numbers.y, numbers.z));
}

/// The foot of a joint and the corners of its box: errors are affine in the place, so they are largest in a corner.
std::vector<Vector3> CornersOf(const JointTree& tree, int joint)
{
  const JointTree::Box& box = tree.Boxes[joint];
  std::vector<Vector3> corners = { tree.Rests[joint] };
  for (int corner = 0; corner < 8 && !box.IsEmpty(); ++corner)
  {
    corners.emplace_back(
      corner & 1 ? box.High.x : box.Low.x, corner & 2 ? box.High.y : box.Low.y, corner & 4 ? box.High.z : box.Low.z);
  }
  return corners;
}

//----------------------------------------------------------------------------
/// Whether a joint takes another one and its box to where they belong, in all frames of all plants.
bool IsCarried(const JointTree& tree, const std::vector<PlantFrames>& plants, int joint, int by)
{
  const std::vector<Vector3> corners = CornersOf(tree, joint);
  for (const PlantFrames& plant : plants)
  {
    const double tolerance = LeftOutShare * plant.Tolerance;
    for (const JointFrame& frame : plant.Frames)
    {
      const Pose right = PoseOf(frame, joint);
      const Pose carrier = PoseOf(frame, by);
      const bool isNear = std::all_of(corners.begin(), corners.end(), [&](const Vector3& corner) {
        return glm::length(right.Of(corner - tree.Rests[joint]) - carrier.Of(corner - tree.Rests[by])) <= tolerance;
      });
      if (!isNear)
      {
        return false;
      }
    }
  }
  return true;
}

/// Keeps joints one after the other where what follows them is not carried by those that are kept.
ReducedJoints ChooseJoints(const JointTree& tree, const std::vector<PlantFrames>& plants)
{
  const bool isExact =
    std::any_of(plants.begin(), plants.end(), [](const PlantFrames& plant) { return plant.Tolerance <= 0.0; });
  ReducedJoints result;
  for (int joint = 0; joint < static_cast<int>(tree.Parents.size()); ++joint)
  {
    const int parent = tree.Parents[joint];
    const int kept = parent < 0 ? -1 : result.Follows[parent];
    const bool isEnough = kept >= 0 && !isExact && IsCarried(tree, plants, joint, result.Kept[kept]);
    result.Follows.push_back(isEnough ? kept : static_cast<int>(result.Kept.size()));
    if (!isEnough)
    {
      result.Kept.push_back(joint);
      result.Parents.push_back(kept);
    }
  }
  return result;
}

/// Samplings that a track may have, those with the fewest numbers first.
std::vector<Sampling> SamplingsOf(int frames)
{
  std::vector<Sampling> samplings;
  const auto add = [&](int stride, bool isSmooth) {
    if (stride <= frames - 1 && CountOf({ stride, isSmooth }, frames) < frames)
    {
      samplings.push_back({ stride, isSmooth });
    }
  };
  for (const bool isSmooth : { false, true })
  {
    if (frames - 1 > Strides[0])
    {
      add(frames - 1, isSmooth);
    }
    for (const int stride : Strides)
    {
      add(stride, isSmooth);
    }
  }
  std::stable_sort(samplings.begin(), samplings.end(),
    [&](const Sampling& a, const Sampling& b) { return CountOf(a, frames) < CountOf(b, frames); });
  return samplings;
}

//----------------------------------------------------------------------------
/// A place that follows a kept joint, and where it belongs in each frame.
struct Probe
{
  Vector3 Offset;             // from the joint at rest
  bool IsFoot = false;        // of a kept joint that hangs on it
  std::vector<Vector3> Right; // of the frames
};

/// Samples the kept joints of a plant from the root to the tips, relative to where those below will be: errors do not
/// add up along a branch.
class JointSampler
{
public:
  JointSampler(const JointTree& tree, const ReducedJoints& joints, const PlantFrames& plant, double frameRate)
    : Tree(tree)
    , Joints(joints)
    , Frames(plant.Frames)
    , Samplings(SamplingsOf(static_cast<int>(plant.Frames.size())))
    , Tolerance(plant.Tolerance)
    , FrameRate(frameRate)
    , Followers(joints.Kept.size())
    , Children(joints.Kept.size())
  {
    for (std::size_t joint = 0; joint < joints.Follows.size(); ++joint)
    {
      this->Followers[joints.Follows[joint]].push_back(static_cast<int>(joint));
    }
    for (std::size_t kept = 0; kept < joints.Kept.size(); ++kept)
    {
      if (joints.Parents[kept] >= 0)
      {
        this->Children[joints.Parents[kept]].push_back(joints.Kept[kept]);
      }
    }
  }

  std::vector<JointTrack> Sample()
  {
    std::vector<JointTrack> tracks;
    for (int kept = 0; kept < static_cast<int>(this->Joints.Kept.size()); ++kept)
    {
      tracks.push_back(this->TrackOf(kept));
      this->Poses.push_back(this->Played(kept, tracks.back()));
    }
    return tracks;
  }

private:
  const JointTree& Tree;
  const ReducedJoints& Joints;
  const std::vector<JointFrame>& Frames;
  std::vector<Sampling> Samplings;
  double Tolerance;
  double FrameRate;
  std::vector<std::vector<int>> Followers; // joints of the tree that follow a kept one
  std::vector<std::vector<int>> Children;  // joints of the tree that are kept and hang on a kept one
  std::vector<std::vector<Pose>> Poses;    // of kept joints as they will be, by frames

  int FrameCount() const { return static_cast<int>(this->Frames.size()); }

  Pose Below(int kept, int frame) const
  {
    const int parent = this->Joints.Parents[kept];
    return parent < 0 ? Pose() : this->Poses[parent][frame];
  }

  /// The foot of a kept joint from that of the one that it hangs on, at rest.
  Vector3 Offset(int kept) const
  {
    const int parent = this->Joints.Parents[kept];
    const Vector3 below = parent < 0 ? Vector3(0.0) : this->Tree.Rests[this->Joints.Kept[parent]];
    return this->Tree.Rests[this->Joints.Kept[kept]] - below;
  }

  /// Motion of a joint relative to its parent, in all frames.
  struct Motion
  {
    std::vector<glm::dvec4> Turns;
    std::vector<glm::dvec4> Places;
  };

  Motion MotionOf(int kept) const
  {
    Motion motion;
    glm::dquat last{ 1.0, 0.0, 0.0, 0.0 };
    for (int frame = 0; frame < this->FrameCount(); ++frame)
    {
      const Pose right = PoseOf(this->Frames[frame], this->Joints.Kept[kept]);
      const Pose below = this->Below(kept, frame);
      const glm::dquat turn = glm::normalize(glm::conjugate(below.Rotation) * right.Rotation);
      last = glm::dot(turn, last) < 0.0 ? -turn : turn;
      motion.Turns.push_back(NumbersOf(last));
      motion.Places.emplace_back(glm::conjugate(below.Rotation) * (right.Position - below.Position), 0.0);
    }
    return motion;
  }

  /// Samples between which the motion is closest to the right one, in the sense of least squares.
  JointTrack Sampled(const Motion& motion, const Sampling& sampling, bool isHeld) const
  {
    JointTrack track;
    track.Stride = sampling.Stride;
    track.IsSmooth = sampling.IsSmooth;
    const auto isSlope = [&](std::size_t index) { return sampling.IsSmooth && index % 3 != 1; };
    const std::vector<glm::dvec4> turns = CurveThrough(motion.Turns, sampling);
    for (std::size_t index = 0; index < turns.size(); ++index)
    {
      track.Rotations.push_back(
        Rounded(isSlope(index) ? this->FrameRate * turns[index] : glm::normalize(turns[index])));
    }
    const std::vector<glm::dvec4> places = isHeld ? std::vector<glm::dvec4>() : CurveThrough(motion.Places, sampling);
    for (std::size_t index = 0; index < places.size(); ++index)
    {
      track.Translations.emplace_back(Vector3(isSlope(index) ? this->FrameRate * places[index] : places[index]));
    }
    return track;
  }

  /// The one turn between those of all frames, so that the joint need not move.
  JointTrack Still(int kept) const
  {
    glm::dquat sum{ 0.0, 0.0, 0.0, 0.0 };
    for (int frame = 0; frame < this->FrameCount(); ++frame)
    {
      const Pose right = PoseOf(this->Frames[frame], this->Joints.Kept[kept]);
      const glm::dquat turn = glm::conjugate(this->Below(kept, frame).Rotation) * right.Rotation;
      sum += glm::dot(turn, sum) < 0.0 ? -turn : turn;
    }
    JointTrack track;
    track.Rotations = { Rounded(NumbersOf(glm::normalize(sum))) };
    return track;
  }

  /// The samples of a track about a frame, those of what changes a second as changes a frame.
  template <typename Samples, typename Number>
  glm::dvec4 ValueAt(const JointTrack& track, const Samples& samples, int frame, const Number& numberOf) const
  {
    const int each = track.IsSmooth ? 3 : 1;
    const int first = each * std::min(frame / track.Stride, static_cast<int>(samples.size()) / each - 1);
    std::vector<glm::dvec4> near; // a sample and the next one
    for (int index = first; index < std::min(first + 2 * each, static_cast<int>(samples.size())); ++index)
    {
      const bool isSlope = track.IsSmooth && index % 3 != 1;
      near.push_back(numberOf(samples[index]) * (isSlope ? 1.0 / this->FrameRate : 1.0));
    }
    const int start = first / each * track.Stride;
    return CurveAt(near, { track.Stride, track.IsSmooth }, this->FrameCount() - start, frame - start);
  }

  /// Pose that a track gives a kept joint in a frame.
  Pose PoseAt(int kept, const JointTrack& track, int frame) const
  {
    const glm::dquat turn = this->TurnAt(track, frame);
    const Vector3 place = track.Translations.empty()
      ? this->Offset(kept)
      : Vector3(this->ValueAt(
          track, track.Translations, frame, [](const glm::vec3& sample) { return glm::dvec4(Vector3(sample), 0.0); }));
    const Pose below = this->Below(kept, frame);
    return { glm::normalize(below.Rotation * turn), below.Of(place) };
  }

  /// The shortest turn between two samples of lines; the curve itself, with the length 1, of cubic ones.
  glm::dquat TurnAt(const JointTrack& track, int frame) const
  {
    const auto numbers = [](const std::array<std::int16_t, 4>& parts) { return NumbersOf(parts); };
    const std::size_t last = track.Rotations.size() - 1;
    const std::size_t before = std::min(static_cast<std::size_t>(frame / track.Stride), last);
    if (track.IsSmooth || last == 0)
    {
      return RotationOf(
        last == 0 ? numbers(track.Rotations[0]) : this->ValueAt(track, track.Rotations, frame, numbers));
    }
    const std::size_t after = std::min(before + 1, last);
    const int first = static_cast<int>(before) * track.Stride;
    const int length = std::min(track.Stride, this->FrameCount() - 1 - first);
    const double share = before == after || length <= 0 ? 0.0 : static_cast<double>(frame - first) / length;
    return glm::slerp(RotationOf(numbers(track.Rotations[before])), RotationOf(numbers(track.Rotations[after])), share);
  }

  std::vector<Pose> Played(int kept, const JointTrack& track) const
  {
    std::vector<Pose> poses;
    poses.reserve(this->Frames.size());
    for (int frame = 0; frame < this->FrameCount(); ++frame)
    {
      poses.push_back(this->PoseAt(kept, track, frame));
    }
    return poses;
  }

  /// All that follows a kept joint.
  std::vector<Probe> ProbesOf(int kept) const
  {
    const Vector3 rest = this->Tree.Rests[this->Joints.Kept[kept]];
    std::vector<Probe> probes;
    const auto add = [&](int joint, const Vector3& place, bool isFoot) {
      Probe probe{ place - rest, isFoot, {} };
      for (const JointFrame& frame : this->Frames)
      {
        probe.Right.push_back(PoseOf(frame, joint).Of(place - this->Tree.Rests[joint]));
      }
      probes.push_back(std::move(probe));
    };
    for (const int joint : this->Followers[kept])
    {
      for (const Vector3& corner : CornersOf(this->Tree, joint))
      {
        add(joint, corner, false);
      }
    }
    for (const int joint : this->Children[kept])
    {
      add(joint, this->Tree.Rests[joint], true);
    }
    return probes;
  }

  /// Maximum errors of a track at the probes.
  std::vector<double> ErrorsOf(const std::vector<Probe>& probes, const std::vector<Pose>& poses) const
  {
    std::vector<double> errors;
    for (const Probe& probe : probes)
    {
      double most = 0.0;
      for (int frame = 0; frame < this->FrameCount(); ++frame)
      {
        most = std::max(most, glm::length(poses[frame].Of(probe.Offset) - probe.Right[frame]));
      }
      errors.push_back(most);
    }
    return errors;
  }

  bool IsGood(
    int kept, const std::vector<Probe>& probes, const std::vector<double>& limits, const JointTrack& track) const
  {
    for (int frame = 0; frame < this->FrameCount(); ++frame)
    {
      const Pose pose = this->PoseAt(kept, track, frame);
      for (std::size_t probe = 0; probe < probes.size(); ++probe)
      {
        if (glm::length(pose.Of(probes[probe].Offset) - probes[probe].Right[frame]) > limits[probe])
        {
          return false;
        }
      }
    }
    return true;
  }

  /// As few samples as the tolerance allows.
  JointTrack TrackOf(int kept) const
  {
    const std::vector<Probe> probes = this->ProbesOf(kept);
    const double tolerance = std::max(this->Tolerance, Rounding);
    const Motion motion = this->MotionOf(kept);
    JointTrack track = this->Sampled(motion, {}, true);
    std::vector<double> errors = this->ErrorsOf(probes, this->Played(kept, track));
    bool isHeld = true;
    for (std::size_t probe = 0; probe < probes.size(); ++probe)
    {
      isHeld = isHeld && (probes[probe].IsFoot || errors[probe] <= tolerance);
    }
    if (!isHeld)
    {
      track = this->Sampled(motion, {}, false);
      errors = this->ErrorsOf(probes, this->Played(kept, track));
    }
    if (this->Tolerance <= 0.0)
    {
      return track;
    }
    // What all samples cannot mend is no reason to take more of them.
    std::vector<double> limits;
    for (std::size_t probe = 0; probe < probes.size(); ++probe)
    {
      const double own = probes[probe].IsFoot ? FootShare * tolerance : tolerance;
      limits.push_back(std::max(own, errors[probe] + (probes[probe].IsFoot ? 0.04 * tolerance : 0.0)));
    }
    if (isHeld && this->IsGood(kept, probes, limits, this->Still(kept)))
    {
      return this->Still(kept);
    }
    for (const Sampling& sampling : this->Samplings)
    {
      const JointTrack fewer = this->Sampled(motion, sampling, isHeld);
      if (this->IsGood(kept, probes, limits, fewer))
      {
        return fewer;
      }
    }
    return track;
  }
};

}

//----------------------------------------------------------------------------
void JointTree::Box::Add(const Vector3& place)
{
  const bool isFirst = this->IsEmpty();
  this->Low = isFirst ? place : glm::min(this->Low, place);
  this->High = isFirst ? place : glm::max(this->High, place);
}

//----------------------------------------------------------------------------
ReducedJoints ReduceJoints(
  const JointTree& tree, const std::vector<PlantFrames>& plants, double frameRate, const ParallelFor& parallelFor)
{
  ReducedJoints result = ChooseJoints(tree, plants);
  result.Tracks.resize(plants.size());
  parallelFor(plants.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t plant = begin; plant < end; ++plant)
    {
      result.Tracks[plant] = JointSampler(tree, result, plants[plant], frameRate).Sample();
    }
  });
  return result;
}

}
