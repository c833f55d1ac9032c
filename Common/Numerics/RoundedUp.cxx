// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/RoundedUp.h"

#include <cmath>
#include <limits>

namespace littoral
{

float RoundedUp(double value)
{
  const float near = static_cast<float>(value);
  return static_cast<double>(near) < value ? std::nextafter(near, std::numeric_limits<float>::infinity()) : near;
}

}
