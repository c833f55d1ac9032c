// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Loops of the classes: each number once, on no more threads than vtkSMPTools has, an exception for the caller, and
// loops in loops that stay in the range that has them.
#include "Check.h"
#include "Pipeline/Threads.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace
{

/// Each number of [begin, end) is in one range.
bool CheckRanges(std::size_t begin, std::size_t end, std::size_t grain)
{
  std::vector<std::atomic<int>> times(end + 1);
  littoral::OnThreads(begin, end, grain, [&](std::size_t first, std::size_t last) {
    for (std::size_t n = first; n < last; ++n)
    {
      ++times[n];
    }
  });
  bool good = true;
  for (std::size_t n = 0; n <= end; ++n)
  {
    good &= times[n] == (n >= begin && n < end ? 1 : 0);
  }
  return Check(good, "a number is in no range or in two");
}

/// Most ranges at a time, each of which waits for others for a while.
int MostAtOnce(int threads)
{
  std::atomic<int> now{ 0 };
  std::atomic<int> most{ 0 };
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false }, [&] {
    littoral::OnThreads(0, 64, 1, [&](std::size_t, std::size_t) {
      const int here = ++now;
      for (int before = most; here > before && !most.compare_exchange_weak(before, here);)
      {
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      --now;
    });
  });
  return most;
}

/// The words of what a range threw.
std::string Thrown()
{
  try
  {
    littoral::SmpFor(100, [](std::size_t begin, std::size_t end) {
      if (begin <= 57 && 57 < end)
      {
        throw std::runtime_error("57");
      }
    });
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

/// Loops in a loop run on the thread of their range, one after the other.
bool CheckNested()
{
  std::atomic<bool> isGood{ true };
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 2, "STDThread", false }, [&] {
    littoral::OnThreads(0, 8, 1, [&](std::size_t, std::size_t) {
      std::set<std::thread::id> seen;
      std::mutex mutex;
      littoral::OnThreads(0, 100, 1, [&](std::size_t, std::size_t) {
        const std::lock_guard<std::mutex> guard(mutex);
        seen.insert(std::this_thread::get_id());
      });
      isGood = isGood && seen == std::set<std::thread::id>{ std::this_thread::get_id() };
    });
  });
  return Check(isGood, "a loop in a loop takes other threads");
}

}

int TestThreads(int, char*[])
{
  bool good = CheckRanges(0, 0, 0) & CheckRanges(0, 1, 0) & CheckRanges(0, 1000, 0) & CheckRanges(7, 1000, 1) &
    CheckRanges(990, 1000, 64) & CheckRanges(0, 100000, 300);
  good &= Check(MostAtOnce(1) == 1, "one thread is asked for, and there are more");
  int two = MostAtOnce(2);
  for (int again = 0; again < 5 && two < 2; ++again) // other programs may hold the second
  {
    two = MostAtOnce(2);
  }
  good &= Check(two == 2, "two threads are asked for, and there are " + std::to_string(two));
  good &= Check(MostAtOnce(3) <= 3, "three threads are asked for, and there are more");
  good &= Check(Thrown() == "57", "an exception of a range is lost");
  good &= CheckNested();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
