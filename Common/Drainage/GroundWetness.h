// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGroundWetness_h
#define LittoralGroundWetness_h

#include "Geometry/HeightGrid.h"
#include "Numerics/Parallel.h"

#include <functional>
#include <vector>

namespace littoral
{

/**
 * The topographic wetness index of Beven and Kirkby (1979): ln(a / tan b), where the drainage area [m2] over the width
 * of a cell [m] is a, and b the slope [radians], at least 0.001 in its tangent.
 */
double WetnessOf(double drainageArea, double cellWidth, double slope);

/**
 * Topographic wetness index (WetnessOf) at each point of a grid, whose drainage areas [m2] are told by `areaOf`,
 * averaged by a Gauss function of two cells: ground beside a stream is wet too. Beside points without a height the
 * ground is taken as level.
 */
std::vector<double> SpreadWetness(
  const HeightGrid& ground, const std::function<double(long long)>& areaOf, const ParallelFor& parallel = SerialFor);

}

#endif
