// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/SimdDouble4.h"
#include "Seaweed/SeaweedMotion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

using namespace littoral;

TEST(SimdDouble4, AnglesAreThoseOfTheStandardLibrary)
{
  for (int i = -1000; i <= 1000; ++i)
  {
    const double angle = Pi * (0.5 + 0.4995 * i / 1000.0);
    for (const double length : { 1e-9, 0.3, 1.0, 1e7 })
    {
      const double sine = length * std::sin(angle);
      const double cosine = length * std::cos(angle);
      EXPECT_NEAR(AngleOf(sine, cosine), std::atan2(sine, cosine), 5e-16);
    }
  }
  EXPECT_EQ(AngleOf(0.0, 1.0), 0.0);
  EXPECT_EQ(AngleOf(0.0, -1.0), Pi);
  EXPECT_EQ(AngleOf(0.0, 0.0), 0.0);
}

TEST(SimdDouble4, SmallAnglesAreThoseOfTheStandardLibrary)
{
  for (int i = 1; i <= 800; ++i)
  {
    const double angle = 0.001 * i;
    EXPECT_NEAR(CosineOfSmall(angle * angle), std::cos(angle), 3e-16);
    EXPECT_NEAR(SineRatioOfSmall(angle * angle), std::sin(angle) / angle, 3e-16);
  }
  EXPECT_EQ(SineRatioOfSmall(0.0), 1.0);
}

TEST(SimdDouble4, LanesEqualScalars)
{
  const double sine[4] = { 0.1, 2.0, 0.0, 0.7 };
  const double cosine[4] = { -1.0, 0.5, 1.0, 0.7 };
  const SimdDouble4 angles =
    AngleOf(SimdDouble4(sine[0], sine[1], sine[2], sine[3]), SimdDouble4(cosine[0], cosine[1], cosine[2], cosine[3]));
  const SimdDouble4 roots = Sqrt(SimdDouble4(sine[0], sine[1], sine[2], sine[3]));
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    EXPECT_EQ(angles.Values[lane], AngleOf(sine[lane], cosine[lane]));
    EXPECT_EQ(roots.Values[lane], std::sqrt(sine[lane]));
  }
}

namespace
{

struct Numbered
{
  double Number;
};

/// Elements in a shuffled order, a lane each.
template <std::size_t Lanes>
void ExpectLanesInOrder()
{
  Numbered elements[16];
  std::array<std::size_t, Lanes> at;
  for (std::size_t i = 0; i < 16; ++i)
  {
    elements[i].Number = 0.1 * static_cast<double>(i);
    at[i % Lanes] = (5 * (i % Lanes) + 3) % 16;
  }
  const SimdDoubles<Lanes> gathered = GatherNumber(elements, at, &Numbered::Number);
  for (std::size_t lane = 0; lane < Lanes; ++lane)
  {
    EXPECT_EQ(gathered.Values[lane], elements[at[lane]].Number) << lane << " of " << Lanes;
  }
}

}

TEST(SimdDouble4, LanesAreFilledInOrder)
{
  ExpectLanesInOrder<2>();
  ExpectLanesInOrder<4>();
  ExpectLanesInOrder<8>();
}

namespace
{

/// Where nine different plants of the same shape are after some steps; those from `first` to `last` alone.
std::vector<LinkPose> MovedPlants(int first, int last)
{
  SeaweedOptions options;
  Skeleton skeleton;
  std::vector<SeaweedSegment> segments;
  for (int plant = first; plant < last; ++plant)
  {
    const Vector3 foot(plant, 0.0, -10.0);
    skeleton.StartBranch(-1, foot, 0.01);
    for (int i = 1; i <= 5; ++i)
    {
      skeleton.Grow(foot + Vector3(0.02 * plant * i, 0.0, (0.2 + 0.03 * plant) * i), 0.01);
    }
    SeaweedSegment segment;
    segment.YoungModulus = 1e4 * (plant + 1);
    segments.resize(skeleton.Nodes.size(), segment);
  }
  const SeaweedMotion motion(LinksOf(skeleton, segments, options), options);
  std::vector<LinkState> states = motion.AtRest();
  std::vector<LinkPose> poses(states.size());
  motion.Pose(states.data(), 0, states.size(), poses.data());
  std::vector<Vector3> middles;
  std::vector<WaterAtLink> water;
  for (int step = 0; step < 200; ++step)
  {
    for (const LinkBatch& batch : motion.GetBatches())
    {
      middles.resize(batch.PaddedLinks());
      water.resize(batch.PaddedLinks());
      motion.Middles(batch, poses.data(), middles.data());
      for (std::size_t i = 0; i < middles.size(); ++i)
      {
        // Fast enough for some plants that they take sub-steps and iterations of their own.
        const double fast = 1.0 + 0.45 * std::max(0.0, middles[i].x);
        water[i].Velocity = { fast * std::sin(middles[i].x + 0.05 * step), 0.3 * middles[i].z / 10.0, 0.0 };
      }
      motion.Step(1.0 / 48.0, batch, water.data(), states.data(), poses.data());
    }
  }
  // The poses that come with the states are those of the states
  std::vector<LinkPose> posed(states.size());
  motion.Pose(states.data(), 0, states.size(), posed.data());
  for (std::size_t link = 0; link < posed.size(); ++link)
  {
    EXPECT_EQ(posed[link].Foot, poses[link].Foot);
    EXPECT_EQ(posed[link].Rotation, poses[link].Rotation);
    EXPECT_EQ(posed[link].Axis, poses[link].Axis);
  }
  return poses;
}

}

TEST(SimdDouble4, APlantMovesAsItWouldAlone)
{
  const std::vector<LinkPose> all = MovedPlants(0, 9);
  ASSERT_EQ(all.size(), 45u);
  for (int plant = 0; plant < 9; ++plant)
  {
    const std::vector<LinkPose> alone = MovedPlants(plant, plant + 1);
    EXPECT_EQ(std::memcmp(alone.data(), &all[5 * plant], 5 * sizeof(LinkPose)), 0) << plant;
    EXPECT_GT(glm::distance(alone[4].Foot, Vector3(plant, 0.0, -10.0)), 0.1);
  }
}
