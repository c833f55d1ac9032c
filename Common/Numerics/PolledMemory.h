// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPolledMemory_h
#define LittoralPolledMemory_h

#include "Numerics/Parallel.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// Makes a vector as long as so many elements, of zeros: new memory of a large grid can take seconds.
template <typename Value>
void Lengthen(std::vector<Value>& values, std::size_t count, const Poll& poll)
{
  values.reserve(count);
  ForPolled(count, poll, [&](std::size_t, std::size_t end) { values.resize(end); });
}

/// Gives the memory of a vector back, which takes long, too.
template <typename Value>
void GiveBack(std::vector<Value>& values, const Poll& poll)
{
  std::vector<Value>().swap(values);
  poll();
}

template <typename Value>
std::vector<Value> CopyOf(const std::vector<Value>& values, const Poll& poll)
{
  std::vector<Value> copy;
  copy.reserve(values.size());
  ForPolled(values.size(), poll,
    [&](std::size_t begin, std::size_t end) { copy.insert(copy.end(), values.data() + begin, values.data() + end); });
  return copy;
}

}

#endif
