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

/// Stream power law of detachment-limited incision, E = K A^m S^n, with the drainage area A [m^2] and the slope S
/// [m/m].
struct StreamPowerLaw
{
  double Erodibility = 1e-5;  ///< erodibility K [m^(1 - 2m) / a], positive
  double AreaExponent = 0.45; ///< area exponent m, 0 to 2
  double SlopeExponent = 1.0; ///< slope exponent n, 0.2 to 5
  double Uplift = 1e-3;       ///< uplift rate U [m/a], not negative; outlets stay
  double MinimumArea = 0.0;   ///< smallest drainage area of a channel [m^2]; hillslopes, below it, are only uplifted
};

/// Why the law is invalid, with the name of the parameter; empty when it is not.
std::string WhyInvalid(const StreamPowerLaw& law);

/**
 * Time step [a] of dz/dt = U - K A^m S^n, implicit, from the outlets upstream along given receivers: stable for any
 * step (Braun & Willett 2013, O(n)). For n = 1 in closed form, z' = (z + U dt + F z'_r) / (1 + F) with F = K A^m dt /
 * d, else by Newton's method.
 */
void StepStreamPower(GridSamples& heights, const FlowRouting& routing, const std::vector<double>& area,
  const StreamPowerLaw& law, double time);

}

#endif
