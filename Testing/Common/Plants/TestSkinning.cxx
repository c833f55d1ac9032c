// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Skins of joints whose turns are known.
#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"
#include "Plants/RigidSkinning.h"
#include "Plants/Skinning.h"
#include "Plants/StandBinding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>
#include <vector>

using namespace littoral;

namespace
{

/// A turn about the vertical through a place, which moves by a shift.
JointPose TurnedBy(double angle, const Vector3& shift)
{
  return { { std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle) }, shift };
}

/// The ranges of vectors, found one number at a time.
void ExpectRangesOf(const std::vector<float>& vectors, const VectorRangeSum& sum)
{
  const VectorRange range = sum.Range();
  double shortest = 1e300;
  double longest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    float low = 1e30f;
    float high = -1e30f;
    for (std::size_t i = 0; i < vectors.size(); i += 3)
    {
      low = std::min(low, vectors[i + axis]);
      high = std::max(high, vectors[i + axis]);
      const double square = glm::dot(
        Vector3(vectors[i], vectors[i + 1], vectors[i + 2]), Vector3(vectors[i], vectors[i + 1], vectors[i + 2]));
      shortest = std::min(shortest, square);
      longest = std::max(longest, square);
    }
    EXPECT_EQ(range.Low[axis], low);
    EXPECT_EQ(range.High[axis], high);
  }
  EXPECT_DOUBLE_EQ(range.MinimumSquare, shortest);
  EXPECT_DOUBLE_EQ(range.MaximumSquare, longest);
  EXPECT_TRUE(range.IsFinite);
}

}

TEST(Skinning, AJointTurnsAboutItsPlace)
{
  const Vector3 rest{ 2.0, 1.0, 5.0 };
  const Vector3 shift{ 0.5, -0.25, 1.0 };
  const JointChange change = ChangeOf(TurnedBy(0.5 * Pi, shift), rest);
  const Vector3 own = change.Of(rest);
  const Vector3 east = change.Of(rest + Vector3(3.0, 0.0, 2.0)); // goes to the north
  const Vector3 wanted = shift + Vector3(-3.0, 3.0, 0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(own[axis], shift[axis], 1e-6);
    EXPECT_NEAR(east[axis], wanted[axis], 1e-6);
  }
}

// Half of a turn to the left and half of one to the right: a place is drawn in by the cosine, a normal keeps its
// length.
TEST(Skinning, NormalsOfBlendedTurnsKeepTheirLengths)
{
  const int count = 100; // more than are stored at once
  std::vector<float> points;
  std::vector<float> normals;
  std::vector<int> ids;
  std::vector<float> weights;
  for (int n = 0; n < count; ++n)
  {
    points.insert(points.end(), { 1.0f, 0.0f, static_cast<float>(n) });
    normals.insert(normals.end(), { n % 2 ? 1.0f : 2.0f, 0.0f, 0.0f });
    ids.insert(ids.end(), { 0, 1, 0, 0 });
    weights.insert(weights.end(), { 0.5f, 0.5f, 0.0f, 0.0f });
  }
  const double angle = Pi / 3.0;
  const std::vector<JointChange> joints{ ChangeOf(TurnedBy(angle, Vector3(0.0)), Vector3(0.0)),
    ChangeOf(TurnedBy(-angle, Vector3(0.0)), Vector3(0.0)) };
  std::vector<float> movedPoints(points.size());
  std::vector<float> movedNormals(normals.size());
  MoveSkin({ points.data(), normals.data() }, { ids.data(), weights.data(), count }, joints.data(), 0, count,
    movedPoints.data(), movedNormals.data());
  for (int n = 0; n < count; ++n)
  {
    EXPECT_NEAR(movedPoints[3 * n], 0.5, 1e-6);
    EXPECT_NEAR(movedPoints[3 * n + 1], 0.0, 1e-6);
    EXPECT_NEAR(movedPoints[3 * n + 2], n, 1e-5);
    EXPECT_NEAR(movedNormals[3 * n], n % 2 ? 1.0 : 2.0, 1e-6);
    EXPECT_NEAR(movedNormals[3 * n + 1], 0.0, 1e-6);
  }
}

namespace
{

/// Joints that lie in a row and turn and go at random, and a skin whose vertices follow one to four of them: some as
/// their neighbours do, some with weights and some with joints of their own.
struct RandomSkin
{
  static constexpr int Joints = 40;
  static constexpr int Vertices = 1001;
  std::vector<JointPose> Poses;
  std::vector<Vector3> Places;
  std::vector<JointChange> Changes;
  std::vector<float> Points, Normals, Weights;
  std::vector<int> Ids;

  explicit RandomSkin(const Vector3& origin)
  {
    const RandomStream random(7, RandomPurpose::QuadratPositions);
    for (int joint = 0; joint < Joints; ++joint)
    {
      const auto a = random.NormalPair(joint, 0);
      const auto b = random.NormalPair(joint, 1);
      this->Poses.push_back(
        { glm::normalize(glm::dquat(1.0, 0.3 * a[0], 0.3 * a[1], 0.3 * b[0])), { a[0], b[1], a[1] } });
      this->Places.push_back(origin + Vector3(0.1 * joint, 0.2 * b[0], 0.2 * b[1]));
      this->Changes.push_back(ChangeOf(this->Poses.back(), this->Places.back()));
    }
    for (int vertex = 0; vertex < Vertices; ++vertex)
    {
      const int ring = vertex / 7; // of seven vertices, so that pairs lie across its ends
      const int joint = ring % (Joints - 4);
      const int used = 1 + ring % 4;
      const auto own = random.UniformPair(vertex, 2);
      std::vector<double> weights{ 1.0, 1.0, 1.0, 1.0 };
      weights[1] = ring % 3 == 0 ? own[0] : 0.5;
      std::fill(weights.begin() + used, weights.end(), 0.0);
      for (int i = 0; i < 4; ++i)
      {
        this->Ids.push_back(i < used ? joint + i : 0);
        this->Weights.push_back(static_cast<float>(weights[i] / (weights[0] + weights[1] + weights[2] + weights[3])));
      }
      const auto b = random.NormalPair(vertex, 3);
      const Vector3 point = this->Places[joint] + Vector3(0.1 * b[0], 0.1 * b[1], 0.3 * own[1]);
      const Vector3 normal = Normalised(Vector3(b[0], b[1], own[0]));
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Points.push_back(static_cast<float>(point[axis]));
        this->Normals.push_back(static_cast<float>(normal[axis]));
      }
    }
  }

  RestSkin Rest() const { return { this->Points.data(), this->Normals.data() }; }

  SkinBinding Binding() const { return { this->Ids.data(), this->Weights.data(), Vertices }; }

  /// Linear blend skinning in double precision, by its definition.
  Vector3 PointAt(int vertex) const
  {
    const Vector3 p(this->Points[3 * vertex], this->Points[3 * vertex + 1], this->Points[3 * vertex + 2]);
    Vector3 moved = p;
    for (int i = 0; i < 4; ++i)
    {
      const int joint = this->Ids[4 * vertex + i];
      moved += double(this->Weights[4 * vertex + i]) *
        (RotationOffset(this->Poses[joint].Rotation, p - this->Places[joint]) + this->Poses[joint].Shift);
    }
    return moved;
  }

  Vector3 NormalAt(int vertex) const
  {
    const Vector3 n(this->Normals[3 * vertex], this->Normals[3 * vertex + 1], this->Normals[3 * vertex + 2]);
    Vector3 turned = n;
    for (int i = 0; i < 4; ++i)
    {
      turned +=
        double(this->Weights[4 * vertex + i]) * RotationOffset(this->Poses[this->Ids[4 * vertex + i]].Rotation, n);
    }
    return glm::length(n) * Normalised(turned);
  }
};

}

// Far from the origin nothing is lost but the last bit of the coordinates.
TEST(Skinning, FollowsItsDefinitionNearAndFar)
{
  for (const double far : { 0.0, 300.0, 20000.0 })
  {
    const RandomSkin skin({ far, -far, 2.0 });
    std::vector<float> points(skin.Points.size());
    std::vector<float> normals(skin.Points.size());
    MoveSkin(skin.Rest(), skin.Binding(), skin.Changes.data(), 0, RandomSkin::Vertices, points.data(), normals.data());
    double worst = 0.0;
    double turned = 0.0;
    for (int vertex = 0; vertex < RandomSkin::Vertices; ++vertex)
    {
      const Vector3 point = skin.PointAt(vertex);
      const Vector3 normal = skin.NormalAt(vertex);
      for (int axis = 0; axis < 3; ++axis)
      {
        const double rounding = std::abs(point[axis]) * 0x1p-24;
        worst = std::max(worst, std::abs(points[3 * vertex + axis] - point[axis]) - rounding);
        turned = std::max(turned, std::abs(normals[3 * vertex + axis] - normal[axis]));
      }
    }
    std::printf("%g m away, points differ by %.2g m beyond their rounding, normals by %.2g\n", far, worst, turned);
    EXPECT_LT(worst, 1e-6);
    EXPECT_LT(turned, 1e-6);
  }
}

TEST(Skinning, AnyRangeHasTheSameBytes)
{
  const RandomSkin skin({ 50.0, 20.0, 1.0 });
  std::vector<float> points(skin.Points.size());
  std::vector<float> normals(skin.Points.size());
  MoveSkin(skin.Rest(), skin.Binding(), skin.Changes.data(), 0, RandomSkin::Vertices, points.data(), normals.data());
  for (const std::size_t length : { 1, 2, 5, 300 })
  {
    std::vector<float> p(points.size());
    std::vector<float> n(points.size());
    for (std::size_t begin = 0; begin < RandomSkin::Vertices; begin += length)
    {
      const std::size_t end = std::min<std::size_t>(RandomSkin::Vertices, begin + length);
      MoveSkin(skin.Rest(), skin.Binding(), skin.Changes.data(), begin, end, p.data(), n.data());
    }
    EXPECT_EQ(p, points);
    EXPECT_EQ(n, normals);
  }
}

TEST(Skinning, RigidVerticesFollowOneJoint)
{
  const std::vector<float> points{ 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f };
  const std::vector<float> normals{ 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 1.0f };
  const std::vector<int> ids{ 0, 1, 0, 0, 0, 1, 0, 0 };
  const std::vector<float> weights{ 0.75f, 0.25f, 0.0f, 0.0f, 0.25f, 0.75f, 0.0f, 0.0f };
  const RestSkin rest{ points.data(), normals.data() };
  const SkinBinding binding(ids.data(), weights.data(), 2);
  // The first joint stays, the second goes up by 1 m.
  const std::vector<JointChange> changes{ ChangeOf(JointPose(), Vector3(0.0)),
    ChangeOf(JointPose{ { 1.0, 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } }, Vector3(0.0)) };
  for (const float rigidity : { 0.0f, 0.5f, 1.0f })
  {
    std::vector<float> p(6, -1.0f);
    std::vector<float> n(6, -1.0f);
    MoveSkin(rest, binding, changes.data(), 1, 2, p.data(), n.data(), rigidity);
    EXPECT_EQ(p[2], -1.0f); // not among them
    EXPECT_FLOAT_EQ(p[5], 0.75f + 0.25f * rigidity);
    MoveSkin(rest, binding, changes.data(), 0, 1, p.data(), n.data(), rigidity);
    EXPECT_FLOAT_EQ(p[2], 0.25f - 0.25f * rigidity);
  }
}

// Each vertex by the definition in double precision, with the joint of its largest weight alone.
TEST(Skinning, RigidSkinsFollowTheMainJoint)
{
  const RandomSkin skin({ 300.0, -300.0, 2.0 });
  const RigidBinding binding(skin.Binding());
  std::vector<float> points(skin.Points.size());
  std::vector<float> normals(skin.Points.size());
  SkinRanges ranges;
  MoveRigidly(
    skin.Rest(), binding.RunOf(0), skin.Changes.data(), 0, RandomSkin::Vertices, points.data(), normals.data(), ranges);
  for (int vertex = 0; vertex < RandomSkin::Vertices; ++vertex)
  {
    const float* weights = &skin.Weights[4 * vertex];
    const int joint = skin.Ids[4 * vertex + (std::max_element(weights, weights + 4) - weights)];
    const JointPose& pose = skin.Poses[joint];
    for (const bool isNormal : { false, true })
    {
      const float* from = (isNormal ? skin.Normals : skin.Points).data() + 3 * vertex;
      const float* to = (isNormal ? normals : points).data() + 3 * vertex;
      const Vector3 rest(from[0], from[1], from[2]);
      const Vector3 moved =
        isNormal ? pose.Rotation * rest : skin.Places[joint] + pose.Rotation * (rest - skin.Places[joint]) + pose.Shift;
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_NEAR(to[axis], moved[axis], 2e-6 + std::abs(moved[axis]) * 0x1p-24);
      }
    }
  }
}

TEST(Skinning, AnyRangeOfARigidSkinHasTheSameBytes)
{
  const RandomSkin skin({ 50.0, 20.0, 1.0 });
  const RigidBinding binding(skin.Binding());
  std::vector<float> points(skin.Points.size());
  std::vector<float> normals(skin.Points.size());
  SkinRanges ranges;
  MoveRigidly(
    skin.Rest(), binding.RunOf(0), skin.Changes.data(), 0, RandomSkin::Vertices, points.data(), normals.data(), ranges);
  for (const std::size_t length : { 1, 2, 5, 300 })
  {
    std::vector<float> p(points.size());
    std::vector<float> n(points.size());
    SkinRanges parts;
    for (std::size_t begin = 0; begin < RandomSkin::Vertices; begin += length)
    {
      const std::size_t end = std::min<std::size_t>(RandomSkin::Vertices, begin + length);
      MoveRigidly(skin.Rest(), binding.RunOf(begin), skin.Changes.data(), begin, end, p.data(), n.data(), parts);
    }
    EXPECT_EQ(p, points);
    EXPECT_EQ(n, normals);
    ExpectRangesOf(points, parts.Points);
    ExpectRangesOf(normals, parts.Normals);
  }
}

TEST(Skinning, NoVerticesAreNoWork)
{
  const RandomSkin skin({ 0.0, 0.0, 0.0 });
  std::vector<float> points(3, 7.0f);
  MoveSkin(skin.Rest(), skin.Binding(), skin.Changes.data(), 0, 0, points.data(), nullptr);
  MoveSkin({}, {}, nullptr, 0, 0, points.data(), nullptr);
  EXPECT_EQ(points, std::vector<float>(3, 7.0f));
}

TEST(SkinBinding, KeepsTheArraysItIsMadeOf)
{
  const RandomSkin skin({ 0.0, 0.0, 0.0 });
  std::vector<int> ids(skin.Ids.size(), -1);
  std::vector<float> weights(skin.Weights.size(), -1.0f);
  skin.Binding().Write(ids.data(), weights.data());
  EXPECT_EQ(ids, skin.Ids);
  EXPECT_EQ(weights, skin.Weights);
}

/// Two plants with the same skin, of which the second stands aside and has joints of its own; both by one binding, and
/// by the binding that they share.
struct TwoAlike
{
  RandomSkin One{ { 0.0, 0.0, 0.0 } };
  std::vector<float> Points = One.Points;
  std::vector<float> Normals = One.Normals;
  std::vector<JointChange> Changes = One.Changes;
  std::vector<int> Ids = One.Ids;
  std::vector<float> Weights = One.Weights;
  StandBinding Shared;

  TwoAlike()
  {
    const std::size_t vertices = this->One.Ids.size() / 4;
    const auto joints = static_cast<int>(this->One.Changes.size());
    const RandomSkin other({ 40.0, -7.0, 0.5 });
    this->Points.insert(this->Points.end(), other.Points.begin(), other.Points.end());
    this->Normals.insert(this->Normals.end(), other.Normals.begin(), other.Normals.end());
    for (int joint = joints - 1; joint >= 0; --joint) // unlike those of the first
    {
      this->Changes.push_back(ChangeOf(this->One.Poses[joint], other.Places[joints - 1 - joint]));
    }
    for (std::size_t n = 0; n < 4 * vertices; ++n)
    {
      this->Ids.push_back(this->One.Ids[n] + joints);
      this->Weights.push_back(this->One.Weights[n]);
    }
    const auto binding = std::make_shared<const SkinBinding>(this->One.Binding());
    this->Shared.Add(binding, 0);
    this->Shared.Add(binding, joints);
  }
};

TEST(StandBinding, PlantsThatShareABindingMoveAsByOneOfAll)
{
  const TwoAlike two;
  const std::size_t vertices = two.Points.size() / 3;
  const SkinBinding all(two.Ids.data(), two.Weights.data(), vertices);
  ASSERT_EQ(two.Shared.GetNumberOfVertices(), vertices);
  std::vector<float> expected(two.Points.size());
  std::vector<float> expectedNormals(expected.size());
  const RestSkin rest{ two.Points.data(), two.Normals.data() };
  MoveSkin(rest, all, two.Changes.data(), 0, vertices, expected.data(), expectedNormals.data());
  std::vector<float> points(expected.size(), -1.0f);
  std::vector<float> normals(points);
  const std::size_t third = vertices / 3; // the second of three ranges is of both plants
  for (std::size_t begin = 0; begin < vertices; begin += third)
  {
    two.Shared.Move(rest, two.Changes.data(), begin, std::min(vertices, begin + third), points.data(), normals.data());
  }
  EXPECT_EQ(points, expected);
  EXPECT_EQ(normals, expectedNormals);
  std::fill(points.begin(), points.end(), -1.0f);
  StandBinding(all).Move({ rest.Points }, two.Changes.data(), 0, vertices, points.data(), nullptr);
  EXPECT_EQ(points, expected);
}

TEST(StandBinding, TellsTheJointsOfAll)
{
  const TwoAlike two;
  std::vector<int> ids(two.Ids.size(), -1);
  std::vector<float> weights(ids.size(), -1.0f);
  two.Shared.Write(ids.data(), weights.data());
  EXPECT_EQ(ids, two.Ids);
  EXPECT_EQ(weights, two.Weights);
  for (std::size_t vertex = 0; vertex < ids.size() / 4; ++vertex)
  {
    EXPECT_EQ(two.Shared.JointOf(vertex), two.Ids[4 * vertex]);
  }
}

TEST(SkinBinding, VerticesAlikeAndVerticesOfTheSameJointsAreRuns)
{
  struct Vertex
  {
    int Joints[4];
    float Weights[4];
  };
  const std::vector<Vertex> vertices{
    { { 1, 2, 0, 0 }, { 0.5f, 0.5f, 0.0f, 0.0f } }, // alike
    { { 1, 2, 0, 0 }, { 0.5f, 0.5f, 0.0f, 0.0f } }, { { 1, 2, 0, 0 }, { 0.5f, 0.5f, 0.0f, 0.0f } },
    { { 1, 2, 0, 0 }, { 0.3f, 0.7f, 0.0f, 0.0f } }, // each with weights of its own
    { { 1, 2, 0, 0 }, { 0.2f, 0.8f, 0.0f, 0.0f } }, { { 1, 2, 0, 0 }, { 0.2f, 0.8f, 0.0f, 0.0f } },
    { { 1, 2, 0, 0 }, { 1.0f, 0.0f, 0.0f, 0.0f } }, // fewer joints
    { { 1, 3, 0, 0 }, { 1.0f, 0.0f, 0.0f, 0.0f } }, // another one, though without weight
    { { 0, 3, 5, 6 }, { 0.0f, 0.0f, 0.0f, 0.0f } }, // none with a weight
  };
  std::vector<int> ids;
  std::vector<float> weights;
  for (const Vertex& vertex : vertices)
  {
    ids.insert(ids.end(), std::begin(vertex.Joints), std::end(vertex.Joints));
    weights.insert(weights.end(), std::begin(vertex.Weights), std::end(vertex.Weights));
  }
  const SkinBinding binding(ids.data(), weights.data(), vertices.size());
  EXPECT_EQ(binding.GetNumberOfVertices(), vertices.size());
  std::vector<std::array<std::size_t, 2>> ends;
  for (std::size_t vertex = 0; vertex < vertices.size(); ++vertex)
  {
    const SkinBinding::Run* run = binding.RunOf(vertex);
    EXPECT_EQ(run->Varies, run->Begin == 3);
    for (int i = 0; i < run->Count; ++i)
    {
      EXPECT_EQ(binding.WeightsOf(*run, vertex)[i], vertices[vertex].Weights[i]) << vertex;
      EXPECT_EQ(run->Joints[i], vertices[vertex].Joints[i]) << vertex;
    }
    if (run->Begin == vertex)
    {
      ends.push_back({ run->Begin, run->End });
    }
  }
  EXPECT_EQ(ends, (std::vector<std::array<std::size_t, 2>>{ { 0, 3 }, { 3, 6 }, { 6, 7 }, { 7, 8 }, { 8, 9 } }));
}
