// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Particles/ParticleLevels.h"

#include "Numerics/ParameterCheck.h"
#include "Numerics/SmoothStep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace littoral
{

namespace
{

/// Cells that one thread tests at a time, and that are not worth a thread.
constexpr std::size_t CellsAtOnce = 16;
constexpr std::size_t CellsOfOneThread = 128;

/// Cells nearer to a boundary than this are tested by particles, for sums are rounded [m].
constexpr double Slack = 1e-6;

/// The least single precision number that is not below: bounds stay bounds.
float RoundedUp(double value)
{
  const float near = static_cast<float>(value);
  return near < value ? std::nextafter(near, std::numeric_limits<float>::infinity()) : near;
}

class Selector
{
public:
  Selector(const PlaceList& places, const ParticleGroups& groups, const TrainTable& table, const ViewFrustum& frustum,
    const ParticleLevelOptions& options, const Box& shift)
    : Places(places)
    , Groups(groups)
    , Table(table)
    , Frustum(frustum)
    , Options(options)
    , Shift(shift)
    , Limit(options.VisibleDistance > 0.0 ? options.VisibleDistance + frustum.GetView().Margin
                                          : std::numeric_limits<double>::infinity())
  {
  }

  /// Adds what the view needs of a cell.
  void Take(const ParticleGroups::Cell& cell, ParticlePart& part, ParticleCounts& counts) const
  {
    const Box box{ cell.Bounds.Low + this->Shift.Low, cell.Bounds.High + this->Shift.High };
    if (!this->MayShow(box))
    {
      return;
    }
    ++counts.CellsShown;
    switch (this->LevelOf(box))
    {
      case CellLevel::Far:
        part.Far.AddRun(cell.Begin, cell.End, 0);
        return;
      case CellLevel::InAllTrains:
        part.Near.AddRun(cell.Begin, cell.End, this->Table.NumberOfTrains());
        return;
      case CellLevel::Middle:
        return this->TakeGroups(cell, [&](auto begin, auto end) { this->TakeMiddle(begin, end, part); });
      case CellLevel::Mixed:
        return this->TakeGroups(cell, [&](auto begin, auto end) { this->TakeGroup(begin, end, part); });
    }
  }

private:
  /// The ways in which the particles of a cell are shown.
  enum class CellLevel
  {
    Mixed,       ///< each in its own way
    InAllTrains, ///< all in Near, by all trains
    Middle,      ///< all in Middle alone
    Far          ///< all in Far alone
  };

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

  /// The level that all places in a box have, if the view shows all of them.
  CellLevel LevelOf(const Box& box) const
  {
    const View& view = this->Frustum.GetView();
    const bool isWhole =
      (!this->Options.UseCulling || this->Frustum.Holds(box, Slack)) && FarthestSight(view, box) <= this->Limit - Slack;
    if (!isWhole)
    {
      return CellLevel::Mixed;
    }
    const bool byAll = this->Table.IsComplete();
    if (!this->Options.UseLevels)
    {
      return byAll ? CellLevel::InAllTrains : CellLevel::Mixed;
    }
    const Distances distances = LevelDistances(view, box);
    const auto isBeyond = [&](double distance) {
      return distances.Least >= distance + this->Options.BlendDistance + Slack;
    };
    const auto isBefore = [&](double distance) {
      return distances.Most <= distance - this->Options.BlendDistance - Slack;
    };
    const bool isMiddle = isBeyond(this->Options.MiddleDistance) && isBefore(this->Options.FarDistance);
    return isBeyond(this->Options.FarDistance)          ? CellLevel::Far
      : isMiddle                                        ? CellLevel::Middle
      : byAll && isBefore(this->Options.MiddleDistance) ? CellLevel::InAllTrains
                                                        : CellLevel::Mixed;
  }

  template <typename Take>
  void TakeGroups(const ParticleGroups::Cell& cell, const Take& take) const
  {
    const std::size_t group = this->Groups.GetGroupSize();
    for (std::size_t begin = cell.Begin; begin < cell.End; begin += group)
    {
      take(begin, std::min(begin + group, cell.End));
    }
  }

  int ParticleAt(std::size_t place) const { return this->Groups.GetOrder()[place]; }

  bool IsSeen(const Vector3& center, double height) const
  {
    return !this->Options.UseCulling ||
      this->Frustum.MayShow(center, this->Table.AmplitudeAt(height) + this->Options.Margin);
  }

  double DistanceOf(const Vector3& place) const { return LevelDistance(this->Frustum.GetView(), place); }

  bool IsInSight(const Vector3& place) const { return SightDistance(this->Frustum.GetView(), place) <= this->Limit; }

  /// A particle that so many trains of its height move.
  ShownParticle ByTrains(std::size_t place, int trains, double height, double weight) const
  {
    return { this->ParticleAt(place), static_cast<int>(place), -1, trains, static_cast<float>(weight),
      RoundedUp(this->Table.TailAt(trains, height)) };
  }

  ShownParticle OnOrbit(std::size_t place, double height, double distance, double weight) const
  {
    return this->ByTrains(place, this->Table.CountAt(distance, height), height, weight);
  }

  void TakeFog(std::size_t place, const Vector3& center, double weight, ParticlePart& part) const
  {
    if (weight > 0.0 && (!this->Options.UseCulling || this->Frustum.MayShow(center, this->Options.FogMargin)))
    {
      part.Far.Add({ this->ParticleAt(place), static_cast<int>(place), -1, 0, static_cast<float>(weight), 0.0f });
    }
  }

  /// A particle with an orbit of its own: masters, and those that follow none. The place of a master in Middle, or -1.
  int TakeMaster(std::size_t place, const Vector3& center, ParticlePart& part) const
  {
    if (!this->IsInSight(center))
    {
      return -1;
    }
    const double distance = this->DistanceOf(center);
    LevelWeights weights = WeightsAt(distance, this->Options);
    this->TakeFog(place, center, weights.Far, part);
    const double weight = 1.0 - weights.Far;
    if (weight <= 0.0 || !this->IsSeen(center, center.z))
    {
      return -1;
    }
    const bool isNear = distance < this->Options.MiddleDistance || !this->Options.UseLevels;
    const ShownParticle shown = this->OnOrbit(place, center.z, distance, weight);
    if (isNear)
    {
      part.Near.Add(shown);
      return -1;
    }
    part.Masters.push_back(shown);
    return static_cast<int>(part.Masters.size()) - 1;
  }

  /// A slave with its master, by places in the order of the groups and where they are.
  struct Following
  {
    std::size_t Place;
    Vector3 Center;
    std::size_t Master;
    Vector3 MasterCenter;
    Vector3 Offset;
  };

  void TakeSlave(const Following& slave, int& place, ParticlePart& part) const
  {
    if (!this->IsInSight(slave.Center))
    {
      return;
    }
    const double distance = this->DistanceOf(slave.Center);
    const LevelWeights weights = WeightsAt(distance, this->Options);
    this->TakeFog(slave.Place, slave.Center, weights.Far, part);
    if (weights.Near > 0.0 && this->IsSeen(slave.Center, slave.Center.z))
    {
      part.Near.Add(this->OnOrbit(slave.Place, slave.Center.z, distance, weights.Near));
    }
    const double masterHeight = slave.MasterCenter.z;
    if (weights.Middle <= 0.0 || !this->IsSeen(slave.MasterCenter + slave.Offset, masterHeight))
    {
      return;
    }
    if (place < 0)
    {
      place = static_cast<int>(part.Masters.size());
      part.Masters.push_back(this->OnOrbit(slave.Master, masterHeight, distance, 0.0));
    }
    // The slave may be nearer to the eye than its master, which then needs more trains.
    ShownParticle& shown = part.Masters[place];
    shown.Trains = std::max(shown.Trains, this->Table.CountAt(distance, masterHeight));
    shown.Error = RoundedUp(this->Table.TailAt(shown.Trains, masterHeight));
    this->AddSlave(slave, place, weights.Middle, part);
  }

  /// Adds a slave to the level Middle; its error is that of its offset, as yet.
  void AddSlave(const Following& slave, int place, double weight, ParticlePart& part) const
  {
    const double highest = slave.MasterCenter.z + std::max(0.0, slave.Offset.z);
    const double error = this->Table.SlaveError(glm::length(slave.Offset), highest);
    part.Slaves.push_back(
      { this->ParticleAt(slave.Place), static_cast<int>(slave.Place), place, 0, static_cast<float>(weight), 0.0f });
    part.OffsetErrors.push_back(error);
  }

  /// Adds the errors of their master to those of the slaves from the first one on.
  void EndGroup(std::size_t firstSlave, ParticlePart& part) const
  {
    for (std::size_t n = firstSlave; n < part.Slaves.size(); ++n)
    {
      ShownParticle& slave = part.Slaves[n];
      slave.Error = RoundedUp(part.Masters[slave.Master].Error + part.OffsetErrors[n]);
    }
  }

  void TakeGroup(std::size_t begin, std::size_t end, ParticlePart& part) const
  {
    const Vector3 center = this->Places[this->ParticleAt(begin)];
    int place = this->TakeMaster(begin, center, part);
    const std::size_t firstSlave = part.Slaves.size();
    for (std::size_t n = begin + 1; n < end; ++n)
    {
      const int particle = this->ParticleAt(n);
      Following slave{ n, this->Places[particle], begin, center, Vector3(0.0) };
      if (this->Options.UseLevels && this->Groups.Follows(particle, slave.Center, center, slave.Offset))
      {
        this->TakeSlave(slave, place, part);
      }
      else
      {
        this->TakeMaster(n, slave.Center, part);
      }
    }
    this->EndGroup(firstSlave, part);
  }

  /// A group in the level Middle alone, all of it in the view: its number of trains is that of its nearest place.
  void TakeMiddle(std::size_t begin, std::size_t end, ParticlePart& part) const
  {
    const Vector3 center = this->Places[this->ParticleAt(begin)];
    const std::size_t place = part.Masters.size();
    const std::size_t firstSlave = part.Slaves.size();
    double nearest = this->DistanceOf(center);
    part.Masters.emplace_back();
    for (std::size_t n = begin + 1; n < end; ++n)
    {
      const int particle = this->ParticleAt(n);
      Following slave{ n, this->Places[particle], begin, center, Vector3(0.0) };
      const double distance = this->DistanceOf(slave.Center);
      if (this->Groups.Follows(particle, slave.Center, center, slave.Offset))
      {
        nearest = std::min(nearest, distance);
        this->AddSlave(slave, static_cast<int>(place), 1.0, part);
      }
      else
      {
        part.Masters.push_back(this->OnOrbit(n, slave.Center.z, distance, 1.0));
      }
    }
    part.Masters[place] = this->OnOrbit(begin, center.z, nearest, 1.0);
    this->EndGroup(firstSlave, part);
  }

  const PlaceList& Places;
  const ParticleGroups& Groups;
  const TrainTable& Table;
  const ViewFrustum& Frustum;
  const ParticleLevelOptions& Options;
  const Box& Shift;
  double Limit;
};

void Count(const ShownParticle& particle, ParticleCounts& counts)
{
  counts.TrainSum += particle.Trains;
  counts.Shown += particle.Weight > 0.0f;
}

/// Adds the numbers of a part.
void Count(const ParticlePart& part, ParticleCounts& counts)
{
  counts.Near += static_cast<long long>(part.Near.Size());
  counts.Masters += static_cast<long long>(part.Masters.size());
  counts.Slaves += static_cast<long long>(part.Slaves.size());
  counts.Far += static_cast<long long>(part.Far.Size());
  part.Near.ForEach(
    [&](std::size_t begin, std::size_t end, std::size_t, int trains) {
      counts.TrainSum += static_cast<long long>(end - begin) * trains;
      counts.Shown += static_cast<long long>(end - begin);
    },
    [&](const ShownParticle& particle, std::size_t) { Count(particle, counts); });
  for (const ShownParticle& particle : part.Masters)
  {
    Count(particle, counts);
  }
  for (const ShownParticle& particle : part.Slaves)
  {
    Count(particle, counts);
    counts.MaximumSlaveError = std::max(counts.MaximumSlaveError, static_cast<double>(particle.Error));
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

bool operator==(const ShownParticle& a, const ShownParticle& b)
{
  return a.Particle == b.Particle && a.Place == b.Place && a.Master == b.Master && a.Trains == b.Trains &&
    a.Weight == b.Weight && a.Error == b.Error;
}

void ShownLevel::AddRun(std::size_t begin, std::size_t end, int trains)
{
  this->TrainsOfRuns = trains;
  this->InRuns += end - begin;
  if (!this->Runs.empty() && this->Runs.back().End == begin && this->Runs.back().Before == this->Listed.size())
  {
    this->Runs.back().End = end;
    return;
  }
  this->Runs.push_back({ begin, end, this->Listed.size() });
}

bool ShownLevel::operator==(const ShownLevel& other) const
{
  const auto areSame = [](const Run& a, const Run& b) {
    return a.Begin == b.Begin && a.End == b.End && a.Before == b.Before;
  };
  return this->TrainsOfRuns == other.TrainsOfRuns && this->Listed == other.Listed &&
    std::equal(this->Runs.begin(), this->Runs.end(), other.Runs.begin(), other.Runs.end(), areSame);
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

ParticleSelection SelectParticles(const PlaceList& places, const ParticleGroups& groups, const TrainTable& table,
  const ViewFrustum& frustum, const ParticleLevelOptions& options, std::size_t firstCell, std::size_t endCell,
  const ParallelFor& parallelFor, const Box& shift)
{
  const Selector selector(places, groups, table, frustum, options, shift);
  const std::size_t cells = endCell - firstCell;
  ParticleSelection selection;
  selection.CellsInAll = static_cast<long long>(cells);
  selection.Parts.resize((cells + CellsAtOnce - 1) / CellsAtOnce);
  std::vector<ParticleCounts> counts(selection.Parts.size());
  const ParallelFor& onThreads = cells > CellsOfOneThread ? parallelFor : SerialFor;
  onThreads(counts.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t part = first; part < last; ++part)
    {
      const std::size_t begin = firstCell + part * CellsAtOnce;
      for (std::size_t cell = begin; cell < std::min(begin + CellsAtOnce, endCell); ++cell)
      {
        selector.Take(groups.GetCells()[cell], selection.Parts[part], counts[part]);
      }
      Count(selection.Parts[part], counts[part]);
    }
  });
  for (std::size_t part = 0; part < counts.size(); ++part)
  {
    selection.Parts[part].Before = selection;
    Add(counts[part], selection);
  }
  return selection;
}

}
