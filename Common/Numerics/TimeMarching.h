// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTimeMarching_h
#define LittoralTimeMarching_h

#include "Numerics/Checkpoints.h"
#include "Numerics/TimeGrid.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace littoral
{

/**
 * A state that is integrated step by step on a grid of times, from its start to any goal. A goal before the state is
 * reached from the latest checkpoint that is not after it. If each step is a function of the state and the number of
 * the step, the state at a goal is a function of the goal alone, to the bit, whatever goals came before.
 *
 * The caller takes the steps:
 *
 *     marching.SetGoal(time);
 *     while (!marching.IsAtGoal())
 *     {
 *       Integrate(marching.State(), marching.GetGrid().Step);
 *       marching.Reach(marching.GetStep() + 1);
 *     }
 *
 * and the remainder of a step, on a copy of the state.
 */
template <typename T>
class TimeMarching
{
public:
  TimeMarching(const TimeGrid& grid, std::size_t maximumCheckpoints)
    : Grid(grid)
    , Kept(maximumCheckpoints)
  {
  }

  const TimeGrid& GetGrid() const { return this->Grid; }

  /// The state at step 0; what is known of later ones is forgotten, the goal is not.
  void Begin(T start)
  {
    this->Start = std::move(start);
    this->Kept.Clear();
    this->HasBegun = true;
    this->Rewind();
  }

  bool IsBegun() const { return this->HasBegun; }

  const T& GetStart() const { return this->Start; }

  /// The state at GetStep(); whoever modifies it says by Reach() which step it is at.
  T& State() { return this->Now; }
  const T& State() const { return this->Now; }
  long long GetStep() const { return this->Step; }

  const StepGoal& GetGoal() const { return this->Goal; }

  /// Sets the time to march to, and the state to the latest one known that is not after it. True where that is
  /// another state than before.
  bool SetGoal(double time)
  {
    this->Goal = this->Grid.GoalAt(time);
    return this->HasBegun && this->Resume();
  }

  bool IsAtGoal() const { return this->Step >= this->Goal.Step; }

  /// Length of the next step [s]: a whole one before the goal's step, there the remainder.
  double NextLength() const { return this->IsAtGoal() ? this->Goal.Remainder : this->Grid.Step; }

  /// The next step at which a checkpoint is due, or that of the goal if it comes first.
  long long NextStop() const
  {
    const long long stride = this->Kept.GetStride();
    return std::min(this->Goal.Step, (this->Step / stride + 1) * stride);
  }

  /// The state has been integrated up to a step, no further than NextStop().
  void Reach(long long step)
  {
    this->Step = step;
    this->Kept.Keep(step, this->Now);
  }

private:
  void Rewind()
  {
    this->Now = this->Start;
    this->Step = 0;
  }

  bool Resume()
  {
    const auto* kept = this->Kept.Latest(this->Goal.Step);
    if (this->Step <= this->Goal.Step && this->Step >= (kept ? kept->first : 0))
    {
      return false;
    }
    if (!kept)
    {
      this->Rewind();
      return true;
    }
    this->Step = kept->first;
    this->Now = kept->second;
    return true;
  }

  TimeGrid Grid;
  StepGoal Goal;
  bool HasBegun = false;
  T Start{};
  T Now{};
  long long Step = 0;
  Checkpoints<T> Kept;
};

}

#endif
