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

/**
 * A state that a filter marches in time while its inputs are asked for one time after the other: the filter executes as
 * often as it takes (CONTINUE_EXECUTING). `History` has IsAtGoal(), IsNextKnown(), GetStep() and GetGoal(), as
 * DriftHistory does.
 */
template <typename History>
class MarchingRequests
{
public:
  History Scene;

  /// Whether the state has to begin anew, for what it depends on has changed. A pipeline that changes whenever it is
  /// asked does not keep a filter executing for ever: within one request a state begins anew twice at most.
  bool BeginsAnew(const std::vector<double>& key)
  {
    constexpr int MaximumRestarts = 2;
    this->Restarts = this->IsExecuting ? this->Restarts : 0;
    if (key == this->Key || this->Restarts >= MaximumRestarts)
    {
      return false;
    }
    this->Key = key;
    ++this->Restarts;
    return true;
  }

  /**
   * Takes steps up to that of the goal, or as far as the currents are known. False when aborted. `advance(progress)`
   * takes one step or more; it returns false when aborted, and may report `progress(step)`, which is `share` at the
   * end.
   */
  template <typename Advance>
  bool March(vtkAlgorithm* algorithm, double share, const Advance& advance)
  {
    const long long first = this->Scene.GetStep();
    const auto progress = [share, first, steps = this->Scene.GetGoal().Step - first + 1](long long step) {
      return share * static_cast<double>(step - first) / static_cast<double>(steps);
    };
    while (!this->Scene.IsAtGoal() && this->Scene.IsNextKnown())
    {
      if (IsAborted(algorithm))
      {
        return false;
      }
      algorithm->UpdateProgress(progress(this->Scene.GetStep()));
      if (!advance(progress))
      {
        return false;
      }
    }
    return true;
  }

  /// Whether the filter has to execute again before the state at the goal is known; the pipeline then does so.
  bool Continues(vtkInformation* request)
  {
    this->IsExecuting = !this->Scene.IsAtGoal() || !this->Scene.IsNextKnown();
    if (this->IsExecuting)
    {
      request->Set(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING(), 1);
    }
    return this->IsExecuting;
  }

  /// The output is complete. For the end of RequestData.
  int Succeed(vtkInformation* request)
  {
    request->Remove(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
    this->IsExecuting = false;
    return 1;
  }

  /// There is no output, and the state is of no use. For the end of RequestData.
  void Fail(vtkInformation* request, vtkDataObject* output)
  {
    request->Remove(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
    *this = MarchingRequests();
    output->Initialize();
  }

private:
  std::vector<double> Key;
  int Restarts = 0;
  bool IsExecuting = false;
};

}

#endif
