// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportMarchingRequests_h
#define LittoralSupportMarchingRequests_h

// Filters whose output is a state that marches in time, from the requests of the pipeline. Private: never installed,
// never wrapped.

#include "Pipeline/Pipeline.h"

#include "vtkDataObject.h"

#include <vector>

namespace littoral
{

/// End of a march.
enum class MarchEnd
{
  Goal,
  Aborted,
  FailedInput ///< it has told why
};

/**
 * A state that a filter marches in time while the inputs at a port are asked for one time after the other. `History`
 * has IsAtGoal(), IsNextKnown(), GetStep() and GetGoal(), as DriftHistory does.
 */
template <typename History>
class MarchingRequests
{
public:
  History Scene;

  /// Whether the state has to begin anew, for what it depends on has changed.
  bool BeginsAnew(const std::vector<double>& key)
  {
    const bool isNew = key != this->Key;
    this->Key = key;
    return isNew;
  }

  /**
   * Takes steps up to the state at the goal. `advance(progress)` takes one step or more; it returns false when aborted,
   * and may report `progress(step)`, which is `share` at the end. Where the inputs are not known for it, `ask()` says
   * which times are needed of them, and `take()` takes these.
   */
  template <typename Advance, typename Ask, typename Take>
  MarchEnd March(
    vtkAlgorithm* algorithm, int port, double share, const Advance& advance, const Ask& ask, const Take& take)
  {
    const long long first = this->Scene.GetStep();
    const auto progress = [share, first, steps = this->Scene.GetGoal().Step - first + 1](long long step) {
      return share * static_cast<double>(step - first) / static_cast<double>(steps);
    };
    while (!this->Scene.IsAtGoal() || !this->Scene.IsNextKnown())
    {
      if (!this->Scene.IsNextKnown())
      {
        ask();
        const bool isUpdated = UpdateInputs(algorithm, port);
        if (IsAborted(algorithm) || !isUpdated)
        {
          return isUpdated ? MarchEnd::Aborted : MarchEnd::FailedInput;
        }
        take();
        continue;
      }
      if (IsAborted(algorithm))
      {
        return MarchEnd::Aborted;
      }
      algorithm->UpdateProgress(progress(this->Scene.GetStep()));
      if (!advance(progress))
      {
        return MarchEnd::Aborted;
      }
    }
    return MarchEnd::Goal;
  }

  /// There is no output, and the state is of no use.
  void Fail(vtkDataObject* output)
  {
    *this = MarchingRequests();
    output->Initialize();
  }

private:
  std::vector<double> Key;
};

}

#endif
