// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "Seaweed/SeaweedGrowth.h"
#include "Seaweed/SeaweedScene.h"
#include "Seaweed/SeaweedSkin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

using namespace littoral;
using littoral::testing::OnThreads;

namespace
{

/// Two wave trains over water of 6 m.
SeaState Waves()
{
  SeaState sea;
  sea.Depth = 6.0;
  for (const double length : { 12.0, 5.0 })
  {
    const double number = 6.283185307179586 / length;
    const double frequency = std::sqrt(9.81 * number * std::tanh(6.0 * number));
    sea.Trains.push_back({ 0.02 * length, frequency, number, 0.3 * length, 0.5 });
  }
  return sea;
}

SeaweedParameters TwoLeaves()
{
  SeaweedParameters parameters = PresetParameters(SeaweedPreset::Eelgrass);
  parameters.NumberOfFronds = 2;
  parameters.SegmentsPerBranch = 4;
  return parameters;
}

/// Some plants at a distance from each other, with a number for each node.
struct Bed
{
  Skeleton Rest;
  std::vector<SeaweedSegment> Segments;
  std::vector<int> Ids;

  void Add(int seed, const Vector3& foot, SeaweedParameters parameters = TwoLeaves())
  {
    parameters.Seed = seed;
    const Seaweed plant = GrowSeaweed(parameters);
    const int nodes = static_cast<int>(this->Rest.Nodes.size());
    const int branches = static_cast<int>(this->Rest.Branches.size());
    for (SkeletonNode node : plant.Wood.Nodes)
    {
      node.Parent += node.Parent < 0 ? 0 : nodes;
      node.Branch += branches;
      node.Position += foot;
      this->Rest.Nodes.push_back(node);
      this->Ids.push_back(seed);
    }
    for (SkeletonBranch branch : plant.Wood.Branches)
    {
      branch.First += nodes;
      this->Rest.Branches.push_back(branch);
    }
    this->Segments.insert(this->Segments.end(), plant.Segments.begin(), plant.Segments.end());
  }
};

Bed TwoPlants()
{
  Bed bed;
  bed.Add(3, { 0.0, 0.0, -6.0 });
  bed.Add(4, { 5.0, 2.0, -6.0 });
  return bed;
}

/// Plants whose blades grow all along their stipes.
Bed TwoCanopies()
{
  SeaweedParameters parameters = PresetParameters(SeaweedPreset::GiantKelp);
  parameters.NumberOfFronds = 2;
  parameters.SegmentsPerBranch = 8;
  parameters.StipeLength = 3.0;
  parameters.BladeSpacing = 0.6;
  parameters.BladeLength = 0.4;
  Bed bed;
  bed.Add(3, { 0.0, 0.0, -6.0 }, parameters);
  bed.Add(4, { 5.0, 2.0, -6.0 }, parameters);
  return bed;
}

constexpr TimeGrid Grid{ -1.0, 0.05 };

/// A current that changes with time: asked for at each half step.
CurrentSeries Tide()
{
  CurrentSeries series;
  series.IsContinuous = true;
  series.Range[0] = -100.0;
  series.Range[1] = 100.0;
  return series;
}

std::shared_ptr<const CurrentSnapshot> TideAt(double time)
{
  FlowPrimitive flow;
  flow.Strength = 0.2 * std::sin(0.7 * time);
  return std::make_shared<CurrentSnapshot>(
    std::vector<FlowPrimitive>{ flow }, std::vector<std::shared_ptr<const VelocityGrid>>());
}

/// The velocities of waves as those of data.
class WaveGrid : public VelocityGrid
{
public:
  explicit WaveGrid(double time)
    : Orbits(Waves(), WaveOrbitOptions(), time)
  {
  }
  GridHeights Heights() const override { return {}; }
  bool IsLevelAt(double) const override { return false; }
  Vector3 Velocity(const Vector3& position) const override
  {
    Vector3 velocity;
    OrbitRequest<double> request;
    request.Centers = &position.x;
    request.Velocity = &velocity.x;
    this->Orbits.Evaluate(request, 0, 1);
    return velocity;
  }

private:
  WaveOrbits Orbits;
};

std::shared_ptr<const CurrentSnapshot> WavesAt(double time)
{
  return std::make_shared<CurrentSnapshot>(
    std::vector<FlowPrimitive>(), std::vector<std::shared_ptr<const VelocityGrid>>{ std::make_shared<WaveGrid>(time) });
}

SeaweedScene SceneOf(
  const Bed& bed, bool isPhysical = true, const ParallelFor& parallel = SerialFor, const SeaweedOptions& options = {})
{
  SeaweedScene scene(Grid, { Tide() }, isPhysical, parallel);
  EXPECT_EQ(scene.SetPlants(bed.Rest, bed.Segments, bed.Ids.data(), options, Waves()), "");
  return scene;
}

/// Moves a scene to a time, with currents supplied as a pipeline does.
void MoveTo(
  SeaweedScene& scene, double time, std::shared_ptr<const CurrentSnapshot> (*snapshotAt)(double time) = TideAt)
{
  scene.SetGoal(time);
  for (int asked = 0; asked < 100000; ++asked)
  {
    while (!scene.IsAtGoal() && scene.IsNextKnown())
    {
      scene.Advance();
    }
    if (scene.IsAtGoal() && scene.IsNextKnown())
    {
      return;
    }
    for (CurrentSeries& current : scene.Currents.Series)
    {
      if (const auto missing = current.MissingTime(scene.GetGrid(), scene.NextMoments()))
      {
        current.Keep(*missing, snapshotAt(*missing));
      }
    }
  }
  ADD_FAILURE() << "no end";
}

std::vector<Vector3> NodesAt(SeaweedScene& scene, double time, const SeaweedLevels& levels = {})
{
  MoveTo(scene, time);
  scene.Show(levels);
  return scene.NodePositions();
}

std::vector<Vector3> NodesAtRest(const Bed& bed)
{
  std::vector<Vector3> nodes;
  for (const SkeletonNode& node : bed.Rest.Nodes)
  {
    nodes.push_back(node.Position);
  }
  return nodes;
}

double MaximumDistance(const std::vector<Vector3>& a, const std::vector<Vector3>& b)
{
  double most = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n)
  {
    most = std::max(most, glm::distance(a[n], b[n]));
  }
  return most;
}

/// A view from a point towards the first plant.
View ViewFrom(const Vector3& eye)
{
  View view;
  view.Point = eye;
  view.Direction = glm::normalize(Vector3(0.0, 0.0, -5.7) - eye);
  view.Up = Vector3(0.0, 0.0, 1.0);
  return view;
}

/// Levels seen from 100 m away.
SeaweedLevels FarAway()
{
  SeaweedLevels levels;
  levels.UseLevels = true;
  levels.Seen = ViewFrom({ 0.0, -100.0, -5.7 });
  return levels;
}

}

TEST(SeaweedScene, IsTheSameToTheBitInAnyOrderOfTimes)
{
  const Bed bed = TwoPlants();
  for (const bool isPhysical : { true, false })
  {
    SeaweedScene scene = SceneOf(bed, isPhysical);
    std::mt19937 random(2);
    for (int n = 0; n < 25; ++n)
    {
      const double time = -1.5 + 0.025 * static_cast<double>(random() % 200); // every other one on the grid
      const std::vector<Vector3> nodes = NodesAt(scene, time);
      SeaweedScene fresh = SceneOf(bed, isPhysical); // has no checkpoint to begin from
      ASSERT_EQ(nodes, NodesAt(fresh, time)) << time;
      if (time > 0.0)
      {
        EXPECT_GT(MaximumDistance(nodes, NodesAtRest(bed)), 1e-3) << time;
      }
    }
  }
}

TEST(SeaweedScene, MovesAlikeOnAnyThreads)
{
  const Bed bed = TwoPlants();
  const ParallelFor backwards = [](std::size_t count, const RangeTask& task) {
    for (std::size_t n = count; n-- > 0;)
    {
      task(n, n + 1);
    }
  };
  SeaweedScene serial = SceneOf(bed);
  SeaweedScene other = SceneOf(bed, true, backwards);
  SeaweedScene onThreads = SceneOf(bed, true, OnThreads(2));
  for (const double time : { 2.0, 0.33, 1.0 })
  {
    const std::vector<Vector3> expected = NodesAt(serial, time);
    EXPECT_EQ(expected, NodesAt(other, time));
    EXPECT_EQ(expected, NodesAt(onThreads, time));
  }
}

TEST(SeaweedScene, PlantsMoveAsEachAlone)
{
  Bed first;
  first.Add(3, { 0.0, 0.0, -6.0 });
  SeaweedScene alone = SceneOf(first);
  SeaweedScene both = SceneOf(TwoPlants());
  const std::vector<Vector3> expected = NodesAt(alone, 1.23);
  const std::vector<Vector3> nodes = NodesAt(both, 1.23);
  EXPECT_EQ(std::vector<Vector3>(nodes.begin(), nodes.begin() + static_cast<long>(expected.size())), expected);
}

/// Wave trains are left out by the distance of each plant, whatever others are found with it.
TEST(SeaweedScene, PlantsLeaveOutTrainsAsEachAlone)
{
  Bed second;
  second.Add(4, { 5.0, 2.0, -6.0 });
  SeaweedLevels levels;
  levels.UseLevels = true;
  levels.Seen = ViewFrom({ -4.0, -1.6, -5.7 }); // 4 m and 10 m away
  SeaweedScene alone = SceneOf(second, false);
  SeaweedScene both = SceneOf(TwoPlants(), false);
  int different = 0;
  std::vector<Vector3> former;
  for (const double error : { 0.001, 0.1, 0.2, 0.4, 10.0 })
  {
    levels.PixelError = error;
    const std::vector<Vector3> expected = NodesAt(alone, 1.23, levels);
    const std::vector<Vector3> nodes = NodesAt(both, 1.23, levels);
    EXPECT_EQ(std::vector<Vector3>(nodes.end() - static_cast<long>(expected.size()), nodes.end()), expected) << error;
    different += former.empty() || expected == former ? 0 : 1;
    former = expected;
  }
  EXPECT_GT(different, 1);
}

TEST(SeaweedScene, PlantsAreAtRestBeforeTheStart)
{
  const Bed bed = TwoPlants();
  SeaweedScene scene = SceneOf(bed);
  NodesAt(scene, 1.0);
  EXPECT_LT(MaximumDistance(NodesAt(scene, -1.0), NodesAtRest(bed)), 1e-12);
  EXPECT_LT(MaximumDistance(NodesAt(scene, -50.0), NodesAtRest(bed)), 1e-12);
  EXPECT_EQ(scene.GetStep(), 0);
}

TEST(SeaweedScene, LevelsDoNotTouchTheState)
{
  const Bed bed = TwoPlants();
  SeaweedScene scene = SceneOf(bed);
  SeaweedLevels levels;
  levels.UseLevels = true;
  levels.Seen = ViewFrom({ 0.0, -100.0, -5.7 }); // far away: the first link of each branch alone
  for (double time = -0.9; time < 2.0; time += 0.37)
  {
    NodesAt(scene, time, levels);
  }
  const SeaweedCounters far = scene.Show(levels);
  levels.Seen = ViewFrom({ 0.0, -50.0, -5.7 });
  levels.Seen.Direction = Vector3(0.0, -1.0, 0.0); // away from all
  const SeaweedCounters none = scene.Show(levels);
  EXPECT_LT(MaximumDistance(scene.NodePositions(), NodesAtRest(bed)), 1e-12);
  SeaweedScene fresh = SceneOf(bed);
  EXPECT_EQ(NodesAt(scene, 2.0), NodesAt(fresh, 2.0));
  const SeaweedCounters all = scene.Show({});
  EXPECT_EQ(all.Plants, 2);
  EXPECT_EQ(all.Segments, static_cast<std::int64_t>(scene.GetNumberOfLinks()));
  EXPECT_EQ(far.Plants, 2);
  EXPECT_EQ(far.Segments, 4); // two leaves of two plants
  EXPECT_EQ(none.Plants, 0);
  EXPECT_EQ(none.Segments, 0);
}

/// Far away each node is where the carrier of its joint takes it, of which alone the change is found.
TEST(SeaweedScene, FarPlantsMoveByTheirCarriers)
{
  for (const Bed& bed : { TwoPlants(), TwoCanopies() })
  {
    const SeaweedLevels levels = FarAway();
    for (const bool isPhysical : { false, true })
    {
      SeaweedScene scene = SceneOf(bed, isPhysical);
      const std::vector<Vector3> nodes = NodesAt(scene, 1.3, levels);
      EXPECT_GT(MaximumDistance(nodes, NodesAtRest(bed)), 0.02);
      const std::vector<int> carriers = scene.GetStand().CarriersOf(scene.GetLinks());
      std::vector<JointChange> changes(nodes.size());
      int carried = 0;
      for (std::size_t plant = 0; plant < 2; ++plant)
      {
        ASSERT_TRUE(scene.IsFar(plant));
        scene.FindChanges(plant, scene.SkinRotations(), changes, true);
      }
      for (std::size_t node = 0; node < nodes.size(); ++node)
      {
        const auto& c = changes[static_cast<std::size_t>(carriers[node])].Columns;
        const Vector3 rest = bed.Rest.Nodes[node].Position;
        // p + (R - 1) (p - r) + s
        Vector3 place = rest + Vector3(c[3][0], c[3][1], c[3][2]);
        for (int k = 0; k < 3; ++k)
        {
          place += (rest[k] - static_cast<double>(c[k][3])) * Vector3(c[k][0], c[k][1], c[k][2]);
        }
        EXPECT_LT(glm::distance(place, nodes[node]), 1e-5) << node;
        const int carrier = scene.GetStand().LinkOf(static_cast<std::size_t>(carriers[node]));
        EXPECT_TRUE(carrier < 0 || scene.GetStand().LastLevelOf(static_cast<std::size_t>(carrier)) == 2) << node;
        carried += carriers[node] != static_cast<int>(node);
      }
      EXPECT_GT(carried, 10);
      MoveTo(scene, 1.4);
      scene.Show({});
      EXPECT_FALSE(scene.IsFar(0));
    }
  }
}

/// All joints of far plants are there where they are needed: they go with their carriers.
TEST(SeaweedScene, JointsOfFarPlantsGoWithTheirCarriers)
{
  for (const Bed& bed : { TwoPlants(), TwoCanopies() })
  {
    const SeaweedLevels levels = FarAway();
    for (const bool isPhysical : { false, true })
    {
      SeaweedScene scene = SceneOf(bed, isPhysical);
      NodesAt(scene, 0.4); // poses of another time
      const std::vector<Vector3> nodes = NodesAt(scene, 1.3, levels);
      scene.NeedsJoints = true;
      EXPECT_EQ(NodesAt(scene, 1.3, levels), nodes);
      std::vector<JointChange> changes(nodes.size());
      for (std::size_t plant = 0; plant < 2; ++plant)
      {
        ASSERT_TRUE(scene.IsFar(plant));
        scene.FindChanges(plant, scene.SkinRotations(), changes);
      }
      for (std::size_t node = 0; node < nodes.size(); ++node)
      {
        const Vector3 rest = bed.Rest.Nodes[node].Position;
        EXPECT_LT(glm::distance(rest + changes[node].Of(rest), nodes[node]), 1e-5) << node;
      }
    }
  }
}

/// Plants in steady water, seen from so far away that they are held.
struct HeldBed
{
  Bed Plants = TwoPlants();
  SeaweedLevels Levels = FarAway();
  SeaweedScene Scene = SceneOf(this->Plants, false);

  HeldBed()
  {
    this->Scene.Currents.Series.clear();
    this->NodesAt(-0.9); // from the second picture on the view stands still
  }
  std::vector<Vector3> NodesAt(double time) { return ::NodesAt(this->Scene, time, this->Levels); }

  /// Whether a plant is in one place in two pictures.
  bool IsSame(std::size_t plant, const std::vector<Vector3>& a, const std::vector<Vector3>& b) const
  {
    bool isSame = a.size() == b.size();
    for (std::size_t node = 0; isSame && node < a.size(); ++node)
    {
      isSame = this->Scene.GetStand().PlantOf(node) != plant || a[node] == b[node];
    }
    return isSame;
  }
};

/// What is held is where it moved last, a step of its own, and is said not to have changed.
TEST(SeaweedScene, HeldPlantsAreThoseOfTheStepAtWhichTheyMoved)
{
  HeldBed bed;
  HeldBed exact;
  std::vector<Vector3> before;
  int held = 0;
  int moved = 0;
  for (int frame = 0; frame < 60; ++frame)
  {
    const double time = 0.313 + 0.04 * frame;
    const std::vector<Vector3> nodes = bed.NodesAt(time);
    for (std::size_t plant = 0; plant < 2; ++plant)
    {
      ASSERT_TRUE(bed.Scene.Stays(plant));
      const long long last = bed.Scene.GetGoal().Step;
      long long step = last;
      while (step > last - MostHeld && !bed.IsSame(plant, nodes, exact.NodesAt(Grid.TimeOf(step))))
      {
        --step;
      }
      ASSERT_GT(step, last - MostHeld) << frame;
      // The water at its top has not moved by more than the error since.
      const StandPlant& own = bed.Scene.GetStand().GetPlants()[plant];
      const double speed = TrainSpeed(Waves(), own.Middle.z + own.Reach);
      const double most = ErrorOfWater(bed.Levels, LevelDistance(bed.Levels.Seen, own.Middle));
      EXPECT_LT((time - Grid.TimeOf(step)) * speed, most) << frame;
      if (frame > 0)
      {
        const bool isSame = bed.IsSame(plant, nodes, before);
        EXPECT_EQ(bed.Scene.HasChangedSince(plant, bed.Scene.GetShow() - 1), !isSame) << frame;
        (isSame ? held : moved) += 1;
      }
    }
    before = nodes;
  }
  EXPECT_GT(held, 30);
  EXPECT_GT(moved, 10);
}

/// Which pictures came before makes no difference, nor does where the camera was.
TEST(SeaweedScene, HeldPlantsAreFunctionsOfTimeAndView)
{
  HeldBed bed;
  std::mt19937 random(5);
  for (int n = 0; n < 60; ++n)
  {
    const double time = -3.0 + 0.0125 * static_cast<double>(random() % 400); // before the start, too
    bed.Levels.UseLevels = random() % 5 > 0;
    bed.Levels.PixelError = random() % 2 > 0 ? 4.0 : 0.5;
    bed.Levels.Seen = ViewFrom({ random() % 2 > 0 ? 0.0 : 3.0, random() % 2 > 0 ? -100.0 : -20.0, -5.7 });
    bed.Levels.Seen.Direction *= random() % 4 > 0 ? 1.0 : -1.0;
    HeldBed fresh;
    fresh.Levels = bed.Levels;
    ASSERT_EQ(bed.NodesAt(time), fresh.NodesAt(time)) << n;
  }
}

/// A current that changes is known at the time alone: nothing is held in it.
TEST(SeaweedScene, PlantsInChangingCurrentsAreNotHeld)
{
  SeaweedScene scene = SceneOf(TwoPlants(), false);
  SeaweedLevels levels = FarAway();
  levels.PixelError = 4.0;
  const std::vector<Vector3> nodes = NodesAt(scene, 1.0, levels);
  EXPECT_GT(MaximumDistance(nodes, NodesAt(scene, 1.01, levels)), 1e-6);
  EXPECT_FALSE(scene.Stays(0));
}

/// Plants out of view are at rest, wherever the camera goes.
TEST(SeaweedScene, PlantsOutOfViewDoNotChange)
{
  for (const bool isPhysical : { true, false })
  {
    SeaweedScene scene = SceneOf(TwoPlants(), isPhysical);
    SeaweedLevels levels = FarAway();
    levels.Seen.Direction *= -1.0;
    NodesAt(scene, 1.0, levels);
    levels.Seen.Point.y -= 10.0;
    EXPECT_LT(MaximumDistance(NodesAt(scene, 1.3, levels), NodesAtRest(TwoPlants())), 1e-12);
    EXPECT_TRUE(scene.Stays(1));
    EXPECT_FALSE(scene.HasChangedSince(1, 1));
    levels.Seen.Direction *= -1.0;
    EXPECT_GT(MaximumDistance(NodesAt(scene, 1.3, levels), NodesAtRest(TwoPlants())), 1e-3);
    EXPECT_TRUE(scene.HasChangedSince(1, 2));
  }
}

TEST(SeaweedScene, VelocitiesAreThoseOfThePositions)
{
  const Bed bed = TwoPlants();
  for (const bool isPhysical : { true, false })
  {
    SeaweedScene scene = SceneOf(bed, isPhysical);
    if (!isPhysical)
    {
      scene.Currents.Series.clear(); // motion is found in the current of the moment
    }
    scene.NeedsMotion = true;
    const double time = 1.52; // within a step
    MoveTo(scene, time);
    scene.Show({});
    EXPECT_TRUE(scene.GetVelocities().empty());
    scene.FindMotion();
    const std::vector<Vector3> velocities = scene.GetVelocities();
    ASSERT_EQ(velocities.size(), bed.Rest.Nodes.size());
    ASSERT_EQ(scene.GetAccelerations().size(), bed.Rest.Nodes.size());
    const double h = isPhysical ? 0.01 : Grid.Step; // 0.01 s on, it is still the same step
    const std::vector<Vector3> before = NodesAt(scene, time - h);
    const std::vector<Vector3> after = NodesAt(scene, time + h);
    double speed = 0.0;
    for (std::size_t n = 0; n < velocities.size(); ++n)
    {
      speed = std::max(speed, glm::length(velocities[n]));
      EXPECT_LT(glm::distance((after[n] - before[n]) / (2.0 * h), velocities[n]), isPhysical ? 0.03 : 1e-9)
        << isPhysical << " " << n;
    }
    EXPECT_GT(speed, 0.1);
  }
}

TEST(SeaweedScene, ShowsTheSameAfterFindingMotion)
{
  const Bed bed = TwoPlants();
  for (const bool isPhysical : { true, false })
  {
    SeaweedScene scene = SceneOf(bed, isPhysical);
    scene.NeedsMotion = true;
    const std::vector<Vector3> nodes = NodesAt(scene, 0.71);
    scene.FindMotion();
    EXPECT_EQ(scene.NodePositions(), nodes);
    EXPECT_EQ(NodesAt(scene, 0.71), nodes);
    const SeaweedLevels levels = FarAway();
    const std::vector<Vector3> far = NodesAt(scene, 0.71, levels);
    scene.FindMotion();
    EXPECT_EQ(scene.NodePositions(), far);
    EXPECT_TRUE(scene.IsFar(0));
    EXPECT_EQ(scene.RigidityOf(0), 1.0f);
  }
}

TEST(SeaweedScene, NeedsTheCurrentsOfTheMiddleAndTheEndsOfAStep)
{
  SeaweedScene scene = SceneOf(TwoPlants());
  scene.SetGoal(-0.92); // a step of 0.05 s and 0.03 s
  ASSERT_EQ(scene.NextMoments().size(), 3u);
  EXPECT_EQ(scene.NextMoments()[0].Step, 0);
  EXPECT_EQ(scene.NextMoments()[0].Share, 0.5);
  EXPECT_EQ(scene.NextMoments()[1].Share, 0.0);
  EXPECT_EQ(scene.NextMoments()[2].Share, 1.0);
  MoveTo(scene, -0.92);
  EXPECT_EQ(scene.NextMoments()[0].Step, 1);
  EXPECT_NEAR(scene.NextMoments()[0].Share, 0.3, 1e-12);
  EXPECT_NEAR(scene.NextMoments()[2].Share, 0.6, 1e-12);
  scene.NeedsMotion = true;
  ASSERT_EQ(scene.NextMoments().size(), 6u);
  EXPECT_EQ(scene.NextMoments()[3].Share, 0.5);
  SeaweedScene procedural = SceneOf(TwoPlants(), false);
  procedural.SetGoal(-0.92);
  EXPECT_TRUE(procedural.IsAtGoal());
  EXPECT_EQ(procedural.NextMoments()[0].Step, 1);
  EXPECT_NEAR(procedural.NextMoments()[0].Share, 0.6, 1e-12);
}

TEST(SeaweedScene, WavesPushAlikeAsASeaAndAsACurrent)
{
  // A current of data whose velocities are those of the waves has their acceleration too.
  Bed bed = TwoPlants();
  for (SeaweedSegment& segment : bed.Segments)
  {
    segment.Width = std::max(segment.Width, 0.05); // of much added mass
  }
  SeaweedScene sea(Grid, {}, true);
  ASSERT_EQ(sea.SetPlants(bed.Rest, bed.Segments, bed.Ids.data(), {}, Waves()), "");
  SeaweedScene data(Grid, { Tide() }, true);
  SeaState still = Waves();
  still.Trains.clear();
  ASSERT_EQ(data.SetPlants(bed.Rest, bed.Segments, bed.Ids.data(), {}, still), "");
  double moved = 0.0;
  double apart = 0.0;
  for (int n = 1; n <= 40; ++n)
  {
    const double time = -1.0 + 0.1 * n;
    const std::vector<Vector3> nodes = NodesAt(sea, time);
    MoveTo(data, time, WavesAt);
    data.Show({});
    moved = std::max(moved, MaximumDistance(nodes, NodesAtRest(bed)));
    apart = std::max(apart, MaximumDistance(nodes, data.NodePositions()));
  }
  EXPECT_GT(moved, 0.15);
  EXPECT_LT(apart, 0.001 * moved);
}

TEST(SeaweedScene, SaysHowFarPlantsReachAboveTheSea)
{
  Bed bed;
  bed.Add(3, { 0.0, 0.0, -0.05 });
  SeaweedScene scene(Grid, {}, true);
  const std::string reason = scene.SetPlants(bed.Rest, bed.Segments, nullptr, {}, Waves());
  EXPECT_NE(reason.find("above the sea"), std::string::npos) << reason;
  EXPECT_FALSE(scene.HasPlants());
}

TEST(SeaweedScene, TakesNoPlants)
{
  SeaweedScene scene(Grid, {}, true);
  EXPECT_EQ(scene.GetNumberOfLinks(), 0u);
  EXPECT_EQ(scene.SetPlants({}, {}, nullptr, {}, Waves()), "");
  EXPECT_EQ(scene.GetNumberOfLinks(), 0u);
  EXPECT_TRUE(NodesAt(scene, 1.0).empty());
}

TEST(SeaweedStand, KnowsThePlantOfEachNodeAndLink)
{
  const Bed bed = TwoPlants();
  const std::vector<SeaweedLink> links = LinksOf(bed.Rest, bed.Segments, {});
  const SeaweedStand stand(bed.Rest, links, bed.Ids.data());
  ASSERT_EQ(stand.GetPlants().size(), 2u);
  EXPECT_EQ(stand.GetPlants()[0].FirstLink, 0u);
  EXPECT_EQ(stand.GetPlants()[0].EndLink, stand.GetPlants()[1].FirstLink);
  EXPECT_EQ(stand.GetPlants()[1].EndLink, links.size());
  for (std::size_t node = 0; node < bed.Rest.Nodes.size(); ++node)
  {
    EXPECT_EQ(stand.PlantOf(node), bed.Ids[node] == 3 ? 0u : 1u);
    const StandPlant& plant = stand.GetPlants()[stand.PlantOf(node)];
    EXPECT_LE(glm::distance(bed.Rest.Nodes[node].Position, plant.Middle), plant.Reach);
    const int link = stand.LinkOf(node);
    if (link >= 0)
    {
      EXPECT_GE(static_cast<std::size_t>(link), plant.FirstLink);
      EXPECT_LT(static_cast<std::size_t>(link), plant.EndLink);
    }
  }
  // Four segments a leaf: the first, the half next to its foot, the others.
  std::vector<int> levels;
  for (std::size_t link = 0; link < links.size(); ++link)
  {
    levels.push_back(stand.LastLevelOf(link));
  }
  const std::vector<int> leaf{ 2, 1, 0, 0 };
  for (std::size_t first = 0; first < links.size(); first += 4)
  {
    EXPECT_EQ(
      std::vector<int>(levels.begin() + static_cast<long>(first), levels.begin() + static_cast<long>(first) + 4), leaf);
  }
  EXPECT_EQ(SeaweedStand(bed.Rest, links, nullptr).GetPlants().size(), 1u);
}

TEST(SeaweedSkin, RunsHoldAllVerticesOfAPlantThatMove)
{
  const Bed bed = TwoPlants();
  const SeaweedStand stand(bed.Rest, LinksOf(bed.Rest, bed.Segments, {}), bed.Ids.data());
  const int last = static_cast<int>(bed.Rest.Nodes.size()) - 1;
  // Plants in turns, as blocks of a scattered forest may have them.
  std::vector<int> ids;
  for (const int node : { 1, 1, last, last, last, 2, last - 1 })
  {
    ids.insert(ids.end(), { node, 0, 0, 0 });
  }
  const SeaweedSkin skin(ids.data(), 7, stand);
  std::vector<std::vector<std::size_t>> vertices(2);
  for (std::size_t plant = 0; plant < 2; ++plant)
  {
    for (const SkinRun* run = skin.RunsOf(plant); run != skin.RunsOf(plant + 1); ++run)
    {
      EXPECT_EQ(run->Plant, plant);
      for (std::size_t vertex = run->First; vertex < run->End; ++vertex)
      {
        vertices[plant].push_back(vertex);
      }
    }
  }
  ASSERT_LT(stand.LinkOf(0), 0); // it is a holdfast
  ASSERT_LT(stand.LinkOf(1), 0);
  EXPECT_EQ(vertices[0], (std::vector<std::size_t>{ 5 }));
  ASSERT_EQ(skin.GetFixedRuns().size(), 1u);
  EXPECT_EQ(skin.GetFixedRuns()[0].First, 0u);
  EXPECT_EQ(skin.GetFixedRuns()[0].End, 2u);
  EXPECT_EQ(vertices[1], (std::vector<std::size_t>{ 2, 3, 4, 6 }));
}

TEST(SeaweedLevels, SharesFallFromOneToZeroOverTheBand)
{
  SeaweedLevels levels; // 5 m, 20 m, 12 m
  EXPECT_EQ(LevelSharesAt(levels, 5.0, 1.0).Near, 1.0);
  EXPECT_EQ(LevelSharesAt(levels, 17.0, 1.0).Near, 0.0);
  EXPECT_DOUBLE_EQ(LevelSharesAt(levels, 11.0, 1.0).Near, 0.5);
  EXPECT_EQ(LevelSharesAt(levels, 20.0, 1.0).Far, 1.0);
  EXPECT_DOUBLE_EQ(LevelSharesAt(levels, 26.0, 1.0).Far, 0.5);
  EXPECT_DOUBLE_EQ(LevelSharesAt(levels, 25.0, 40.0).Near, 0.5); // a reach beyond the band
  levels.BlendDistance = 0.0;
  EXPECT_EQ(LevelSharesAt(levels, 5.0, 40.0).Near, 1.0);
  EXPECT_EQ(LevelSharesAt(levels, 5.001, 40.0).Near, 0.0);
}

/// The speed of the water comes up to its bound where one train is all, and never beyond it.
TEST(SeaweedLevels, TrainSpeedBoundsTheSpeedOfTheWater)
{
  SeaState sea = Waves();
  for (const bool isOne : { false, true })
  {
    sea.Trains.resize(isOne ? 1 : 2);
    for (const float height : { -0.5f, -3.0f, -5.5f })
    {
      double fastest = 0.0;
      for (int n = 0; n < 400; ++n)
      {
        WaveOrbitOptions options;
        options.Bound.Motion = BoundMotion::Places;
        const WaveOrbits orbits(sea, options, 0.05 * n);
        const float place[3] = { 1.0f, 2.0f, height };
        float velocity[3] = { 0.0f, 0.0f, 0.0f };
        OrbitRequest<float> request;
        request.Centers = place;
        request.Velocity = velocity;
        orbits.Evaluate(request, 0, 1);
        fastest = std::max(fastest, static_cast<double>(std::hypot(velocity[0], velocity[1], velocity[2])));
      }
      const double bound = TrainSpeed(sea, static_cast<double>(height));
      EXPECT_LE(fastest, bound * (1.0 + 1e-6));
      EXPECT_GT(fastest, (isOne ? 0.999 : 0.8) * bound);
    }
  }
}

TEST(SeaweedLevels, PlantsAreHeldWhileTheWaterMovesByTheErrorAtMost)
{
  constexpr double step = 1.0 / 48.0;
  for (const double speed : { 0.01, 0.4, 3.0 })
  {
    for (double most = 1e-4; most < 10.0; most *= 1.3)
    {
      const int held = StepsHeld(most, speed, step);
      EXPECT_LE(held * step * speed, most);
      EXPECT_TRUE(held == MostHeld || std::max(1, 2 * held) * step * speed > most) << most << " " << speed;
      if (held > 0)
      {
        for (long long now = -70; now < 70; ++now)
        {
          const long long last = StepOfHeld(now, held, 13);
          EXPECT_TRUE(last <= now && last > now - held) << now;
          EXPECT_EQ(StepOfHeld(last, held, 13), last);
        }
        EXPECT_TRUE(held == 1 || StepOfHeld(40, held, 13) != StepOfHeld(40, held, 14));
      }
    }
  }
  EXPECT_EQ(StepsHeld(0.0, 0.0, step), 0);
  EXPECT_EQ(StepsHeld(1.0, 0.0, step), MostHeld);
}

TEST(SeaweedLevels, TrainsLeaveOutNoMoreThanTheMaximum)
{
  SeaState sea = Waves();
  for (int n = 0; n < 60; ++n)
  {
    const double number = 1.0 + 0.2 * n;
    sea.Trains.push_back({ 0.05 / (1.0 + n), std::sqrt(9.81 * number), number, 0.1 * n, 0.0 });
  }
  for (const double height : { 0.0, -1.0, -5.0 })
  {
    for (const double maximum : { 1e-4, 1e-2, 0.1, 10.0 })
    {
      std::vector<float> shares(sea.Trains.size(), -1.0f);
      FindTrainShares(TrainSums(sea, height).data(), shares.size(), maximum, shares.data());
      double left = 0.0;
      for (std::size_t n = 0; n < shares.size(); ++n)
      {
        EXPECT_GE(shares[n], 0.0f);
        EXPECT_LE(shares[n], 1.0f);
        left += (1.0 - shares[n]) * AxesAt(sea.Trains[n], height, sea.Depth).Horizontal;
      }
      EXPECT_LE(left, maximum);
      // What a train and all after it move: nothing below half of the maximum counts, all above three halves does.
      double rest = 0.0;
      for (std::size_t n = shares.size(); n-- > 0;)
      {
        rest += AxesAt(sea.Trains[n], height, sea.Depth).Horizontal;
        EXPECT_TRUE(shares[n] == 0.0f || rest > 0.49 * maximum);
        EXPECT_TRUE(shares[n] == 1.0f || rest < 1.51 * maximum);
      }
      EXPECT_EQ(shares.back() < 1.0f, maximum > 1e-3 || height < 0.0); // it is of 0.8 mm at the surface
    }
  }
}
