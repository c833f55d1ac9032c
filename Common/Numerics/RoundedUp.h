// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRoundedUp_h
#define LittoralRoundedUp_h

#include <cmath>
#include <limits>

namespace littoral
{

/// The least single precision number that is not below: bounds stay bounds.
inline float RoundedUp(double value)
{
  const float near = static_cast<float>(value);
  return static_cast<double>(near) < value ? std::nextafter(near, std::numeric_limits<float>::infinity()) : near;
}

}

#endif
