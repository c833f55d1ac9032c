// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCurrentSet_h
#define LittoralCurrentSet_h

#include "Currents/CurrentSeries.h"
#include "Currents/FlowPrimitives.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// The sum of all currents at the moments of a step at which an integrator evaluates it.
struct StepCurrents
{
  FlowField Steady;                                  ///< all primitives that do not change, in one sum
  std::vector<const CurrentSnapshot*> SteadyGrids;   ///< currents that do not change and have grids
  std::vector<std::vector<CurrentMixture>> Changing; ///< by moment
  std::vector<double> Times;                         ///< of the moments, since the first of them [s]

  /// Velocity at a position [m/s], at one of the moments.
  Vector3 Velocity(const Vector3& position, std::size_t moment) const;

  /// Du/Dt = du/dt + (v.grad) u of the currents u [m/s2] for water that passes a position at the first of three moments
  /// with a velocity v [m/s]: the change of u along its way from the second moment to the third. Where a grid ends on
  /// that way, it counts as steady and even.
  Vector3 Acceleration(const Vector3& position, const Vector3& velocity) const;

  /// Whether the way from one position to another touches the core of a sink as it is at the last moment; see
  /// FlowField::Capture.
  bool Capture(const Vector3& from, Vector3& to) const;
};

/// Currents that add up, each known at times of its own.
class CurrentSet
{
public:
  std::vector<CurrentSeries> Series;
  WaterLayer Layer; ///< walls for the primitives that do not change

  bool AreSteady() const;

  /// Whether their sum is known to be the same everywhere and at all times.
  bool AreUniform() const;

  /// Whether no snapshot is missing for some moments.
  bool AreKnown(const TimeGrid& grid, const std::vector<StepMoment>& moments) const;

  /// Sum of the series at moments for which no snapshot is missing. It refers to the snapshots of this set.
  StepCurrents At(const TimeGrid& grid, const std::vector<StepMoment>& moments) const;
};

}

#endif
