// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Plants/AonoKuniiTree.h"
#include "Plants/BranchSkin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace littoral;

namespace
{

AonoKuniiParameters Exact(ForkPreset preset)
{
  AonoKuniiParameters parameters = PresetParameters(preset);
  parameters.Variation = 0.0;
  parameters.NumberOfLeaves = 0;
  return parameters;
}

/// A segment of wood between two nodes of a branch.
struct Segment
{
  int Foot;
  Vector3 Along;
  double Radius;
};

std::vector<Segment> SegmentsOf(const Skeleton& wood)
{
  std::vector<Segment> segments;
  for (int branch = 0; branch < static_cast<int>(wood.Branches.size()); ++branch)
  {
    for (int node = wood.Branches[branch].First; node < wood.Tip(branch); ++node)
    {
      segments.push_back({ node, wood.Nodes[node + 1].Position - wood.Nodes[node].Position, wood.Nodes[node].Radius });
    }
  }
  return segments;
}

/// The direction of a segment.
Vector3 Direction(const Skeleton& wood, int foot)
{
  return glm::normalize(wood.Nodes[foot + 1].Position - wood.Nodes[foot].Position);
}

double AngleBetween(const Vector3& a, const Vector3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) / Degree;
}

/// The turn about an axis from one vector to another, 0 to 180 degrees.
double TurnAbout(const Vector3& axis, const Vector3& a, const Vector3& b)
{
  return AngleBetween(a - glm::dot(a, axis) * axis, b - glm::dot(b, axis) * axis);
}

/// A turn in degrees as the smallest one to the same place.
double Smallest(double turn)
{
  return std::abs(std::remainder(turn, 360.0));
}

bool SameBytes(const Plant& a, const Plant& b)
{
  const auto sameNode = [](const SkeletonNode& one, const SkeletonNode& other) {
    return one.Position == other.Position && one.Radius == other.Radius && one.Parent == other.Parent;
  };
  const auto sameLeaf = [](const LeafParticle& one, const LeafParticle& other) {
    return one.Position == other.Position && one.Axis == other.Axis && one.Tint == other.Tint && one.Size == other.Size;
  };
  return std::equal(a.Wood.Nodes.begin(), a.Wood.Nodes.end(), b.Wood.Nodes.begin(), b.Wood.Nodes.end(), sameNode) &&
    std::equal(a.Leaves.begin(), a.Leaves.end(), b.Leaves.begin(), b.Leaves.end(), sameLeaf);
}

double DistanceToSegment(const Vector3& point, const Vector3& from, const Vector3& to)
{
  const double part = std::clamp(glm::dot(point - from, to - from) / glm::dot(to - from, to - from), 0.0, 1.0);
  return glm::distance(point, from + part * (to - from));
}

class ForkPresets : public testing::TestWithParam<int>
{
protected:
  ForkPreset Preset() const { return static_cast<ForkPreset>(GetParam()); }
};

}

TEST_P(ForkPresets, GrowASoundTree)
{
  AonoKuniiParameters parameters = PresetParameters(this->Preset());
  ASSERT_EQ(WhyInvalid(parameters), "");
  for (const double variation : { 0.0, 0.1, 0.5 })
  {
    parameters.Variation = variation;
    const Plant tree = GrowAonoKuniiTree(parameters);
    const Skeleton& wood = tree.Wood;
    ASSERT_EQ(WhyInvalid(wood), "");
    EXPECT_EQ(wood.Nodes[0].Position, Vector3(0.0, 0.0, 0.0));
    for (std::size_t branch = 1; branch < wood.Branches.size(); ++branch)
    {
      const SkeletonNode& first = wood.Nodes[wood.Branches[branch].First];
      ASSERT_GE(first.Parent, 0);
      ASSERT_EQ(wood.Nodes[first.Parent].Branch, wood.Nodes[first.Parent + 1].Branch);
      EXPECT_EQ(
        DistanceToSegment(first.Position, wood.Nodes[first.Parent].Position, wood.Nodes[first.Parent + 1].Position),
        0.0);
    }
    ASSERT_EQ(tree.Leaves.size(), static_cast<std::size_t>(parameters.NumberOfLeaves));
    for (const LeafParticle& leaf : tree.Leaves)
    {
      ASSERT_GE(Depth(tree.Crown, leaf.Position), 0.0);
      ASSERT_NEAR(glm::length(leaf.Normal), 1.0, 1e-12);
      ASSERT_NEAR(glm::length(leaf.Axis), 1.0, 1e-12);
      ASSERT_NEAR(glm::dot(leaf.Axis, leaf.Facing), 0.0, 1e-12);
      ASSERT_GT(leaf.Tint[0] + leaf.Tint[1] + leaf.Tint[2], 40) << "a black leaf";
    }
  }
}

TEST_P(ForkPresets, HaveTheSegmentsOfTheirRules)
{
  AonoKuniiParameters parameters = Exact(this->Preset());
  for (int steps = 1; steps <= 7; ++steps)
  {
    parameters.Iterations = steps;
    const Skeleton wood = GrowAonoKuniiTree(parameters).Wood;
    const bool ternary = parameters.Form == Branching::Ternary;
    const auto power = static_cast<std::size_t>(std::lround(std::pow(ternary ? 3.0 : 2.0, steps)));
    EXPECT_EQ(SegmentsOf(wood).size(), ternary ? 2 * power - 1 : power - 1);
    EXPECT_EQ(wood.Branches.size(), ternary ? (3 * power - 1) / 2 : power / 2);
  }
}

TEST_P(ForkPresets, AreAFunctionOfTheirSeed)
{
  AonoKuniiParameters parameters = PresetParameters(this->Preset());
  const Plant one = GrowAonoKuniiTree(parameters);
  EXPECT_TRUE(SameBytes(one, GrowAonoKuniiTree(parameters)));
  parameters.Seed = 2;
  const Plant other = GrowAonoKuniiTree(parameters);
  EXPECT_NE(one.Wood.Nodes[1].Position, other.Wood.Nodes[1].Position);
  EXPECT_NE(one.Leaves[0].Position, other.Leaves[0].Position);
  parameters.Variation = 0.0;
  const Plant exact = GrowAonoKuniiTree(parameters);
  parameters.Seed = 1;
  EXPECT_EQ(exact.Wood.Nodes.back().Position, GrowAonoKuniiTree(parameters).Wood.Nodes.back().Position)
    << "without variation the wood depends on the seed";
}

TEST_P(ForkPresets, KeepTheSectionOfWoodAtForks)
{
  const AonoKuniiParameters parameters = Exact(this->Preset());
  const double children = parameters.Form == Branching::Ternary ? 3.0 : 2.0;
  EXPECT_NEAR(children * parameters.WidthRatio * parameters.WidthRatio, 1.0, 3.1e-4);
  const Skeleton wood = GrowAonoKuniiTree(parameters).Wood;
  // Sections of the segments that rest on each segment.
  std::vector<double> above(wood.Nodes.size(), 0.0);
  for (const Segment& segment : SegmentsOf(wood))
  {
    const SkeletonNode& foot = wood.Nodes[segment.Foot];
    const bool first = wood.Branches[foot.Branch].First == segment.Foot;
    const bool atTip = first && foot.Parent >= 0 && foot.Position != wood.Nodes[foot.Parent].Position;
    const int below = !first || atTip ? foot.Parent : foot.Parent - 1;
    if (below >= 0)
    {
      above[below] += segment.Radius * segment.Radius;
    }
  }
  int forks = 0;
  for (const Segment& segment : SegmentsOf(wood))
  {
    if (above[segment.Foot] > 0.0)
    {
      ++forks;
      EXPECT_NEAR(above[segment.Foot] / (segment.Radius * segment.Radius), 1.0, 3.1e-4);
    }
  }
  EXPECT_GT(forks, 300);
}

TEST_P(ForkPresets, SkinWithoutDegenerateTriangles)
{
  const PlantMesh mesh = SkinOf(GrowAonoKuniiTree(PresetParameters(this->Preset())).Wood, {});
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    const int* corner = &mesh.Corners[mesh.Offsets[polygon]];
    const Vector3& a = mesh.Points[corner[0]];
    ASSERT_GT(glm::length(glm::cross(mesh.Points[corner[1]] - a, mesh.Points[corner[2]] - a)), 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Published, ForkPresets, testing::Range(1, NumberOfForkPresets));

TEST(AonoKuniiTree, MonopodialAxisIsStraightWithSideBranchesByDivergence)
{
  const AonoKuniiParameters p = Exact(ForkPreset::MonopodialA);
  const Skeleton wood = GrowAonoKuniiTree(p).Wood;
  ASSERT_EQ(wood.Branches[0].Count, p.Iterations + 1);
  const Vector3 up{ 0.0, 0.0, 1.0 };
  Vector3 before{ 0.0, 0.0, 0.0 };
  for (int step = 0; step < p.Iterations; ++step)
  {
    EXPECT_NEAR(AngleBetween(Direction(wood, step), up), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(wood.Nodes[step + 1].Position, wood.Nodes[step].Position),
      p.TrunkLength * std::pow(0.9, step), 1e-12);
    EXPECT_NEAR(wood.Nodes[step].Radius, p.TrunkRadius * std::pow(0.707, step), 1e-12);
    if (step + 1 == p.Iterations)
    {
      break;
    }
    // Side branches follow the axis in the order in which they leave it.
    const SkeletonBranch& side = wood.Branches[step + 1];
    ASSERT_EQ(wood.Nodes[side.First].Parent, step + 1);
    ASSERT_EQ(side.Count, p.Iterations - step);
    const Vector3 direction = Direction(wood, side.First);
    EXPECT_NEAR(AngleBetween(direction, up), 45.0, 1e-9);
    for (int segment = 0; segment + 1 < side.Count; ++segment)
    {
      const int foot = side.First + segment;
      EXPECT_NEAR(glm::distance(wood.Nodes[foot + 1].Position, wood.Nodes[foot].Position),
        p.TrunkLength * std::pow(0.9, step + segment) * 0.6, 1e-12);
      EXPECT_NEAR(AngleBetween(Direction(wood, foot), direction), 0.0, 1e-5);
    }
    if (step > 0)
    {
      EXPECT_NEAR(TurnAbout(up, before, direction), 137.5, 1e-9);
    }
    before = direction;
  }
}

TEST(AonoKuniiTree, MonopodialBranchesForkByTheSecondAngleFlatAndToAlternateSides)
{
  for (const ForkPreset preset : { ForkPreset::MonopodialA, ForkPreset::MonopodialD })
  {
    const AonoKuniiParameters p = Exact(preset);
    const Skeleton wood = GrowAonoKuniiTree(p).Wood;
    const SkeletonBranch& limb = wood.Branches[1];
    const Vector3 axis = Direction(wood, limb.First);
    Vector3 before{ 0.0, 0.0, 0.0 };
    int sides = 0;
    for (const SkeletonBranch& branch : wood.Branches)
    {
      const int parent = wood.Nodes[branch.First].Parent;
      if (parent > limb.First && parent < limb.First + limb.Count)
      {
        const Vector3 direction = Direction(wood, branch.First);
        EXPECT_NEAR(AngleBetween(direction, axis), std::abs(p.Angle2), 1e-5);
        if (sides > 0)
        {
          EXPECT_NEAR(TurnAbout(axis, before, direction), 180.0, 1e-4);
        }
        before = direction;
        ++sides;
      }
    }
    EXPECT_EQ(sides, p.Iterations - 2);
  }
}

TEST(AonoKuniiTree, SympodialForksByBothAngles)
{
  const AonoKuniiParameters p = Exact(static_cast<ForkPreset>(6));
  ASSERT_EQ(p.Angle1, 10.0);
  ASSERT_EQ(p.Angle2, 60.0);
  const Skeleton wood = GrowAonoKuniiTree(p).Wood;
  int forks = 0;
  for (const SkeletonBranch& branch : wood.Branches)
  {
    const int parent = wood.Nodes[branch.First].Parent;
    if (parent < 1)
    {
      continue;
    }
    const Vector3 below = wood.Nodes[parent].Position - wood.Nodes[parent - 1].Position;
    const Vector3 stronger = wood.Nodes[parent + 1].Position - wood.Nodes[parent].Position;
    const Vector3 weaker = wood.Nodes[branch.First + 1].Position - wood.Nodes[branch.First].Position;
    EXPECT_NEAR(AngleBetween(stronger, below), 10.0, 1e-6);
    EXPECT_NEAR(AngleBetween(weaker, below), 60.0, 1e-6);
    EXPECT_NEAR(AngleBetween(weaker, stronger), 70.0, 1e-6) << "a fork that is not flat";
    EXPECT_NEAR(glm::length(stronger) / glm::length(below), 0.9, 1e-10);
    EXPECT_NEAR(glm::length(weaker) / glm::length(below), 0.7, 1e-10);
    ++forks;
  }
  EXPECT_EQ(forks, 511);
}

TEST(AonoKuniiTree, TernaryLengthsWidthsAndDivergenceFollowTheRules)
{
  AonoKuniiParameters p = Exact(ForkPreset::TernaryA);
  p.Susceptibility = 0.0;
  const Skeleton wood = GrowAonoKuniiTree(p).Wood;
  // The rules as published: lengths in units of the trunk after all steps, 200 lr^n.
  const auto length = [&p](int step) {
    return p.TrunkLength * 50.0 * std::pow(1.109, p.Iterations - step) / (200.0 * std::pow(1.109, p.Iterations));
  };
  const auto segment = [&wood](int foot) { return wood.Nodes[foot + 1].Position - wood.Nodes[foot].Position; };
  EXPECT_NEAR(glm::length(segment(0)), p.TrunkLength, 1e-12);
  EXPECT_NEAR(glm::length(segment(1)), length(1), 1e-12);
  for (int branch = 1; branch < static_cast<int>(wood.Branches.size()); ++branch)
  {
    const SkeletonBranch& run = wood.Branches[branch];
    const int parent = wood.Nodes[run.First].Parent;
    EXPECT_NEAR(glm::length(segment(run.First)), length(run.Order), 1e-12);
    EXPECT_NEAR(wood.Nodes[run.First].Radius, p.TrunkRadius * std::pow(1.732, -run.Order), 1e-12);
    EXPECT_NEAR(AngleBetween(segment(run.First), segment(parent)), 18.95, 1e-6);
    ASSERT_EQ(run.Count, run.Order == p.Iterations ? 2 : 3);
    if (run.Count == 3)
    {
      EXPECT_NEAR(glm::length(segment(run.First + 1)), length(run.Order + 1), 1e-12);
      EXPECT_NEAR(AngleBetween(segment(run.First), segment(run.First + 1)), 0.0, 1e-5);
    }
  }
  // Siblings follow each other.
  for (int branch = 1; branch < static_cast<int>(wood.Branches.size()); branch += 3)
  {
    const Vector3 axis = glm::normalize(segment(wood.Nodes[wood.Branches[branch].First].Parent));
    const Vector3 a = segment(wood.Branches[branch].First);
    const Vector3 b = segment(wood.Branches[branch + 1].First);
    const Vector3 c = segment(wood.Branches[branch + 2].First);
    EXPECT_NEAR(TurnAbout(axis, a, b), Smallest(94.74), 1e-5);
    EXPECT_NEAR(TurnAbout(axis, b, c), Smallest(132.63), 1e-5);
    EXPECT_NEAR(TurnAbout(axis, a, c), Smallest(94.74 + 132.63), 1e-5);
  }
}

TEST(AonoKuniiTree, BendsTowardsTheTropismByTheSineOfTheAngle)
{
  AonoKuniiParameters p = Exact(ForkPreset::TernaryA);
  p.Tropism = { 3.0, 0.0, -4.0 };
  p.Susceptibility = 0.25;
  const Vector3 towards{ 0.6, 0.0, -0.8 };
  const Skeleton wood = GrowAonoKuniiTree(p).Wood;
  int bends = 0;
  for (const SkeletonBranch& branch : wood.Branches)
  {
    if (branch.Count == 3)
    {
      const Vector3 before = Direction(wood, branch.First);
      const Vector3 after = Direction(wood, branch.First + 1);
      const double expected = 0.25 * glm::length(glm::cross(before, towards)) / Degree;
      EXPECT_NEAR(AngleBetween(before, after), expected, 1e-6);
      EXPECT_NEAR(AngleBetween(after, towards), AngleBetween(before, towards) - expected, 1e-6) << "the wrong way";
      ++bends;
    }
  }
  EXPECT_EQ(bends, 364);
  p.Tropism = { 0.0, 0.0, 0.0 };
  EXPECT_EQ(Direction(GrowAonoKuniiTree(p).Wood, 1), Vector3(0.0, 0.0, 1.0)) << "a bend to nowhere";
}

TEST(AonoKuniiTree, IndividualsVaryAsAsked)
{
  AonoKuniiParameters p = Exact(ForkPreset::MonopodialA);
  p.Iterations = 5;
  p.Variation = 0.1;
  double sum = 0.0;
  double squares = 0.0;
  const int individuals = 400;
  for (p.Seed = 1; p.Seed <= individuals; ++p.Seed)
  {
    const double length = glm::length(GrowAonoKuniiTree(p).Wood.Nodes[1].Position) / p.TrunkLength;
    sum += length;
    squares += length * length;
  }
  const double mean = sum / individuals;
  const double deviation = std::sqrt(squares / individuals - mean * mean);
  EXPECT_NEAR(mean, 1.0, 4.0 * 0.14 / std::sqrt(individuals));
  // Two factors, of the individual and of the segment, each cut at two standard deviations.
  const double expected = 0.1 * std::sqrt(2.0 * 0.9205);
  EXPECT_NEAR(deviation, expected, 4.0 * expected / std::sqrt(2.0 * individuals));
}

TEST(AonoKuniiTree, LeavesStandOnTheLastSegments)
{
  const AonoKuniiParameters p = PresetParameters(ForkPreset::TernaryA);
  const Plant tree = GrowAonoKuniiTree(p);
  std::vector<int> counts(tree.Wood.Nodes.size(), 0);
  for (const LeafParticle& leaf : tree.Leaves)
  {
    const SkeletonBranch& branch = tree.Wood.Branches[tree.Wood.Nodes[leaf.Node].Branch];
    EXPECT_EQ(branch.Order, p.Iterations);
    EXPECT_EQ(leaf.Node, branch.First);
    const double distance =
      DistanceToSegment(leaf.Position, tree.Wood.Nodes[leaf.Node].Position, tree.Wood.Nodes[leaf.Node + 1].Position);
    EXPECT_LE(distance, 0.4 * 2.0 * std::sqrt(3.0) * p.LeafSize);
    ++counts[leaf.Node];
  }
  EXPECT_EQ(std::count_if(counts.begin(), counts.end(), [](int count) { return count > 0; }), 729);
}

TEST(AonoKuniiTree, TheLongestTreesAreSoundAndLongerOnesRefused)
{
  for (const ForkPreset preset : { ForkPreset::MonopodialA, ForkPreset::SympodialA, ForkPreset::TernaryA })
  {
    AonoKuniiParameters p = Exact(preset);
    p.LengthRatio1 = p.LengthRatio2 = 0.3;
    p.Elongation = 3.0;
    p.Iterations = MaximumIterations(p.Form);
    ASSERT_EQ(WhyInvalid(p), "");
    EXPECT_EQ(WhyInvalid(GrowAonoKuniiTree(p).Wood), "");
    ++p.Iterations;
    EXPECT_EQ(WhyInvalid(p).rfind("Iterations", 0), 0u);
  }
}

TEST(AonoKuniiTree, NamesBadParameters)
{
  const auto names = [](const char* word, void (*spoil)(AonoKuniiParameters&)) {
    AonoKuniiParameters parameters;
    spoil(parameters);
    return WhyInvalid(parameters).rfind(word, 0) == 0;
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(names("Branching", [](AonoKuniiParameters& p) { p.Form = static_cast<Branching>(3); }));
  EXPECT_TRUE(names("Iterations", [](AonoKuniiParameters& p) { p.Iterations = 0; }));
  EXPECT_TRUE(names("Iterations", [](AonoKuniiParameters& p) { p.Iterations = 1000000; }));
  EXPECT_TRUE(names("LengthRatio1", [](AonoKuniiParameters& p) { p.LengthRatio1 = nan; }));
  EXPECT_TRUE(names("LengthRatio2", [](AonoKuniiParameters& p) { p.LengthRatio2 = 0.0; }));
  EXPECT_TRUE(names("Angle1", [](AonoKuniiParameters& p) { p.Angle1 = 180.0; }));
  EXPECT_TRUE(names("Tropism", [](AonoKuniiParameters& p) { p.Tropism[1] = nan; }));
  EXPECT_TRUE(names("Susceptibility", [](AonoKuniiParameters& p) { p.Susceptibility = -0.1; }));
  EXPECT_TRUE(names("TrunkLength", [](AonoKuniiParameters& p) { p.TrunkLength = 0.0; }));
  EXPECT_TRUE(names("NumberOfLeaves", [](AonoKuniiParameters& p) { p.NumberOfLeaves = -1; }));
  EXPECT_TRUE(names("LeafSize", [](AonoKuniiParameters& p) { p.LeafSize = 0.0; }));
}
