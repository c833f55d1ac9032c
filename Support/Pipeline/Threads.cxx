// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/Threads.h"

#include "vtkSMPTools.h"

#include <algorithm>

#ifdef LITTORAL_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#else
#include "Pipeline/Exceptions.h"
#endif

namespace littoral
{
namespace
{

#ifdef LITTORAL_WITH_TBB
/// Whether this thread is within a range.
thread_local bool IsWithin = false;

/// Marks the ranges of a thread, and ends with what was before.
class Within
{
public:
  Within()
    : Before(IsWithin)
  {
    IsWithin = true;
  }
  ~Within() { IsWithin = this->Before; }
  Within(const Within&) = delete;
  Within& operator=(const Within&) = delete;

private:
  bool Before;
};
#endif

}

std::size_t NumberOfThreads()
{
  return static_cast<std::size_t>(std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()));
}

void OnThreads(std::size_t begin, std::size_t end, std::size_t grain, const RangeTask& task)
{
  if (begin >= end)
  {
    return;
  }
  if (end - begin <= std::max<std::size_t>(1, grain)) // one range
  {
    task(begin, end);
    return;
  }
#ifdef LITTORAL_WITH_TBB
  const std::size_t threads = NumberOfThreads();
  if (threads == 1 || IsWithin)
  {
    task(begin, end);
    return;
  }
  const auto run = [&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end, std::max<std::size_t>(1, grain)),
      [&](const tbb::blocked_range<std::size_t>& range) {
        const Within within;
        task(range.begin(), range.end());
      });
  };
  static_cast<int>(threads) == tbb::this_task_arena::max_concurrency()
    ? run()
    : tbb::task_arena(static_cast<int>(threads)).execute(run);
#else
  FirstException first;
  vtkSMPTools::For(static_cast<vtkIdType>(begin), static_cast<vtkIdType>(end), static_cast<vtkIdType>(grain),
    [&](vtkIdType a, vtkIdType b) {
      first.Catch([&] { task(static_cast<std::size_t>(a), static_cast<std::size_t>(b)); });
    });
  first.Rethrow();
#endif
}

void SmpFor(std::size_t count, const RangeTask& task)
{
  OnThreads(0, count, 0, task);
}

}
