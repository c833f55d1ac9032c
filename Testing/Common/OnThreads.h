// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTestOnThreads_h
#define LittoralTestOnThreads_h

#include "Numerics/Parallel.h"

#include <thread>
#include <vector>

namespace littoral::testing
{

/// A parallel loop on so many threads, made for each call, with a range each.
inline ParallelFor OnThreads(int threads)
{
  return [threads](std::size_t count, const RangeTask& task) {
    std::vector<std::thread> others;
    for (int t = 0; t < threads; ++t)
    {
      others.emplace_back([&, t] { task(count * t / threads, count * (t + 1) / threads); });
    }
    for (std::thread& other : others)
    {
      other.join();
    }
  };
}

}

#endif
