// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCheckpoints_h
#define LittoralCheckpoints_h

#include <cstddef>
#include <iterator>
#include <map>

namespace littoral
{

/**
 * States of a time integration by step, from which it can be resumed. States are kept at multiples of a stride, which
 * doubles when there would be more than a maximal number of them: the whole of the past stays covered evenly.
 */
template <typename State>
class Checkpoints
{
public:
  /// A state and its step.
  using Entry = typename std::map<long long, State>::value_type;

  explicit Checkpoints(std::size_t maximum)
    : Maximum(maximum)
  {
  }

  std::size_t GetNumberOfStates() const { return this->States.size(); }

  /// Number of steps between checkpoints, a power of two.
  long long GetStride() const { return this->Stride; }

  void Clear()
  {
    this->States.clear();
    this->Stride = 1;
  }

  /// Keeps a state if its step is a multiple of the stride.
  void Keep(long long step, const State& state)
  {
    if (step % this->Stride != 0)
    {
      return;
    }
    this->States[step] = state;
    while (this->States.size() > this->Maximum)
    {
      this->DoubleStride();
    }
  }

  /// The latest state that is not after a step; null if there is none.
  const Entry* Latest(long long step) const
  {
    const auto after = this->States.upper_bound(step);
    return after == this->States.begin() ? nullptr : &*std::prev(after);
  }

private:
  void DoubleStride()
  {
    this->Stride *= 2;
    for (auto it = this->States.begin(); it != this->States.end();)
    {
      it = it->first % this->Stride == 0 ? std::next(it) : this->States.erase(it);
    }
  }

  std::size_t Maximum;
  long long Stride = 1;
  std::map<long long, State> States;
};

}

#endif
