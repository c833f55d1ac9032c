// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralParallel_h
#define LittoralParallel_h

#include <algorithm>
#include <cstddef>
#include <functional>

namespace littoral
{

/// Work on the half-open range [begin, end).
using RangeTask = std::function<void(std::size_t begin, std::size_t end)>;

/**
 * Cuts [0, count) into ranges and runs the task on each, on whatever threads the caller has. Results may not depend on
 * the cuts. The VTK classes pass vtkSMPTools; a program without a pipeline can do with SerialFor.
 */
using ParallelFor = std::function<void(std::size_t count, const RangeTask& task)>;

inline void SerialFor(std::size_t count, const RangeTask& task)
{
  task(0, count);
}

/// Callback of long work on one thread, by which its caller can report, or end the work by an exception.
using Poll = std::function<void()>;

inline void NoPoll() {}

/// Calls a poll at each of so many steps of a loop.
class SteppedPoll
{
public:
  explicit SteppedPoll(const Poll& poll, std::size_t steps = 4096)
    : Called(poll)
    , Steps(steps)
    , Left(steps)
  {
  }

  void Step()
  {
    if (--this->Left == 0)
    {
      this->Left = this->Steps;
      this->Called();
    }
  }

private:
  const Poll& Called;
  std::size_t Steps;
  std::size_t Left;
};

/// A loop on one thread in ranges in their order, with a poll before each.
inline void ForPolled(std::size_t count, const Poll& poll, const RangeTask& task)
{
  constexpr std::size_t length = std::size_t{ 1 } << 16;
  for (std::size_t begin = 0; begin < count; begin += length)
  {
    poll();
    task(begin, std::min(count, begin + length));
  }
}

/// A parallel loop in ranges of a length [elements], the last one shorter, on however few threads. What is no longer
/// than one runs at once: threads cost some 0.1 ms to call.
inline void ForRanges(const ParallelFor& parallel, std::size_t count, std::size_t length, const RangeTask& task)
{
  const std::size_t size = std::max<std::size_t>(1, length);
  if (count <= size)
  {
    task(0, count);
    return;
  }
  parallel((count + size - 1) / size, [&](std::size_t begin, std::size_t end) {
    for (std::size_t range = begin; range < end; ++range)
    {
      task(range * size, std::min(count, (range + 1) * size));
    }
  });
}

}

#endif
