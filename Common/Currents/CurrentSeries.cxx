// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/CurrentSeries.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace littoral
{

/// The half step that a moment is in. Halves are counted in whole numbers, so that their times do not depend on
/// rounding; nor does a moment at a half step ask for the next one.
CurrentSeries::Bracket CurrentSeries::HalfSteps(const TimeGrid& grid, const StepMoment& moment) const
{
  const double halves = grid.WholeWithin(2.0 * moment.Share, static_cast<double>(moment.Step));
  const double half = std::floor(halves);
  const auto timeOf = [&](double count) {
    const double time = grid.Start + 0.5 * grid.Step * (2.0 * static_cast<double>(moment.Step) + count);
    return std::clamp(time, this->Range[0], this->Range[1]);
  };
  return { timeOf(half), timeOf(half + 1.0), halves - half };
}

/// Times of two snapshots around a moment, and the share of the second.
CurrentSeries::Bracket CurrentSeries::BracketOf(const TimeGrid& grid, const StepMoment& moment) const
{
  if (this->IsSteady())
  {
    return { 0.0, 0.0, 0.0 };
  }
  if (this->IsContinuous)
  {
    return this->HalfSteps(grid, moment);
  }
  const double time = grid.TimeOf(moment.Step) + moment.Share * grid.Step;
  const auto after = std::upper_bound(this->Steps.begin(), this->Steps.end(), time);
  if (after == this->Steps.begin() || after == this->Steps.end())
  {
    const double end = after == this->Steps.begin() ? this->Steps.front() : this->Steps.back();
    return { end, end, 0.0 };
  }
  const double before = *(after - 1);
  return { before, *after, (time - before) / (*after - before) };
}

std::optional<double> CurrentSeries::MissingTime(const TimeGrid& grid, const StepMoment& moment) const
{
  const Bracket bracket = this->BracketOf(grid, moment);
  if (this->Snapshots.count(bracket.First) == 0)
  {
    return bracket.First;
  }
  if (bracket.Share > 0.0 && this->Snapshots.count(bracket.Second) == 0)
  {
    return bracket.Second;
  }
  return std::nullopt;
}

std::optional<double> CurrentSeries::MissingTime(const TimeGrid& grid, const std::vector<StepMoment>& moments) const
{
  for (const StepMoment& moment : moments)
  {
    if (const std::optional<double> time = this->MissingTime(grid, moment))
    {
      return time;
    }
  }
  return std::nullopt;
}

void CurrentSeries::Keep(double time, std::shared_ptr<const CurrentSnapshot> snapshot)
{
  this->Snapshots[this->IsSteady() ? 0.0 : time] = std::move(snapshot);
  while (this->Snapshots.size() > MaximumSnapshots)
  {
    const bool firstIsFarther = time - this->Snapshots.begin()->first > this->Snapshots.rbegin()->first - time;
    this->Snapshots.erase(firstIsFarther ? this->Snapshots.begin() : std::prev(this->Snapshots.end()));
  }
}

CurrentMixture CurrentSeries::At(const TimeGrid& grid, const StepMoment& moment) const
{
  const Bracket bracket = this->BracketOf(grid, moment);
  const CurrentSnapshot* first = this->Snapshots.at(bracket.First).get();
  return bracket.Share > 0.0 ? CurrentMixture{ first, this->Snapshots.at(bracket.Second).get(), bracket.Share }
                             : CurrentMixture{ first, first, 0.0 };
}

}
