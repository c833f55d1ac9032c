// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCarriedWind_h
#define LittoralCarriedWind_h

#include "Numerics/Parallel.h"
#include "Wind/WindField.h"

#include <array>

namespace littoral
{

/// The samples of a wind field with First <= (i, j, k) <= Last.
struct WindWindow
{
  std::array<int, 3> First{ 0, 0, 0 };
  std::array<int, 3> Last{ 0, 0, 0 };
};

/**
 * Velocities of a periodic wind field, as WindField::Make gives them, at a time [s]: the field is carried along the
 * wind by one sample a time step, between samples by the sums of its waves. They are turned into world axes by an angle
 * of which the cosine and sine are given. Three numbers a sample of the window, the first index fastest. Times are
 * rounded to a 1024th of a time step.
 */
void CarryWind(const WindGrid& grid, const float* velocities, double time, const std::array<double, 2>& turn,
  const WindWindow& window, float* carried, const ParallelFor& parallel = SerialFor);

}

#endif
