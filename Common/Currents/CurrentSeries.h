// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCurrentSeries_h
#define LittoralCurrentSeries_h

#include "Currents/CurrentSnapshot.h"
#include "Numerics/TimeGrid.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace littoral
{

/// A current at a moment, interpolated linearly between two snapshots.
struct CurrentMixture
{
  const CurrentSnapshot* First = nullptr;
  const CurrentSnapshot* Second = nullptr;
  double Share = 0.0; ///< weight of the second, 0 to 1

  Vector3 Velocity(const Vector3& position) const
  {
    Vector3 velocity = this->First->Velocity(position);
    if (this->Share > 0.0)
    {
      velocity += this->Share * (this->Second->Velocity(position) - velocity);
    }
    return velocity;
  }
  const CurrentSnapshot* Nearest() const { return this->Share < 0.5 ? this->First : this->Second; }
};

/**
 * A current over time, by snapshots that are supplied when they are needed. A steady current has one snapshot. One with
 * time steps has snapshots at these; one with a time range only, at each half step of a TimeGrid. In between it is
 * interpolated linearly; before the first and after the last time it is that of the end.
 */
class CurrentSeries
{
public:
  /// Largest number of snapshots kept; a step of the Runge-Kutta method needs six at most.
  static constexpr std::size_t MaximumSnapshots = 12;

  std::vector<double> Steps;      ///< times of the snapshots, rising [s]; none: steady, or continuous
  bool IsContinuous = false;      ///< whether there is a snapshot of any time in Range
  double Range[2] = { 0.0, 0.0 }; ///< of a continuous current [s]
  double Asked = 0.0;             ///< time of the snapshot that was asked for last [s]

  bool IsSteady() const { return !this->IsContinuous && this->Steps.empty(); }

  /// Whether a steady current has one velocity everywhere.
  bool IsUniform() const
  {
    return this->IsSteady() && !this->Snapshots.empty() && this->Snapshots.begin()->second->IsUniform();
  }

  /// The first time [s] of which a snapshot is missing for a moment; none if the current is known.
  std::optional<double> MissingTime(const TimeGrid& grid, const StepMoment& moment) const;

  /// The same for several moments.
  std::optional<double> MissingTime(const TimeGrid& grid, const std::vector<StepMoment>& moments) const;

  /// Keeps the snapshot of a time [s], any time if the current is steady. Of too many, those farthest from it go.
  void Keep(double time, std::shared_ptr<const CurrentSnapshot> snapshot);

  std::size_t GetNumberOfSnapshots() const { return this->Snapshots.size(); }

  /// The current at a moment for which no snapshot is missing.
  CurrentMixture At(const TimeGrid& grid, const StepMoment& moment) const;

private:
  struct Bracket
  {
    double First;
    double Second;
    double Share;
  };
  Bracket BracketOf(const TimeGrid& grid, const StepMoment& moment) const;
  Bracket HalfSteps(const TimeGrid& grid, const StepMoment& moment) const;

  std::map<double, std::shared_ptr<const CurrentSnapshot>> Snapshots;
};

}

#endif
