// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Plants/BranchSkin.h"
#include "Plants/ReevesTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

using namespace littoral;

namespace
{

class ReevesTreePresets : public testing::TestWithParam<TreePreset>
{
};

bool SameBytes(const Plant& a, const Plant& b)
{
  if (a.Wood.Nodes.size() != b.Wood.Nodes.size() || a.Leaves.size() != b.Leaves.size())
  {
    return false;
  }
  for (std::size_t i = 0; i < a.Wood.Nodes.size(); ++i)
  {
    if (a.Wood.Nodes[i].Position != b.Wood.Nodes[i].Position || a.Wood.Nodes[i].Radius != b.Wood.Nodes[i].Radius)
    {
      return false;
    }
  }
  for (std::size_t i = 0; i < a.Leaves.size(); ++i)
  {
    if (a.Leaves[i].Position != b.Leaves[i].Position || a.Leaves[i].Tint != b.Leaves[i].Tint)
    {
      return false;
    }
  }
  return true;
}

}

TEST_P(ReevesTreePresets, GrowsASoundTreeInItsCrown)
{
  ReevesTreeParameters parameters = PresetParameters(GetParam());
  ASSERT_EQ(WhyInvalid(parameters), "");
  for (int seed = 1; seed <= 8; ++seed)
  {
    parameters.Seed = seed;
    const Plant tree = GrowReevesTree(parameters);
    ASSERT_EQ(WhyInvalid(tree.Wood), "");
    EXPECT_GT(tree.Wood.Branches.size(), 50u);
    for (std::size_t branch = 1; branch < tree.Wood.Branches.size(); ++branch)
    {
      EXPECT_LE(tree.Wood.Branches[branch].Order, parameters.Orders);
      for (int node = tree.Wood.Branches[branch].First + 1; node <= tree.Wood.Tip(static_cast<int>(branch)); ++node)
      {
        EXPECT_GT(Depth(CrownOf(parameters), tree.Wood.Nodes[node].Position), 0.0);
      }
    }
    ASSERT_EQ(tree.Leaves.size(), static_cast<std::size_t>(parameters.NumberOfLeaves));
    double highest = 0.0;
    for (const LeafParticle& leaf : tree.Leaves)
    {
      EXPECT_GE(Depth(CrownOf(parameters), leaf.Position), -0.02);
      EXPECT_NEAR(glm::length(leaf.Normal), 1.0, 1e-12);
      EXPECT_GT(leaf.Tint[0] + leaf.Tint[1] + leaf.Tint[2], 40) << "a black leaf";
      highest = std::max(highest, leaf.Position[2]);
    }
    EXPECT_GT(highest, 0.85 * parameters.Height);
  }
}

TEST_P(ReevesTreePresets, IsAFunctionOfItsSeed)
{
  ReevesTreeParameters parameters = PresetParameters(GetParam());
  const Plant one = GrowReevesTree(parameters);
  EXPECT_TRUE(SameBytes(one, GrowReevesTree(parameters)));
  parameters.Seed = 2;
  EXPECT_FALSE(SameBytes(one, GrowReevesTree(parameters)));
}

TEST_P(ReevesTreePresets, SkinsWithoutDegenerateTriangles)
{
  const PlantMesh mesh = SkinOf(GrowReevesTree(PresetParameters(GetParam())).Wood, {});
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    const int* corner = &mesh.Corners[mesh.Offsets[polygon]];
    const Vector3& a = mesh.Points[corner[0]];
    EXPECT_GT(glm::length(glm::cross(mesh.Points[corner[1]] - a, mesh.Points[corner[2]] - a)), 0.0);
  }
}

namespace
{

/// Places along a branch [m] and sections of the branches on it, the lowest first; `bearer` is the branch's radius
/// below the first of them.
std::vector<std::array<double, 2>> ChildrenOf(const Skeleton& wood, int branch, double& bearer)
{
  const SkeletonBranch& run = wood.Branches[branch];
  std::vector<std::array<double, 2>> children; // place along the branch [m], section
  for (int child = branch + 1; child < static_cast<int>(wood.Branches.size()); ++child)
  {
    const SkeletonNode& foot = wood.Nodes[wood.Branches[child].First];
    if (wood.Nodes[foot.Parent].Branch == branch)
    {
      double place = glm::distance(foot.Position, wood.Nodes[foot.Parent].Position);
      for (int node = run.First; node < foot.Parent; ++node)
      {
        place += glm::distance(wood.Nodes[node + 1].Position, wood.Nodes[node].Position);
      }
      bearer = std::max(bearer, wood.Nodes[foot.Parent].Radius); // below the first of them
      children.push_back({ place, foot.Radius * foot.Radius });
    }
  }
  std::sort(children.begin(), children.end());
  return children;
}

/// Section of a branch at a place along it [m].
double SectionAt(const Skeleton& wood, const SkeletonBranch& run, double place)
{
  int node = run.First;
  double below = 0.0;
  double length = glm::distance(wood.Nodes[node + 1].Position, wood.Nodes[node].Position);
  while (below + length < place && node + 2 < run.First + run.Count)
  {
    below += length;
    ++node;
    length = glm::distance(wood.Nodes[node + 1].Position, wood.Nodes[node].Position);
  }
  const double radius = wood.Nodes[node].Radius +
    std::min(1.0, (place - below) / length) * (wood.Nodes[node + 1].Radius - wood.Nodes[node].Radius);
  return radius * radius;
}

}

TEST_P(ReevesTreePresets, BranchesObeyDaVinci)
{
  // All branches at a stage of a tree's height, put together, are as thick as what bears them: the trunk at a place and
  // the feet of those that left it below, against the trunk where the crown starts; so in each branch that bears
  // others.
  ReevesTreeParameters parameters = PresetParameters(GetParam());
  parameters.NumberOfLeaves = 0;
  double least = 1e9;
  double most = 0.0;
  for (int seed = 1; seed <= 6; ++seed)
  {
    parameters.Seed = seed;
    const Skeleton wood = GrowReevesTree(parameters).Wood;
    for (int branch = 0; branch < static_cast<int>(wood.Branches.size()); ++branch)
    {
      const SkeletonBranch& run = wood.Branches[branch];
      double bearer = 0.0;
      const std::vector<std::array<double, 2>> children = ChildrenOf(wood, branch, bearer);
      if (children.size() < 4 || run.Order > 1)
      {
        continue; // fewer leave in steps of the tolerance
      }
      const double whole = bearer * bearer;
      const double length = wood.BranchLength(branch);
      double mean = 0.0;
      int places = 0;
      for (const double part : { 0.35, 0.5, 0.65, 0.8, 0.95 })
      {
        double sum = SectionAt(wood, run, part * length);
        for (const auto& child : children)
        {
          sum += child[0] <= part * length ? child[1] : 0.0;
        }
        if (part * length > children.front()[0])
        {
          mean = (places * mean + sum / whole) / (places + 1);
          ++places;
          if (branch == 0)
          {
            EXPECT_NEAR(sum / whole, 1.0, 0.3) << "trunk at " << part << ", seed " << seed;
          }
        }
      }
      if (places > 0)
      {
        least = std::min(least, mean);
        most = std::max(most, mean);
        EXPECT_NEAR(mean, 1.0, 0.3) << "branch " << branch << ", seed " << seed;
      }
    }
  }
  std::printf("sections put together: %.2f to %.2f of what bears them\n", least, most);
}

TEST_P(ReevesTreePresets, TrunkIsAsThickAsGivenAndBearsAPlausibleCrown)
{
  ReevesTreeParameters parameters = PresetParameters(GetParam());
  const auto volumeOf = [](const Skeleton& wood, bool trunk) {
    double volume = 0.0;
    for (std::size_t node = 1; node < wood.Nodes.size(); ++node)
    {
      const SkeletonNode& b = wood.Nodes[node];
      if (b.Parent >= 0 && wood.Nodes[b.Parent].Branch == b.Branch && (b.Branch == 0) == trunk)
      {
        const SkeletonNode& a = wood.Nodes[b.Parent];
        volume +=
          (a.Radius * a.Radius + a.Radius * b.Radius + b.Radius * b.Radius) * glm::distance(a.Position, b.Position);
      }
    }
    return volume;
  };
  for (const double thicker : { 0.5, 1.0, 1.5 })
  {
    ReevesTreeParameters own = parameters;
    own.TrunkRadius *= thicker;
    const Plant tree = GrowReevesTree(own);
    const std::vector<SkeletonNode>& nodes = tree.Wood.Nodes;
    const double height = std::min(1.3, 0.1 * own.Height);
    int node = 0;
    while (nodes[node + 1].Position.z < height)
    {
      ++node;
    }
    const double part = (height - nodes[node].Position.z) / (nodes[node + 1].Position.z - nodes[node].Position.z);
    EXPECT_NEAR(nodes[node].Radius + part * (nodes[node + 1].Radius - nodes[node].Radius), own.TrunkRadius, 1e-12);
    const double ratio = volumeOf(tree.Wood, false) / volumeOf(tree.Wood, true);
    double leaves = 0.0;
    for (const LeafParticle& leaf : tree.Leaves)
    {
      leaves += 0.5 * leaf.Size * leaf.Size * leaf.Width; // a kite
    }
    const double index = leaves / (TwoPi / 2.0 * own.CrownRadius * own.CrownRadius);
    std::printf("branches hold %.2f of the trunk's wood, leaf area index %.1f\n", ratio, index);
    if (GetParam() != TreePreset::Shrub) // which has next to no trunk
    {
      EXPECT_GT(ratio, 0.1);
      EXPECT_LT(ratio, 1.2);
    }
    if (GetParam() == TreePreset::Oak || GetParam() == TreePreset::Birch)
    {
      EXPECT_GT(index, 3.9);
      EXPECT_LT(index, 6.3);
    }
  }
}

TEST_P(ReevesTreePresets, HasTheSizeThatIsAskedFor)
{
  const ReevesTreeParameters own = PresetParameters(GetParam());
  const ReevesTreeParameters same = SizedParameters(GetParam(), 0.0, 0.0);
  EXPECT_EQ(same.CrownBase, own.CrownBase);
  EXPECT_EQ(same.LeafSize, own.LeafSize);
  const ReevesTreeParameters wide = SizedParameters(GetParam(), 0.0, 0.0, 3.0 * own.CrownRadius);
  EXPECT_DOUBLE_EQ(wide.CrownRadius, 1.5 * own.CrownRadius);
  EXPECT_EQ(wide.TrunkRadius, own.TrunkRadius);
  EXPECT_NEAR(wide.LeafSize, std::sqrt(1.5) * own.LeafSize, 1e-12);
  for (const double taller : { 0.7, 1.0, 1.6 })
  {
    for (const double wider : { 0.3, 1.0, 1.7 })
    {
      const ReevesTreeParameters p = SizedParameters(GetParam(), taller * own.Height, 2.0 * wider * own.TrunkRadius);
      ASSERT_EQ(WhyInvalid(p), "");
      EXPECT_DOUBLE_EQ(p.Height, taller * own.Height);
      EXPECT_DOUBLE_EQ(p.TrunkRadius, wider * own.TrunkRadius);
      EXPECT_EQ(WhyInvalid(GrowReevesTree(p).Wood), "");
      const bool isShort = wider < taller && GetParam() != TreePreset::Shrub;
      EXPECT_EQ(p.CrownBase / p.Height > own.CrownBase / own.Height + 1e-9, isShort) << "slender, short crown";
      EXPECT_EQ(p.TrunkReach > own.TrunkReach + 1e-9, isShort) << "and a trunk that goes on";
    }
  }
}

namespace
{

std::vector<TreePreset> AllSpecies()
{
  std::vector<TreePreset> presets;
  for (int preset = 1; preset < NumberOfTreePresets; ++preset)
  {
    presets.push_back(static_cast<TreePreset>(preset));
  }
  return presets;
}

}

INSTANTIATE_TEST_SUITE_P(Species, ReevesTreePresets, testing::ValuesIn(AllSpecies()),
  [](const auto& one) { return TraitsOf(one.param).Name; });

TEST(ReevesTree, IndividualsVary)
{
  ReevesTreeParameters parameters = PresetParameters(TreePreset::Oak);
  parameters.NumberOfLeaves = 0;
  double sum = 0.0;
  double squares = 0.0;
  const int individuals = 40;
  for (int seed = 1; seed <= individuals; ++seed)
  {
    parameters.Seed = seed;
    const double length = GrowReevesTree(parameters).Wood.BranchLength(1);
    sum += length;
    squares += length * length;
  }
  const double mean = sum / individuals;
  const double deviation = std::sqrt(squares / individuals - mean * mean);
  EXPECT_GT(deviation, 0.05 * mean);
  EXPECT_LT(deviation, 0.6 * mean);
}

TEST(ReevesTree, LeavesAreDarkerInside)
{
  const ReevesTreeParameters parameters = PresetParameters(TreePreset::Oak);
  double light[2] = { 0.0, 0.0 };
  int count[2] = { 0, 0 };
  for (const LeafParticle& leaf : GrowReevesTree(parameters).Leaves)
  {
    const int inside = Depth(CrownOf(parameters), leaf.Position) > 0.4 ? 1 : 0;
    light[inside] += leaf.Tint[1];
    ++count[inside];
  }
  ASSERT_GT(count[0], 100);
  ASSERT_GT(count[1], 100);
  EXPECT_GT(light[0] / count[0], 1.1 * light[1] / count[1]);
}

TEST(ReevesTree, NamesBadParameters)
{
  const auto names = [](const char* word, void (*spoil)(ReevesTreeParameters&)) {
    ReevesTreeParameters parameters;
    spoil(parameters);
    return WhyInvalid(parameters).rfind(word, 0) == 0;
  };
  EXPECT_TRUE(names("Height", [](ReevesTreeParameters& p) { p.Height = 0.0; }));
  EXPECT_TRUE(
    names("CrownRadius", [](ReevesTreeParameters& p) { p.CrownRadius = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_TRUE(names("CrownBase", [](ReevesTreeParameters& p) { p.CrownBase = p.Height; }));
  EXPECT_TRUE(names("CrownShape", [](ReevesTreeParameters& p) { p.Shape = static_cast<CrownShape>(2); }));
  EXPECT_TRUE(names("Orders", [](ReevesTreeParameters& p) { p.Orders = 0; }));
  // 1 + 20 + 400 + 8000 branches for each main branch
  ReevesTreeParameters many;
  many.Orders = 4;
  many.MainBranches = 12;
  many.SideBranches = 20;
  EXPECT_NE(WhyInvalid(many).find("MainBranches of 12 give 101052 branches"), std::string::npos) << WhyInvalid(many);
  EXPECT_NE(WhyInvalid(many).find("; 11 will do."), std::string::npos);
  many.MainBranches = 11;
  EXPECT_EQ(WhyInvalid(many), "");
  EXPECT_TRUE(names("NumberOfLeaves", [](ReevesTreeParameters& p) { p.NumberOfLeaves = -1; }));
  EXPECT_TRUE(names("LeafSize", [](ReevesTreeParameters& p) { p.LeafSize = 0.0; }));
}
