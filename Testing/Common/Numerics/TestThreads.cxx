// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the numerics compute in parallel is the same to the byte on threads. Run it under the sanitizer of threads.
#include "../OnThreads.h"
#include "../WindAlong.h"
#include "Currents/VelocitySpline.h"
#include "Numerics/FourierGrid.h"
#include "Particles/ParticleLevels.h"
#include "Plants/PlantLevels.h"
#include "Plants/ReevesTree.h"
#include "Sway/SwayScene.h"
#include "Terrain/TerrainLevels.h"
#include "Wind/WindLines.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <memory>
#include <random>
#include <utility>
#include <vector>

using namespace littoral;
using littoral::testing::OnThreads;
using littoral::testing::WindAlong;

namespace
{

std::vector<float> Noise(std::size_t count)
{
  std::mt19937 engine(3);
  std::normal_distribution<float> normal;
  std::vector<float> values(count);
  for (float& value : values)
  {
    value = normal(engine);
  }
  return values;
}

/// Two masts in a wind; the positions of their joints at a time.
std::vector<Vector3> Joints(const ParallelFor& parallel)
{
  const Vector3 feet[2] = { Vector3(0.0, 0.0, 0.0), Vector3(20.0, -7.0, 1.0) };
  std::vector<PlantPlace> places(2);
  SwayScene scene({}, std::shared_ptr<const FrozenWind>(new FrozenWind(WindAlong().Field())), places, {});
  std::size_t joints = 0;
  for (int row = 0; row < 2; ++row)
  {
    Skeleton mast;
    mast.StartBranch(-1, feet[row], 0.1);
    for (int n = 1; n <= 8; ++n)
    {
      mast.Grow(feet[row] + Vector3(0.0, 0.0, n), 0.1);
    }
    joints += mast.Nodes.size();
    EXPECT_EQ(scene.AddPlant(row, mast, scene.BeamsOf(row, mast, {})), "");
  }
  scene.MoveTo(3.7, parallel);
  std::vector<Vector3> positions;
  for (std::size_t joint = 0; joint < joints; ++joint)
  {
    positions.push_back(scene.JointPosition(joint));
  }
  EXPECT_GT(glm::distance(positions[8], feet[0] + Vector3(0.0, 0.0, 8.0)), 1e-6) << "it stands still";
  return positions;
}

}

TEST(Threads, PicturesOfAPlant)
{
  const Plant birch = GrowReevesTree(PresetParameters(TreePreset::Birch));
  PlantLevelOptions options;
  const PlantPrototype one = LevelsOf(birch, options);
  options.Parallel = OnThreads(3);
  const PlantPrototype three = LevelsOf(birch, options);
  EXPECT_EQ(one.Impostor.Pictures.Texels, three.Impostor.Pictures.Texels);
  EXPECT_EQ(one.Impostor.Normals, three.Impostor.Normals);
  EXPECT_EQ(one.Impostor.Shape.Areas, three.Impostor.Shape.Areas);
  EXPECT_EQ(one.Impostor.Mean, three.Impostor.Mean);
}

TEST(Threads, LinesOfAWind)
{
  const std::array<int, 3> size{ 60, 7, 5 };
  const std::vector<float> field = Noise(std::size_t(3) * size[0] * size[1] * size[2]);
  std::vector<Vector3> one(60);
  std::vector<Vector3> three(60);
  WindLines(field.data(), size).Sample({ 4.5, 3.25, 2.75 }, 0.0, one.size(), one.data());
  WindLines(field.data(), size, OnThreads(3)).Sample({ 4.5, 3.25, 2.75 }, 0.0, three.size(), three.data());
  EXPECT_EQ(one, three);
}

TEST(Threads, SplinesOfVelocities)
{
  const std::vector<float> field = Noise(std::size_t(3) * 13 * 11 * 9);
  const auto sample = [&](std::size_t n) { return Vector3(field[3 * n], field[3 * n + 1], field[3 * n + 2]); };
  std::array<SplineAxis, 3> axes;
  const std::array<int, 3> size{ 13, 11, 9 };
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> nodes;
    for (int n = 0; n < size[axis]; ++n)
    {
      nodes.push_back(n + 0.01 * n * n);
    }
    axes[axis] = SplineAxis(nodes);
  }
  for (const bool isSingle : { false, true })
  {
    const VelocitySpline one(axes, sample, isSingle);
    const VelocitySpline three(axes, sample, isSingle, OnThreads(3));
    for (double part = 0.0; part <= 1.0; part += 0.01)
    {
      const Vector3 place(12.0 * part, 10.0 * part * part, 8.0 * (1.0 - part));
      ASSERT_EQ(one.At(place), three.At(place)) << part;
    }
  }
}

TEST(Threads, TilesOfATerrain)
{
  HeightSamples samples;
  samples.Width = 101;
  samples.Height = 57;
  samples.Values = Noise(std::size_t(101) * 57);
  const TerrainPyramid one(samples, 16, 4);
  const TerrainPyramid three(samples, 16, 4, OnThreads(3));
  ASSERT_EQ(one.GetTiles().size(), three.GetTiles().size());
  for (std::size_t tile = 0; tile < one.GetTiles().size(); ++tile)
  {
    EXPECT_EQ(one.GetTiles()[tile].Errors, three.GetTiles()[tile].Errors);
    EXPECT_EQ(one.GetTiles()[tile].Bounds.Low, three.GetTiles()[tile].Bounds.Low);
    EXPECT_EQ(one.GetTiles()[tile].Bounds.High, three.GetTiles()[tile].Bounds.High);
  }
  for (std::size_t sample = 0; sample < samples.Values.size(); ++sample)
  {
    ASSERT_EQ(one.GetNormal(sample), three.GetNormal(sample));
  }
}

TEST(Threads, TransformsOfAGrid)
{
  const std::vector<float> noise = Noise(std::size_t(60) * 37);
  FourierGrid one(60, 37);
  FourierGrid three(60, 37);
  for (int n = 0; n < 60 * 37; ++n)
  {
    one.At(n % 60, n / 60) = three.At(n % 60, n / 60) = noise[n];
  }
  one.Forward();
  three.Forward(OnThreads(3));
  for (int n = 0; n < 60 * 37; ++n)
  {
    ASSERT_EQ(one.At(n % 60, n / 60), three.At(n % 60, n / 60)) << n;
  }
}

TEST(Threads, ParticlesThatAViewNeeds)
{
  std::vector<Vector3> places;
  const std::vector<float> noise = Noise(3 * 4000);
  for (std::size_t n = 0; n < noise.size(); n += 3)
  {
    places.push_back({ 6.0 * noise[n], 6.0 * noise[n + 1], -5.0 - noise[n + 2] });
  }
  SeaState sea;
  sea.Depth = 20.0;
  sea.Trains.push_back({ 0.2, 1.4, 0.2, 0.3, 0.5 });
  View view;
  view.Point = Vector3(0.0, -6.0, -5.0);
  view.Direction = Vector3(0.0, 1.0, 0.0);
  view.Up = Vector3(0.0, 0.0, 1.0);
  const ParticleGroups groups(places, {}, 64);
  const TrainTable table(sea, -12.0, 0.0, view, TrainRule::TailSum, 1.0);
  const auto select = [&](const ParallelFor& parallel) {
    return SelectParticles(groups, table, ViewFrustum(view), {}, 0, groups.GetCells().size(), parallel);
  };
  const ParticleSelection one = select(SerialFor);
  const ParticleSelection three = select(OnThreads(3));
  ASSERT_EQ(one.Parts.size(), three.Parts.size());
  EXPECT_GT(std::min({ one.Near, one.Masters, one.Slaves, one.Far }), 0);
  for (std::size_t part = 0; part < one.Parts.size(); ++part)
  {
    ASSERT_TRUE(one.Parts[part].Near == three.Parts[part].Near && one.Parts[part].Far == three.Parts[part].Far);
    ASSERT_TRUE(one.Parts[part].Orbits == three.Parts[part].Orbits);
    ASSERT_TRUE(one.Parts[part].Slaves == three.Parts[part].Slaves);
  }
  EXPECT_EQ(one.TrainSum, three.TrainSum);
  EXPECT_EQ(one.Shown, three.Shown);
}

TEST(Threads, PlantsInTheWind)
{
  EXPECT_EQ(Joints(SerialFor), Joints(OnThreads(2)));
}
