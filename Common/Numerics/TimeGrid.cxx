// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/TimeGrid.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

double TimeGrid::WholeWithin(double count, double steps)
{
  const double nearest = std::round(count);
  return std::abs(count - nearest) < Tolerance * std::max(1.0, steps) ? nearest : count;
}

StepGoal TimeGrid::GoalAt(double time) const
{
  const double elapsed = std::max(0.0, time - this->Start);
  const double steps = std::min(elapsed / this->Step, 2.0 * MaximumSteps);
  const double counted = WholeWithin(steps, std::round(steps));
  const auto whole = static_cast<long long>(std::floor(counted));
  const bool isOnGrid = counted == static_cast<double>(whole);
  return { time, whole, isOnGrid ? 0.0 : std::max(0.0, time - this->TimeOf(whole)) };
}

std::string WhyTooFar(const TimeGrid& grid, double time)
{
  if ((time - grid.Start) / grid.Step > TimeGrid::MaximumSteps)
  {
    return "time " + std::to_string(time) + " is more than 10 million times TimeStep after StartTime.";
  }
  return {};
}

}
