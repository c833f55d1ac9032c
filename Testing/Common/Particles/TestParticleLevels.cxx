// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Particles in levels of detail: errors within their bounds, nothing visible lost, the work of the paper's table 1, and
// fog that hides as much as its particles do.
#include "../OnThreads.h"
#include "../PictureOf.h"
#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"
#include "Particles/ParticleFog.h"
#include "Particles/ParticleGroups.h"
#include "Particles/ParticleLevels.h"
#include "Particles/ParticleMotion.h"
#include "Sea/TrainSelection.h"
#include "Sea/WaveOrbits.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace littoral;
using littoral::testing::OnThreads;

namespace
{

SeaState Sea(double depth, double wind = 10.0)
{
  SpectrumParameters parameters;
  parameters.WindSpeed = wind;
  return { TrainsOf(SeaSpectrum(parameters), depth, TrainParameters{}), depth, 0.0 };
}

std::vector<Vector3> Places(int count, const Box& box, unsigned int seed = 1)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vector3> places(count);
  for (Vector3& place : places)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] = box.Low[axis] + unit(engine) * (box.High[axis] - box.Low[axis]);
    }
  }
  return places;
}

/// Extinction [1/m] between the samples of a grid, by trilinear interpolation.
double ExtinctionAt(const FogGrid& grid, const std::vector<float>& extinction, const Vector3& place)
{
  const Vector3 index = (place - grid.Origin) / grid.Spacing;
  std::array<int, 3> low;
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = std::clamp(static_cast<int>(std::floor(index[axis])), 0, grid.Count[axis] - 2);
  }
  const Vector3 part = index - Vector3(low[0], low[1], low[2]);
  const auto alongX = [&](int j, int k) {
    const std::size_t first = (static_cast<std::size_t>(k) * grid.Count[1] + j) * grid.Count[0] + low[0];
    return glm::mix<double>(extinction[first], extinction[first + 1], part.x);
  };
  const auto alongY = [&](int k) { return glm::mix(alongX(low[1], k), alongX(low[1] + 1, k), part.y); };
  return glm::mix(alongY(low[2]), alongY(low[2] + 1), part.z);
}

/// Moved by their first trains; counts empty: by all.
std::vector<Vector3> Moved(
  const SeaState& sea, double time, const std::vector<Vector3>& places, std::vector<int> counts)
{
  if (counts.empty())
  {
    counts.assign(places.size(), static_cast<int>(sea.Trains.size()));
  }
  std::vector<double> centers(3 * places.size());
  std::vector<double> shift(3 * places.size());
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    std::copy_n(&places[n].x, 3, &centers[3 * n]);
  }
  OrbitRequest<double> request;
  request.Centers = centers.data();
  request.TrainCounts = counts.data();
  request.Displacement = shift.data();
  WaveOrbits(sea, {}, time).Evaluate(request, 0, places.size());
  std::vector<Vector3> moved(places.size());
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    moved[n] = places[n] + Vector3(shift[3 * n], shift[3 * n + 1], shift[3 * n + 2]);
  }
  return moved;
}

View Look(const Vector3& eye, const Vector3& direction, double angle = 45.0, double aspect = 4.0 / 3.0)
{
  View view;
  view.Point = eye;
  view.Direction = direction;
  view.Angle = angle * Pi / 180.0;
  view.AspectRatio = aspect;
  view.Height = 480.0;
  return view;
}

/// Pixels of a point from the center of the picture; false if the picture does not show it.
bool Project(const View& view, const Vector3& point, std::array<double, 2>& pixel)
{
  const Vector3 ahead = glm::normalize(view.Direction);
  const Vector3 right = glm::normalize(glm::cross(ahead, view.Up));
  const Vector3 up = glm::cross(right, ahead);
  const Vector3 seen = point - view.Point;
  const double depth = glm::dot(seen, ahead);
  const double scale = view.Height / (2.0 * std::tan(0.5 * view.Angle)) / depth;
  pixel = { scale * glm::dot(seen, right), scale * glm::dot(seen, up) };
  return depth > 0.0 && std::abs(pixel[0]) <= 0.5 * view.Height * view.AspectRatio &&
    std::abs(pixel[1]) <= 0.5 * view.Height;
}

TrainTable Table(
  const SeaState& sea, const ParticleGroups& groups, const View& view, TrainRule rule, double error = 1.0)
{
  double low = groups.GetCells().front().Bounds.Low.z;
  double high = groups.GetCells().front().Bounds.High.z;
  for (const ParticleGroups::Cell& cell : groups.GetCells())
  {
    low = std::min(low, cell.Bounds.Low.z);
    high = std::max(high, cell.Bounds.High.z);
  }
  return TrainTable(sea, low, high, view, rule, error);
}

/// A selection particle by particle.
struct Listed : ParticleCounts
{
  std::vector<ShownParticle> Near;
  std::vector<ShownParticle> Middle; ///< those with orbits first
  std::vector<ShownParticle> Far;
};

std::vector<ShownParticle> ListOf(const ShownLevel& level, const ParticleGroups& groups)
{
  std::vector<ShownParticle> list;
  level.ForEach(
    [&](std::size_t begin, std::size_t end, std::size_t place, int trains) {
      EXPECT_EQ(place, list.size());
      for (std::size_t n = begin; n < end; ++n)
      {
        list.push_back({ groups.GetOrder()[n], static_cast<int>(n), -1, trains, 1.0f, 0.0f });
      }
    },
    [&](const ShownParticle& particle, std::size_t place) {
      EXPECT_EQ(place, list.size());
      EXPECT_EQ(groups.GetOrder()[particle.Place], particle.Particle);
      list.push_back(particle);
    });
  return list;
}

Listed ListOf(const ParticleSelection& selection, const ParticleGroups& groups)
{
  Listed all;
  static_cast<ParticleCounts&>(all) = selection;
  const auto append = [](std::vector<ShownParticle>& to, const std::vector<ShownParticle>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (const ParticlePart& part : selection.Parts)
  {
    append(all.Near, ListOf(part.Near, groups));
    append(all.Far, ListOf(part.Far, groups));
    append(all.Middle, part.Masters);
  }
  for (const ParticlePart& part : selection.Parts)
  {
    for (ShownParticle slave : part.Slaves)
    {
      slave.Master += static_cast<int>(part.Before.Masters);
      all.Middle.push_back(slave);
    }
  }
  return all;
}

Listed Select(const SeaState& sea, const std::vector<Vector3>& places, const ParticleGroups& groups, const View& view,
  const ParticleLevelOptions& options, TrainRule rule)
{
  return ListOf(SelectParticles(places, groups, Table(sea, groups, view, rule), ViewFrustum(view), options, 0,
                  groups.GetCells().size()),
    groups);
}

/// A view of frame n on a way through the water, looking about.
View FrameView(int frame)
{
  const double t = 0.05 * frame;
  return Look({ 12.0 * std::cos(t), 9.0 * std::sin(1.3 * t), -6.0 + 5.0 * std::sin(0.7 * t) },
    { std::cos(2.1 * t), std::sin(2.1 * t), 0.5 * std::sin(3.0 * t) });
}

}

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

TEST(ParticleGroups, GroupsAreCompleteAndOffsetsInRange)
{
  const std::vector<Vector3> places = Places(4001, { { 0.0, 0.0, -8.5 }, { 10.0, 10.0, -7.5 } });
  GroupOptions options;
  options.NearestOffset = 0.05;
  options.MaximumOffset = 0.4;
  for (const bool scatter : { false, true })
  {
    options.Scatter = scatter;
    const ParticleGroups groups(places, options, 64);
    std::vector<int> seen(places.size(), 0);
    std::size_t end = 0;
    int slaves = 0;
    for (const ParticleGroups::Cell& cell : groups.GetCells())
    {
      EXPECT_EQ(cell.Begin, end);
      end = cell.End;
      EXPECT_LE(cell.End - cell.Begin, 64u);
      for (std::size_t n = cell.Begin; n < cell.End; ++n)
      {
        const int particle = groups.GetOrder()[n];
        ++seen[particle];
        const int master = groups.MasterOf(particle);
        EXPECT_EQ(groups.MasterOf(master), master) << "a master that is a slave";
        const Vector3 kept = places[master] + groups.OffsetOf(particle);
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_GE(kept[axis], cell.Bounds.Low[axis] - 1e-12);
          EXPECT_LE(kept[axis], cell.Bounds.High[axis] + 1e-12);
        }
        if (master != particle)
        {
          ++slaves;
          const double length = glm::length(groups.OffsetOf(particle));
          EXPECT_GE(length, options.NearestOffset - 1e-12);
          EXPECT_LE(length, options.MaximumOffset + 1e-12);
          EXPECT_TRUE(scatter || glm::distance(kept, places[particle]) < 1e-12) << "a slave leaves its place";
        }
      }
    }
    EXPECT_EQ(end, places.size());
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(places.size()));
    EXPECT_GT(slaves, scatter ? 2999 : 2500);

    const ParticleGroups again(places, options, 64, OnThreads(2));
    EXPECT_EQ(again.GetOrder(), groups.GetOrder());
  }
}

/// Halves of the particles by a full sort along the longest side, down to groups: each as the set of its numbers.
void HalvesBySorting(
  const std::vector<Vector3>& places, std::vector<int> all, std::size_t group, std::vector<std::vector<int>>& sets)
{
  if (all.size() <= group)
  {
    std::sort(all.begin(), all.end());
    sets.push_back(all);
    return;
  }
  Vector3 low = places[all[0]];
  Vector3 high = low;
  for (const int n : all)
  {
    low = glm::min(low, places[n]);
    high = glm::max(high, places[n]);
  }
  const Vector3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::sort(all.begin(), all.end(),
    [&](int a, int b) { return std::make_pair(places[a][axis], a) < std::make_pair(places[b][axis], b); });
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>((all.size() + group - 1) / group / 2 * group);
  HalvesBySorting(places, { all.begin(), middle }, group, sets);
  HalvesBySorting(places, { middle, all.end() }, group, sets);
}

TEST(ParticleGroups, AreThoseOfASort)
{
  const GroupOptions options;
  std::vector<Vector3> places = Places(3001, { { -9.0, 0.0, -9.0 }, { 9.0, 14.0, 0.0 } });
  for (const double step : { 0.0, 1.5 }) // also on a lattice, with many ties
  {
    for (Vector3& place : places)
    {
      place = step > 0.0 ? step * glm::floor(place / step) : place;
    }
    std::vector<int> all(places.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<std::vector<int>> sets;
    HalvesBySorting(places, all, 4, sets);
    const ParticleGroups groups(places, options, 4);
    ASSERT_EQ(groups.GetCells().size(), sets.size());
    for (std::size_t n = 0; n < sets.size(); ++n)
    {
      const ParticleGroups::Cell& cell = groups.GetCells()[n];
      const auto first = groups.GetOrder().begin() + static_cast<std::ptrdiff_t>(cell.Begin);
      std::vector<int> found(first, first + static_cast<std::ptrdiff_t>(cell.End - cell.Begin));
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, sets[n]) << n;
    }
  }
}

TEST(ParticleGroups, AreTheSameWhateverWasBefore)
{
  GroupOptions options;
  options.MaximumOffset = 0.6;
  std::vector<Vector3> places = Places(5000, { { -9.0, 0.0, -9.0 }, { 9.0, 14.0, 0.0 } });
  std::vector<int> former(places.size());
  std::iota(former.rbegin(), former.rend(), 0); // from last to first
  for (int frame = 0; frame < 6; ++frame)
  {
    const ParticleGroups fresh(places, options, 64);
    const ParticleGroups later(places, options, 64, OnThreads(2), NoPoll, former);
    EXPECT_EQ(later.GetOrder(), fresh.GetOrder()) << frame;
    ASSERT_EQ(later.GetCells().size(), fresh.GetCells().size());
    for (std::size_t n = 0; n < fresh.GetCells().size(); ++n)
    {
      EXPECT_EQ(later.GetCells()[n].Begin, fresh.GetCells()[n].Begin);
      EXPECT_EQ(later.GetCells()[n].Bounds.Low, fresh.GetCells()[n].Bounds.Low);
      EXPECT_EQ(later.GetCells()[n].Bounds.High, fresh.GetCells()[n].Bounds.High);
    }
    for (int particle = 0; particle < 5000; ++particle)
    {
      EXPECT_EQ(later.MasterOf(particle), fresh.MasterOf(particle));
      EXPECT_EQ(later.OffsetOf(particle), fresh.OffsetOf(particle));
    }
    former = fresh.GetOrder();
    for (Vector3& place : places) // a whirl
    {
      place += 0.05 * Vector3(-place.y, place.x, std::sin(place.x));
    }
  }
}

TEST(ParticleGroups, OddSets)
{
  const GroupOptions options;
  EXPECT_TRUE(ParticleGroups(std::vector<Vector3>(), options, 64).GetCells().empty());
  // The order of other particles is of no use.
  EXPECT_TRUE(ParticleGroups(std::vector<Vector3>(), options, 64, SerialFor, NoPoll, { 1, 0 }).GetOrder().empty());
  const std::vector<Vector3> three = Places(3, { { 0.0, 0.0, -1.0 }, { 1.0, 1.0, 0.0 } });
  EXPECT_EQ(ParticleGroups(three, options, 64, SerialFor, NoPoll, { 4, 2, 0, 1, 3 }).GetOrder(),
    ParticleGroups(three, options, 64).GetOrder());
  for (const int count : { 1, 2, 3, 4, 5, 63, 64, 65, 257 })
  {
    const ParticleGroups alike(std::vector<Vector3>(count, Vector3(1.0, 2.0, -3.0)), options, 64);
    EXPECT_EQ(alike.GetOrder().size(), static_cast<std::size_t>(count));
    EXPECT_EQ(alike.GetCells().back().End, static_cast<std::size_t>(count));
  }
  GroupOptions alone;
  alone.Slaves = 0;
  const ParticleGroups each(Places(100, { { 0.0, 0.0, -1.0 }, { 1.0, 1.0, 0.0 } }), alone, 1);
  EXPECT_EQ(each.GetCells().size(), 100u);
  GroupOptions bad;
  bad.Slaves = -1;
  EXPECT_NE(WhyInvalid(bad).find("SlavesPerMaster"), std::string::npos);
  bad = {};
  bad.NearestOffset = 2.0;
  EXPECT_NE(WhyInvalid(bad).find("OffsetRange"), std::string::npos);
}

TEST(ParticleLevels, SlavesStayWithinTheirBound)
{
  for (const double depth : { 1e9, 12.0 })
  {
    const SeaState sea = Sea(depth);
    const std::vector<Vector3> places = Places(3000, { { -9.0, 0.0, -9.0 }, { 9.0, 14.0, 0.0 } });
    for (const bool scatter : { false, true })
    {
      GroupOptions grouping;
      grouping.MaximumOffset = 1.5;
      grouping.Scatter = scatter;
      const ParticleGroups groups(places, grouping, 64);
      const View view = Look({ 0.0, -2.0, -4.0 }, { 0.0, 1.0, 0.0 }, 70.0);
      const Listed selection = Select(sea, places, groups, view, {}, TrainRule::TailSum);
      const TrainTable table = Table(sea, groups, view, TrainRule::TailSum);
      double closest = 0.0;
      int slaves = 0;
      for (int frame = 0; frame < 60; ++frame)
      {
        std::vector<Vector3> masters;
        std::vector<int> counts;
        std::vector<Vector3> own;
        std::vector<const ShownParticle*> shown;
        for (const ShownParticle& particle : selection.Middle)
        {
          if (particle.Master >= 0)
          {
            const ShownParticle& master = selection.Middle[particle.Master];
            EXPECT_LT(master.Master, 0);
            EXPECT_EQ(master.Particle, groups.MasterOf(particle.Particle));
            // As many trains as at each slave's own distance, also of slaves that are nearer to the eye.
            EXPECT_GE(
              master.Trains, table.CountAt(LevelDistance(view, places[particle.Particle]), places[master.Particle].z));
            masters.push_back(places[master.Particle]);
            counts.push_back(master.Trains);
            own.push_back(places[master.Particle] + groups.OffsetOf(particle.Particle));
            shown.push_back(&particle);
          }
        }
        const std::vector<Vector3> moved = Moved(sea, 0.83 * frame, masters, counts);
        const std::vector<Vector3> wanted = Moved(sea, 0.83 * frame, own, {});
        for (std::size_t n = 0; n < own.size(); ++n)
        {
          const Vector3 place = moved[n] + groups.OffsetOf(shown[n]->Particle);
          const double error = glm::distance(place, wanted[n]);
          EXPECT_LE(error, shown[n]->Error);
          closest = std::max(closest, error / shown[n]->Error);
        }
        slaves = static_cast<int>(own.size());
      }
      EXPECT_GT(slaves, 500);
      EXPECT_GT(closest, 0.2) << "the bound is of no use";
      std::printf("depth %g m: %d slaves, errors up to %.2f of their bounds, largest bound %.3f m\n", depth, slaves,
        closest, selection.MaximumSlaveError);
    }
  }
}

TEST(ParticleLevels, ASlaveAboveItsMasterMovesMoreThanIt)
{
  // A wave of 3 m dies out with depth: by e^2 from 1 m to 2 m.
  const SeaState sea{ { { 0.2, std::sqrt(Gravity * 2.0), 2.0, 0.3, 0.0 } }, 1e9, 0.0 };
  const std::vector<Vector3> places{ { 0.0, 6.0, -2.0 }, { 0.1, 6.0, -1.0 }, { -0.1, 6.0, -3.0 } };
  GroupOptions grouping;
  grouping.Slaves = 2;
  grouping.MaximumOffset = 1.5;
  const ParticleGroups groups(places, grouping, 3);
  ASSERT_EQ(groups.MasterOf(1), 0);
  const View view = Look({ 0.0, 0.0, -2.0 }, { 0.0, 1.0, 0.0 }, 70.0);
  const Listed selection = Select(sea, places, groups, view, {}, TrainRule::All);
  int slaves = 0;
  double largest = 0.0;
  for (const ShownParticle& particle : selection.Middle)
  {
    for (int moment = 0; particle.Master >= 0 && moment < 20; ++moment)
    {
      const std::vector<Vector3> moved = Moved(sea, 0.07 * moment, places, {});
      const double error = glm::distance(moved[0] + groups.OffsetOf(particle.Particle), moved[particle.Particle]);
      EXPECT_LE(error, particle.Error);
      largest = std::max(largest, error);
      ++slaves;
    }
  }
  EXPECT_EQ(slaves, 40);
  EXPECT_GT(largest, 0.02);
}

TEST(ParticleLevels, StepsAreSmoothAndEven)
{
  EXPECT_EQ(BlendAt(-2.0, 2.0), 0.0);
  EXPECT_EQ(BlendAt(-9.0, 2.0), 0.0);
  EXPECT_EQ(BlendAt(2.0, 2.0), 1.0);
  EXPECT_EQ(BlendAt(9.0, 2.0), 1.0);
  double before = 0.0;
  for (double x = -2.0; x <= 2.0; x += 0.01)
  {
    const double now = BlendAt(x, 2.0);
    EXPECT_NEAR(now + BlendAt(-x, 2.0), 1.0, 1e-12);
    EXPECT_GE(now, before);
    EXPECT_LT(now - before, 0.0038); // the slope of a cubic step is nowhere above 3/2 of the straight line's
    before = now;
  }
  EXPECT_EQ(BlendAt(-1e-9, 0.0), 0.0);
  EXPECT_EQ(BlendAt(1e-9, 0.0), 1.0);
}

TEST(ParticleLevels, NothingVisibleIsLost)
{
  const SeaState sea = Sea(30.0);
  const std::vector<Vector3> places = Places(6000, { { -20.0, -20.0, -12.0 }, { 20.0, 20.0, 0.0 } });
  const ParticleGroups groups(places, {}, 64);
  long long visible[2] = { 0, 0 };
  long long culled = 0;
  for (int frame = 0; frame < 25; ++frame)
  {
    View view = FrameView(8 * frame);
    view.IsParallel = frame % 2 == 1;
    view.ParallelScale = frame % 4 == 1 ? 1.5 : 7.0;
    const PictureOf picture(view);
    ParticleLevelOptions options;
    options.Margin = 0.0;
    options.MiddleDistance = view.IsParallel ? 6.0 : options.MiddleDistance;
    const Listed selection = Select(sea, places, groups, view, options, TrainRule::All);
    std::vector<double> weight(places.size(), 0.0);
    for (const auto* level : { &selection.Near, &selection.Middle, &selection.Far })
    {
      for (const ShownParticle& particle : *level)
      {
        weight[particle.Particle] += particle.Weight;
      }
    }
    culled += std::count(weight.begin(), weight.end(), 0.0);
    for (int moment = 0; moment < 3; ++moment)
    {
      // At its own place and at the one it keeps from its master.
      const std::vector<Vector3> moved = Moved(sea, 3.1 * moment, places, {});
      for (std::size_t n = 0; n < places.size(); ++n)
      {
        const int master = groups.MasterOf(static_cast<int>(n));
        const Vector3 kept = moved[master] + groups.OffsetOf(static_cast<int>(n));
        const double distance =
          view.IsParallel ? view.ParallelScale / std::tan(0.5 * view.Angle) : glm::distance(places[n], view.Point);
        const LevelWeights levels = WeightsAt(distance, options);
        const bool isNear = levels.Near > 0.0 && picture.Shows(moved[n]);
        const bool isMiddle = levels.Middle > 0.0 && picture.Shows(master == static_cast<int>(n) ? moved[n] : kept);
        const bool isFar = levels.Far > 0.0 && picture.Shows(places[n]);
        if (isNear || isMiddle || isFar)
        {
          ++visible[view.IsParallel];
          EXPECT_GT(weight[n], 0.0) << "particle " << n << " in frame " << frame;
        }
      }
    }
  }
  EXPECT_GT(visible[0], 10000);
  EXPECT_GT(visible[1], 10000);
  EXPECT_GT(culled, 25 * 3000);
}

TEST(ParticleLevels, WeightsOfLevelsSumToOne)
{
  const SeaState sea = Sea(1e9);
  const std::vector<Vector3> places = Places(4000, { { -10.0, 0.0, -12.0 }, { 10.0, 25.0, -3.0 } });
  const ParticleGroups groups(places, {}, 64);
  ParticleLevelOptions options;
  options.UseCulling = false;
  options.BlendDistance = 1.0;
  const View view = Look({ 0.0, 0.0, -6.0 }, { 0.0, 1.0, 0.0 });
  const Listed selection = Select(sea, places, groups, view, options, TrainRule::PerTrain);
  std::vector<double> sum(places.size(), 0.0);
  int blended = 0;
  for (const auto* level : { &selection.Near, &selection.Middle, &selection.Far })
  {
    for (const ShownParticle& particle : *level)
    {
      sum[particle.Particle] += particle.Weight;
      blended += particle.Weight > 0.0f && particle.Weight < 1.0f;
    }
  }
  for (const double one : sum)
  {
    EXPECT_NEAR(one, 1.0, 1e-6);
  }
  EXPECT_GT(blended, 200);
  for (double d = 0.0; d < 20.0; d += 0.01)
  {
    const LevelWeights w = WeightsAt(d, options);
    EXPECT_NEAR(w.Near + w.Middle + w.Far, 1.0, 1e-15);
    EXPECT_TRUE(w.Near >= 0.0 && w.Middle >= 0.0 && w.Far >= 0.0);
  }
}

/// Cells of one particle are hardly ever in a level as a whole with what is about them: they are looked at one by one.
TEST(ParticleLevels, WholeCellsAreAsTheirParticles)
{
  const SeaState sea = Sea(30.0);
  const std::vector<Vector3> places = Places(20000, { { -15.0, -15.0, -9.0 }, { 15.0, 15.0, -1.0 } });
  const ParticleGroups groups(places, {}, 64);
  for (int frame = 0; frame < 12; ++frame)
  {
    View view = FrameView(11 * frame);
    view.IsParallel = frame % 4 == 3;
    view.ParallelScale = 3.0;
    ParticleLevelOptions options;
    options.UseCulling = frame % 3 > 0;
    options.VisibleDistance = 20.0;
    const TrainRule rule = frame % 2 == 0 ? TrainRule::All : TrainRule::TailSum;
    const Listed whole = Select(sea, places, groups, view, options, rule);
    // A shift that says nothing of where particles are makes no cell a whole one.
    const Box anywhere{ Vector3(-100.0), Vector3(100.0) };
    const TrainTable table = Table(sea, groups, view, rule);
    const Listed each = ListOf(SelectParticles(places, groups, table, ViewFrustum(view), options, 0,
                                 groups.GetCells().size(), SerialFor, anywhere),
      groups);
    EXPECT_EQ(whole.Near, each.Near);
    EXPECT_EQ(whole.Middle, each.Middle);
    EXPECT_EQ(whole.Far, each.Far);
    EXPECT_EQ(whole.TrainSum, each.TrainSum);
    EXPECT_EQ(whole.Shown, each.Shown);
    EXPECT_EQ(whole.MaximumSlaveError, each.MaximumSlaveError);
  }
}

TEST(ParticleMotion, WaysOfAll)
{
  const std::vector<Vector3> from = Places(40001, { { -5.0, 0.0, -8.5 }, { 5.0, 10.0, -7.5 } });
  std::vector<Vector3> to = from;
  std::for_each(to.begin(), to.end(), [](Vector3& place) { place += Vector3(1.0, -2.0, 0.5); });
  to[17] += Vector3(0.0, 0.25, 0.0);
  to[40000] -= Vector3(0.0, 0.0, 1.0);
  double sum = 0.0;
  std::for_each(to.begin(), to.end(), [&](const Vector3& place) { sum += place.z; });
  const ParticleMotion motion = MotionOf(from, to, OnThreads(3));
  EXPECT_LT(glm::distance(motion.Shift.Low, Vector3(1.0, -2.0, -0.5)), 1e-12);
  EXPECT_LT(glm::distance(motion.Shift.High, Vector3(1.0, -1.75, 0.5)), 1e-12);
  EXPECT_NEAR(motion.Spread(), 1.0, 1e-12);
  EXPECT_NEAR(motion.MeanHeight, sum / 40001.0, 1e-10);
  EXPECT_EQ(motion.MeanHeight, MotionOf(from, to).MeanHeight);
  EXPECT_TRUE(motion.IsFinite);
  to[40000].y = std::nan("");
  EXPECT_FALSE(MotionOf(from, to).IsFinite);
}

TEST(ParticleLevels, WorkOfTheTableOfThePaper)
{
  // Section 3.4: 4000 particles in 10 m x 1 m x 10 m, 30 trains, 3 slaves a master, levels at 2 m and 12 m, 30 m of
  // visibility. Wind, depth, lens and picture are not in the paper.
  const SeaState asMade = Sea(std::numeric_limits<double>::infinity());
  const SeaState sea = Ordered(asMade, OrderAt(asMade, -8.0));
  ASSERT_EQ(sea.Trains.size(), 30u);
  const std::vector<Vector3> places = Places(4000, { { -5.0, 0.0, -8.5 }, { 5.0, 10.0, -7.5 } });
  const ParticleGroups groups(places, {}, 64);
  const double published[3][5] = { { 1.82, 2.09, 2.64, 4.09, 8.82 }, { 1.18, 1.45, 1.91, 2.55, 2.73 },
    { 2.00, 2.55, 3.45, 5.64, 11.09 } };
  const char* names[3] = { "levels of detail", "selection of trains", "both" };
  const double everything = 30.0 * 4000.0;
  double ratio[3][5];
  for (int variant = 0; variant < 3; ++variant)
  {
    for (int step = 0; step < 5; ++step)
    {
      const View view = Look({ 0.0, -3.0 * step, -8.0 }, { 0.0, 1.0, 0.0 });
      ParticleLevelOptions options;
      options.UseLevels = variant != 1;
      options.UseCulling = variant != 1;
      options.VisibleDistance = 30.0;
      const TrainRule rule = variant == 0 ? TrainRule::All : TrainRule::PerTrain;
      const Listed selection = Select(sea, places, groups, view, options, rule);
      ratio[variant][step] = everything / static_cast<double>(selection.TrainSum);
    }
    for (const double* row : std::array<const double*, 2>{ published[variant], ratio[variant] })
    {
      std::printf("%-20s %s", names[variant], row == published[variant] ? "published" : "here     ");
      for (int step = 0; step < 5; ++step)
      {
        std::printf(" %8.2f", row[step]);
      }
      std::printf("\n");
    }
    for (int step = 0; step < 5; ++step)
    {
      if (step < 4)
      {
        EXPECT_GE(ratio[variant][step], published[variant][step]) << names[variant] << " at " << 3 * step << " m";
      }
      if (step > 0)
      {
        EXPECT_GT(ratio[variant][step], ratio[variant][step - 1]) << names[variant] << " at " << 3 * step << " m";
      }
    }
  }
  for (int step = 0; step < 5; ++step)
  {
    EXPECT_GE(ratio[2][step], std::max(ratio[0][step], ratio[1][step]));
  }
}

TEST(ParticleLevels, BadOptions)
{
  ParticleLevelOptions options;
  options.MiddleDistance = 13.0;
  EXPECT_NE(WhyInvalid(options).find("MiddleDistance"), std::string::npos);
  options = {};
  options.BlendDistance = std::nan("");
  EXPECT_NE(WhyInvalid(options).find("BlendDistance"), std::string::npos);
  EXPECT_EQ(WhyInvalid(ParticleLevelOptions{}), "");
}

namespace
{

ParticleFog FogOf(
  const FogGrid& grid, const std::vector<FogParticle>& particles, const ParallelFor& parallel = SerialFor)
{
  const auto read = [&particles](std::size_t begin, std::size_t end, FogParticle* to) {
    std::copy(
      particles.begin() + static_cast<std::ptrdiff_t>(begin), particles.begin() + static_cast<std::ptrdiff_t>(end), to);
  };
  FogMemory memory;
  return ParticleFog(grid, particles.size(), read, memory, parallel);
}

}

TEST(ParticleFog, BoundsAreThatThick)
{
  using Bounds = std::array<double, 6>;
  EXPECT_EQ(Thickened({ 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 }, 0.5), (Bounds{ 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 }));
  EXPECT_EQ(Thickened({ 1.0, 4.0, 5.0, 5.0, -2.0, -1.75 }, 0.5), (Bounds{ 1.0, 4.0, 4.75, 5.25, -2.125, -1.625 }));
}

TEST(ParticleFog, KeepsTheSumOfCrossSections)
{
  const FogGrid grid{ { -1.0, 2.0, -3.0 }, { 0.5, 0.25, 1.0 }, { 7, 9, 4 } };
  const std::vector<Vector3> places = Places(5000, { { -1.0, 2.0, -3.0 }, { 2.0, 4.0, 0.0 } });
  std::vector<FogParticle> particles;
  double sum = 0.0;
  for (const Vector3& place : places)
  {
    particles.push_back({ place, 1e-4 * (1.0 + place.x * place.x) });
    sum += particles.back().CrossSection;
  }
  const ParticleFog fog = FogOf(grid, particles);
  EXPECT_EQ(fog.GetOutside(), 0);
  EXPECT_NEAR(TotalCrossSection(grid, fog.GetExtinction()) / sum, 1.0, 1e-6);

  // One particle: the integral of the field about it, and its first moment.
  const FogParticle one{ { 0.13, 3.04, -1.3 }, 2e-3 };
  const ParticleFog alone = FogOf(grid, { one });
  Vector3 moment(0.0);
  for (int k = 0; k < grid.Count[2]; ++k)
  {
    for (int j = 0; j < grid.Count[1]; ++j)
    {
      for (int i = 0; i < grid.Count[0]; ++i)
      {
        const double e = alone.GetExtinction()[(static_cast<std::size_t>(k) * 9 + j) * 7 + i];
        moment += 0.125 * e * (grid.Origin + Vector3(0.5 * i, 0.25 * j, 1.0 * k));
      }
    }
  }
  EXPECT_LT(glm::distance(moment / one.CrossSection, one.Place), 1e-6);

  particles.push_back({ { 2.01, 3.0, -1.0 }, 1.0 });
  const ParticleFog again = FogOf(grid, particles, OnThreads(2));
  EXPECT_EQ(again.GetOutside(), 1);
  EXPECT_EQ(again.GetExtinction(), fog.GetExtinction());
}

// More layers and particles than one thread takes at a time, against a sum over all particles in their order.
TEST(ParticleFog, LayersKeepTheOrderOfTheParticles)
{
  const FogGrid grid{ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, { 3, 3, 21 } };
  const std::vector<Vector3> places = Places(9000, { { -0.1, 0.0, 0.0 }, { 2.0, 2.0, 20.0 } });
  std::vector<FogParticle> particles;
  std::vector<double> below(grid.NumberOfSamples(), 0.0); // of the particles under a sample
  std::vector<double> above(grid.NumberOfSamples(), 0.0);
  long long outside = 0;
  for (const Vector3& p : places)
  {
    particles.push_back({ p, 1e-3 * (1.0 + p.z) });
    if (p.x < 0.0)
    {
      ++outside;
      continue;
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      const int at[3] = { static_cast<int>(p.x) + corner % 2, static_cast<int>(p.y) + corner / 2 % 2,
        static_cast<int>(p.z) + corner / 4 };
      double share = 1.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        share *= 1.0 - std::abs(p[axis] - at[axis]);
      }
      const std::size_t sample = static_cast<std::size_t>((at[2] * 3 + at[1]) * 3 + at[0]);
      (corner / 4 > 0 ? below : above)[sample] += share * particles.back().CrossSection;
    }
  }
  const ParticleFog fog = FogOf(grid, particles);
  EXPECT_EQ(fog.GetOutside(), outside);
  EXPECT_GT(outside, 0);
  EXPECT_EQ(FogOf(grid, particles, OnThreads(3)).GetExtinction(), fog.GetExtinction());
  for (std::size_t n = 0; n < below.size(); ++n)
  {
    const int at[3] = { static_cast<int>(n % 3), static_cast<int>(n / 3 % 3), static_cast<int>(n / 9) };
    const double volume = (at[0] == 1 ? 1.0 : 0.5) * (at[1] == 1 ? 1.0 : 0.5) * (at[2] % 20 > 0 ? 1.0 : 0.5);
    EXPECT_FLOAT_EQ(fog.GetExtinction()[n], static_cast<float>((below[n] + above[n]) / volume));
  }
}

TEST(ParticleFog, MemoryOfFormerFogsDoesNotShow)
{
  const FogGrid grid{ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, { 3, 3, 3 } };
  FogMemory memory;
  for (const int count : { 500, 20, 9000 })
  {
    std::vector<FogParticle> particles;
    for (const Vector3& place : Places(count, { { 0.0, 0.0, 0.0 }, { 2.0, 2.0, 2.0 } }))
    {
      particles.push_back({ place, 1e-3 });
    }
    const auto read = [&particles](std::size_t begin, std::size_t end, FogParticle* to) {
      std::copy(particles.data() + begin, particles.data() + end, to);
    };
    EXPECT_EQ(
      ParticleFog(grid, particles.size(), read, memory).GetExtinction(), FogOf(grid, particles).GetExtinction());
    memory.Limit(400);
  }
}

TEST(ParticleFog, SpreadsParticlesOverTheVolumeOfTheirSample)
{
  // On a sample, its cross section over the part of the cells around that is in the grid.
  const FogGrid grid{ { 0.0, 0.0, 0.0 }, { 0.5, 0.25, 1.0 }, { 5, 5, 5 } };
  for (int faces = 0; faces <= 3; ++faces)
  {
    const int i = faces > 0 ? 0 : 2;
    const int j = faces > 1 ? 4 : 2;
    const int k = faces > 2 ? 4 : 2;
    const ParticleFog fog = FogOf(grid, { { { 0.5 * i, 0.25 * j, 1.0 * k }, 2e-3 } });
    const double volume = 0.125 * std::pow(0.5, faces);
    EXPECT_NEAR(fog.GetExtinction()[(static_cast<std::size_t>(k) * 5 + j) * 5 + i] * volume, 2e-3, 1e-9);
  }
}

namespace
{

constexpr int Rays = 160; // a side

/// Place of a ray along x or z [m].
double RayAt(int index)
{
  const double from = 0.2;
  const double step = 3.6 / Rays;
  return from + (index + 0.5) * step;
}

/// Particles of a radius that each ray along y meets.
std::vector<std::vector<int>> ParticlesOfRays(const std::vector<Vector3>& places, double radius)
{
  std::vector<std::vector<int>> columns(Rays * Rays);
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    for (int i = 0; i < Rays; ++i)
    {
      const double x = RayAt(i);
      if (std::abs(places[n].x - x) > radius)
      {
        continue;
      }
      for (int j = 0; j < Rays; ++j)
      {
        const double z = RayAt(j);
        if (std::hypot(places[n].x - x, places[n].z - z) <= radius)
        {
          columns[i * Rays + j].push_back(static_cast<int>(n));
        }
      }
    }
  }
  return columns;
}

}

TEST(ParticleFog, HidesAsMuchAsItsParticlesDo)
{
  // Light along y through a box of particles: the part of rays that meet none, against the fog. Some particles are
  // drawn in part, as where levels change: drawn and fog together must hide as much.
  const Box box{ { 0.0, 0.0, 0.0 }, { 4.0, 10.0, 4.0 } };
  const double diameter = 0.04;
  const double section = 0.25 * Pi * diameter * diameter;
  const std::vector<Vector3> places = Places(9000, box, 5);
  const FogGrid grid{ box.Low, { 0.2, 0.2, 0.2 }, { 21, 51, 21 } };
  ParticleLevelOptions options;
  options.FarDistance = 5.0;
  options.BlendDistance = 2.0;
  std::vector<FogParticle> particles;
  for (const Vector3& place : places)
  {
    particles.push_back({ place, section * WeightsAt(place.y, options).Far });
  }
  std::vector<FogParticle> all = particles;
  for (FogParticle& particle : all)
  {
    particle.CrossSection = section;
  }
  const std::vector<float> blended = FogOf(grid, particles).GetExtinction();
  const std::vector<float> whole = FogOf(grid, all).GetExtinction();

  double drawn = 0.0;
  double fog = 0.0;
  double both = 0.0;
  const std::vector<std::vector<int>> columns = ParticlesOfRays(places, 0.5 * diameter);
  for (int i = 0; i < Rays; ++i)
  {
    for (int j = 0; j < Rays; ++j)
    {
      const double x = RayAt(i);
      const double z = RayAt(j);
      double depth = 0.0;
      double depthBlended = 0.0;
      for (double y = 0.05; y < 10.0; y += 0.1)
      {
        depth += 0.1 * ExtinctionAt(grid, whole, { x, y, z });
        depthBlended += 0.1 * ExtinctionAt(grid, blended, { x, y, z });
      }
      double through = 1.0;
      for (const int particle : columns[i * Rays + j])
      {
        through *= 1.0 - (1.0 - WeightsAt(places[particle].y, options).Far);
      }
      drawn += columns[i * Rays + j].empty();
      fog += std::exp(-depth);
      both += through * std::exp(-depthBlended);
    }
  }
  drawn /= Rays * Rays;
  fog /= Rays * Rays;
  both /= Rays * Rays;
  std::printf("transmittance: particles %.4f, fog %.4f, half and half %.4f, uniform %.4f\n", drawn, fog, both,
    std::exp(-9000.0 / 160.0 * section * 10.0));
  EXPECT_LT(drawn, 0.7);
  EXPECT_NEAR(fog / drawn, 1.0, 0.05);
  EXPECT_NEAR(both / drawn, 1.0, 0.05);
}
