// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/CurrentSet.h"

#include <algorithm>

namespace littoral
{

namespace
{

/// The change of a velocity that is known at both ends. A grid is at rest where it ends.
Vector3 ChangeOf(const Vector3& before, const Vector3& after)
{
  const Vector3 rest(0.0);
  return before == rest || after == rest ? rest : after - before;
}

}

Vector3 StepCurrents::Velocity(const Vector3& position, std::size_t moment) const
{
  Vector3 sum = this->Steady.Velocity(position);
  for (const CurrentSnapshot* current : this->SteadyGrids)
  {
    sum += current->GridVelocity(position);
  }
  for (const CurrentMixture& current : this->Changing[moment])
  {
    sum += current.Velocity(position);
  }
  return sum;
}

Vector3 StepCurrents::Acceleration(const Vector3& position, const Vector3& velocity) const
{
  const bool isEven = this->Steady.IsUniform() && this->SteadyGrids.empty() && this->Changing[0].empty();
  const double time = this->Times[2] - this->Times[1];
  if (isEven || !(time > 0.0))
  {
    return Vector3(0.0);
  }
  const Vector3 from = position + this->Times[1] * velocity;
  const Vector3 to = position + this->Times[2] * velocity;
  Vector3 change = this->Steady.Velocity(to) - this->Steady.Velocity(from);
  for (const CurrentSnapshot* current : this->SteadyGrids)
  {
    change += ChangeOf(current->GridVelocity(from), current->GridVelocity(to));
  }
  for (std::size_t i = 0; i < this->Changing[0].size(); ++i)
  {
    change += ChangeOf(this->Changing[1][i].Velocity(from), this->Changing[2][i].Velocity(to));
  }
  return change / time;
}

bool StepCurrents::Capture(const Vector3& from, Vector3& to) const
{
  if (this->Steady.HasSinks() && this->Steady.Capture(from, to))
  {
    return true;
  }
  return std::any_of(this->Changing.back().begin(), this->Changing.back().end(), [&](const CurrentMixture& current) {
    const FlowField& flow = current.Nearest()->GetFlow();
    return flow.HasSinks() && flow.Capture(from, to);
  });
}

bool CurrentSet::AreSteady() const
{
  return std::all_of(
    this->Series.begin(), this->Series.end(), [](const CurrentSeries& current) { return current.IsSteady(); });
}

bool CurrentSet::AreUniform() const
{
  return std::all_of(
    this->Series.begin(), this->Series.end(), [](const CurrentSeries& current) { return current.IsUniform(); });
}

bool CurrentSet::AreKnown(const TimeGrid& grid, const std::vector<StepMoment>& moments) const
{
  return std::none_of(this->Series.begin(), this->Series.end(),
    [&](const CurrentSeries& current) { return current.MissingTime(grid, moments).has_value(); });
}

StepCurrents CurrentSet::At(const TimeGrid& grid, const std::vector<StepMoment>& moments) const
{
  StepCurrents sum;
  sum.Changing.resize(moments.size());
  for (const StepMoment& moment : moments)
  {
    const double steps =
      static_cast<double>(moment.Step - moments.front().Step) + (moment.Share - moments.front().Share);
    sum.Times.push_back(grid.Step * steps);
  }
  std::vector<FlowPrimitive> steady;
  for (const CurrentSeries& current : this->Series)
  {
    if (!current.IsSteady())
    {
      for (std::size_t moment = 0; moment < moments.size(); ++moment)
      {
        sum.Changing[moment].push_back(current.At(grid, moments[moment]));
      }
      continue;
    }
    const CurrentSnapshot* snapshot = current.At(grid, moments.front()).First;
    steady.insert(steady.end(), snapshot->GetPrimitives().begin(), snapshot->GetPrimitives().end());
    if (snapshot->HasGrids())
    {
      sum.SteadyGrids.push_back(snapshot);
    }
  }
  sum.Steady = FlowField(steady, this->Layer);
  return sum;
}

}
