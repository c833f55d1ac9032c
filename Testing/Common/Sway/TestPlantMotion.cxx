// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/RandomStream.h"
#include "Plants/BranchSkin.h"
#include "Plants/ReevesTree.h"
#include "Sway/BeamModes.h"
#include "Sway/PlantMotion.h"
#include "Sway/TrunkSkin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

using namespace littoral;

namespace
{

Skeleton Oak()
{
  return GrowReevesTree(PresetParameters(TreePreset::Oak)).Wood;
}

/// Random amplitudes at right angles to the branches, as parts of their lengths.
std::vector<Vector3> RandomAmplitudes(const Skeleton& plant, int modes, double part)
{
  const RandomStream random(4, RandomPurpose::QuadratPositions);
  std::vector<Vector3> amplitudes;
  for (int branch = 0; branch < static_cast<int>(plant.Branches.size()); ++branch)
  {
    const Vector3 axis = BranchAxis(plant, branch);
    for (int mode = 0; mode < modes; ++mode)
    {
      const auto a = random.NormalPair(branch, 2 * mode);
      const auto b = random.NormalPair(branch, 2 * mode + 1);
      const Vector3 any = part * plant.BranchLength(branch) * Vector3(a[0], a[1], b[0]);
      amplitudes.push_back(any - glm::dot(any, axis) * axis);
    }
  }
  return amplitudes;
}

std::vector<JointPose> PosesOf(const PlantMotion& motion, const std::vector<Vector3>& amplitudes)
{
  std::vector<JointPose> poses(motion.GetNumberOfJoints());
  motion.Pose(amplitudes.data(), poses.data());
  return poses;
}

std::vector<JointChange> ChangesOf(const Skeleton& rest, const std::vector<JointPose>& poses)
{
  std::vector<JointChange> changes;
  for (std::size_t node = 0; node < poses.size(); ++node)
  {
    changes.push_back(ChangeOf(poses[node], rest.Nodes[node].Position));
  }
  return changes;
}

/// Numbers of a list of vectors as MoveSkin takes them.
template <typename Tuple>
std::vector<float> Floats(const std::vector<Tuple>& tuples)
{
  std::vector<float> numbers;
  for (const Tuple& tuple : tuples)
  {
    for (std::size_t i = 0; i < sizeof(Tuple) / sizeof(double); ++i)
    {
      numbers.push_back(static_cast<float>(tuple[static_cast<int>(i)]));
    }
  }
  return numbers;
}

/// Points and normals of a mesh in single precision, as they are drawn.
struct FloatSkin
{
  explicit FloatSkin(const PlantMesh& mesh)
    : Points(Floats(mesh.Points))
    , Normals(Floats(mesh.Normals))
  {
  }

  std::vector<float> Points;
  std::vector<float> Normals;
};

FloatSkin MovedSkin(const PlantMesh& mesh, const std::vector<JointChange>& changes)
{
  const FloatSkin rest(mesh);
  const std::vector<float> weights = Floats(mesh.JointWeights);
  FloatSkin moved = rest;
  const SkinBinding binding(mesh.JointIds[0].data(), weights.data(), mesh.Points.size());
  MoveSkin({ rest.Points.data(), rest.Normals.data() }, binding, changes.data(), 0, mesh.Points.size(),
    moved.Points.data(), moved.Normals.data());
  return moved;
}

Vector3 VectorAt(const std::vector<float>& numbers, std::size_t vertex)
{
  return { numbers[3 * vertex], numbers[3 * vertex + 1], numbers[3 * vertex + 2] };
}

/// A straight trunk along z in equal segments.
Skeleton Mast(int segments, double length)
{
  Skeleton mast;
  mast.StartBranch(-1, { 0.0, 0.0, 0.0 }, 0.1);
  for (int i = 1; i <= segments; ++i)
  {
    mast.Grow({ 0.0, 0.0, length * i / segments }, 0.1);
  }
  return mast;
}

}

TEST(PlantMotion, NoWindIsTheRestPoseExactly)
{
  const Skeleton rest = Oak();
  const PlantMotion motion(rest, 3);
  const std::vector<JointPose> poses =
    PosesOf(motion, std::vector<Vector3>(3 * motion.GetNumberOfBranches(), Vector3(0.0)));
  const Skeleton moved = Moved(rest, poses);
  for (std::size_t node = 0; node < rest.Nodes.size(); ++node)
  {
    EXPECT_EQ(std::memcmp(&rest.Nodes[node].Position, &moved.Nodes[node].Position, sizeof(Vector3)), 0);
  }
  const PlantMesh skin = SkinOf(rest, {});
  const FloatSkin still = MovedSkin(skin, ChangesOf(rest, poses));
  EXPECT_EQ(still.Points, FloatSkin(skin).Points);
  EXPECT_EQ(still.Normals, FloatSkin(skin).Normals);
}

TEST(PlantMotion, SegmentsKeepTheirLengths)
{
  const Skeleton rest = Oak();
  for (const double part : { 0.01, 0.3, 5.0 })
  {
    const PlantMotion motion(rest, 2);
    const Skeleton moved = Moved(rest, PosesOf(motion, RandomAmplitudes(rest, 2, part)));
    double worst = 0.0;
    double farthest = 0.0;
    for (std::size_t node = 0; node < rest.Nodes.size(); ++node)
    {
      const int parent = rest.Nodes[node].Parent;
      farthest = std::max(farthest, glm::distance(rest.Nodes[node].Position, moved.Nodes[node].Position));
      if (parent >= 0)
      {
        const double before = glm::distance(rest.Nodes[node].Position, rest.Nodes[parent].Position);
        const double after = glm::distance(moved.Nodes[node].Position, moved.Nodes[parent].Position);
        worst = std::max(worst, std::abs(after - before) / std::max(before, 1e-3));
      }
    }
    std::printf("amplitudes of %g lengths: a node goes %.3g m, lengths change by %.3g\n", part, farthest, worst);
    EXPECT_LT(worst, 1e-6);
    EXPECT_GT(farthest, part);
    EXPECT_EQ(WhyInvalid(moved), "");
  }
}

TEST(PlantMotion, FollowsTheModeShapes)
{
  const double length = 3.0;
  const Skeleton mast = Mast(200, length);
  for (int mode = 1; mode <= MaximumModes; ++mode)
  {
    const PlantMotion motion(mast, mode);
    std::vector<Vector3> amplitudes(mode, Vector3(0.0));
    const double amplitude = 1e-6;
    amplitudes[mode - 1] = { amplitude, 0.0, 0.0 };
    const Skeleton moved = Moved(mast, PosesOf(motion, amplitudes));
    double worst = 0.0;
    for (int i = 0; i <= 200; ++i)
    {
      worst = std::max(worst, std::abs(moved.Nodes[i].Position.x / amplitude - ModeShape(mode, i / 200.0)));
    }
    EXPECT_LT(worst, 1e-6) << "mode " << mode;
  }
}

TEST(PlantMotion, ChildrenMoveWithTheirParents)
{
  Skeleton rest = Mast(4, 4.0);
  rest.StartBranch(2, { 0.0, 0.0, 2.5 }, 0.05);
  rest.Grow({ 1.0, 0.3, 3.0 }, 0.04);
  const int end = rest.Grow({ 2.0, 0.5, 3.2 }, 0.03);
  rest.StartBranch(end, { 2.0, 0.5, 3.2 }, 0.02);
  rest.Grow({ 2.2, 1.0, 3.5 }, 0.01);
  const PlantMotion motion(rest, 1);
  const std::vector<JointPose> poses = PosesOf(motion, { { 0.4, -0.2, 0.0 }, Vector3(0.0), Vector3(0.0) });
  const Skeleton moved = Moved(rest, poses);
  // All that grows on the third segment moves as a rigid body with it.
  for (std::size_t a = 5; a < rest.Nodes.size(); ++a)
  {
    const Vector3 before = rest.Nodes[a].Position - rest.Nodes[2].Position;
    const Vector3 after = moved.Nodes[a].Position - moved.Nodes[2].Position;
    EXPECT_NEAR(glm::distance(after, before + RotationOffset(poses[2].Rotation, before)), 0.0, 1e-12);
    EXPECT_NEAR(std::abs(glm::dot(poses[a].Rotation, poses[2].Rotation)), 1.0, 1e-12);
  }
}

TEST(PlantMotion, EnvelopesGoWithTheTrunk)
{
  // A trunk with a bend and a branch: vertices on the trunk go with it, those around it turn with its segments, and the
  // branch is not asked.
  Skeleton plant;
  plant.StartBranch(-1, { 1.0, 2.0, 3.0 }, 0.2);
  for (int i = 1; i <= 6; ++i)
  {
    plant.Grow({ 1.0 + 0.05 * i * i, 2.0, 3.0 + i }, 0.2);
  }
  plant.StartBranch(3, plant.Nodes[3].Position, 0.05);
  plant.Grow(plant.Nodes[3].Position + Vector3(0.0, 2.0, 0.0), 0.05);
  const Skeleton trunk = TrunkAlone(plant);
  ASSERT_EQ(WhyInvalid(trunk), "");
  ASSERT_EQ(trunk.Nodes.size(), 7u);
  std::vector<JointPose> poses(7);
  const Vector3 amplitude(0.1, 0.4, 0.0);
  PlantMotion(trunk, 1).Pose(&amplitude, poses.data());
  std::vector<JointPose> whole(plant.Nodes.size());
  const Vector3 both[2] = { amplitude, Vector3(0.0, 0.0, 0.3) };
  PlantMotion(plant, 1).Pose(both, whole.data());
  std::vector<JointChange> changes;
  for (int node = 0; node < 7; ++node)
  {
    EXPECT_EQ(whole[node].Shift, poses[node].Shift); // that of the plant in full
    changes.push_back(ChangeOf(poses[node], trunk.Nodes[node].Position));
  }
  const TrunkSkin skin(trunk);
  const auto moved = [&](const Vector3& position) {
    const JointHold hold = skin.At(position);
    EXPECT_NEAR(hold.Weights[0] + hold.Weights[1] + hold.Weights[2] + hold.Weights[3], 1.0, 1e-7);
    Vector3 to = position;
    for (int i = 0; i < 4; ++i)
    {
      const JointChange& change = changes[hold.Joints[i]];
      to += static_cast<double>(hold.Weights[i]) * change.Of(position);
    }
    return to;
  };
  double worst = 0.0;
  double turned = 0.0;
  for (int node = 1; node < 7; ++node)
  {
    const Vector3 position = trunk.Nodes[node].Position;
    worst = std::max(worst, glm::distance(moved(position), position + poses[node].Shift));
    const double across = glm::distance(moved(position + Vector3(0.0, 3.0, 0.0)), moved(position));
    turned = std::max(turned, std::abs(across - 3.0));
  }
  std::printf("vertices on the trunk miss it by %.3g m of a sway of %.3g m; an envelope stretches by %.3g\n", worst,
    glm::length(poses[6].Shift), turned / 3.0);
  EXPECT_LT(worst, 0.02);
  EXPECT_LT(turned / 3.0, 0.05);
  const JointHold foot = skin.At({ 1.0, 2.0, -5.0 });
  const JointHold top = skin.At({ 3.0, 2.0, 50.0 });
  EXPECT_EQ(foot.Joints[0], 0);
  EXPECT_EQ(top.Joints[0], 5);
  // Nearby vertices do not part.
  for (double z = 2.0; z < 11.0; z += 0.01)
  {
    EXPECT_LT(glm::distance(moved({ 2.0, 1.0, z + 0.01 }), moved({ 2.0, 1.0, z })), 0.02);
  }
}

// Segments by segments, one after the other: several at a time give the same bytes.
TEST(PlantMotion, PosesAreThoseOfSegmentsOneByOne)
{
  const Skeleton rest = Oak();
  const int modes = 2;
  std::vector<Vector3> amplitudes = RandomAmplitudes(rest, modes, 0.3);
  amplitudes[2 * modes] = amplitudes[2 * modes + 1] = Vector3(0.0);
  const std::vector<JointPose> poses = PosesOf(PlantMotion(rest, modes), amplitudes);
  for (int index = 0; index < static_cast<int>(rest.Branches.size()); ++index)
  {
    const SkeletonBranch& branch = rest.Branches[index];
    const int parent = rest.Nodes[branch.First].Parent;
    const glm::dquat frame = parent < 0 ? glm::dquat(1.0, 0.0, 0.0, 0.0) : poses[parent].Rotation;
    double place = 0.0;
    for (int node = branch.First; node < rest.Tip(index); ++node)
    {
      const Vector3 segment = rest.Nodes[node + 1].Position - rest.Nodes[node].Position;
      const double next = std::min(1.0, place + glm::length(segment) / rest.BranchLength(index));
      Vector3 bent = segment;
      for (int mode = 1; mode <= modes; ++mode)
      {
        bent += (ModeShape(mode, next) - ModeShape(mode, place)) * amplitudes[modes * index + mode - 1];
      }
      EXPECT_EQ(poses[node].Rotation, frame * RotationBetween(segment, bent));
      EXPECT_EQ(poses[node + 1].Shift, poses[node].Shift + RotationOffset(poses[node].Rotation, segment));
      place = next;
    }
  }
}

// Opposite directions have an axis all the same, in any lane.
TEST(PlantMotion, SegmentsTurnBack)
{
  const Skeleton mast = Mast(5, 5.0);
  const PlantMotion motion(mast, 1);
  for (int node = 0; node < 5; ++node)
  {
    const double rise = ModeShape(1, (node + 1) / 5.0) - ModeShape(1, node / 5.0);
    const JointPose pose = PosesOf(motion, { { 0.0, 0.0, -2.0 / rise } })[node];
    EXPECT_NEAR(glm::distance(Rotated(pose.Rotation, Vector3(0.0, 0.0, 1.0)), Vector3(0.0, 0.0, -1.0)), 0.0, 1e-9);
  }
}

TEST(PlantMotion, RotationsBetweenDirections)
{
  const RandomStream random(9, RandomPurpose::QuadratCounts);
  for (int i = 0; i < 200; ++i)
  {
    const auto a = random.NormalPair(i, 0);
    const auto b = random.NormalPair(i, 1);
    const auto c = random.NormalPair(i, 2);
    const Vector3 from{ a[0], a[1], b[0] };
    const Vector3 to{ b[1], c[0], c[1] };
    const glm::dquat q = RotationBetween(from, to);
    EXPECT_NEAR(glm::length(q), 1.0, 1e-14);
    EXPECT_NEAR(glm::dot(Normalised(from + RotationOffset(q, from)), Normalised(to)), 1.0, 1e-14);
    const Vector3 back = from + RotationOffset(RotationBetween(from, -from), from);
    EXPECT_NEAR(glm::distance(back, -from), 0.0, 1e-12);
    const JointChange change = ChangeOf({ q, to }, from);
    const Vector3 expected = (from + to) + RotationOffset(q, c[0] * to - from);
    // In single precision: an epsilon of the distance from the joint and one of its shift.
    const double size = glm::distance(c[0] * to, from) + glm::length(to);
    EXPECT_LT(glm::distance(c[0] * to + change.Of(c[0] * to), expected + c[0] * to - from),
      std::numeric_limits<float>::epsilon() * size);
  }
}

TEST(PlantMotion, SkinLiesAroundTheMovedJoints)
{
  const Skeleton rest = Mast(20, 4.0);
  const PlantMesh skin = SkinOf(rest, {});
  const PlantMotion motion(rest, 1);
  const std::vector<JointPose> poses = PosesOf(motion, { { 0.5, 0.0, 0.0 } });
  const FloatSkin bent = MovedSkin(skin, ChangesOf(rest, poses));
  const Skeleton moved = Moved(rest, poses);
  const int ring = 13;
  double worst = 0.0;
  const std::size_t rings = ring * rest.Nodes.size(); // then come the tip, and the end at the foot
  for (std::size_t vertex = 0; vertex < rings; ++vertex)
  {
    const Vector3& joint = moved.Nodes[vertex / ring].Position;
    const Vector3 point = VectorAt(bent.Points, vertex);
    const Vector3 normal = VectorAt(bent.Normals, vertex);
    worst = std::max(worst, std::abs(glm::distance(point, joint) / 0.1 - 1.0));
    // In single precision: rounded at rest, turned, and given its length.
    EXPECT_NEAR(glm::length(normal), 1.0, 4.0 * std::numeric_limits<float>::epsilon());
    EXPECT_GT(glm::dot(normal, (point - joint) / 0.1), 0.99);
  }
  std::printf("the skin's distance from the bent mast changes by %.3g\n", worst);
  EXPECT_LT(worst, 0.01);
}
