// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/DriftHistory.h"

#include "Currents/CurrentDrift.h"

#include <algorithm>
#include <utility>

namespace littoral
{

DriftHistory::DriftHistory(const TimeGrid& grid, std::vector<CurrentSeries> currents)
  : Marching(grid, MaximumCheckpoints)
{
  this->Currents.Series = std::move(currents);
}

std::vector<StepMoment> DriftHistory::NextMoments() const
{
  const double share = this->GetGrid().ShareOf(this->Marching.NextLength());
  const long long step = this->GetStep();
  return { { step, 0.0 }, { step, 0.5 * share }, { step, share } };
}

void DriftHistory::Carry(const StepCurrents& currents, long long step, std::size_t begin, std::size_t end)
{
  Drifters& points = this->Marching.State();
  for (std::size_t id = begin; id < end; ++id)
  {
    for (long long now = this->GetStep(); now < step; ++now)
    {
      this->CarryOne(currents, this->GetGrid().Step, points.Positions[id], points.Fates[id]);
    }
  }
}

/// Carries a point by one step of a length [s].
void DriftHistory::CarryOne(const StepCurrents& currents, double length, Vector3& position, DriftFate& fate) const
{
  if (fate != DriftFate::Free)
  {
    return;
  }
  const Vector3 from = position;
  Vector3 ahead;
  position = DriftStep(
    this->Currents.Layer, from, length, [&](const Vector3& at, int stage) { return currents.Velocity(at, stage); },
    &ahead);
  if (!IsFinite(position)) // beyond all numbers
  {
    position = from;
    fate = DriftFate::Still;
  }
  else if (currents.Capture(from, ahead))
  {
    position = ahead;
    fate = DriftFate::Captured;
  }
  else if (currents.Capture(from, position))
  {
    fate = DriftFate::Captured;
  }
}

Vector3 DriftHistory::ClosedWay(const StepCurrents& currents) const
{
  return std::max(0.0, this->GetGoal().Time - this->GetGrid().Start) * currents.Velocity(Vector3(0.0), 0);
}

void DriftHistory::At(const StepCurrents& currents, std::size_t id, Vector3& position, DriftFate& fate) const
{
  const StepGoal& goal = this->GetGoal();
  const bool isClosed = this->IsClosed();
  const Drifters& points = isClosed ? this->Marching.GetStart() : this->Marching.State();
  position = points.Positions[id];
  fate = points.Fates[id];
  if (isClosed && fate == DriftFate::Free)
  {
    position += this->ClosedWay(currents);
  }
  else if (!isClosed && goal.Remainder > 0.0)
  {
    this->CarryOne(currents, goal.Remainder, position, fate);
  }
}

}
