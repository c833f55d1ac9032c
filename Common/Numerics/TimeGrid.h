// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTimeGrid_h
#define LittoralTimeGrid_h

#include <string>

namespace littoral
{

/// A time within a step of a TimeGrid.
struct StepMoment
{
  long long Step = 0;
  double Share = 0.0; ///< time since the beginning of the step over its length, 0 to 1
};

/// A time as a number of whole steps and a remainder.
struct StepGoal
{
  double Time = 0.0;      ///< [s]
  long long Step = 0;     ///< the last step of the grid that is not after Time, 0 before the start
  double Remainder = 0.0; ///< from that step to Time [s]
};

/// Equidistant times at which a state is computed.
struct TimeGrid
{
  /// Largest number of steps: more are taken for a mistake.
  static constexpr double MaximumSteps = 1e7;
  /// Relative distance from a whole number of steps within which a time is on the grid, as the times are that players
  /// sum up.
  static constexpr double Tolerance = 1e-12;

  double Start = 0.0; ///< [s]
  double Step = 0.1;  ///< length of a step [s], positive

  double TimeOf(long long step) const { return this->Start + static_cast<double>(step) * this->Step; }

  /// Length [s] in units of a step; exactly 1 for a whole step.
  double ShareOf(double length) const { return length == this->Step ? 1.0 : length / this->Step; }

  /// A count, or the whole number that rounding alone keeps it from, after a number of steps since Start.
  static double WholeWithin(double count, double steps);

  /// The steps to a finite time, at most twice MaximumSteps.
  StepGoal GoalAt(double time) const;
};

/// Why there are too many steps to a time, in words for a user; empty if there are not.
std::string WhyTooFar(const TimeGrid& grid, double time);

}

#endif
