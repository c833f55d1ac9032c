// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BranchSkin.h"
#include "ReevesTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

INSTANTIATE_TEST_SUITE_P(
  Species, ReevesTreePresets, testing::Values(TreePreset::Pine, TreePreset::Oak, TreePreset::Birch, TreePreset::Shrub));

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
  EXPECT_TRUE(names("NumberOfLeaves", [](ReevesTreeParameters& p) { p.NumberOfLeaves = -1; }));
  EXPECT_TRUE(names("LeafSize", [](ReevesTreeParameters& p) { p.LeafSize = 0.0; }));
}
