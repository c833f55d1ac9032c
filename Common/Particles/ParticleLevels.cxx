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

/// Cells that one thread tests at a time.
constexpr std::size_t CellsAtOnce = 16;

/// Selection of some cells. Masters in Middle count from the start of the part's own masters.
struct Part
{
  std::vector<ShownParticle> Near;
  std::vector<ShownParticle> Masters;
  std::vector<ShownParticle> Slaves;
  std::vector<ShownParticle> Far;
  long long CellsShown = 0;
};

/// The least single precision number that is not below: bounds stay bounds.
float RoundedUp(double value)
{
  const float near = static_cast<float>(value);
  return near < value ? std::nextafter(near, std::numeric_limits<float>::infinity()) : near;
}

class Selector
{
public:
  Selector(const std::vector<Vector3>& places, const ParticleGroups& groups, const TrainTable& table,
    const ViewFrustum& frustum, const ParticleLevelOptions& options)
    : Places(places)
    , Groups(groups)
    , Table(table)
    , Frustum(frustum)
    , Options(options)
    , Limit(options.VisibleDistance > 0.0 ? options.VisibleDistance + frustum.GetView().Margin
                                          : std::numeric_limits<double>::infinity())
  {
  }

  bool MayShow(const ParticleGroups::Cell& cell) const
  {
    if (SightDistance(this->Frustum.GetView(), cell.Bounds) > this->Limit)
    {
      return false;
    }
    const double reach = this->Table.AmplitudeAt(cell.Bounds.High.z) +
      std::max(this->Options.Margin, this->Options.UseLevels ? this->Options.FogMargin : 0.0);
    return !this->Options.UseCulling || this->Frustum.MayShow({ cell.Bounds.Low - reach, cell.Bounds.High + reach });
  }

  void Take(const ParticleGroups::Cell& cell, std::size_t group, Part& part) const
  {
    for (std::size_t begin = cell.Begin; begin < cell.End; begin += group)
    {
      this->TakeGroup(begin, std::min(begin + group, cell.End), part);
    }
  }

private:
  bool IsSeen(const Vector3& center, double height) const
  {
    return !this->Options.UseCulling ||
      this->Frustum.MayShow(center, this->Table.AmplitudeAt(height) + this->Options.Margin);
  }

  double DistanceOf(int particle) const { return LevelDistance(this->Frustum.GetView(), this->Places[particle]); }

  bool IsInSight(int particle) const
  {
    return SightDistance(this->Frustum.GetView(), this->Places[particle]) <= this->Limit;
  }

  ShownParticle OnOrbit(int particle, double distance, double weight) const
  {
    const double height = this->Places[particle].z;
    const int trains = this->Table.CountAt(distance, height);
    const double error = this->Table.TailAt(trains, height);
    return { particle, -1, trains, static_cast<float>(weight), RoundedUp(error) };
  }

  void TakeFog(int particle, double weight, Part& part) const
  {
    if (weight > 0.0 &&
      (!this->Options.UseCulling || this->Frustum.MayShow(this->Places[particle], this->Options.FogMargin)))
    {
      part.Far.push_back({ particle, -1, 0, static_cast<float>(weight), 0.0f });
    }
  }

  /// A particle with an orbit of its own: masters, and those that follow none. The place of a master in Middle, or -1.
  int TakeMaster(int particle, Part& part) const
  {
    if (!this->IsInSight(particle))
    {
      return -1;
    }
    const double distance = this->DistanceOf(particle);
    LevelWeights weights = WeightsAt(distance, this->Options);
    this->TakeFog(particle, weights.Far, part);
    const double weight = 1.0 - weights.Far;
    if (weight <= 0.0 || !this->IsSeen(this->Places[particle], this->Places[particle].z))
    {
      return -1;
    }
    const bool isNear = distance < this->Options.MiddleDistance || !this->Options.UseLevels;
    std::vector<ShownParticle>& level = isNear ? part.Near : part.Masters;
    level.push_back(this->OnOrbit(particle, distance, weight));
    return isNear ? -1 : static_cast<int>(level.size()) - 1;
  }

  void TakeSlave(int particle, int master, int& place, Part& part) const
  {
    if (!this->IsInSight(particle))
    {
      return;
    }
    const double distance = this->DistanceOf(particle);
    const LevelWeights weights = WeightsAt(distance, this->Options);
    this->TakeFog(particle, weights.Far, part);
    const Vector3& center = this->Places[particle];
    if (weights.Near > 0.0 && this->IsSeen(center, center.z))
    {
      part.Near.push_back(this->OnOrbit(particle, distance, weights.Near));
    }
    const Vector3 kept = this->Places[master] + this->Groups.OffsetOf(particle);
    const double masterHeight = this->Places[master].z;
    if (weights.Middle <= 0.0 || !this->IsSeen(kept, masterHeight))
    {
      return;
    }
    if (place < 0)
    {
      place = static_cast<int>(part.Masters.size());
      part.Masters.push_back(this->OnOrbit(master, distance, 0.0));
    }
    // The slave may be nearer to the eye than its master, which then needs more trains.
    ShownParticle& shown = part.Masters[place];
    shown.Trains = std::max(shown.Trains, this->Table.CountAt(distance, masterHeight));
    shown.Error = RoundedUp(this->Table.TailAt(shown.Trains, masterHeight));
    part.Slaves.push_back({ particle, place, 0, static_cast<float>(weights.Middle), 0.0f });
  }

  void TakeGroup(std::size_t begin, std::size_t end, Part& part) const
  {
    const std::vector<int>& order = this->Groups.GetOrder();
    const int master = order[begin];
    int place = this->TakeMaster(master, part);
    const std::size_t firstSlave = part.Slaves.size();
    for (std::size_t n = begin + 1; n < end; ++n)
    {
      const int particle = order[n];
      if (this->Options.UseLevels && this->Groups.MasterOf(particle) == master)
      {
        this->TakeSlave(particle, master, place, part);
      }
      else
      {
        this->TakeMaster(particle, part);
      }
    }
    for (std::size_t n = firstSlave; n < part.Slaves.size(); ++n)
    {
      const Vector3& offset = this->Groups.OffsetOf(part.Slaves[n].Particle);
      const double highest = this->Places[master].z + std::max(0.0, offset.z);
      part.Slaves[n].Error =
        RoundedUp(part.Masters[place].Error + this->Table.SlaveError(glm::length(offset), highest));
    }
  }

  const std::vector<Vector3>& Places;
  const ParticleGroups& Groups;
  const TrainTable& Table;
  const ViewFrustum& Frustum;
  const ParticleLevelOptions& Options;
  double Limit;
};

void Append(std::vector<ShownParticle>& to, const std::vector<ShownParticle>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

void Count(const std::vector<ShownParticle>& level, ParticleSelection& selection)
{
  for (const ShownParticle& particle : level)
  {
    selection.Orbits += particle.Master < 0;
    selection.TrainSum += particle.Trains;
    selection.Shown += particle.Weight > 0.0f;
    if (particle.Master >= 0)
    {
      selection.MaximumSlaveError = std::max(selection.MaximumSlaveError, static_cast<double>(particle.Error));
    }
  }
}

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

ParticleSelection SelectParticles(const std::vector<Vector3>& places, const ParticleGroups& groups,
  const TrainTable& table, const ViewFrustum& frustum, const ParticleLevelOptions& options, std::size_t firstCell,
  std::size_t endCell, const ParallelFor& parallelFor)
{
  const Selector selector(places, groups, table, frustum, options);
  const std::size_t cells = endCell - firstCell;
  std::vector<Part> parts((cells + CellsAtOnce - 1) / CellsAtOnce);
  parallelFor(parts.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t part = first; part < last; ++part)
    {
      const std::size_t begin = firstCell + part * CellsAtOnce;
      for (std::size_t cell = begin; cell < std::min(begin + CellsAtOnce, endCell); ++cell)
      {
        if (selector.MayShow(groups.GetCells()[cell]))
        {
          ++parts[part].CellsShown;
          selector.Take(groups.GetCells()[cell], groups.GetGroupSize(), parts[part]);
        }
      }
    }
  });
  ParticleSelection selection;
  selection.CellsInAll = static_cast<long long>(cells);
  std::vector<int> firstMaster;
  for (const Part& part : parts)
  {
    selection.CellsShown += part.CellsShown;
    firstMaster.push_back(static_cast<int>(selection.Middle.size()));
    Append(selection.Near, part.Near);
    Append(selection.Middle, part.Masters);
    Append(selection.Far, part.Far);
  }
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    for (ShownParticle& slave : parts[part].Slaves)
    {
      slave.Master += firstMaster[part];
    }
    Append(selection.Middle, parts[part].Slaves);
  }
  Count(selection.Near, selection);
  Count(selection.Middle, selection);
  return selection;
}

}
