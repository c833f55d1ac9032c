// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/TimeGrid.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

StepGoal TimeGrid::GoalAt(double time) const
{
  const double elapsed = std::max(0.0, time - this->Start);
  const double steps = std::min(elapsed / this->Step, 2.0 * MaximumSteps);
  const double nearest = std::round(steps);
  if (std::abs(steps - nearest) < Tolerance * std::max(1.0, nearest))
  {
    return { time, static_cast<long long>(nearest), 0.0 };
  }
  const auto whole = static_cast<long long>(std::floor(steps));
  return { time, whole, std::max(0.0, time - this->TimeOf(whole)) };
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
