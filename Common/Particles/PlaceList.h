// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlaceList_h
#define LittoralPlaceList_h

#include "Numerics/Vector3.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// Places as they lie in memory, three numbers each, in single or double precision [m]. They must outlive the list.
class PlaceList
{
public:
  PlaceList(const std::vector<Vector3>& places)
    : PlaceList(places.empty() ? nullptr : &places.front().x, places.size())
  {
  }
  PlaceList(const double* places, std::size_t count)
    : Doubles(places)
    , Count(count)
  {
  }
  PlaceList(const float* places, std::size_t count)
    : Singles(places)
    , Count(count)
  {
  }

  std::size_t Size() const { return this->Count; }

  Vector3 operator[](std::size_t n) const
  {
    return this->Singles ? Vector3(this->Singles[3 * n], this->Singles[3 * n + 1], this->Singles[3 * n + 2])
                         : Vector3(this->Doubles[3 * n], this->Doubles[3 * n + 1], this->Doubles[3 * n + 2]);
  }

  const float* GetSingles() const { return this->Singles; }
  const double* GetDoubles() const { return this->Doubles; }

private:
  const float* Singles = nullptr;
  const double* Doubles = nullptr;
  std::size_t Count;
};

}

#endif
