// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../WindAlong.h"
#include "Plants/ReevesTree.h"
#include "Sway/SwayScene.h"
#include "Sway/TrunkSkin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>

using namespace littoral;
using littoral::testing::WindAlong;

namespace
{

/// A bare straight trunk.
Skeleton Mast(double length, double radius, const Vector3& foot = Vector3(0.0))
{
  constexpr int Segments = 12;
  Skeleton mast;
  mast.StartBranch(-1, foot, radius);
  for (int i = 1; i <= Segments; ++i)
  {
    mast.Grow(foot + Vector3(0.0, 0.0, length * i / Segments), radius);
  }
  return mast;
}

/// An oak at a site.
Skeleton OakAt(const PlantPlace& place)
{
  static const Skeleton oak = GrowReevesTree(PresetParameters(TreePreset::Oak)).Wood;
  return Placed(oak, place);
}

PlantPlace PlaceAt(const Vector3& foot, double scale = 1.0, double azimuth = 0.0)
{
  PlantPlace place;
  place.Foot = foot;
  place.Scale = scale;
  place.Azimuth = azimuth;
  return place;
}

std::shared_ptr<const FrozenWind> FieldOf(const WindAlong& wind)
{
  return std::shared_ptr<const FrozenWind>(new FrozenWind(wind.Field()));
}

WindAlong SteadyWind(double speed)
{
  WindAlong wind;
  wind.Speed = speed;
  wind.Gusts = 0.0;
  return wind;
}

/// The response of slender beams by the textbook: neither weight nor carried twigs make them softer.
SwaySettings TextbookSettings()
{
  SwaySettings settings;
  settings.Options.NumberOfModes = 5;
  settings.Options.Carries = false;
  return settings;
}

/// Deflection of the tip of a cantilever under the drag of a steady wind, q L^4 / (8 E I) [m].
double TextbookDeflection(double length, double radius, double speed, const SwayOptions& options)
{
  const double load = 0.5 * options.Load.AirDensity * options.Load.DragCoefficient * 2.0 * radius * speed * speed;
  const double secondMoment = Pi * std::pow(radius, 4) / 4.0;
  return load * std::pow(length, 4) / (8.0 * options.Wood.YoungModulus * secondMoment);
}

/// Adds a plant in full of the row's wood.
void Add(SwayScene& scene, int row, const Skeleton& rest)
{
  ASSERT_EQ(scene.AddPlant(row, rest, scene.BeamsOf(row, rest, {})), "");
}

/// Positions of a scene's joints at a time.
std::vector<Vector3> JointsAt(SwayScene& scene, double time, std::size_t first, std::size_t count)
{
  scene.MoveTo(time);
  std::vector<Vector3> positions;
  for (std::size_t node = first; node < first + count; ++node)
  {
    positions.push_back(scene.JointPosition(node));
  }
  return positions;
}

/// One area of the atlas above the other, each a unit high, so that coordinates tell the number of the picture.
std::vector<AtlasArea> StackedAreas(int count)
{
  std::vector<AtlasArea> areas(static_cast<std::size_t>(count));
  for (int area = 0; area < count; ++area)
  {
    areas[area].Corner[1] = area;
  }
  return areas;
}

}

TEST(SwayScene, PlantsMoveAsEachDoesAloneInTheWindByItsFormula)
{
  WindAlong wind;
  wind.Direction = 2.2;
  const std::vector<PlantPlace> places = { PlaceAt({ 10.0, -20.0, 2.0 }, 0.8, 1.0), PlaceAt({ -15.0, 5.0, -1.0 }),
    PlaceAt({ 0.0, 30.0, 0.0 }, 1.1, 4.0) };
  for (const SwayResponse response : { SwayResponse::Interpolated, SwayResponse::Direct })
  {
    SwaySettings settings;
    settings.Options.Response = response;
    settings.Options.NumberOfModes = 2;
    SwayScene scene(settings, FieldOf(wind), places, {});
    for (int row = 0; row < 3; ++row)
    {
      Add(scene, row, OakAt(places[row]));
    }
    std::size_t first = 0;
    for (const PlantPlace& place : places)
    {
      const Skeleton rest = OakAt(place);
      const auto beams = BeamsOf(rest, {}, settings.Options);
      int node = 0;
      PlantSway sway(beams, settings.Options, wind.Times(), rest.Along(0, 0.75, node), wind.Formula());
      std::vector<Vector3> amplitudes(2 * beams.size());
      sway.Amplitudes(7.3, amplitudes.data());
      std::vector<JointPose> poses(rest.Nodes.size());
      PlantMotion(rest, 2, beams.front().Modes).Pose(amplitudes.data(), poses.data());
      const Skeleton moved = Moved(rest, poses);
      const std::vector<Vector3> joints = JointsAt(scene, 7.3, first, rest.Nodes.size());
      double farthest = 0.0;
      double error = 0.0;
      for (std::size_t i = 0; i < joints.size(); ++i)
      {
        farthest = std::max(farthest, glm::distance(joints[i], rest.Nodes[i].Position));
        error = std::max(error, glm::distance(joints[i], moved.Nodes[i].Position));
      }
      std::printf("a joint goes %.3g m, and differs by %.2g m from the plant alone\n", farthest, error);
      EXPECT_GT(farthest, 0.01);
      EXPECT_LT(error, 1e-5 * farthest);
      first += rest.Nodes.size();
    }
  }
}

TEST(SwayScene, NeitherNeighborsNorEarlierTimesChangeAByte)
{
  const WindAlong wind;
  const std::vector<PlantPlace> places = { PlaceAt({ 10.0, -20.0, 2.0 }), PlaceAt({ -15.0, 5.0, -1.0 }, 1.0, 2.0) };
  const Skeleton oak = OakAt(places[1]);
  SwayScene alone({}, FieldOf(wind), places, {});
  Add(alone, 1, oak);
  const std::vector<Vector3> expected = JointsAt(alone, 3.7, 0, oak.Nodes.size());

  SwayScene both({}, FieldOf(wind), places, {});
  const Skeleton neighbor = OakAt(places[0]);
  Add(both, 0, neighbor);
  Add(both, 1, oak);
  for (const double time : { 41.0, -3.0, 3.6, 1e6 })
  {
    EXPECT_NE(JointsAt(both, time, neighbor.Nodes.size(), oak.Nodes.size()), expected);
  }
  EXPECT_EQ(JointsAt(both, 3.7, neighbor.Nodes.size(), oak.Nodes.size()), expected);
  const std::size_t bytes = oak.Nodes.size() * sizeof(JointChange);
  alone.MoveTo(3.7);
  EXPECT_EQ(std::memcmp(&both.GetChanges()[neighbor.Nodes.size()], alone.GetChanges().data(), bytes), 0);
}

TEST(SwayScene, SteadyWindBendsMastsByTheTextbook)
{
  constexpr double Speed = 3.0;
  const SwaySettings settings = TextbookSettings();
  const PlantPlace large = PlaceAt({ 20.0, 10.0, 1.0 }, 2.0, 0.7);
  const SwaySpecies species = MakeSpecies(Mast(3.0, 0.02), settings.Options.Wood, {}, settings);
  SwayScene scene(settings, FieldOf(SteadyWind(Speed)), { PlaceAt(Vector3(0.0)), large }, { species });
  // In full; in full and twice as large; and that as a trunk of the level Medium.
  Add(scene, 0, species.Rest);
  Add(scene, 1, Placed(species.Rest, large));
  int plant = -1;
  ASSERT_EQ(scene.FindTrunk(1, plant), "");
  ASSERT_EQ(plant, 2);
  scene.MoveTo(12.3);
  const std::size_t nodes = species.Rest.Nodes.size();
  const double exact[] = { TextbookDeflection(3.0, 0.02, Speed, settings.Options),
    TextbookDeflection(6.0, 0.04, Speed, settings.Options), TextbookDeflection(6.0, 0.04, Speed, settings.Options) };
  const Vector3 feet[] = { Vector3(0.0), large.Foot, large.Foot };
  for (std::size_t mast = 0; mast < 3; ++mast)
  {
    const Vector3 tip = scene.JointPosition((mast + 1) * nodes - 1) - feet[mast];
    std::printf("tip %.6g m, %.6f of q L^4 / 8 E I\n", tip.x, tip.x / exact[mast]);
    EXPECT_NEAR(tip.x / exact[mast], 1.0, 1e-4);
    EXPECT_NEAR(tip.y, 0.0, 1e-9);
    EXPECT_EQ(scene.JointPosition(mast * nodes), feet[mast]);
  }
}

TEST(SwayScene, FrequenciesOfMastsByTheTextbook)
{
  const SwaySettings settings = TextbookSettings();
  const SwaySpecies species = MakeSpecies(Mast(3.0, 0.02), settings.Options.Wood, {}, settings);
  const WoodParameters wood;
  const double radius = 0.02;
  const double stiffness = wood.YoungModulus * Pi * std::pow(radius, 4) / 4.0;
  const double mass = wood.Density * Pi * radius * radius;
  const double exact = 3.516015 / TwoPi * std::sqrt(stiffness / (mass * std::pow(3.0, 4)));
  std::printf("first mode %.6f Hz, %.6f by the textbook\n", species.SwingFrequency, exact);
  EXPECT_NEAR(species.SwingFrequency / exact, 1.0, 1e-3);
  SwayScene scene(settings, FieldOf(SteadyWind(3.0)),
    { PlaceAt(Vector3(0.0)), PlaceAt({ 5.0, 0.0, 0.0 }, 2.0), PlaceAt({ 9.0, 0.0, 0.0 }) }, { species });
  Add(scene, 0, species.Rest);
  int plant = -1;
  EXPECT_EQ(scene.FindTrunk(1, plant), "");
  EXPECT_NEAR(scene.GetFrequencies()[0] / exact, 1.0, 1e-3);
  EXPECT_NEAR(scene.GetFrequencies()[1] / exact, 0.5, 5e-4); // frequencies go by 1 / scale
  EXPECT_EQ(scene.GetFrequencies()[2], 0.0);                 // not added
}

TEST(SwayScene, BlocksOfTheMiddleLevelFollowTheirTrunk)
{
  const SwaySettings settings = TextbookSettings();
  const SwaySpecies species = MakeSpecies(Mast(3.0, 0.02), settings.Options.Wood, {}, settings);
  const Vector3 foot(8.0, -3.0, 2.0);
  SwayScene scene(settings, FieldOf(WindAlong()), { PlaceAt(Vector3(0.0)), PlaceAt(foot) }, { species });
  Add(scene, 0, species.Rest);
  int plant = -1;
  ASSERT_EQ(scene.FindTrunk(1, plant), "");
  int again = -1;
  ASSERT_EQ(scene.FindTrunk(1, again), "");
  EXPECT_EQ(again, plant);
  EXPECT_EQ(scene.GetNumberOfPlants(), 2u);

  // The first point belongs to another plant.
  const std::size_t nodes = species.Rest.Nodes.size();
  std::vector<float> points = { 9.0f, 9.0f, 9.0f };
  for (std::size_t node = 0; node < nodes; ++node)
  {
    const Vector3 position = foot + species.Rest.Nodes[node].Position;
    points.insert(points.end(), { float(position.x), float(position.y), float(position.z) });
  }
  std::vector<int> joints(4 * (nodes + 1), 0);
  std::vector<float> weights(4 * (nodes + 1), 0.0f);
  scene.FollowTrunk(plant, points.data(), 1, nodes + 1, joints.data(), weights.data());
  scene.MoveTo(5.0);
  std::vector<float> moved(points.size());
  MoveSkin({ points.data(), nullptr }, { joints.data(), weights.data(), nodes + 1 }, scene.GetChanges().data(), 0,
    nodes + 1, moved.data(), nullptr);
  EXPECT_TRUE(std::equal(moved.begin(), moved.begin() + 3, points.begin()));
  for (std::size_t node = 1; node + 1 < nodes; ++node)
  {
    const Vector3 joint = scene.JointPosition(nodes + node);
    const float* p = &moved[3 * (node + 1)];
    EXPECT_NEAR(glm::distance(joint, Vector3(p[0], p[1], p[2])), 0.0, 1e-4) << node;
  }
  EXPECT_GT(glm::distance(scene.JointPosition(2 * nodes - 1), foot + Vector3(0.0, 0.0, 3.0)), 0.01);
}

TEST(SwayScene, CrownsShowLaterWhatTheWindBringsLater)
{
  constexpr int Pictures = 8;
  constexpr double Downwind = 12.0;
  for (const double degrees : { 0.0, 90.0, 217.0 })
  {
    WindAlong wind;
    wind.Direction = degrees * Pi / 180.0;
    SwaySettings settings = TextbookSettings();
    settings.Pictures = Pictures;
    SwaySpecies still;
    still.CrownTCoords = { { 0.5, 0.5 } };
    SwaySpecies species = MakeSpecies(Mast(3.0, 0.02), settings.Options.Wood, {}, settings);
    species.CrownTCoords = { { 0.5, 0.5 }, { 0.25, 0.5 } };
    const Vector3 foot = 20.0 * wind.Along() - 30.0 * wind.Across();
    std::vector<PlantPlace> places = { PlaceAt(foot), PlaceAt(foot + Downwind * wind.Along()),
      PlaceAt(foot + 9.0 * wind.Across()) };
    for (PlantPlace& place : places)
    {
      place.Species = 1;
    }
    SwayScene scene(settings, FieldOf(wind), places, { still, species });
    scene.SetPictureAreas(StackedAreas(2 * Pictures));
    for (int row = 0; row < 3; ++row)
    {
      scene.AddCrown(row, 2 * static_cast<std::size_t>(row));
    }
    const auto picturesAt = [&](double time) {
      scene.MoveTo(time);
      std::array<float, 12> tcoords{};
      scene.ShowPictures(6, tcoords.data());
      std::array<int, 3> pictures{};
      for (int row = 0; row < 3; ++row)
      {
        EXPECT_EQ(tcoords[4 * row], 0.5f);
        EXPECT_EQ(tcoords[4 * row + 2], 0.25f);
        pictures[row] = static_cast<int>(tcoords[4 * row + 1]) - Pictures;
      }
      return pictures;
    };
    // The mast's first mode by the textbook, in whole swings a period.
    const WoodParameters wood;
    const double frequency = 3.516015 / TwoPi * 0.02 / 2.0 / 9.0 * std::sqrt(wood.YoungModulus / wood.Density);
    const double period = wind.Samples * wind.Spacing / wind.Speed;
    const double swings = std::round(frequency * period);
    int shifted = 0;
    std::map<int, int> shown;
    for (int k = 0; k < 64; ++k)
    {
      const double time = -7.0 + 0.2171 * k;
      const std::array<int, 3> pictures = picturesAt(time);
      const double phase = swings / period * (time - 20.0 / wind.Speed);
      EXPECT_EQ(pictures[0], static_cast<int>(Pictures * (phase - std::floor(phase))));
      EXPECT_EQ(pictures[2], pictures[0]);
      EXPECT_EQ(picturesAt(time + Downwind / wind.Speed)[1], pictures[0]);
      shifted += pictures[1] != pictures[0];
      ++shown[pictures[0]];
    }
    std::printf(
      "wind towards %3.0f degrees: a crown downwind shows another picture at %d of 64 times\n", degrees, shifted);
    EXPECT_GT(shifted, 32);
    EXPECT_EQ(shown.size(), static_cast<std::size_t>(Pictures));
  }
}

TEST(SwayScene, LeavesInOrderShareTheVerticesOut)
{
  const WindAlong wind;
  SwayScene scene({}, FieldOf(wind), { PlaceAt(Vector3(0.0)) }, {});
  EXPECT_TRUE(scene.AreLeavesInOrder());
  EXPECT_EQ(scene.VerticesOfLeaves(0, 0, 7), (std::array<std::size_t, 2>{ 0, 7 }));
  // Vertices of no leaf before, between and behind them; corners in any order.
  scene.AddLeaf({ 5, 2, 3, 4 }, 0, 1);
  scene.AddLeaf({ 6, 7, 8, 9 }, 0, 1);
  scene.AddLeaf({ 16, 14, 13, 12 }, 0, 1);
  EXPECT_TRUE(scene.AreLeavesInOrder());
  EXPECT_EQ(scene.VerticesOfLeaves(0, 1, 20), (std::array<std::size_t, 2>{ 0, 6 }));
  EXPECT_EQ(scene.VerticesOfLeaves(1, 2, 20), (std::array<std::size_t, 2>{ 6, 12 }));
  EXPECT_EQ(scene.VerticesOfLeaves(2, 3, 20), (std::array<std::size_t, 2>{ 12, 20 }));
  EXPECT_EQ(scene.VerticesOfLeaves(0, 3, 20), (std::array<std::size_t, 2>{ 0, 20 }));
  scene.AddLeaf({ 17, 15, 18, 19 }, 0, 1); // one corner among those of the last leaf
  EXPECT_FALSE(scene.AreLeavesInOrder());
  scene.AddLeaf({ 20, 21, 22, 23 }, 0, 1);
  EXPECT_FALSE(scene.AreLeavesInOrder());
}

TEST(SwayScene, LeavesFlutterAloneAndRestInCalm)
{
  const std::array<int, 4> corners{ 0, 1, 2, 3 };
  const std::array<int, 4> others{ 4, 5, 6, 7 };
  std::vector<float> rest;
  for (const double foot : { 2.0, 2.5 })
  {
    const auto z = static_cast<float>(foot);
    rest.insert(rest.end(), { 0.0f, 0.0f, z, 0.05f, -0.03f, z, 0.1f, 0.0f, z, 0.05f, 0.03f, z });
  }
  const auto turned = [&](const WindAlong& wind, bool withNeighbor) {
    SwayScene scene({}, FieldOf(wind), { PlaceAt(Vector3(0.0)), PlaceAt({ 5.0, 0.0, 0.0 }) }, {});
    int plant = 0;
    if (withNeighbor)
    {
      Add(scene, 1, Mast(4.0, 0.05, { 5.0, 0.0, 0.0 }));
      scene.AddLeaf(others, plant++, 77);
    }
    Add(scene, 0, Mast(3.0, 0.02));
    scene.AddLeaf(corners, plant, 55);
    scene.MoveTo(4.2);
    std::vector<float> points = rest;
    scene.TurnLeaves(0, scene.GetNumberOfLeaves(), points.data(), nullptr);
    return points;
  };
  const std::vector<float> alone = turned(WindAlong(), false);
  const std::vector<float> both = turned(WindAlong(), true);
  EXPECT_TRUE(std::equal(alone.begin(), alone.begin() + 12, both.begin()));
  EXPECT_FALSE(std::equal(alone.begin(), alone.begin() + 12, rest.begin()));
  EXPECT_TRUE(std::equal(alone.begin() + 12, alone.end(), rest.begin() + 12));
  EXPECT_FALSE(std::equal(both.begin() + 12, both.end(), rest.begin() + 12));
  // As the leaf of its identity does.
  LeafMotionOptions leaves;
  leaves.Period = WindAlong().Samples * WindAlong().Spacing / WindAlong().Speed;
  Vector3 wind;
  int node = 0;
  PlantSway sway(BeamsOf(Mast(3.0, 0.02), {}, {}), {}, WindAlong().Times(), Mast(3.0, 0.02).Along(0, 0.75, node),
    WindAlong().Formula());
  wind = sway.Wind(4.2);
  std::vector<float> expected = rest;
  const Vector3 foot(rest[0], rest[1], rest[2]);
  const glm::dquat turn = LeafRotation({ { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } }, LeafWindOf(wind, leaves),
    LeafFlutter(leaves).At(std::uint64_t(55) << 32, 4.2));
  for (std::size_t corner = 0; corner < 4; ++corner)
  {
    float* p = &expected[3 * corner];
    const Vector3 at = foot + Rotated(turn, Vector3(p[0], p[1], p[2]) - foot);
    std::copy_n(&at.x, 3, p);
  }
  for (std::size_t i = 0; i < 12; ++i)
  {
    EXPECT_NEAR(alone[i], expected[i], 1e-6f);
  }
  EXPECT_EQ(turned(SteadyWind(1e-30), true), rest);
}

TEST(SwayScene, NamesPlantsOutOfTheWind)
{
  const SwaySettings settings;
  SwaySpecies still;
  const SwaySpecies mast = MakeSpecies(Mast(3.0, 0.02), settings.Options.Wood, {}, settings);
  std::vector<PlantPlace> places = { PlaceAt({ 0.0, 61.0, 0.0 }), PlaceAt({ 9e3, 59.0, 0.0 }), PlaceAt(Vector3(0.0)) };
  places[2].Species = 1;
  SwayScene scene(settings, FieldOf(WindAlong()), places, { mast, still });
  int plant = -1;
  EXPECT_NE(scene.FindTrunk(0, plant).find("The wind does not reach all plants"), std::string::npos);
  EXPECT_EQ(scene.GetNumberOfPlants(), 0u);
  EXPECT_EQ(scene.FindTrunk(1, plant), ""); // the wind has no end along its direction
  EXPECT_EQ(plant, 0);
  EXPECT_EQ(scene.FindTrunk(2, plant), "");
  EXPECT_EQ(plant, -1); // stands still
  const Skeleton tall = Mast(60.0, 0.5);
  EXPECT_NE(scene.AddPlant(2, tall, scene.BeamsOf(2, tall, {})), "");
}
