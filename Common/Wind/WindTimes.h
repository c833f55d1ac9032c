// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWindTimes_h
#define LittoralWindTimes_h

#include "Numerics/Vector3.h"

#include <cstddef>
#include <functional>

namespace littoral
{

/// Time axis of a periodic wind.
struct WindTimes
{
  double Step = 0.1;       ///< time step [s], positive
  std::size_t Samples = 4; ///< steps in a period, at least 4

  /// Period [s].
  double Period() const { return this->Step * static_cast<double>(this->Samples); }
};

/// Wind velocities [m/s] at a place [m]: `count` values, one a step, from the step `first` on, any finite number.
/// Called from many threads.
using WindAtPlace = std::function<void(const Vector3& place, double first, std::size_t count, Vector3* velocities)>;

}

#endif
