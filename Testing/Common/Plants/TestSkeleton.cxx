// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/BranchSkin.h"
#include "Plants/Skeleton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

using namespace littoral;

namespace
{

/// A bent trunk with two branches and a twig.
Skeleton SmallPlant()
{
  Skeleton plant;
  plant.StartBranch(-1, { 0.0, 0.0, 0.0 }, 0.2);
  plant.Grow({ 0.0, 0.0, 2.0 }, 0.15);
  plant.Grow({ 0.3, 0.0, 4.0 }, 0.1);
  plant.StartBranch(1, { 0.0, 0.0, 2.0 }, 0.05);
  const int end = plant.Grow({ 1.0, 0.5, 3.0 }, 0.03);
  plant.StartBranch(2, { 0.3, 0.0, 4.0 }, 0.05);
  plant.Grow({ -1.0, 0.0, 4.0 }, 0.02);
  plant.StartBranch(end, { 1.0, 0.5, 3.0 }, 0.02);
  plant.Grow({ 1.0, 1.0, 3.0 }, 0.01);
  return plant;
}

std::string After(void (*spoil)(Skeleton&))
{
  Skeleton plant = SmallPlant();
  spoil(plant);
  return WhyInvalid(plant);
}

/// The representative of a vertex's connected piece.
int Root(std::vector<int>& group, int vertex)
{
  while (group[vertex] != vertex)
  {
    vertex = group[vertex] = group[group[vertex]];
  }
  return vertex;
}

}

TEST(Skeleton, OrdersAndLengths)
{
  const Skeleton plant = SmallPlant();
  EXPECT_EQ(WhyInvalid(plant), "");
  ASSERT_EQ(plant.Branches.size(), 4u);
  EXPECT_EQ(plant.Branches[0].Order, 0);
  EXPECT_EQ(plant.Branches[1].Order, 1);
  EXPECT_EQ(plant.Branches[2].Order, 1);
  EXPECT_EQ(plant.Branches[3].Order, 2);
  EXPECT_NEAR(plant.BranchLength(1), 1.5, 1e-15);
  EXPECT_NEAR(plant.BranchLength(0), 2.0 + std::sqrt(4.09), 1e-15);
}

TEST(Skeleton, PlacesAlongABranch)
{
  const Skeleton plant = SmallPlant();
  int node = -1;
  const Vector3 middle = plant.Along(0, 0.25, node);
  EXPECT_EQ(node, 0);
  EXPECT_NEAR(middle[2], 1.0, 1e-15);
  const Vector3 end = plant.Along(0, 1.0, node);
  EXPECT_EQ(node, 1);
  EXPECT_NEAR(end[2], 4.0, 1e-15);
}

TEST(Skeleton, SaysWhatIsWrong)
{
  const auto says = [](const std::string& text, const char* word) { return text.find(word) != std::string::npos; };
  EXPECT_TRUE(says(WhyInvalid(Skeleton{}), "needs nodes"));
  EXPECT_TRUE(says(After([](Skeleton& s) { s.Nodes[1].Parent = 4; }), "cycle"));
  EXPECT_TRUE(says(After([](Skeleton& s) { s.Nodes[1].Parent = 1; }), "cycle"));
  EXPECT_TRUE(says(After([](Skeleton& s) { s.Nodes[1].Parent = 99; }), "does not exist"));
  EXPECT_TRUE(says(After([](Skeleton& s) { s.Nodes[1].Parent = -2; }), "does not exist"));
  EXPECT_TRUE(says(After([](Skeleton& s) { s.Nodes[2].Branch = 9; }), "branch that does not exist"));
  EXPECT_TRUE(
    says(After([](Skeleton& s) { s.Nodes[2].Position[1] = std::numeric_limits<double>::quiet_NaN(); }), "finite"));
  EXPECT_TRUE(says(After([](Skeleton& s) { s.Nodes[2].Radius = 0.0; }), "radius"));
  EXPECT_TRUE(says(After([](Skeleton& s) { s.Nodes[2].Position = s.Nodes[1].Position; }), "zero length"));
  EXPECT_TRUE(says(After([](Skeleton& s) { s.Branches[3].Order = 1; }), "order"));
  EXPECT_TRUE(says(After([](Skeleton& s) { s.Branches[3].Count = 1; }), "run"));
  EXPECT_TRUE(says(After([](Skeleton& s) { s.Branches.pop_back(); }), "branch that does not exist"));
  EXPECT_TRUE(says(After([](Skeleton& s) { s.Nodes[2].Parent = 0; }), "node to node"));
}

TEST(Skeleton, FallsIntoItsPlants)
{
  // Three plants in a row; each comes back as it was.
  const Skeleton one = SmallPlant();
  Skeleton all;
  for (int copy = 0; copy < 3; ++copy)
  {
    const int firstNode = static_cast<int>(all.Nodes.size());
    const int firstBranch = static_cast<int>(all.Branches.size());
    for (SkeletonNode node : one.Nodes)
    {
      node.Parent += node.Parent < 0 ? 0 : firstNode;
      node.Branch += firstBranch;
      all.Nodes.push_back(node);
    }
    for (SkeletonBranch branch : one.Branches)
    {
      branch.First += firstNode;
      all.Branches.push_back(branch);
    }
  }
  ASSERT_EQ(WhyInvalid(all), "");
  const std::vector<Skeleton> plants = PlantsOf(all);
  ASSERT_EQ(plants.size(), 3u);
  for (const Skeleton& plant : plants)
  {
    EXPECT_EQ(WhyInvalid(plant), "");
    ASSERT_EQ(plant.Nodes.size(), one.Nodes.size());
    ASSERT_EQ(plant.Branches.size(), one.Branches.size());
    for (std::size_t node = 0; node < one.Nodes.size(); ++node)
    {
      EXPECT_EQ(plant.Nodes[node].Parent, one.Nodes[node].Parent);
      EXPECT_EQ(plant.Nodes[node].Branch, one.Nodes[node].Branch);
      EXPECT_EQ(plant.Nodes[node].Position, one.Nodes[node].Position);
    }
    for (std::size_t branch = 0; branch < one.Branches.size(); ++branch)
    {
      EXPECT_EQ(plant.Branches[branch].First, one.Branches[branch].First);
      EXPECT_EQ(plant.Branches[branch].Order, one.Branches[branch].Order);
    }
  }
  // A branch on the first plant after the second one's trunk.
  Skeleton mixed = SmallPlant();
  mixed.StartBranch(-1, { 5.0, 0.0, 0.0 }, 0.1);
  mixed.Grow({ 5.0, 0.0, 1.0 }, 0.1);
  mixed.StartBranch(1, { 0.0, 0.0, 2.0 }, 0.1);
  mixed.Grow({ 0.0, 1.0, 2.0 }, 0.1);
  ASSERT_EQ(WhyInvalid(mixed), "");
  EXPECT_TRUE(PlantsOf(mixed).empty());
}

TEST(BranchSkin, HasNoDegenerateTriangles)
{
  const PlantMesh mesh = SkinOf(SmallPlant(), {});
  ASSERT_GT(mesh.NumberOfPolygons(), 0);
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    ASSERT_EQ(mesh.Offsets[polygon + 1] - mesh.Offsets[polygon], 3);
    const int* corner = &mesh.Corners[mesh.Offsets[polygon]];
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_GE(corner[i], 0);
      ASSERT_LT(corner[i], static_cast<int>(mesh.Points.size()));
    }
    const Vector3& a = mesh.Points[corner[0]];
    const Vector3 across = glm::cross(mesh.Points[corner[1]] - a, mesh.Points[corner[2]] - a);
    EXPECT_GT(glm::length(across), 1e-6);
    EXPECT_GT(glm::dot(across, mesh.Normals[corner[0]]), 0.0) << "triangle " << polygon << " faces inward";
  }
}

TEST(BranchSkin, IsOnePieceABranch)
{
  const Skeleton plant = SmallPlant();
  const PlantMesh mesh = SkinOf(plant, {});
  std::vector<int> group(mesh.Points.size());
  std::iota(group.begin(), group.end(), 0);
  std::map<std::array<double, 3>, int> places; // vertices that are apart in normals or texture alone
  for (int vertex = 0; vertex < static_cast<int>(group.size()); ++vertex)
  {
    const Vector3& point = mesh.Points[vertex];
    group[vertex] = places.insert({ { point.x, point.y, point.z }, vertex }).first->second;
  }
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    for (int i = mesh.Offsets[polygon]; i + 1 < mesh.Offsets[polygon + 1]; ++i)
    {
      group[Root(group, mesh.Corners[i])] = Root(group, mesh.Corners[i + 1]);
    }
  }
  std::set<int> pieces;
  for (int vertex = 0; vertex < static_cast<int>(group.size()); ++vertex)
  {
    pieces.insert(Root(group, vertex));
  }
  EXPECT_EQ(pieces.size(), plant.Branches.size());
}

TEST(BranchSkin, LiesAroundTheJoints)
{
  const Skeleton plant = SmallPlant();
  const PlantMesh mesh = SkinOf(plant, {});
  ASSERT_EQ(mesh.JointIds.size(), mesh.Points.size());
  ASSERT_EQ(mesh.JointWeights.size(), mesh.Points.size());
  ASSERT_EQ(mesh.Normals.size(), mesh.Points.size());
  ASSERT_EQ(mesh.TCoords.size(), mesh.Points.size());
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    double sum = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      const int joint = mesh.JointIds[vertex][i];
      ASSERT_GE(joint, 0);
      ASSERT_LT(joint, static_cast<int>(plant.Nodes.size()));
      EXPECT_GE(mesh.JointWeights[vertex][i], 0.0);
      sum += mesh.JointWeights[vertex][i];
      EXPECT_EQ(plant.Nodes[joint].Branch, plant.Nodes[mesh.JointIds[vertex][0]].Branch);
    }
    EXPECT_DOUBLE_EQ(sum, 1.0);
    EXPECT_NEAR(glm::length(mesh.Normals[vertex]), 1.0, 1e-12);
  }
  for (int corner = 0; corner < 13; ++corner) // the trunk's first ring
  {
    EXPECT_NEAR(glm::length(mesh.Points[corner]), 0.2, 1e-12);
    EXPECT_NEAR(mesh.Points[corner][2], 0.0, 1e-12);
  }
}

TEST(BranchSkin, ThinBranchesGetFewerSides)
{
  EXPECT_EQ(NumberOfSides(0.2, 0.2, 12), 12);
  EXPECT_EQ(NumberOfSides(0.05, 0.2, 12), 6);
  EXPECT_EQ(NumberOfSides(1e-9, 0.2, 12), 3);
}

TEST(BranchSkin, RingsLieAroundTheirNodes)
{
  const Skeleton plant = SmallPlant();
  const PlantMesh mesh = SkinOf(plant, {});
  std::size_t vertex = 0;
  for (const SkeletonBranch& branch : plant.Branches)
  {
    const int sides = NumberOfSides(plant.Nodes[branch.First].Radius, 0.2, 12);
    const int last = branch.First + branch.Count - 1;
    for (int node = branch.First; node <= last; ++node)
    {
      const bool isBetween = node > branch.First && node < last;
      for (int corner = 0; corner <= sides; ++corner, ++vertex)
      {
        EXPECT_NEAR(glm::distance(mesh.Points[vertex], plant.Nodes[node].Position), plant.Nodes[node].Radius, 1e-12);
        // Of two segments that meet, half and half; at the ends the only one.
        EXPECT_EQ(mesh.JointWeights[vertex][0], isBetween ? 0.5 : 1.0);
        EXPECT_EQ(mesh.JointIds[vertex][0], std::min(node, last - 1));
        EXPECT_EQ(mesh.JointIds[vertex][1], isBetween ? node - 1 : mesh.JointIds[vertex][0]);
      }
    }
    const Vector3 end = glm::normalize(plant.Nodes[last].Position - plant.Nodes[last - 1].Position);
    EXPECT_NEAR(glm::distance(mesh.Points[vertex], plant.Nodes[last].Position + plant.Nodes[last].Radius * end), 0.0,
      1e-12);            // the tip
    vertex += 1 + sides; // and the corners of the foot
  }
  EXPECT_EQ(vertex, mesh.Points.size());
}
