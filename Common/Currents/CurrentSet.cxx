// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/CurrentSet.h"

#include <algorithm>

namespace littoral
{

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
