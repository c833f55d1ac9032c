// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStreamPower_h
#define LittoralStreamPower_h

#include "Drainage/FlowRouting.h"
#include "Terrain/GridSamples.h"

#include <string>
#include <vector>

namespace littoral
{

/// Rivers cut their beds at the rate K A^m S^n, with the drainage area A [m^2] and the slope S [m/m].
struct StreamPowerLaw
{
  double Erodibility = 1e-5;  ///< K [m^(1 - 2m) / a], positive
  double AreaExponent = 0.45; ///< m, 0 to 2
  double SlopeExponent = 1.0; ///< n, 0.2 to 5
  double Uplift = 1e-3;       ///< U [m/a], not negative; outlets stay
  double MinimumArea = 0.0;     ///< [m^2]; cells that drain less are hillslopes, and are lifted alone
};

/// Why no river can follow the law; empty when one can.
std::string WhyInvalid(const StreamPowerLaw& law);

/**
 * A step of time [a] of dh/dt = U - K A^m S^n, implicit, from the outlets upstream along given receivers: no step is
 * too long (Braun & Willett 2013, O(n)). For n = 1 in closed form, else by Newton's method.
 */
void StepStreamPower(GridSamples& heights, const FlowRouting& routing, const std::vector<double>& area,
  const StreamPowerLaw& law, double time);

}

#endif
