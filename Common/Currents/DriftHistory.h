// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDriftHistory_h
#define LittoralDriftHistory_h

#include "Currents/CurrentSet.h"
#include "Numerics/TimeMarching.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace littoral
{

/// Fate of a point in a current.
enum class DriftFate : unsigned char
{
  Free = 0,
  Captured = 1, ///< held by the core of a sink
  Still = 2,    ///< out of the water, or moved by another point: not carried
};

/// Positions [m] and fates of all points.
struct Drifters
{
  std::vector<Vector3> Positions;
  std::vector<DriftFate> Fates;

  std::size_t Size() const { return this->Positions.size(); }
};

/**
 * Points that drift with currents, from a start to any time: eq. 3 of Coulais et al. by the Runge-Kutta method of
 * fourth order (DriftStep), in steps of a TimeGrid and a shorter last one. Where the sum of the currents is the same
 * everywhere and at all times, positions are a closed form of the time instead.
 *
 * To a goal: while IsAtGoal() is false, the currents at NextMoments() are supplied, all points are carried up to
 * NextStop(), and Reach() is called. Then the currents at NextMoments() are those for At().
 */
class DriftHistory
{
public:
  /// Largest number of states kept. Fixed, so that all ranks ask for currents in the same order.
  static constexpr std::size_t MaximumCheckpoints = 8;

  DriftHistory()
    : DriftHistory(TimeGrid(), {})
  {
  }
  DriftHistory(const TimeGrid& grid, std::vector<CurrentSeries> currents);

  CurrentSet Currents; ///< with the walls for points

  const TimeGrid& GetGrid() const { return this->Marching.GetGrid(); }
  const StepGoal& GetGoal() const { return this->Marching.GetGoal(); }
  long long GetStep() const { return this->Marching.GetStep(); }

  /// The points at the start.
  void Begin(Drifters start) { this->Marching.Begin(std::move(start)); }
  bool IsBegun() const { return this->Marching.IsBegun(); }

  /// Sets the time to drift to [s]; before the start points are where they start.
  void SetGoal(double time) { this->Marching.SetGoal(time); }

  /// Whether no step is left but the last, shorter one.
  bool IsAtGoal() const { return this->IsClosed() || this->Marching.IsAtGoal(); }

  /// Whether positions are a closed form of the time.
  bool IsClosed() const { return this->Currents.AreUniform(); }

  /// Beginning, middle and end of the next step.
  std::vector<StepMoment> NextMoments() const;

  /// Whether the currents of the next step are known.
  bool IsNextKnown() const { return this->Currents.AreKnown(this->GetGrid(), this->NextMoments()); }

  /// The currents of the next step.
  StepCurrents NextCurrents() const { return this->Currents.At(this->GetGrid(), this->NextMoments()); }

  /// Up to which step the next currents hold and no checkpoint is due.
  long long NextStop() const
  {
    return this->Currents.AreSteady() ? this->Marching.NextStop() : this->Marching.GetStep() + 1;
  }

  /// Carries the points [begin, end) up to a step. Safe to call from many threads.
  void Carry(const StepCurrents& currents, long long step, std::size_t begin, std::size_t end);

  /// All points have been carried up to a step.
  void Reach(long long step) { this->Marching.Reach(step); }

  /// Number of points.
  std::size_t Size() const { return this->Marching.State().Size(); }

  /// A point at the time of the goal.
  void At(const StepCurrents& currents, std::size_t id, Vector3& position, DriftFate& fate) const;

  /// The points at the start.
  const Drifters& GetStart() const { return this->Marching.GetStart(); }

  /// The way that free points have gone at the time of the goal, where that is a closed form [m].
  Vector3 ClosedWay(const StepCurrents& currents) const;

private:
  void CarryOne(const StepCurrents& currents, double length, Vector3& position, DriftFate& fate) const;

  TimeMarching<Drifters> Marching;
};

}

#endif
