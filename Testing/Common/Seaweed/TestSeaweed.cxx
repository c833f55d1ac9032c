// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Seaweeds: their skeletons, the paper's angles, what they weigh, and their meshes at all levels.
#include "Seaweed/SeaweedMesh.h"
#include "Seaweed/SeaweedPlant.h"
#include "Seaweed/SegmentAngles.h"

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

using namespace littoral;

namespace
{

constexpr double SeaWater = 1025.0; // [kg/m3]

class SeaweedPresets : public testing::TestWithParam<SeaweedPreset>
{
};

/// The foot of the segment that belongs to a node.
int FootOf(const Skeleton& wood, int node)
{
  const SkeletonBranch& branch = wood.Branches[wood.Nodes[node].Branch];
  return std::min(node, branch.First + branch.Count - 2);
}

/// Node positions from the angles and the segment lengths of a skeleton: local bases (columns X, Y, Z) are rotated by
/// Theta about Y and then by Phi about X.
std::vector<Vector3> PositionsOf(const Skeleton& wood, const std::vector<SegmentAngles>& angles)
{
  std::vector<glm::dmat3> bases;
  std::vector<Vector3> positions;
  for (int node = 0; node < static_cast<int>(wood.Nodes.size()); ++node)
  {
    const int foot = FootOf(wood, node);
    if (foot != node) // the tip of a branch
    {
      bases.push_back(bases[foot]);
      const double length = glm::distance(wood.Nodes[node].Position, wood.Nodes[foot].Position);
      positions.push_back(positions[foot] + length * bases[foot][1]);
      continue;
    }
    const glm::dmat3 ground(Vector3(1.0, 0.0, 0.0), Vector3(0.0, 0.0, 1.0), Vector3(0.0, -1.0, 0.0));
    const int parent = wood.Nodes[node].Parent < 0 ? -1 : FootOf(wood, wood.Nodes[node].Parent);
    const glm::dmat3 base = parent < 0 ? ground : bases[parent];
    bases.push_back(base *
      glm::mat3_cast(glm::angleAxis(angles[node].Theta, Vector3(0.0, 1.0, 0.0)) *
        glm::angleAxis(angles[node].Phi, Vector3(1.0, 0.0, 0.0))));
    positions.push_back(parent < 0 ? wood.Nodes[node].Position : positions[parent] + angles[node].Attachment * base[1]);
  }
  return positions;
}

/// Whether a node starts a segment, and the segment's length.
bool StartsSegment(const Skeleton& wood, int node, double& length)
{
  if (FootOf(wood, node) != node)
  {
    return false;
  }
  length = glm::distance(wood.Nodes[node].Position, wood.Nodes[node + 1].Position);
  return true;
}

double AreaOf(const PlantMesh& mesh, int polygon)
{
  Vector3 area(0.0);
  const int begin = mesh.Offsets[polygon];
  const int end = mesh.Offsets[polygon + 1];
  const Vector3& origin = mesh.Points[mesh.Corners[begin]];
  for (int corner = begin + 1; corner + 1 < end; ++corner)
  {
    area +=
      0.5 * glm::cross(mesh.Points[mesh.Corners[corner]] - origin, mesh.Points[mesh.Corners[corner + 1]] - origin);
  }
  return glm::length(area);
}

/// The nearest distance from a point to a branch [m].
double DistanceTo(const Skeleton& wood, int branch, const Vector3& point)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (int node = wood.Branches[branch].First; node < wood.Tip(branch); ++node)
  {
    const Vector3& from = wood.Nodes[node].Position;
    const Vector3 step = wood.Nodes[node + 1].Position - from;
    const double part = std::clamp(glm::dot(point - from, step) / glm::dot(step, step), 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(point, from + part * step));
  }
  return nearest;
}

void ExpectSoundMesh(const PlantMesh& mesh, bool hasJoints, int nodes)
{
  ASSERT_GT(mesh.NumberOfPolygons(), 0);
  ASSERT_EQ(mesh.Normals.size(), mesh.Points.size());
  ASSERT_EQ(mesh.Colors.size(), mesh.Points.size());
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    ASSERT_GT(AreaOf(mesh, polygon), 1e-12) << "polygon " << polygon;
  }
  std::set<int> used(mesh.Corners.begin(), mesh.Corners.end());
  EXPECT_EQ(used.size(), mesh.Points.size()) << "vertices without polygons";
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    ASSERT_TRUE(IsFinite(mesh.Points[vertex]));
    ASSERT_NEAR(glm::length(mesh.Normals[vertex]), 1.0, 1e-9);
    ASSERT_GT(mesh.Colors[vertex][0] + mesh.Colors[vertex][1] + mesh.Colors[vertex][2], 60) << "a black vertex";
  }
  ASSERT_EQ(mesh.JointIds.size(), hasJoints ? mesh.Points.size() : 0u);
  for (std::size_t vertex = 0; vertex < mesh.JointIds.size(); ++vertex)
  {
    double sum = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      ASSERT_GE(mesh.JointIds[vertex][i], 0);
      ASSERT_LT(mesh.JointIds[vertex][i], nodes);
      ASSERT_GE(mesh.JointWeights[vertex][i], 0.0);
      sum += mesh.JointWeights[vertex][i];
    }
    ASSERT_NEAR(sum, 1.0, 1e-12);
  }
}

bool SameBytes(const Seaweed& a, const Seaweed& b)
{
  bool same = a.Wood.Nodes.size() == b.Wood.Nodes.size() && a.Blades.size() == b.Blades.size();
  for (std::size_t i = 0; same && i < a.Wood.Nodes.size(); ++i)
  {
    same = a.Wood.Nodes[i].Position == b.Wood.Nodes[i].Position && a.Segments[i].Width == b.Segments[i].Width &&
      a.Segments[i].Across == b.Segments[i].Across;
  }
  for (std::size_t i = 0; same && i < a.Blades.size(); ++i)
  {
    same = a.Blades[i].Tint == b.Blades[i].Tint && a.Blades[i].Phase == b.Blades[i].Phase;
  }
  return same;
}

/// What an eye far away in a direction sees of a mesh if nothing hides anything [m2].
double SeenArea(const PlantMesh& mesh, const Vector3& towards)
{
  double sum = 0.0;
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    Vector3 area(0.0);
    const int begin = mesh.Offsets[polygon];
    const Vector3& origin = mesh.Points[mesh.Corners[begin]];
    for (int corner = begin + 1; corner + 1 < mesh.Offsets[polygon + 1]; ++corner)
    {
      area +=
        0.5 * glm::cross(mesh.Points[mesh.Corners[corner]] - origin, mesh.Points[mesh.Corners[corner + 1]] - origin);
    }
    sum += std::abs(glm::dot(area, towards));
  }
  return sum;
}

double HighestPoint(const PlantMesh& mesh)
{
  double highest = 0.0;
  for (const Vector3& point : mesh.Points)
  {
    highest = std::max(highest, point.z);
  }
  return highest;
}

}

TEST_P(SeaweedPresets, GrowsASoundSkeleton)
{
  SeaweedParameters p = PresetParameters(GetParam());
  ASSERT_EQ(WhyInvalid(p), "");
  for (int seed = 1; seed <= 6; ++seed)
  {
    p.Seed = seed;
    const Seaweed weed = GrowSeaweed(p);
    ASSERT_EQ(WhyInvalid(weed.Wood), "");
    ASSERT_EQ(weed.Segments.size(), weed.Wood.Nodes.size());
    int roots = 0;
    int fronds = 0;
    for (std::size_t branch = 0; branch < weed.Wood.Branches.size(); ++branch)
    {
      const SkeletonBranch& run = weed.Wood.Branches[branch];
      roots += run.Order == 0 ? 1 : 0;
      fronds += run.Order == 1 ? 1 : 0;
      if (run.Order == 1)
      {
        EXPECT_EQ(run.Count, p.SegmentsPerBranch + 1);
      }
      EXPECT_EQ(weed.Segments[run.First].Tissue == SeaweedTissue::Holdfast, run.Order == 0);
    }
    EXPECT_EQ(roots, 1);
    EXPECT_EQ(fronds, p.NumberOfFronds);
    EXPECT_EQ(weed.Wood.Nodes.front().Position, Vector3(0.0, 0.0, 0.0));
    for (std::size_t node = 0; node < weed.Segments.size(); ++node)
    {
      ASSERT_EQ(WhyInvalid(weed.Segments[node]), "") << node;
      EXPECT_NEAR(weed.Wood.Nodes[node].Radius, EquivalentRadius(weed.Segments[node]), 1e-15);
      EXPECT_GE(weed.Wood.Nodes[node].Position.z, -1e-12) << "a joint below the ground";
      double length = 0.0;
      if (StartsSegment(weed.Wood, static_cast<int>(node), length))
      {
        const Vector3 along = (weed.Wood.Nodes[node + 1].Position - weed.Wood.Nodes[node].Position) / length;
        EXPECT_NEAR(glm::dot(along, weed.Segments[node].Across), 0.0, 1e-9);
      }
    }
  }
}

TEST_P(SeaweedPresets, SegmentsOfABladeGetLongerFromItsFootAndAddUp)
{
  const Seaweed weed = GrowSeaweed(PresetParameters(GetParam()));
  ASSERT_FALSE(weed.Blades.empty());
  for (const SeaweedBlade& blade : weed.Blades)
  {
    const SkeletonBranch& run = weed.Wood.Branches[blade.Branch];
    const int first = run.First + blade.FirstStep;
    const int last = weed.Wood.Tip(blade.Branch);
    double sum = 0.0;
    double before = 0.0;
    for (int node = first; node < last; ++node)
    {
      const double length = glm::distance(weed.Wood.Nodes[node].Position, weed.Wood.Nodes[node + 1].Position);
      if (node > first)
      {
        const bool isGraded = node - first <= std::min(5, (last - first) / 2);
        EXPECT_NEAR(length, (isGraded ? 1.6 : 1.0) * before, 1e-12 * blade.Length);
      }
      before = length;
      EXPECT_EQ(weed.Segments[node].Tissue, SeaweedTissue::Blade);
      EXPECT_LE(weed.Segments[node].Width, blade.Width * (1.0 + 1e-12));
      sum += length;
    }
    EXPECT_NEAR(sum, blade.Length, 1e-12 * blade.Length);
  }
}

TEST_P(SeaweedPresets, BranchesStartOnTheirParent)
{
  const Seaweed weed = GrowSeaweed(PresetParameters(GetParam()));
  for (const SkeletonBranch& run : weed.Wood.Branches)
  {
    const int parent = weed.Wood.Nodes[run.First].Parent;
    if (parent >= 0)
    {
      const int branch = weed.Wood.Nodes[parent].Branch;
      EXPECT_LT(DistanceTo(weed.Wood, branch, weed.Wood.Nodes[run.First].Position), 1e-12);
    }
  }
}

TEST_P(SeaweedPresets, ThePapersAnglesGiveTheSkeleton)
{
  const Seaweed weed = GrowSeaweed(PresetParameters(GetParam()));
  const std::vector<SegmentAngles> angles = AnglesOf(weed.Wood);
  const std::vector<Vector3> positions = PositionsOf(weed.Wood, angles);
  for (std::size_t node = 0; node < positions.size(); ++node)
  {
    ASSERT_LT(glm::distance(positions[node], weed.Wood.Nodes[node].Position), 1e-11) << node;
    EXPECT_GE(angles[node].Phi, 0.0);
    EXPECT_LE(angles[node].Phi, 3.2);
  }
}

TEST_P(SeaweedPresets, FloatsInWater)
{
  const Seaweed weed = GrowSeaweed(PresetParameters(GetParam()));
  double lift = 0.0;
  double mass = 0.0;
  int floats = 0;
  for (int node = 0; node < static_cast<int>(weed.Segments.size()); ++node)
  {
    double length = 0.0;
    const SeaweedSegment& segment = weed.Segments[node];
    if (!StartsSegment(weed.Wood, node, length) || segment.Tissue == SeaweedTissue::Holdfast)
    {
      continue;
    }
    const double own = NetBuoyancy(segment, length, SeaWater);
    lift += own;
    mass += SegmentMass(segment, length);
    EXPECT_GT(JointStiffness(segment, length), 0.0);
    if (segment.Tissue == SeaweedTissue::Float)
    {
      EXPECT_GT(own, 0.0) << "a float that sinks";
      ++floats;
    }
  }
  EXPECT_GT(lift, 0.0) << "the whole plant sinks";
  EXPECT_GT(mass, 0.0);
  const bool isCanopy = GetParam() == SeaweedPreset::GiantKelp;
  EXPECT_EQ(floats, isCanopy ? static_cast<int>(weed.Blades.size()) : 0);
}

TEST_P(SeaweedPresets, HasSoundMeshes)
{
  SeaweedParameters p = PresetParameters(GetParam());
  for (int seed = 1; seed <= 3; ++seed)
  {
    p.Seed = seed;
    const PlantPrototype prototype = LevelsOf(GrowSeaweed(p), PlantLevelOptions{});
    const int nodes = static_cast<int>(prototype.Wood.Nodes.size());
    ExpectSoundMesh(prototype.Skin, true, nodes);
    ExpectSoundMesh(prototype.Leaves, true, nodes);
    ExpectSoundMesh(prototype.Trunk, false, nodes);
    ExpectSoundMesh(prototype.Crown, false, nodes);
    ExpectSoundMesh(prototype.Low, false, nodes);
    EXPECT_EQ(prototype.Low.NumberOfPolygons(), 4);
    EXPECT_LT(3 * prototype.Crown.NumberOfPolygons(), 2 * prototype.Leaves.NumberOfPolygons());
    EXPECT_EQ(prototype.CrownTexture.Columns, PlantLevelOptions{}.TextureColumns);
    for (const PlantMesh* mesh : { &prototype.Leaves, &prototype.Crown })
    {
      for (const auto& at : mesh->TCoords)
      {
        ASSERT_TRUE(at[0] >= 0.0 && at[0] <= 1.0 && at[1] >= 0.0 && at[1] <= 1.0);
      }
    }
  }
}

TEST_P(SeaweedPresets, HoldfastFollowsNothingThatMoves)
{
  const Seaweed weed = GrowSeaweed(PresetParameters(GetParam()));
  const PlantMesh skin = StipesOf(weed);
  int fixed = 0;
  for (const auto& joints : skin.JointIds)
  {
    const bool holds = weed.Segments[joints[0]].Tissue == SeaweedTissue::Holdfast;
    for (const int joint : joints)
    {
      EXPECT_EQ(weed.Segments[joint].Tissue == SeaweedTissue::Holdfast, holds) << "half of a vertex is held";
    }
    fixed += holds ? 1 : 0;
  }
  EXPECT_GT(fixed, 20);
}

TEST_P(SeaweedPresets, BladesLieOnTheirSkeleton)
{
  SeaweedParameters p = PresetParameters(GetParam());
  p.Ruffle = 0.0;
  const Seaweed weed = GrowSeaweed(p);
  RibbonOptions options;
  options.RowsOfSegment = 4;
  const PlantMesh mesh = RibbonsOf(weed, options);
  for (std::size_t vertex = 0; vertex + 1 < mesh.Points.size(); vertex += 2)
  {
    const int branch = weed.Wood.Nodes[mesh.JointIds[vertex][0]].Branch;
    const Vector3 middle = 0.5 * (mesh.Points[vertex] + mesh.Points[vertex + 1]);
    const double segment = weed.Wood.BranchLength(branch) / (weed.Wood.Branches[branch].Count - 1);
    EXPECT_LT(DistanceTo(weed.Wood, branch, middle), 0.1 * segment);
    EXPECT_LE(glm::distance(mesh.Points[vertex], mesh.Points[vertex + 1]), 1.5 * p.BladeWidth);
  }
}

TEST_P(SeaweedPresets, LowerLevelsAreAsLargeAsThePlant)
{
  const PlantPrototype prototype = LevelsOf(GrowSeaweed(PresetParameters(GetParam())), PlantLevelOptions{});
  const double height = std::max(HighestPoint(prototype.Skin), HighestPoint(prototype.Leaves));
  EXPECT_NEAR(std::max(HighestPoint(prototype.Trunk), HighestPoint(prototype.Crown)), height, 0.05 * height);
  EXPECT_NEAR(HighestPoint(prototype.Low), height, 1e-9 * height);
  const Vector3 side{ 0.6, 0.8, 0.0 };
  const double blades = SeenArea(prototype.Leaves, side);
  EXPECT_NEAR(SeenArea(prototype.Crown, side), blades, 0.35 * blades);
  const double all = blades + SeenArea(prototype.Skin, side);
  EXPECT_LT(SeenArea(prototype.Low, side), 2.0 * all);
  EXPECT_GT(SeenArea(prototype.Low, side), 0.5 * all);
}

TEST_P(SeaweedPresets, IsAFunctionOfItsSeed)
{
  SeaweedParameters p = PresetParameters(GetParam());
  const Seaweed one = GrowSeaweed(p);
  EXPECT_TRUE(SameBytes(one, GrowSeaweed(p)));
  p.Seed = 2;
  EXPECT_FALSE(SameBytes(one, GrowSeaweed(p)));
}

TEST_P(SeaweedPresets, TakesAnyNumberOfSegments)
{
  SeaweedParameters p = PresetParameters(GetParam());
  for (const int segments : { 2, 3, 16, 64 })
  {
    p.SegmentsPerBranch = segments;
    ASSERT_EQ(WhyInvalid(p), "");
    const Seaweed weed = GrowSeaweed(p);
    ASSERT_EQ(WhyInvalid(weed.Wood), "");
    ExpectSoundMesh(RibbonsOf(weed, {}), true, static_cast<int>(weed.Wood.Nodes.size()));
  }
}

namespace
{

std::vector<SeaweedPreset> AllSpecies()
{
  std::vector<SeaweedPreset> presets;
  for (int preset = 0; preset < NumberOfSeaweedPresets; ++preset)
  {
    presets.push_back(static_cast<SeaweedPreset>(preset));
  }
  return presets;
}

}

INSTANTIATE_TEST_SUITE_P(
  Species, SeaweedPresets, testing::ValuesIn(AllSpecies()), [](const auto& one) { return TraitsOf(one.param).Name; });

TEST(Seaweed, SizesAreThoseOfTheSpecies)
{
  const auto height = [](SeaweedPreset preset) {
    const PlantPrototype prototype = LevelsOf(GrowSeaweed(PresetParameters(preset)), PlantLevelOptions{});
    return std::max(HighestPoint(prototype.Skin), HighestPoint(prototype.Leaves));
  };
  EXPECT_GT(height(SeaweedPreset::SugarKelp), 1.0);
  EXPECT_LT(height(SeaweedPreset::SugarKelp), 3.0);
  EXPECT_GT(height(SeaweedPreset::GiantKelp), 10.0);
  EXPECT_LT(height(SeaweedPreset::GiantKelp), 30.0);
  EXPECT_GT(height(SeaweedPreset::Eelgrass), 0.3);
  EXPECT_LT(height(SeaweedPreset::Eelgrass), 1.0);
}

TEST(Seaweed, MassAndStiffnessAreThoseOfBeams)
{
  SeaweedSegment round;
  round.Width = round.Thickness = 0.02;
  round.YoungModulus = 2e7;
  round.Density = 1000.0;
  EXPECT_NEAR(SegmentMass(round, 0.5), 1000.0 * 3.14159265358979 * 1e-4 * 0.5, 1e-12);
  EXPECT_NEAR(SecondMoment(round), 3.14159265358979 * 1e-8 / 4.0, 1e-20);
  EXPECT_NEAR(JointStiffness(round, 0.5), 2e7 * 3.14159265358979 * 1e-8 / 4.0 / 0.5, 1e-12);
  EXPECT_NEAR(EquivalentRadius(round), 0.01, 1e-15);
  EXPECT_NEAR(NetBuoyancy(round, 0.5, 1025.0), 25.0 * 9.80665 * 3.14159265358979e-4 * 0.5, 1e-9);
}

TEST(Seaweed, FrondsStandEvenlyOnTheUpperPartOfTheHoldfast)
{
  SeaweedParameters parameters;
  parameters.NumberOfFronds = 30;
  const Skeleton wood = GrowSeaweed(parameters).Wood;
  const double top = wood.Nodes[1].Position.z;
  std::vector<double> parts;
  for (std::size_t branch = 1; branch < wood.Branches.size(); ++branch)
  {
    parts.push_back(wood.Nodes[wood.Branches[branch].First].Position.z / top);
  }
  std::sort(parts.begin(), parts.end());
  ASSERT_EQ(parts.size(), 30u);
  EXPECT_NEAR(std::accumulate(parts.begin(), parts.end(), 0.0) / 30.0, 0.7, 1e-9); // between 0.4 and 1
  for (std::size_t n = 1; n < parts.size(); ++n)
  {
    EXPECT_NEAR(parts[n] - parts[n - 1], 0.02, 1e-9);
  }
}

// A bent chain of three links, cut into many points: the moment of inertia of all beyond a joint about its foot, and
// the work that it takes to turn one link while those on it keep their directions.
TEST(Seaweed, DampingAndBuoyancyOfAChainAreThoseOfItsPoints)
{
  std::vector<SeaweedLink> links(3);
  const Vector3 axes[3] = { { 0.0, 0.0, 1.0 }, { 0.6, 0.0, 0.8 }, { 0.0, 1.0, 0.0 } };
  const double lengths[3] = { 0.5, 0.8, 0.3 };
  Vector3 foot(0.0);
  for (int n = 0; n < 3; ++n)
  {
    links[n].Parent = n - 1;
    links[n].Foot = foot;
    links[n].Axis = axes[n];
    links[n].Length = lengths[n];
    links[n].Mass = 0.2 + 0.1 * n;
    links[n].FaceMass = 0.05 * n;
    links[n].Stiffness = 3.0 - n;
    links[n].Buoyancy = 1.5 - n; // the last one sinks
    foot += lengths[n] * axes[n];
  }
  SetDamping(links, { 0.1, 0.2, 0.3 });
  constexpr int Points = 2000;
  for (int n = 0; n < 3; ++n)
  {
    double inertia = 0.0;
    double tops = 0.0;
    for (int link = n; link < 3; ++link)
    {
      for (int point = 0; point < Points; ++point)
      {
        const Vector3 arm = links[link].Foot + (point + 0.5) / Points * lengths[link] * axes[link] - links[n].Foot;
        inertia += (links[link].Mass + links[link].FaceMass) / Points * glm::dot(arm, arm);
      }
      tops += link > n ? links[link].Buoyancy : 0.0;
    }
    const double ratio = 0.1 * (n + 1);
    EXPECT_NEAR(links[n].Damping, 2.0 * ratio * std::sqrt(links[n].Stiffness * inertia), 1e-6);
    // Energy of an upright link that is turned by a small angle: its middle and its end, which carries the rest, sink.
    const double angle = 1e-3;
    const double sunk = 1.0 - std::cos(angle);
    const double energy = links[n].Buoyancy * 0.5 * lengths[n] * sunk + tops * lengths[n] * sunk;
    EXPECT_NEAR(links[n].BuoyancyStiffness, std::max(0.0, 2.0 * energy / (angle * angle)), 1e-5);
  }
}

TEST(Seaweed, AnglesOfABendAreThoseOfThePaper)
{
  // Up, then to the east: theta about the vertical from Z = -y towards X = x, phi a right angle.
  Skeleton wood;
  wood.StartBranch(-1, { 0.0, 0.0, 0.0 }, 0.01);
  wood.Grow({ 0.0, 0.0, 2.0 }, 0.01);
  wood.Grow({ 1.0, 0.0, 2.0 }, 0.01);
  wood.StartBranch(0, { 0.0, 0.0, 0.5 }, 0.01);
  wood.Grow({ 0.0, -3.0, 0.5 }, 0.01);
  const std::vector<SegmentAngles> angles = AnglesOf(wood);
  const double right = 1.5707963267948966;
  EXPECT_EQ(angles[0].Phi, 0.0);
  EXPECT_EQ(angles[0].Theta, 0.0);
  EXPECT_NEAR(angles[1].Attachment, 2.0, 1e-15);
  EXPECT_NEAR(angles[1].Theta, right, 1e-15);
  EXPECT_NEAR(angles[1].Phi, right, 1e-15);
  EXPECT_NEAR(angles[3].Attachment, 0.5, 1e-15);
  EXPECT_NEAR(angles[3].Theta, 0.0, 1e-15);
  EXPECT_NEAR(angles[3].Phi, right, 1e-15);
}

TEST(Seaweed, NamesBadParameters)
{
  const auto names = [](const char* word, void (*spoil)(SeaweedParameters&)) {
    SeaweedParameters p;
    spoil(p);
    return WhyInvalid(p).rfind(word, 0) == 0;
  };
  constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(names("Form", [](SeaweedParameters& p) { p.Form = static_cast<SeaweedForm>(3); }));
  EXPECT_TRUE(names("NumberOfFronds", [](SeaweedParameters& p) { p.NumberOfFronds = 0; }));
  EXPECT_TRUE(names("BladeLength", [](SeaweedParameters& p) { p.BladeLength = NaN; }));
  EXPECT_TRUE(names("BladeWidth", [](SeaweedParameters& p) { p.BladeWidth = -0.1; }));
  EXPECT_TRUE(names("SegmentsPerBranch", [](SeaweedParameters& p) { p.SegmentsPerBranch = 1; }));
  EXPECT_TRUE(names("BladeModulus", [](SeaweedParameters& p) { p.BladeModulus = 0.0; }));
  EXPECT_TRUE(names("StipeDensity", [](SeaweedParameters& p) { p.StipeDensity = 0.0; }));
  EXPECT_TRUE(names("StipeLength", [](SeaweedParameters& p) {
    p.Form = SeaweedForm::Canopy;
    p.StipeLength = 0.1;
  }));
  EXPECT_TRUE(names("BladeSpacing", [](SeaweedParameters& p) {
    p.Form = SeaweedForm::Canopy;
    p.StipeLength = 100.0;
    p.NumberOfFronds = 500;
  }));
  SeaweedSegment segment;
  segment.Density = 0.0;
  EXPECT_EQ(WhyInvalid(segment).rfind("Density", 0), 0u);
  segment = {};
  segment.YoungModulus = -1.0;
  EXPECT_EQ(WhyInvalid(segment).rfind("YoungModulus", 0), 0u);
}
