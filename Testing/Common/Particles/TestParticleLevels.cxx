// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Particles in levels of detail: errors within their bounds, nothing visible lost, the work of the paper's table 1.
#include "../OnThreads.h"
#include "../PictureOf.h"
#include "ParticleScenes.h"
#include "Particles/ParticleGroups.h"
#include "Particles/ParticleLevels.h"
#include "Particles/ParticleMotion.h"
#include "Sea/TrainSelection.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

using namespace littoral;
using namespace littoral::testing;

namespace
{

TrainTable Table(
  const SeaState& sea, const ParticleGroups& groups, const View& view, TrainRule rule, double error = 1.0)
{
  double low = groups.GetCells().front().Bounds.Low.z;
  double high = groups.GetCells().front().Bounds.High.z;
  for (const ParticleRegion& cell : groups.GetCells())
  {
    low = std::min(low, cell.Bounds.Low.z);
    high = std::max(high, cell.Bounds.High.z);
  }
  return TrainTable(sea, low, high, view, rule, error);
}

/// A particle that a level shows.
struct ShownParticle
{
  int Particle;
  int Master; ///< its index in the level; -1 for a particle with an orbit of its own
  int Trains;
  float Weight;
  float Error; ///< [m]
};

/// A selection particle by particle.
struct Listed : ParticleCounts
{
  std::vector<ShownParticle> Near;
  std::vector<ShownParticle> Middle; ///< those with orbits first
  std::vector<ShownParticle> Far;
};

/// Particles of a level with their weights at some places.
struct Lister
{
  const ParticleGroups& Groups;
  const std::vector<Vector3>& Places;
  const View& Seen;
  const ParticleLevelOptions& Options;

  void Append(const ShownRuns& runs, ParticleLevel level, std::vector<ShownParticle>& list) const
  {
    for (const ShownRun& run : runs)
    {
      for (std::size_t n = run.Begin; n < run.End; ++n)
      {
        const int particle = this->Groups.GetOrder()[n];
        const int master = this->Groups.MasterOf(particle);
        const double own =
          WeightIn(level, master != particle, LevelDistance(this->Seen, this->Places[master]), this->Options);
        const double weight = run.Weight == RunWeight::None ? 0.0 : run.Weight == RunWeight::One ? 1.0 : own;
        list.push_back({ particle, -1, run.Trains, static_cast<float>(weight), run.Error });
      }
    }
  }
};

Listed ListOf(const ParticleSelection& selection, const Lister& lister)
{
  const ParticleGroups& groups = lister.Groups;
  Listed all;
  static_cast<ParticleCounts&>(all) = selection;
  for (const ParticlePart& part : selection.Parts)
  {
    lister.Append(part.Near, ParticleLevel::Near, all.Near);
    lister.Append(part.Far, ParticleLevel::Far, all.Far);
    lister.Append(part.Orbits, ParticleLevel::Middle, all.Middle);
  }
  const std::size_t orbits = all.Middle.size();
  std::vector<int> places(groups.GetOrder().size(), -1);
  for (std::size_t n = 0; n < orbits; ++n)
  {
    places[all.Middle[n].Particle] = static_cast<int>(n);
  }
  for (const ParticlePart& part : selection.Parts)
  {
    lister.Append(part.Slaves, ParticleLevel::Middle, all.Middle);
  }
  for (std::size_t n = orbits; n < all.Middle.size(); ++n)
  {
    all.Middle[n].Master = places[groups.MasterOf(all.Middle[n].Particle)];
    EXPECT_GE(all.Middle[n].Master, 0);
  }
  return all;
}

Listed Select(const SeaState& sea, const std::vector<Vector3>& places, const ParticleGroups& groups, const View& view,
  const ParticleLevelOptions& options, TrainRule rule)
{
  return ListOf(
    SelectParticles(groups, Table(sea, groups, view, rule), ViewFrustum(view), options, 0, groups.GetCells().size()),
    { groups, places, view, options });
}

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

/// In calm water the reach of a group alone tells which of its particles may be seen.
TEST(ParticleLevels, NothingVisibleIsLostInCalmWater)
{
  const SeaState sea{ { { 1e-9, std::sqrt(Gravity * 2.0), 2.0, 0.3, 0.0 } }, 1e9, 0.0 };
  const std::vector<Vector3> places = Places(4000, { { -10.0, -10.0, -9.0 }, { 10.0, 10.0, -1.0 } });
  GroupOptions scattered;
  scattered.Scatter = true;
  scattered.MaximumOffset = 0.05;
  const ParticleGroups ofBoth[] = { ParticleGroups(places, {}, 64), ParticleGroups(places, scattered, 64) };
  ParticleLevelOptions options;
  options.Margin = 0.0;
  options.FogMargin = 0.0;
  int visible = 0;
  for (int frame = 0; frame < 20; ++frame)
  {
    const ParticleGroups& groups = ofBoth[frame % 2];
    const View view = FrameView(8 * frame);
    const ViewFrustum frustum(view);
    const Listed selection = Select(sea, places, groups, view, options, TrainRule::All);
    std::vector<char> isShown(places.size(), 0);
    for (const auto* level : { &selection.Near, &selection.Middle, &selection.Far })
    {
      std::for_each(
        level->begin(), level->end(), [&](const ShownParticle& one) { isShown[one.Particle] |= one.Weight > 0.0f; });
    }
    for (std::size_t n = 0; n < places.size(); ++n)
    {
      const int master = groups.MasterOf(static_cast<int>(n));
      const LevelWeights weights = WeightsAt(LevelDistance(view, places[master]), options);
      const bool isOwn = weights.Near + weights.Far > 0.0 && frustum.MayShow(places[n], 0.0);
      const Vector3 kept = places[master] + groups.OffsetOf(static_cast<int>(n));
      const bool isVisible = isOwn || (weights.Middle > 0.0 && frustum.MayShow(kept, 0.0));
      visible += isVisible;
      EXPECT_TRUE(isShown[n] || !isVisible) << "particle " << n << " in frame " << frame;
    }
  }
  EXPECT_GT(visible, 5000);
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

/// Clusters, cells and groups that are taken at once: each particle in the levels that the distance of its master
/// tells, with as many trains as its own place needs.
TEST(ParticleLevels, LevelsAreThoseOfTheMaster)
{
  const SeaState sea = Sea(30.0);
  const std::vector<Vector3> places = Places(60000, { { -15.0, -15.0, -9.0 }, { 15.0, 15.0, -1.0 } });
  GroupOptions scattered;
  scattered.Scatter = true;
  scattered.MaximumOffset = 0.2;
  const ParticleGroups ofBoth[] = { ParticleGroups(places, {}, 64), ParticleGroups(places, scattered, 64) };
  long long shown = 0;
  for (int frame = 0; frame < 12; ++frame)
  {
    const ParticleGroups& groups = ofBoth[frame / 6];
    View view = FrameView(11 * frame);
    view.IsParallel = frame % 4 == 3;
    view.ParallelScale = 3.0;
    ParticleLevelOptions options;
    options.UseCulling = frame % 3 > 0;
    options.UseLevels = frame != 7;
    options.VisibleDistance = 20.0;
    const TrainRule rule = frame % 2 == 0 ? TrainRule::All : TrainRule::TailSum;
    const TrainTable table = Table(sea, groups, view, rule);
    const Listed selection = Select(sea, places, groups, view, options, rule);
    std::vector<std::array<double, 3>> weights(places.size(), { 0.0, 0.0, 0.0 });
    const auto add = [&](const std::vector<ShownParticle>& level, int index) {
      for (const ShownParticle& particle : level)
      {
        const Vector3& place = places[particle.Particle];
        weights[particle.Particle][index] += particle.Weight;
        EXPECT_TRUE(
          index == 2 || particle.Master >= 0 || particle.Trains >= table.CountAt(LevelDistance(view, place), place.z));
      }
    };
    add(selection.Near, 0);
    add(selection.Middle, 1);
    add(selection.Far, 2);
    for (std::size_t n = 0; n < places.size(); ++n)
    {
      const int master = groups.MasterOf(static_cast<int>(n));
      const double distance = LevelDistance(view, places[master]);
      const LevelWeights wanted = WeightsAt(distance, options);
      const std::array<double, 3>& own = weights[n];
      const bool isOrbit = master == static_cast<int>(n);
      const bool isNear = distance < options.MiddleDistance || !options.UseLevels;
      const double near = !isOrbit ? wanted.Near : isNear ? 1.0 - wanted.Far : 0.0;
      const bool isHidden = SightDistance(view, places[master]) > options.VisibleDistance;
      EXPECT_FALSE(isHidden && own[0] + own[1] + own[2] > 0.0);
      const bool isSeen = !isHidden && (!options.UseCulling || own[0] + own[1] > 0.0);
      if (isSeen)
      {
        ++shown;
        EXPECT_NEAR(own[0], near, 1e-6);
        EXPECT_NEAR(own[1], 1.0 - wanted.Far - near, 1e-6);
      }
      EXPECT_TRUE(own[2] == 0.0 || std::abs(own[2] - wanted.Far) < 1e-6);
    }
  }
  EXPECT_GT(shown, 100000);
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

TEST(ParticleMotion, ShiftHoldsRoundedSums)
{
  const std::vector<Vector3> places = Places(5000, { { -500.0, 0.0, -8.5 }, { 800.0, 10.0, -7.5 } });
  std::vector<float> from(3 * places.size());
  for (std::size_t n = 0; n < from.size(); ++n)
  {
    from[n] = static_cast<float>(places[n / 3][static_cast<int>(n % 3)]);
  }
  const PlaceList start(from.data(), places.size());
  for (const Vector3& way : { Vector3(0.0), Vector3(0.37, 0.0, -0.011), Vector3(-73.1, 4e-5, 0.2) })
  {
    std::vector<float> to(from.size());
    for (std::size_t n = 0; n < from.size(); ++n)
    {
      to[n] = static_cast<float>(static_cast<double>(from[n]) + way[static_cast<int>(n % 3)]);
    }
    const ParticleMotion found = MotionOf(start, PlaceList(to.data(), places.size()));
    const Box box{ { -500.0, 0.0, -8.5 }, { 800.0, 10.0, -7.5 } };
    const ParticleMotion shifted = Shifted(MotionOf(start, start), way, box);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_LE(shifted.Shift.Low[axis], found.Shift.Low[axis]);
      EXPECT_GE(shifted.Shift.High[axis], found.Shift.High[axis]);
    }
    EXPECT_LT(shifted.Spread(), 2.5e-4);
    EXPECT_NEAR(shifted.MeanHeight, found.MeanHeight, 1e-6);
  }
  EXPECT_EQ(Shifted(MotionOf(start, start), Vector3(0.0), {}).Spread(), 0.0);
}

/// Particles that have gone any of the ways for which they were chosen: all that the distance of their master asks for
/// is there, and what is whole is so.
TEST(ParticleLevels, ASelectionHoldsForAllItsWays)
{
  const SeaState sea = Sea(30.0);
  const std::vector<Vector3> places = Places(40000, { { -15.0, -15.0, -9.0 }, { 15.0, 15.0, -1.0 } });
  const ParticleGroups groups(places, {}, 64);
  const View view = Look({ 0.0, -4.0, -5.0 }, { 0.2, 1.0, 0.1 }, 60.0);
  ParticleLevelOptions options;
  options.UseCulling = false;
  const Box shift{ { 0.2, -0.1, 0.0 }, { 0.6, 0.0, 0.1 } };
  const TrainTable table = Table(sea, groups, view, TrainRule::TailSum);
  const ParticleSelection selection =
    SelectParticles(groups, table, ViewFrustum(view), options, 0, groups.GetCells().size(), SerialFor, shift);
  using Weights = std::vector<std::array<int, 3>>; // 0 none, 1 by distance, 2 whole
  Weights found(places.size(), { 0, 0, 0 });
  const auto add = [&](const ShownRuns& runs, int level) {
    for (const ShownRun& run : runs)
    {
      for (std::size_t n = run.Begin; n < run.End && run.Weight != RunWeight::None; ++n)
      {
        found[groups.GetOrder()[n]][level] = run.Weight == RunWeight::One ? 2 : 1;
      }
    }
  };
  for (const ParticlePart& part : selection.Parts)
  {
    add(part.Near, 0);
    add(part.Orbits, 1);
    add(part.Slaves, 1);
    add(part.Far, 2);
  }
  int whole = 0;
  for (const Vector3& share : { Vector3(0.0), Vector3(1.0), Vector3(0.5), Vector3(1.0, 0.0, 0.3) })
  {
    const Vector3 way = shift.Low + share * (shift.High - shift.Low);
    for (std::size_t n = 0; n < places.size(); ++n)
    {
      const int master = groups.MasterOf(static_cast<int>(n));
      const LevelWeights weights = WeightsAt(LevelDistance(view, places[master] + way), options);
      const std::array<int, 3>& own = found[n];
      const bool isOrbit = master == static_cast<int>(n);
      const bool isThere = isOrbit ? weights.Far >= 1.0 || own[0] + own[1] > 0
                                   : (weights.Near <= 0.0 || own[0] > 0) && (weights.Middle <= 0.0 || own[1] > 0);
      EXPECT_TRUE(isThere && (weights.Far <= 0.0 || own[2] > 0)) << n;
      EXPECT_TRUE(own[2] != 2 || weights.Far >= 1.0) << n;
      EXPECT_TRUE(isOrbit || own[0] != 2 || weights.Near >= 1.0) << n;
      EXPECT_TRUE(isOrbit || own[1] != 2 || weights.Middle >= 1.0) << n;
      EXPECT_TRUE(!isOrbit || own[0] + own[1] < 2 || weights.Far <= 0.0) << n;
      whole += own[0] == 2 || own[1] == 2 || own[2] == 2;
    }
  }
  EXPECT_GT(whole, 100000);
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
