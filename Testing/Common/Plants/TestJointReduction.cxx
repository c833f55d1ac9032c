// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Chains of joints whose turns are known.
#include "Numerics/Constants.h"
#include "Plants/JointReduction.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace littoral;

namespace
{

/// A straight chain along x, 1 m a joint, each with a box from itself to the next one.
JointTree Chain(int joints)
{
  JointTree tree;
  for (int joint = 0; joint < joints; ++joint)
  {
    JointTree::Box box;
    box.Add({ joint, -0.1, 0.0 });
    box.Add({ joint + 1.0, 0.1, 0.0 });
    tree.Parents.push_back(joint - 1);
    tree.Rests.emplace_back(joint, 0.0, 0.0);
    tree.Boxes.push_back(box);
  }
  return tree;
}

/// Each joint turned about z relative to its parent.
JointFrame Turned(const JointTree& tree, const std::vector<double>& angles)
{
  JointFrame frame;
  double angle = 0.0;
  Vector3 place{ 0.0, 0.0, 0.0 };
  for (std::size_t joint = 0; joint < tree.Parents.size(); ++joint)
  {
    angle += angles[joint];
    frame.Rotations.emplace_back(
      static_cast<float>(std::cos(0.5 * angle)), 0.0f, 0.0f, static_cast<float>(std::sin(0.5 * angle)));
    frame.Positions.emplace_back(place);
    place += Vector3(std::cos(angle), std::sin(angle), 0.0);
  }
  return frame;
}

/// Where the tracks take a place that follows a joint of the tree.
Vector3 Played(const JointTree& tree, const ReducedJoints& reduced, std::size_t frame, int joint, const Vector3& place)
{
  int kept = reduced.Follows[joint];
  Vector3 at = place - tree.Rests[reduced.Kept[kept]];
  for (; kept >= 0; kept = reduced.Parents[kept])
  {
    const JointTrack& track = reduced.Tracks[0][kept];
    const auto& q = track.Rotations[frame];
    const glm::dquat turn = glm::normalize(glm::dquat(q[3], q[0], q[1], q[2]));
    const int parent = reduced.Parents[kept];
    const Vector3 below = parent < 0 ? Vector3(0.0) : tree.Rests[reduced.Kept[parent]];
    const Vector3 offset =
      track.Translations.empty() ? tree.Rests[reduced.Kept[kept]] - below : Vector3(track.Translations[frame]);
    at = offset + turn * at;
  }
  return at;
}

}

TEST(JointReduction, KeepsWhatTurns)
{
  const JointTree tree = Chain(5);
  // joint 2 turns by a right angle, joint 4 by so little that its end goes by 0.5 mm
  const std::vector<JointFrame> frames = { Turned(tree, { 0.0, 0.0, 0.0, 0.0, 0.0 }),
    Turned(tree, { 0.0, 0.0, 0.5 * Pi, 0.0, 0.0005 }) };
  const ReducedJoints reduced = ReduceJoints(tree, { frames }, 0.001);
  EXPECT_EQ(reduced.Kept, (std::vector<int>{ 0, 2 }));
  EXPECT_EQ(reduced.Parents, (std::vector<int>{ -1, 0 }));
  EXPECT_EQ(reduced.Follows, (std::vector<int>{ 0, 0, 1, 1, 1 }));
  const Vector3 end = Played(tree, reduced, 1, 4, { 5.0, 0.0, 0.0 });
  EXPECT_NEAR(end.x, 2.0, 0.001);
  EXPECT_NEAR(end.y, 3.0, 0.001);
  EXPECT_EQ(ReduceJoints(tree, { frames }, 0.0).Kept.size(), 5u);
}

TEST(JointReduction, ErrorsStayBelowTheTolerance)
{
  constexpr int joints = 60;
  constexpr int samples = 20;
  const JointTree tree = Chain(joints);
  std::vector<JointFrame> frames;
  for (int sample = 0; sample < samples; ++sample)
  {
    std::vector<double> angles;
    for (int joint = 0; joint < joints; ++joint)
    {
      angles.push_back(0.01 * std::sin(0.7 * sample + 0.3 * joint) / (1.0 + joint % 7));
    }
    frames.push_back(Turned(tree, angles));
  }
  std::size_t last = joints + 1;
  for (const double tolerance : { 0.0005, 0.01, 0.2 })
  {
    const ReducedJoints reduced = ReduceJoints(tree, { frames }, tolerance);
    EXPECT_LT(reduced.Kept.size(), last);
    last = reduced.Kept.size();
    double worst = 0.0;
    for (int sample = 0; sample < samples; ++sample)
    {
      for (int joint = 0; joint < joints; ++joint)
      {
        const glm::dquat turn = glm::normalize(glm::dquat(frames[sample].Rotations[joint]));
        for (const double along : { 0.0, 0.5, 1.0 })
        {
          const Vector3 right = Vector3(frames[sample].Positions[joint]) + turn * Vector3(along, 0.1, 0.0);
          const Vector3 place = tree.Rests[joint] + Vector3(along, 0.1, 0.0);
          worst = std::max(worst, glm::length(Played(tree, reduced, sample, joint, place) - right));
        }
      }
    }
    EXPECT_LT(worst, tolerance + 2e-5) << reduced.Kept.size();
    EXPECT_GT(worst, 0.2 * tolerance) << "the tolerance is hardly used";
  }
}
