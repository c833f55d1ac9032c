// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// What holds for the meshes of all plants: normals agree with the winding, and what is round is closed.
#include "Numerics/Constants.h"
#include "Plants/AonoKuniiTree.h"
#include "Plants/BranchSkin.h"
#include "Plants/GardnerPlant.h"
#include "Plants/LeafCards.h"
#include "Plants/PlantLevels.h"
#include "Plants/ReevesTree.h"
#include "Seaweed/SeaweedGrowth.h"
#include "Seaweed/SeaweedMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace littoral;

namespace
{

struct Named
{
  std::string Name;
  PlantPrototype Plant;
};

/// Presets of all kinds of plants, with crowns that are dented too.
std::vector<Named> MakeAllPlants()
{
  PlantLevelOptions options;
  options.TextureColumns = 32;
  options.TextureRows = 16;
  std::vector<Named> plants;
  const auto add = [&](const std::string& kind, int preset, const auto& plant) {
    plants.push_back({ kind + " " + std::to_string(preset), LevelsOf(plant, options) });
  };
  for (int preset = 0; preset < NumberOfForkPresets; ++preset)
  {
    options.Crown = preset % 3 == 0 ? MediumCrown::Leaves : MediumCrown::Envelope;
    options.CrownJitter = preset % 3 == 1 ? 0.0 : 0.4;
    if (preset < NumberOfTreePresets)
    {
      ReevesTreeParameters parameters = PresetParameters(static_cast<TreePreset>(preset));
      parameters.NumberOfLeaves = std::min(parameters.NumberOfLeaves, 3000);
      add("Reeves", preset, GrowReevesTree(parameters));
    }
    if (preset % 4 == 1)
    {
      add("Aono-Kunii", preset, GrowAonoKuniiTree(PresetParameters(static_cast<ForkPreset>(preset))));
    }
    if (preset < NumberOfGardnerPresets)
    {
      add("Gardner", preset, GrowGardnerPlant(PresetParameters(static_cast<GardnerPreset>(preset))));
    }
    if (preset < NumberOfSeaweedPresets)
    {
      add("Seaweed", preset, GrowSeaweed(PresetParameters(static_cast<SeaweedPreset>(preset))));
    }
  }
  return plants;
}

const std::vector<Named>& AllPlants()
{
  static const std::vector<Named> plants = MakeAllPlants();
  return plants;
}

/// Twice the area of a polygon, along the normal of its winding.
Vector3 AreaOf(const PlantMesh& mesh, int polygon)
{
  const int begin = mesh.Offsets[polygon];
  const int end = mesh.Offsets[polygon + 1];
  const Vector3& origin = mesh.Points[mesh.Corners[begin]];
  Vector3 area(0.0);
  for (int corner = begin + 1; corner + 1 < end; ++corner)
  {
    area += glm::cross(mesh.Points[mesh.Corners[corner]] - origin, mesh.Points[mesh.Corners[corner + 1]] - origin);
  }
  return area;
}

/// Corners whose normal is not on the front of the polygon.
int WrongNormals(const PlantMesh& mesh)
{
  int wrong = 0;
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    const Vector3 front = Normalised(AreaOf(mesh, polygon));
    for (int corner = mesh.Offsets[polygon]; corner < mesh.Offsets[polygon + 1]; ++corner)
    {
      wrong += !(glm::dot(front, mesh.Normals[mesh.Corners[corner]]) > 0.0);
    }
  }
  return wrong;
}

using Place = std::tuple<double, double, double>;

/// Edges that are not in two polygons, once in each direction. Vertices at the same place are one.
int OpenEdges(const PlantMesh& mesh)
{
  std::map<Place, int> places;
  std::vector<int> own;
  for (const Vector3& point : mesh.Points)
  {
    own.push_back(places.insert({ { point.x, point.y, point.z }, static_cast<int>(places.size()) }).first->second);
  }
  std::map<std::pair<int, int>, int> edges;
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    const int begin = mesh.Offsets[polygon];
    const int count = mesh.Offsets[polygon + 1] - begin;
    for (int corner = 0; corner < count; ++corner)
    {
      ++edges[{ own[mesh.Corners[begin + corner]], own[mesh.Corners[begin + (corner + 1) % count]] }];
    }
  }
  int open = 0;
  for (const auto& [edge, count] : edges)
  {
    const auto back = edges.find({ edge.second, edge.first });
    open += !(edge.first != edge.second && count == 1 && back != edges.end() && back->second == 1);
  }
  return open;
}

}

TEST(PlantMeshes, NormalsAgreeWithTheWinding)
{
  for (const Named& plant : AllPlants())
  {
    for (const auto& [name, mesh] : std::initializer_list<std::pair<const char*, const PlantMesh&>>{
           { "Skin", plant.Plant.Skin }, { "Leaves", plant.Plant.Leaves }, { "Trunk", plant.Plant.Trunk },
           { "Crown", plant.Plant.Crown }, { "Low", plant.Plant.Low } })
    {
      EXPECT_EQ(WrongNormals(mesh), 0) << plant.Name << " " << name << " of " << mesh.Corners.size();
    }
  }
}

// Both sides of a triangle on the same vertices have no common front.
TEST(PlantMeshes, PolygonsWithoutACommonFrontGetVerticesOfTheirOwn)
{
  PlantMesh mesh;
  mesh.Points = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } };
  mesh.Normals.assign(3, Normalised({ 0.3, -0.5, 0.1 }));
  mesh.AddPolygon(std::array<int, 3>{ 0, 1, 2 });
  TurnNormalsToFronts(mesh);
  EXPECT_EQ(mesh.Normals, std::vector<Vector3>(3, Normalised({ 0.3, -0.5, 0.1 }))); // nothing to do
  mesh.AddPolygon(std::array<int, 3>{ 0, 2, 1 });
  TurnNormalsToFronts(mesh);
  EXPECT_EQ(WrongNormals(mesh), 0);
  EXPECT_EQ(mesh.Points.size(), 6u);
  EXPECT_EQ(OpenEdges(mesh), 0);
}

TEST(PlantMeshes, SkinsAreClosed)
{
  for (const Named& plant : AllPlants())
  {
    EXPECT_EQ(OpenEdges(plant.Plant.Skin), 0) << plant.Name;
    EXPECT_EQ(OpenEdges(plant.Plant.Trunk), 0) << plant.Name;
    if (plant.Plant.CrownIsEnvelope) // else cards or blades
    {
      EXPECT_EQ(OpenEdges(plant.Plant.Crown), 0) << plant.Name;
    }
  }
}

namespace
{

/// By the divergence theorem [m3]: a third of the integral of the place along the normal.
double VolumeOf(const PlantMesh& mesh)
{
  double volume = 0.0;
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    volume += glm::dot(mesh.Points[mesh.Corners[mesh.Offsets[polygon]]], AreaOf(mesh, polygon)) / 6.0;
  }
  return volume;
}

/// Of the cones between the nodes of a branch and at its tip, of as many sides [m3].
double VolumeOfCones(const Skeleton& skeleton, const SkeletonBranch& branch, int sides)
{
  const auto section = [&](int node) {
    const double radius = skeleton.Nodes[node].Radius;
    return 0.5 * sides * std::sin(TwoPi / sides) * radius * radius;
  };
  const int tip = branch.First + branch.Count - 1;
  double volume = section(tip) * skeleton.Nodes[tip].Radius / 3.0;
  for (int node = branch.First; node < tip; ++node)
  {
    const double height = glm::distance(skeleton.Nodes[node].Position, skeleton.Nodes[node + 1].Position);
    const double low = section(node);
    const double high = section(node + 1);
    volume += height * (low + high + std::sqrt(low * high)) / 3.0;
  }
  return volume;
}

double VolumeOfCones(const Skeleton& skeleton)
{
  double thickest = 0.0;
  for (const SkeletonNode& node : skeleton.Nodes)
  {
    thickest = std::max(thickest, node.Radius);
  }
  double volume = 0.0;
  for (const SkeletonBranch& branch : skeleton.Branches)
  {
    const int sides = NumberOfSides(skeleton.Nodes[branch.First].Radius, thickest, BranchSkinOptions().MaximumSides);
    volume += VolumeOfCones(skeleton, branch, sides);
  }
  return volume;
}

}

// Straight branches in any direction, thinner and thicker along them.
TEST(PlantMeshes, SkinsOfStraightBranchesHoldTheVolumeOfTheirCones)
{
  const double radii[] = { 0.3, 0.21, 0.25, 0.1, 0.02 };
  for (const Vector3& step : { Vector3(0.0, 0.0, 1.0), Vector3(1.0, 0.2, -0.3), Vector3(-0.4, -2.0, 0.7) })
  {
    Skeleton skeleton;
    for (int branch = 0; branch < 4; ++branch)
    {
      const Vector3 foot(3.0 * branch, 1.0, -2.0);
      skeleton.StartBranch(-1, foot, radii[0] / (1 + branch));
      for (int node = 1; node < 5; ++node)
      {
        skeleton.Grow(foot + static_cast<double>(node * node) * step, radii[node] / (1 + branch));
      }
    }
    const PlantMesh skin = SkinOf(skeleton, {});
    EXPECT_EQ(OpenEdges(skin), 0);
    EXPECT_NEAR(VolumeOf(skin), VolumeOfCones(skeleton), 1e-12 * VolumeOfCones(skeleton));
  }
}

// Where branches bend, rings are tilted: a little less or more. An open foot or a tip turned inside out is seen.
TEST(PlantMeshes, SkinsHoldTheVolumeOfTheirCones)
{
  for (const Named& plant : AllPlants())
  {
    if (plant.Plant.Segments.empty()) // else floats and haptera
    {
      EXPECT_NEAR(VolumeOf(plant.Plant.Skin) / VolumeOfCones(plant.Plant.Wood), 1.0, 0.05) << plant.Name;
    }
    else
    {
      EXPECT_GT(VolumeOf(plant.Plant.Skin), 0.0);
    }
  }
}

// Seven blades on a twig fill most of the kite and hardly anything beside it, and there are gaps between them at its rim.
TEST(PlantMeshes, SprayIsWithinItsKite)
{
  const TextureImage picture = LeafPicture(LeafForm::Spray);
  int inside = 0;
  int filled = 0;
  int beside = 0;
  double shades = 0.0;
  for (int row = 0; row < picture.Rows; ++row)
  {
    for (int column = 0; column < picture.Columns; ++column)
    {
      const double across = std::abs(2.0 * (column + 0.5) / picture.Columns - 1.0);
      const double along = (row + 0.5) / picture.Rows;
      const bool isInside = across < std::min(along / 0.42, (1.0 - along) / 0.58);
      const bool isLeaf = picture.At(column, row)[3] >= 128;
      inside += isInside ? 1 : 0;
      filled += isInside && isLeaf ? 1 : 0;
      beside += !isInside && isLeaf ? 1 : 0;
      shades += isInside && isLeaf ? picture.At(column, row)[0] : 0.0;
    }
  }
  EXPECT_NEAR(static_cast<double>(filled) / inside, 0.78, 0.02);
  EXPECT_LT(static_cast<double>(beside) / filled, 0.06);
  // A mean has the color of the blades: their shade is also that of the gaps
  EXPECT_NEAR(shades / filled, picture.At(0, 0)[0], 0.02 * 255.0);
}

// Edges and tip of a leaf hang down: normals lean to them by the same angle, and the foot has the leaf's own.
TEST(PlantMeshes, NormalsOfLeavesLeanToTheirEdges)
{
  Plant plant;
  plant.Leaves.emplace_back();
  LeafParticle& leaf = plant.Leaves.back();
  leaf.Normal = leaf.Facing;
  const PlantMesh mesh = LeafCards(plant);
  EXPECT_NEAR(glm::length(mesh.Normals[0] - leaf.Normal), 0.0, 1e-12);
  for (const int corner : { 1, 2, 3 })
  {
    const Vector3 outward = mesh.Points[corner] - mesh.Points[0];
    EXPECT_NEAR(glm::dot(mesh.Normals[corner], leaf.Normal), 1.0 / std::hypot(1.0, 0.45), 1e-12);
    EXPECT_GT(glm::dot(mesh.Normals[corner], outward), 0.0);
  }
}
