// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Particles/ParticleLevels.h"

#include "Numerics/ParameterCheck.h"
#include "Numerics/RoundedUp.h"
#include "Numerics/SmoothStep.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

namespace littoral
{

namespace
{

/// Clusters that are not worth a thread.
constexpr std::size_t ClustersOfOneThread = 64;

/// Distance from a boundary within which groups are tested one by one, for sums are rounded [m].
constexpr double Slack = 1e-6;

/// Appends a run, to the last one where that is shown alike and ends where it begins.
void AddRun(ShownRuns& runs, const PlaceRange& range, int trains, RunWeight weight, float error)
{
  if (range.Size() == 0)
  {
    return;
  }
  const bool goesOn = !runs.empty() && runs.back().End == range.Begin && runs.back().Trains == trains &&
    runs.back().Weight == weight && runs.back().Error == error;
  goesOn ? static_cast<void>(runs.back().End = range.End)
         : runs.push_back({ range.Begin, range.End, trains, weight, error });
}

class Selector
{
public:
  Selector(const ParticleGroups& groups, const TrainTable& table, const ViewFrustum& frustum,
    const ParticleLevelOptions& options, const Box& shift)
    : Groups(groups)
    , Table(table)
    , Frustum(frustum)
    , Options(options)
    , Shift(shift)
    , Way(0.5 * (shift.Low + shift.High))
    , Spread(0.5 * glm::length(shift.High - shift.Low))
    , Limit(options.VisibleDistance > 0.0 ? options.VisibleDistance + frustum.GetView().Margin
                                          : std::numeric_limits<double>::infinity())
  {
  }

  /// Adds what the view needs of the cells from begin up to end, which are in the cluster of the part.
  void Take(std::size_t begin, std::size_t end, ParticlePart& part, ParticleCounts& counts)
  {
    const std::vector<ParticleRegion>& cells = this->Groups.GetCells();
    const ParticleRegion& cluster = this->Groups.GetClusters()[part.Cluster];
    const bool isWhole =
      cells[begin].Orbits.Begin == cluster.Orbits.Begin && cells[end - 1].Slaves.End == cluster.Slaves.End;
    const Verdict verdict = isWhole ? this->TakeWhole(cluster, 1, part) : Verdict::Mixed;
    counts.CellsShown += verdict == Verdict::Taken ? static_cast<long long>(end - begin) : 0;
    for (std::size_t cell = begin; verdict == Verdict::Mixed && cell < end; ++cell)
    {
      const Verdict own = this->TakeWhole(cells[cell], this->Table.NumberOfTrains(), part);
      counts.CellsShown += own == Verdict::Hidden ? 0 : 1;
      if (own == Verdict::Mixed)
      {
        this->TakeGroups(cells[cell], part);
      }
    }
  }

private:
  /// Result of the test of a region.
  enum class Verdict
  {
    Hidden, ///< the view needs nothing of it
    Taken,  ///< it is in one level
    Mixed   ///< its parts are to be tested
  };

  enum class Level
  {
    Near,
    Middle,
    Far,
    Mixed
  };

  /// A level of a group: whether it is in it, and with which weight.
  struct InLevel
  {
    bool Is = false;
    RunWeight Weight = RunWeight::One;
  };

  /// Levels of a group.
  struct GroupShow
  {
    InLevel Orbit; ///< of the master, in Near or in Middle
    bool IsNear = false;
    InLevel Near; ///< of slaves
    InLevel Middle;
    InLevel Far; ///< of all
  };

  /// Number of trains of the orbits of a region, and errors [m].
  struct Motion
  {
    int Trains;
    float Tail;       ///< error of all that have orbits
    float SlaveError; ///< and of slaves
  };

  Box Shifted(const Box& box) const { return { box.Low + this->Shift.Low, box.High + this->Shift.High }; }

  bool MayShow(const Box& box) const
  {
    if (SightDistance(this->Frustum.GetView(), box) > this->Limit)
    {
      return false;
    }
    const double reach = this->Table.AmplitudeAt(box.High.z) +
      std::max(this->Options.Margin, this->Options.UseLevels ? this->Options.FogMargin : 0.0);
    return !this->Options.UseCulling || this->Frustum.MayShow({ box.Low - reach, box.High + reach });
  }

  /// The level that all places in a box have; Mixed where it is not one, or the view does not need all of it.
  Level LevelOf(const Box& box, const Distances& distances) const
  {
    const View& view = this->Frustum.GetView();
    if (FarthestSight(view, box) > this->Limit - Slack)
    {
      return Level::Mixed;
    }
    const auto isBeyond = [&](double distance) {
      return distances.Least >= distance + this->Options.BlendDistance + Slack;
    };
    const auto isBefore = [&](double distance) {
      return distances.Most <= distance - this->Options.BlendDistance - Slack;
    };
    if (this->Options.UseLevels && isBeyond(this->Options.FarDistance))
    {
      return Level::Far;
    }
    if (this->Options.UseCulling && !this->Frustum.Holds(box, Slack))
    {
      return Level::Mixed;
    }
    const bool isMiddle = isBeyond(this->Options.MiddleDistance) && isBefore(this->Options.FarDistance);
    return !this->Options.UseLevels || isBefore(this->Options.MiddleDistance) ? Level::Near
      : isMiddle                                                              ? Level::Middle
                                                                              : Level::Mixed;
  }

  /// Takes a region that is in one level, if the numbers of trains that its parts need differ by no more than so many.
  Verdict TakeWhole(const ParticleRegion& region, int difference, ParticlePart& part) const
  {
    const Box box = this->Shifted(region.Bounds);
    if (!this->MayShow(box))
    {
      return Verdict::Hidden;
    }
    const Distances distances = LevelDistances(this->Frustum.GetView(), box);
    const Level level = this->LevelOf(box, distances);
    if (level == Level::Far)
    {
      AddRun(part.Far, region.Orbits, 0, RunWeight::One, 0.0f);
      AddRun(part.Far, region.Slaves, 0, RunWeight::One, 0.0f);
      return Verdict::Taken;
    }
    const Motion motion = this->MotionOf(region, box, distances);
    if (level == Level::Mixed || motion.Trains - this->Table.CountAt(distances.Most, box.Low.z) > difference)
    {
      return Verdict::Mixed;
    }
    const bool isNear = level == Level::Near;
    AddRun(isNear ? part.Near : part.Orbits, region.Orbits, motion.Trains, RunWeight::One, motion.Tail);
    isNear ? AddRun(part.Near, region.Slaves, motion.Trains, RunWeight::One, motion.Tail)
           : AddRun(part.Slaves, region.Slaves, 0, RunWeight::One, motion.SlaveError);
    return Verdict::Taken;
  }

  /// The motion of a region in a box: that of its nearest and highest place, and of the slave farthest from its master.
  Motion MotionOf(const ParticleRegion& region, const Box& box, const Distances& distances) const
  {
    const int trains = this->Table.CountAt(distances.Least, box.High.z);
    const double tail = this->Table.TailAt(trains, box.High.z);
    const double error = this->Table.SlaveError(region.Reach + 2.0 * this->Spread, box.High.z);
    return { trains, RoundedUp(tail), RoundedUp(error + tail) };
  }

  /// A level whose weight is between two bounds.
  static InLevel LevelWith(double least, double most)
  {
    return { most > 0.0, least >= 1.0 ? RunWeight::One : RunWeight::ByDistance };
  }

  /// Levels of the group of the master at a place. All of it is within a reach of the master.
  GroupShow ShowOf(std::size_t place) const
  {
    GroupShow show;
    const View& view = this->Frustum.GetView();
    const Vector3 center = this->Groups.GetPlaces()[place] + this->Way;
    const double reach = this->Groups.ReachOf(this->Groups.GetOrder()[place]) + 2.0 * this->Spread;
    const double margin = this->Table.AmplitudeAt(center.z + reach) + this->Options.Margin;
    const auto isSeen = [&](double wider) {
      return !this->Options.UseCulling || this->Frustum.MayShow(center, reach + wider);
    };
    const double fogMargin = this->Options.UseLevels ? this->Options.FogMargin : 0.0;
    if (!isSeen(std::max(margin, fogMargin)) || SightDistance(view, center) > this->Limit)
    {
      return show;
    }
    // Weights are monotonous in the distance.
    const double distance = LevelDistance(view, center);
    const double spread = this->Spread / view.DetailFactor;
    const LevelWeights nearest = WeightsAt(distance - spread, this->Options);
    const LevelWeights farthest = spread > 0.0 ? WeightsAt(distance + spread, this->Options) : nearest;
    show.Far = LevelWith(nearest.Far, farthest.Far > 0.0 && isSeen(fogMargin) ? farthest.Far : 0.0);
    if (nearest.Far >= 1.0 || !isSeen(margin))
    {
      return show;
    }
    show.IsNear = distance < this->Options.MiddleDistance || !this->Options.UseLevels;
    show.Orbit = LevelWith(1.0 - farthest.Far, 1.0 - nearest.Far);
    show.Near = LevelWith(farthest.Near, nearest.Near);
    show.Middle = LevelWith(1.0 - nearest.Near - farthest.Far, 1.0 - farthest.Near - nearest.Far);
    return show;
  }

  void TakeGroups(const ParticleRegion& cell, ParticlePart& part)
  {
    const Box box = this->Shifted(cell.Bounds);
    const Motion motion = this->MotionOf(cell, box, LevelDistances(this->Frustum.GetView(), box));
    this->Shows.clear();
    for (std::size_t place = cell.Orbits.Begin; place < cell.Orbits.End; ++place)
    {
      this->Shows.push_back(this->ShowOf(place));
      TakeOrbit({ place, place + 1 }, this->Groups.SlavesAt(cell, place).Size() > 0, this->Shows.back(), motion, part);
    }
    auto show = this->Shows.begin();
    for (std::size_t place = cell.Orbits.Begin; place < cell.Orbits.End; ++place)
    {
      TakeSlaves(this->Groups.SlavesAt(cell, place), *show++, motion, part);
    }
  }

  static void TakeOrbit(
    const PlaceRange& orbit, bool isMaster, const GroupShow& show, const Motion& motion, ParticlePart& part)
  {
    if (show.Orbit.Is)
    {
      AddRun(show.IsNear ? part.Near : part.Orbits, orbit, motion.Trains, show.Orbit.Weight, motion.Tail);
    }
    if (show.IsNear && show.Middle.Is && isMaster)
    {
      AddRun(part.Orbits, orbit, motion.Trains, RunWeight::None, motion.Tail);
    }
    if (show.Far.Is)
    {
      AddRun(part.Far, orbit, 0, show.Far.Weight, 0.0f);
    }
  }

  static void TakeSlaves(const PlaceRange& slaves, const GroupShow& show, const Motion& motion, ParticlePart& part)
  {
    if (show.Near.Is)
    {
      AddRun(part.Near, slaves, motion.Trains, show.Near.Weight, motion.Tail);
    }
    if (show.Middle.Is)
    {
      AddRun(part.Slaves, slaves, 0, show.Middle.Weight, motion.SlaveError);
    }
    if (show.Far.Is)
    {
      AddRun(part.Far, slaves, 0, show.Far.Weight, 0.0f);
    }
  }

  const ParticleGroups& Groups;
  const TrainTable& Table;
  const ViewFrustum& Frustum;
  const ParticleLevelOptions& Options;
  const Box& Shift;
  Vector3 Way;   ///< in the middle of all [m]
  double Spread; ///< of the others about it [m]
  double Limit;
  std::vector<GroupShow> Shows; ///< of a cell
};

/// Number of particles of some runs.
long long SizeOf(const ShownRuns& runs)
{
  return std::accumulate(runs.begin(), runs.end(), 0ll,
    [](long long sum, const ShownRun& run) { return sum + static_cast<long long>(run.Size()); });
}

/// Adds the numbers of a part.
void Count(const ParticlePart& part, ParticleCounts& counts)
{
  counts.Near += SizeOf(part.Near);
  counts.Masters += SizeOf(part.Orbits);
  counts.Slaves += SizeOf(part.Slaves);
  counts.Far += SizeOf(part.Far);
  for (const ShownRuns* runs : { &part.Near, &part.Orbits, &part.Slaves })
  {
    for (const ShownRun& run : *runs)
    {
      const auto size = static_cast<long long>(run.Size());
      counts.TrainSum += size * run.Trains;
      counts.Shown += run.Weight == RunWeight::None ? 0 : size;
    }
  }
  for (const ShownRun& run : part.Slaves)
  {
    counts.MaximumSlaveError = std::max(counts.MaximumSlaveError, static_cast<double>(run.Error));
  }
}

void Add(const ParticleCounts& some, ParticleCounts& to)
{
  to.CellsShown += some.CellsShown;
  to.Near += some.Near;
  to.Masters += some.Masters;
  to.Slaves += some.Slaves;
  to.Far += some.Far;
  to.TrainSum += some.TrainSum;
  to.Shown += some.Shown;
  to.MaximumSlaveError = std::max(to.MaximumSlaveError, some.MaximumSlaveError);
}

}

bool operator==(const ShownRun& a, const ShownRun& b)
{
  return a.Begin == b.Begin && a.End == b.End && a.Trains == b.Trains && a.Weight == b.Weight && a.Error == b.Error;
}

std::string WhyInvalid(const ParticleLevelOptions& options)
{
  ParameterCheck check;
  check.NotNegative("MiddleDistance", options.MiddleDistance, "m");
  check.NotNegative("FarDistance", options.FarDistance, "m");
  check.NotNegative("BlendDistance", options.BlendDistance, "m");
  check.NotNegative("VisibleDistance", options.VisibleDistance, "m");
  check.NotNegative("Margin", options.Margin, "m");
  check.NotNegative("FogMargin", options.FogMargin, "m");
  check.Require(options.MiddleDistance <= options.FarDistance,
    "MiddleDistance is " + TextOf(options.MiddleDistance) + " m and FarDistance " + TextOf(options.FarDistance) +
      " m; far must not be nearer than middle.");
  return check.Reason();
}

double BlendAt(double x, double width)
{
  if (!(width > 0.0))
  {
    return x < 0.0 ? 0.0 : 1.0;
  }
  return SmoothStep(0.0, 1.0, 0.5 * (x / width + 1.0));
}

LevelWeights WeightsAt(double distance, const ParticleLevelOptions& options)
{
  if (!options.UseLevels)
  {
    return { 1.0, 0.0, 0.0 };
  }
  const double beyondMiddle = BlendAt(distance - options.MiddleDistance, options.BlendDistance);
  const double beyondFar = BlendAt(distance - options.FarDistance, options.BlendDistance);
  return { 1.0 - beyondMiddle, beyondMiddle - beyondFar, beyondFar };
}

double WeightIn(ParticleLevel level, bool isSlave, double distance, const ParticleLevelOptions& options)
{
  const LevelWeights weights = WeightsAt(distance, options);
  return level == ParticleLevel::Far ? weights.Far
    : !isSlave                       ? 1.0 - weights.Far
    : level == ParticleLevel::Near   ? weights.Near
                                     : weights.Middle;
}

ParticleSelection SelectParticles(const ParticleGroups& groups, const TrainTable& table, const ViewFrustum& frustum,
  const ParticleLevelOptions& options, std::size_t firstCell, std::size_t endCell, const ParallelFor& parallelFor,
  const Box& shift)
{
  constexpr std::size_t size = ParticleGroups::CellsOfCluster;
  ParticleSelection selection;
  selection.CellsInAll = static_cast<long long>(endCell - firstCell);
  const std::size_t firstCluster = firstCell / size;
  selection.Parts.resize(firstCell < endCell ? (endCell - 1) / size + 1 - firstCluster : 0);
  std::vector<ParticleCounts> counts(selection.Parts.size());
  ForRanges(parallelFor, counts.size(), ClustersOfOneThread, [&](std::size_t first, std::size_t last) {
    Selector selector(groups, table, frustum, options, shift);
    for (std::size_t n = first; n < last; ++n)
    {
      ParticlePart& part = selection.Parts[n];
      part.Cluster = firstCluster + n;
      selector.Take(
        std::max(firstCell, part.Cluster * size), std::min(endCell, (part.Cluster + 1) * size), part, counts[n]);
      Count(part, counts[n]);
    }
  });
  for (std::size_t n = 0; n < counts.size(); ++n)
  {
    selection.Parts[n].Before = selection;
    Add(counts[n], selection);
  }
  return selection;
}

}
