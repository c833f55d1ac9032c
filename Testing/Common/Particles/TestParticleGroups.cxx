// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Groups of particles, against those of a full sort.
#include "../OnThreads.h"
#include "ParticleScenes.h"
#include "Particles/ParticleGroups.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

using namespace littoral;
using namespace littoral::testing;

namespace
{

/// Places in the order of the groups of the particles of a region.
std::vector<std::size_t> PlacesOf(const ParticleRegion& region)
{
  std::vector<std::size_t> places(region.Size());
  const auto slaves = places.begin() + static_cast<std::ptrdiff_t>(region.Orbits.Size());
  std::iota(places.begin(), slaves, region.Orbits.Begin);
  std::iota(slaves, places.end(), region.Slaves.Begin);
  return places;
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
    for (const ParticleRegion& cell : groups.GetCells())
    {
      end += cell.Size();
      EXPECT_LE(cell.Size(), 64u);
      for (const std::size_t n : PlacesOf(cell))
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

/// In each cluster all that have orbits lie before the slaves, and each slave is found by its master and finds it.
TEST(ParticleGroups, MastersAndSlavesFindEachOther)
{
  GroupOptions options;
  options.MaximumOffset = 0.4;
  const std::vector<Vector3> places = Places(7003, { { 0.0, 0.0, -8.5 }, { 10.0, 10.0, -7.5 } });
  const ParticleGroups groups(places, options, 64);
  const std::vector<int>& order = groups.GetOrder();
  ASSERT_GT(groups.GetClusters().size(), 3u);
  std::size_t end = 0;
  for (std::size_t n = 0; n < groups.GetCells().size(); ++n)
  {
    const ParticleRegion& cell = groups.GetCells()[n];
    const ParticleRegion& cluster = groups.GetClusters()[n / ParticleGroups::CellsOfCluster];
    if (n % ParticleGroups::CellsOfCluster == 0)
    {
      EXPECT_EQ(cluster.Orbits.Begin, end);
      EXPECT_EQ(cluster.Orbits.End, cluster.Slaves.Begin);
      end = cluster.Slaves.End;
    }
    EXPECT_TRUE(cell.Orbits.Begin >= cluster.Orbits.Begin && cell.Orbits.End <= cluster.Orbits.End);
    EXPECT_TRUE(cell.Slaves.Begin >= cluster.Slaves.Begin && cell.Slaves.End <= cluster.Slaves.End);
    double farthest = 0.0;
    std::size_t next = cell.Slaves.Begin;
    for (std::size_t place = cell.Orbits.Begin; place < cell.Orbits.End; ++place)
    {
      EXPECT_EQ(groups.MasterOf(order[place]), order[place]);
      const PlaceRange slaves = groups.SlavesAt(cell, place);
      EXPECT_EQ(slaves.Begin, next);
      next = slaves.End;
      double reach = 0.0;
      for (std::size_t slave = slaves.Begin; slave < slaves.End; ++slave)
      {
        EXPECT_EQ(groups.MasterOf(order[slave]), order[place]);
        EXPECT_EQ(groups.MasterAt(slave), place);
        reach = std::max(reach, glm::distance(places[order[slave]], places[order[place]]));
      }
      EXPECT_NEAR(groups.ReachOf(order[place]), reach, 1e-6);
      EXPECT_GE(groups.ReachOf(order[place]), reach);
      farthest = std::max(farthest, reach);
    }
    EXPECT_EQ(next, cell.Slaves.End);
    EXPECT_NEAR(cell.Reach, farthest, 1e-6);
    EXPECT_GE(cluster.Reach, cell.Reach);
  }
  EXPECT_EQ(end, places.size());
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
      std::vector<int> found;
      for (const std::size_t place : PlacesOf(groups.GetCells()[n]))
      {
        found.push_back(groups.GetOrder()[place]);
      }
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
      EXPECT_EQ(later.GetCells()[n].Orbits.Begin, fresh.GetCells()[n].Orbits.Begin);
      EXPECT_EQ(later.GetCells()[n].Slaves.Begin, fresh.GetCells()[n].Slaves.Begin);
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
    EXPECT_EQ(alike.GetCells().back().Slaves.End, static_cast<std::size_t>(count));
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
