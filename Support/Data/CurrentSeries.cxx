// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/CurrentSeries.h"

#include "Pipeline/Pipeline.h"

#include "vtkInformationVector.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{
/// Snapshots kept of one current; a step needs six at most.
constexpr std::size_t MostKept = 12;
}

CurrentSeries::Bracket CurrentSeries::BracketOf(const DriftClock& clock, const DriftMoment& moment) const
{
  if (this->IsConstant())
  {
    return { 0.0, 0.0, 0.0 };
  }
  if (this->IsContinuous)
  {
    // Halves are counted in whole numbers, so that the times asked for do not depend on rounding.
    const double half = std::floor(2.0 * moment.Share);
    const auto timeOf = [&](double halves) {
      const double time = clock.Start + 0.5 * clock.Step * (2.0 * static_cast<double>(moment.Step) + halves);
      return std::clamp(time, this->Range[0], this->Range[1]);
    };
    return { timeOf(half), timeOf(half + 1.0), 2.0 * moment.Share - half };
  }
  const double time = clock.TimeOf(moment.Step) + moment.Share * clock.Step;
  const auto after = std::upper_bound(this->Steps.begin(), this->Steps.end(), time);
  if (after == this->Steps.begin() || after == this->Steps.end())
  {
    const double end = after == this->Steps.begin() ? this->Steps.front() : this->Steps.back();
    return { end, end, 0.0 };
  }
  const double before = *(after - 1);
  return { before, *after, (time - before) / (*after - before) };
}

bool CurrentSeries::FindMissing(const DriftClock& clock, const DriftMoment& moment, double& time) const
{
  const Bracket bracket = this->BracketOf(clock, moment);
  if (this->Kept.count(bracket.First) == 0)
  {
    time = bracket.First;
    return true;
  }
  if (bracket.Share > 0.0 && this->Kept.count(bracket.Second) == 0)
  {
    time = bracket.Second;
    return true;
  }
  return false;
}

void CurrentSeries::Keep(double time, std::shared_ptr<const CurrentSnapshot> snapshot)
{
  this->Kept[this->IsConstant() ? 0.0 : time] = std::move(snapshot);
  while (this->Kept.size() > MostKept)
  {
    const bool firstIsFarther = time - this->Kept.begin()->first > this->Kept.rbegin()->first - time;
    this->Kept.erase(firstIsFarther ? this->Kept.begin() : std::prev(this->Kept.end()));
  }
}

CurrentMixture CurrentSeries::At(const DriftClock& clock, const DriftMoment& moment) const
{
  const Bracket bracket = this->BracketOf(clock, moment);
  const CurrentSnapshot* first = this->Kept.at(bracket.First).get();
  return bracket.Share > 0.0 ? CurrentMixture{ first, this->Kept.at(bracket.Second).get(), bracket.Share }
                             : CurrentMixture{ first, first, 0.0 };
}

//----------------------------------------------------------------------------
std::vector<CurrentSeries> AnnouncedCurrents(vtkInformationVector* inputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  std::vector<CurrentSeries> currents;
  for (int connection = 0; connection < inputs->GetNumberOfInformationObjects(); ++connection)
  {
    vtkInformation* info = inputs->GetInformationObject(connection);
    RequestAll(info);
    CurrentSeries current;
    if (info->Has(Pipeline::TIME_STEPS()))
    {
      const double* steps = info->Get(Pipeline::TIME_STEPS());
      current.Steps.assign(steps, steps + info->Length(Pipeline::TIME_STEPS()));
    }
    else if (info->Has(Pipeline::TIME_RANGE()))
    {
      info->Get(Pipeline::TIME_RANGE(), current.Range);
      current.IsContinuous = current.Range[0] < current.Range[1];
    }
    currents.push_back(current);
  }
  return currents;
}

void AddTimes(const std::vector<CurrentSeries>& currents, std::vector<double>& key)
{
  for (const CurrentSeries& current : currents)
  {
    key.insert(key.end(), current.Steps.begin(), current.Steps.end());
    key.insert(key.end(), current.Range, current.Range + 2);
  }
}

void AskForTimes(const std::vector<CurrentSeries>& currents, vtkInformationVector* inputs)
{
  for (std::size_t connection = 0; connection < currents.size(); ++connection)
  {
    if (!currents[connection].IsConstant())
    {
      inputs->GetInformationObject(static_cast<int>(connection))
        ->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), currents[connection].Asked);
    }
  }
}

}
