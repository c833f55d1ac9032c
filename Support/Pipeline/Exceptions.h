// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportExceptions_h
#define LittoralSupportExceptions_h

// No exception leaves a request, or a thread of one: it would end the program. Private: never installed, never wrapped.

#include "Numerics/InvalidInput.h"
#include "Pipeline/Mistakes.h"

#include <exception>
#include <mutex>
#include <new>
#include <string>

namespace littoral
{

/// Ends a request that the user asked to stop, from where no false can be handed back.
struct Aborted
{
};

/// Keeps the first exception of several threads for the one that waits for them.
class FirstException
{
public:
  template <typename Task>
  void Catch(const Task& task) noexcept
  {
    try
    {
      task();
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> guard(this->Mutex);
      this->First = this->First ? this->First : std::current_exception();
    }
  }

  void Rethrow() const
  {
    if (this->First)
    {
      std::rethrow_exception(this->First);
    }
  }

private:
  std::mutex Mutex;
  std::exception_ptr First;
};

/**
 * Result of the answer to a request; 1 if it ends by an abort. Any other exception is reported as a mistake of the
 * algorithm, of InvalidInput its sentence after these words. Outputs are empty after each of them.
 */
template <typename Answer>
int WithoutExceptions(vtkAlgorithm* algorithm, vtkInformation* request, vtkInformationVector* outputs,
  const std::string& words, const Answer& answer)
{
  const AnsweredRequest answered(algorithm, request, outputs);
  try
  {
    const int result = answer();
    return result != 0 ? result : answered.WithoutInput();
  }
  catch (const Aborted&)
  {
    answered.EmptyOutputs();
    return 1;
  }
  catch (const InvalidInput& refusal)
  {
    return answered.FailedBy(words + refusal.what());
  }
  catch (const std::bad_alloc&)
  {
    return answered.FailedBy("There is not enough memory for the output.");
  }
  catch (const std::exception& error)
  {
    return answered.FailedBy("The input or a property leads to an error (" + std::string(error.what()) + ").");
  }
}

/// The same for an algorithm whose sentences stand alone.
template <typename Answer>
int WithoutExceptions(
  vtkAlgorithm* algorithm, vtkInformation* request, vtkInformationVector* outputs, const Answer& answer)
{
  return WithoutExceptions(algorithm, request, outputs, "", answer);
}

}

#endif
