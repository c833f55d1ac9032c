// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportCurrentSeries_h
#define LittoralSupportCurrentSeries_h

// A current over time, as it is asked from a pipeline bit by bit. Private: never installed, never wrapped.

#include "Data/CurrentSnapshot.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkInformationVector;

namespace littoral
{

/// The grid of times on which points drift.
struct DriftClock
{
  double Start = 0.0; ///< [s]
  double Step = 0.1;  ///< [s]

  double TimeOf(long long step) const { return this->Start + static_cast<double>(step) * this->Step; }
};

/// A moment of a step of the drift: as a share of TimeStep, 0 to 1.
struct DriftMoment
{
  long long Step = 0;
  double Share = 0.0;
};

/// A current at a moment: one snapshot, or a mixture of two.
struct CurrentMixture
{
  const CurrentSnapshot* First = nullptr;
  const CurrentSnapshot* Second = nullptr;
  double Share = 0.0; ///< of the second

  Vector3 Velocity(const Vector3& place) const
  {
    Vector3 velocity = this->First->Velocity(place);
    if (this->Share > 0.0)
    {
      velocity += this->Share * (this->Second->Velocity(place) - velocity);
    }
    return velocity;
  }
  const CurrentSnapshot* Nearest() const { return this->Share < 0.5 ? this->First : this->Second; }
};

/**
 * A current that does not change has one snapshot. One with time steps has snapshots at these; one with a time range
 * only, at each half of the drift's steps. In between, currents are interpolated.
 */
class CurrentSeries
{
public:
  /// What the pipeline says of its times; none: the current does not change.
  std::vector<double> Steps;
  bool IsContinuous = false; ///< Range counts, and no Steps
  double Range[2] = { 0.0, 0.0 };

  bool IsConstant() const { return !this->IsContinuous && this->Steps.empty(); }
  bool SameTimes(const CurrentSeries& other) const
  {
    return this->Steps == other.Steps && this->IsContinuous == other.IsContinuous && this->Range[0] == other.Range[0] &&
      this->Range[1] == other.Range[1];
  }

  /// The first time that has to be asked for before the current is known at a moment; false if it is known.
  bool FindMissing(const DriftClock& clock, const DriftMoment& moment, double& time) const;

  /// Keeps a snapshot of a time; those farthest from it give way. Constant currents take any time.
  void Keep(double time, std::shared_ptr<const CurrentSnapshot> snapshot);

  /// The current at a moment for which nothing is missing.
  CurrentMixture At(const DriftClock& clock, const DriftMoment& moment) const;

  /// Whether a constant current is the same everywhere.
  bool IsUniform() const
  {
    return this->IsConstant() && !this->Kept.empty() && this->Kept.begin()->second->IsUniform();
  }

  /// The time asked for last; of no meaning before.
  double Asked = 0.0;

private:
  struct Bracket
  {
    double First;
    double Second;
    double Share;
  };
  Bracket BracketOf(const DriftClock& clock, const DriftMoment& moment) const;

  std::map<double, std::shared_ptr<const CurrentSnapshot>> Kept;
};

/// The currents of a port, by what they announce of their times; asks each for all of its data.
std::vector<CurrentSeries> AnnouncedCurrents(vtkInformationVector* inputs);

/// Adds the times of currents to what a state depends on.
void AddTimes(const std::vector<CurrentSeries>& currents, std::vector<double>& key);

/// Asks each current that changes for the time that it is to be Asked for.
void AskForTimes(const std::vector<CurrentSeries>& currents, vtkInformationVector* inputs);

}

#endif
