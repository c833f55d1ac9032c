// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Trains that a particle needs for an error on the screen, against all of them.
#include "../Particles/ParticleScenes.h"
#include "Sea/TrainSelection.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

using namespace littoral;
using namespace littoral::testing;

TEST(TrainSelection, TailSumBoundsTheErrorOnTheScreen)
{
  for (const double depth : { 1e9, 25.0 })
  {
    const SeaState sea = Sea(depth);
    const std::vector<Vector3> places = Places(10000, { { -40.0, -40.0, -20.0 }, { 40.0, 40.0, 0.0 } });
    double largest = 0.0;
    long long compared = 0;
    long long used = 0;
    for (int frame = 0; frame < 200; frame += 3)
    {
      const View view = FrameView(frame);
      const TrainTable table(sea, -20.0, 0.0, view, TrainRule::TailSum, 1.0);
      const ViewFrustum frustum(view);
      std::vector<Vector3> near;
      std::vector<int> counts;
      for (const Vector3& place : places)
      {
        if (frustum.MayShow(place, table.AmplitudeAt(place.z)))
        {
          near.push_back(place);
          counts.push_back(table.CountAt(glm::distance(place, view.Point), place.z));
        }
      }
      const std::vector<Vector3> all = Moved(sea, 0.37 * frame, near, {});
      const std::vector<Vector3> some = Moved(sea, 0.37 * frame, near, counts);
      for (std::size_t n = 0; n < near.size(); ++n)
      {
        std::array<double, 2> a;
        std::array<double, 2> b;
        if (Project(view, all[n], a) && Project(view, some[n], b))
        {
          largest = std::max(largest, std::hypot(a[0] - b[0], a[1] - b[1]));
          ++compared;
          used += counts[n];
        }
      }
    }
    EXPECT_GT(compared, 50000);
    EXPECT_LE(largest, 1.0);
    EXPECT_GT(largest, 0.3) << "the bound is of no use";
    const double mean = static_cast<double>(used) / static_cast<double>(compared);
    EXPECT_LT(mean, 0.9 * static_cast<double>(sea.Trains.size())) << "hardly a train is left out";
    std::printf("depth %g m: largest error %.3f pixels, %.1f of %zu trains\n", depth, largest, mean, sea.Trains.size());
  }
}

TEST(TrainSelection, WhatIsLeftOutStaysBelowTheScreenErrorAtTheNearEndOfOrbits)
{
  const SeaState sea = Sea(1e9);
  const View view = Look({ 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
  const double tangent = std::tan(0.5 * view.Angle);
  // Pixels of a metre across the ray to a corner of the picture, a metre ahead.
  const double pixels =
    view.Height / (2.0 * tangent) * (1.0 + tangent * tangent * (1.0 + view.AspectRatio * view.AspectRatio));
  const TrainTable table(sea, -20.0, 0.0, view, TrainRule::TailSum, 1.0);
  for (const double height : { 0.0, -2.0, -9.0 })
  {
    const double reach = table.AmplitudeAt(height);
    for (double away = 0.01; away < 1000.0; away *= 1.1)
    {
      const int trains = table.CountAt(reach + away, height);
      EXPECT_LE(table.TailAt(trains, height) * pixels / away, 1.0 + 1e-9) << away;
    }
    EXPECT_LE(table.SlaveError(1e6, height), 2.0 * reach); // two orbits, however far apart
    EXPECT_LT(table.SlaveError(1e-3, height), 1e-2 * reach);
  }
}

TEST(TrainSelection, AMarginLetsTheEyeComeNearer)
{
  const SeaState sea = Sea(1e9);
  View view = Look({ 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
  const TrainTable exact(sea, -20.0, 0.0, view, TrainRule::TailSum, 1.0);
  view.Margin = 5.0;
  const TrainTable rounded(sea, -20.0, 0.0, view, TrainRule::TailSum, 1.0);
  for (double distance = 0.05 * (1.0 + 1e-6); distance < 1000.0; distance *= std::exp2(1.0 / 6.0)) // of the table
  {
    for (const double height : { 0.0, -3.0, -12.0 })
    {
      EXPECT_GE(rounded.CountAt(distance + view.Margin, height), exact.CountAt(distance, height));
    }
  }
}

TEST(TrainSelection, FewerFarAndDeep)
{
  const SeaState sea = Sea(1e9);
  const View view = Look({ 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
  for (const TrainRule rule : { TrainRule::PerTrain, TrainRule::TailSum })
  {
    const TrainTable table(sea, -60.0, 0.0, view, rule, 1.0);
    const TrainTable finer(sea, -60.0, 0.0, view, rule, 0.25);
    for (double z = -60.0; z <= 0.0; z += 0.7)
    {
      for (double d = 0.01; d < 1000.0; d *= 1.3)
      {
        const int count = table.CountAt(d, z);
        EXPECT_LE(table.CountAt(1.3 * d, z), count);
        EXPECT_LE(table.CountAt(d, z - 0.7), count);
        EXPECT_GE(finer.CountAt(d, z), count);
      }
    }
    EXPECT_EQ(table.CountAt(0.0, 0.0), table.NumberOfTrains());
    EXPECT_LT(table.CountAt(60.0, -20.0), table.NumberOfTrains() / 2);
  }
  const TrainTable all(sea, -60.0, 0.0, view, TrainRule::All, 1.0);
  EXPECT_EQ(all.CountAt(1e6, -60.0), all.NumberOfTrains());
}

TEST(TrainSelection, OrderAtADepth)
{
  const SeaState sea = Sea(40.0);
  const std::vector<int> order = OrderAt(sea, -12.0);
  EXPECT_TRUE(IsPermutation(order));
  EXPECT_FALSE(IsPermutation({ 0, 2 }));
  EXPECT_FALSE(IsPermutation({ 1, 1 }));
  EXPECT_FALSE(IsPermutation({ -1, 0 }));
  const SeaState ordered = Ordered(sea, order);
  for (std::size_t n = 1; n < ordered.Trains.size(); ++n)
  {
    EXPECT_GE(AxesAt(ordered.Trains[n - 1], -12.0, 40.0).Horizontal, AxesAt(ordered.Trains[n], -12.0, 40.0).Horizontal);
  }
  EXPECT_NE(ordered.Trains[2].WaveNumber, sea.Trains[2].WaveNumber) << "depth has no effect on the order";
  // It takes fewer trains there, and all of them move a particle as before.
  const View view = Look({ 0.0, 0.0, -12.0 }, { 0.0, 1.0, 0.0 });
  const TrainTable plain(sea, -13.0, -12.0, view, TrainRule::PerTrain, 1.0);
  const TrainTable better(ordered, -13.0, -12.0, view, TrainRule::PerTrain, 1.0);
  EXPECT_LT(better.CountAt(15.0, -12.5), plain.CountAt(15.0, -12.5));
  const std::vector<Vector3> places = Places(10, { { 0.0, 0.0, -13.0 }, { 5.0, 5.0, -12.0 } });
  const std::vector<Vector3> a = Moved(sea, 3.0, places, {});
  const std::vector<Vector3> b = Moved(ordered, 3.0, places, {});
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    EXPECT_LT(glm::distance(a[n], b[n]), 1e-12);
  }
}
