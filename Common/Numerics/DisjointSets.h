// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDisjointSets_h
#define LittoralDisjointSets_h

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace littoral
{

/// Sets of things that are joined, each known by one of its things, the root.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  std::int32_t RootOf(std::int32_t thing)
  {
    while (this->Parents[thing] != thing)
    {
      this->Parents[thing] = this->Parents[this->Parents[thing]];
      thing = this->Parents[thing];
    }
    return thing;
  }

  /// Joins the set of one thing to that of another, whose root stays; false if they are one.
  bool Join(std::int32_t thing, std::int32_t to)
  {
    const std::int32_t root = this->RootOf(thing);
    const std::int32_t other = this->RootOf(to);
    this->Parents[root] = other;
    return root != other;
  }

private:
  std::vector<std::int32_t> Parents;
};

}

#endif
