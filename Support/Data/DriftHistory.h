// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportDriftHistory_h
#define LittoralSupportDriftHistory_h

// Points that drift, from a start to any time. Private: never installed, never wrapped.

#include "Currents/CurrentDrift.h"
#include "Data/CurrentSeries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

namespace littoral
{

/// States kept to begin from. Fixed, so that all ranks ask for currents in the same order.
inline constexpr std::size_t MostDriftCheckpoints = 8;
/// More steps than this are hardly meant.
inline constexpr double MostDriftSteps = 1e7;
/// Times this near to a whole number of steps are on the grid, as those that players count up are.
inline constexpr double WholeDriftStep = 1e-12;

/// What a point does.
enum DriftFate : unsigned char
{
  Free = 0,
  Captured = 1,
  Still = 2, ///< out of the water, or a slave: not carried by itself
};

/// Where all points are, and what they do.
struct Drifters
{
  std::vector<Vector3> Places;
  std::vector<unsigned char> Fates;

  std::size_t Size() const { return this->Places.size(); }
};

/// All currents during a step of the Runge-Kutta method.
struct StepCurrents
{
  FlowField Steady;                                ///< the primitives that do not change, in one sum
  std::vector<const CurrentSnapshot*> SteadyGrids; ///< the rest of what does not change
  std::vector<CurrentMixture> Changing[3];         ///< at the beginning, the middle and the end

  Vector3 Velocity(const Vector3& place, int stage) const
  {
    Vector3 sum = this->Steady.Velocity(place);
    for (const CurrentSnapshot* current : this->SteadyGrids)
    {
      sum += current->GridVelocity(place);
    }
    for (const CurrentMixture& current : this->Changing[stage])
    {
      sum += current.Velocity(place);
    }
    return sum;
  }

  /// Whether a sink, as it is at the end of the step, captures on the way.
  bool Capture(const Vector3& from, Vector3& to) const
  {
    if (this->Steady.HasSinks() && this->Steady.Capture(from, to))
    {
      return true;
    }
    for (const CurrentMixture& current : this->Changing[2])
    {
      const FlowField& flow = current.Nearest()->GetFlow();
      if (flow.HasSinks() && flow.Capture(from, to))
      {
        return true;
      }
    }
    return false;
  }
};

/// States of points in currents, with what is needed to go on from them to a goal.
class DriftHistory
{
public:
  DriftClock Clock;
  WaterLayer Layer;
  std::vector<CurrentSeries> Currents;

  // What is asked for: a whole number of steps and a part of one [s].
  bool HasGoal = false;
  double Time = 0.0;
  long long Step = 0;
  double Rest = 0.0;

  // What is known.
  bool HasStart = false;
  Drifters Start;
  std::map<long long, Drifters> Checkpoints; ///< by step
  long long Stride = 1;                      ///< steps between checkpoints
  Drifters Now;
  long long NowStep = 0;
  bool IsClosed = false; ///< all currents are the same everywhere: no steps
  bool IsLooping = false;
  int Restarts = 0;
  std::vector<double> Key; ///< what all of this depends on

  void Forget()
  {
    this->HasStart = false;
    this->HasGoal = false;
    this->IsClosed = false;
    this->IsLooping = false;
    this->Start = {};
    this->Now = {};
    this->Checkpoints.clear();
    this->Stride = 1;
    this->NowStep = 0;
    this->Currents.clear();
  }

  /// Begins from the latest known state that is not after the goal.
  void SetGoal(double time)
  {
    if (this->HasGoal && this->Time == time)
    {
      return;
    }
    this->HasGoal = true;
    this->Time = time;
    const double passed = std::max(0.0, time - this->Clock.Start);
    const double steps = std::min(passed / this->Clock.Step, 2.0 * MostDriftSteps);
    const double whole = std::round(steps);
    const bool isWhole = std::abs(steps - whole) < WholeDriftStep * std::max(1.0, whole);
    this->Step = static_cast<long long>(isWhole ? whole : std::floor(steps));
    this->Rest = isWhole ? 0.0 : std::max(0.0, time - this->Clock.TimeOf(this->Step));
    if (this->HasStart)
    {
      this->Resume();
    }
  }

  void Resume()
  {
    auto after = this->Checkpoints.upper_bound(this->Step);
    const bool hasOne = after != this->Checkpoints.begin();
    const long long kept = hasOne ? std::prev(after)->first : 0;
    if (this->NowStep <= this->Step && this->NowStep >= kept && this->Now.Size() == this->Start.Size())
    {
      return;
    }
    this->NowStep = kept;
    this->Now = hasOne ? std::prev(after)->second : this->Start;
  }

  void KeepCheckpoint()
  {
    if (this->NowStep % this->Stride != 0)
    {
      return;
    }
    this->Checkpoints[this->NowStep] = this->Now;
    while (this->Checkpoints.size() > MostDriftCheckpoints)
    {
      this->Stride *= 2;
      for (auto it = this->Checkpoints.begin(); it != this->Checkpoints.end();)
      {
        it = it->first % this->Stride == 0 ? std::next(it) : this->Checkpoints.erase(it);
      }
    }
  }

  bool IsConstant() const
  {
    return std::all_of(
      this->Currents.begin(), this->Currents.end(), [](const CurrentSeries& current) { return current.IsConstant(); });
  }

  /// The moments that a step of this length [s] from a step of the clock needs.
  std::array<DriftMoment, 3> MomentsOf(long long step, double length) const
  {
    const double share = length == this->Clock.Step ? 1.0 : length / this->Clock.Step;
    return { { { step, 0.0 }, { step, 0.5 * share }, { step, share } } };
  }

  bool FindMissing(const CurrentSeries& current, double& time) const
  {
    if (this->IsClosed)
    {
      return false;
    }
    const double length = this->NowStep < this->Step ? this->Clock.Step : this->Rest;
    for (const DriftMoment& moment : this->MomentsOf(this->NowStep, length))
    {
      if (current.FindMissing(this->Clock, moment, time))
      {
        return true;
      }
    }
    return false;
  }

  bool AnyMissing() const
  {
    double time = 0.0;
    return std::any_of(this->Currents.begin(), this->Currents.end(),
      [&](const CurrentSeries& current) { return this->FindMissing(current, time); });
  }

  StepCurrents CurrentsOf(long long step, double length) const
  {
    StepCurrents currents;
    const auto moments = this->MomentsOf(step, length);
    std::vector<FlowPrimitive> steady;
    for (const CurrentSeries& current : this->Currents)
    {
      for (int stage = 0; !current.IsConstant() && stage < 3; ++stage)
      {
        currents.Changing[stage].push_back(current.At(this->Clock, moments[stage]));
      }
      if (current.IsConstant())
      {
        const CurrentSnapshot* snapshot = current.At(this->Clock, moments[0]).First;
        steady.insert(steady.end(), snapshot->GetPrimitives().begin(), snapshot->GetPrimitives().end());
        if (snapshot->HasGrids())
        {
          currents.SteadyGrids.push_back(snapshot);
        }
      }
    }
    currents.Steady = FlowField(steady, this->Layer);
    return currents;
  }

  /// Carries a point by one step.
  void Carry(const StepCurrents& currents, double length, Vector3& place, unsigned char& fate) const
  {
    if (fate != Free)
    {
      return;
    }
    const Vector3 from = place;
    Vector3 ahead;
    place = DriftStep(
      this->Layer, from, length, [&](const Vector3& at, int stage) { return currents.Velocity(at, stage); }, &ahead);
    if (!IsFinite(place)) // beyond all numbers
    {
      place = from;
      fate = Still;
    }
    else if (currents.Capture(from, ahead))
    {
      place = ahead;
      fate = Captured;
    }
    else if (currents.Capture(from, place))
    {
      fate = Captured;
    }
  }

  /// The state at the goal, of one point; `currents` are those of the rest of a step.
  void Finish(const StepCurrents& currents, std::size_t id, Vector3& place, unsigned char& fate) const
  {
    place = this->Now.Places[id];
    fate = this->Now.Fates[id];
    if (this->IsClosed)
    {
      if (fate == Free)
      {
        place += std::max(0.0, this->Time - this->Clock.Start) * currents.Velocity(place, 0);
      }
    }
    else if (this->Rest > 0.0)
    {
      this->Carry(currents, this->Rest, place, fate);
    }
  }
};

}

#endif
