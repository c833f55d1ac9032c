// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLandscapeStep_h
#define LittoralLandscapeStep_h

#include "Landscapes/MeshDrainage.h"

#include <string>
#include <vector>

namespace littoral
{

/**
 * Evolution of a landscape, of rivers and of hillslopes (Braun & Willett 2013; Roering, Kirchner & Dietrich 1999):
 *
 *   dz/dt = U - K A^m S + div(D grad z / (1 - (|grad z| / S_c)^2))
 *
 * with the slope S to the receiver and the drainage area A. Between two points |grad z| is the slope from one to the
 * other. A steady state without hillslopes has S = U / K A^-m. Rock of a hardness h rises and resists, with U sqrt(h)
 * and K / sqrt(h): slopes of rivers go with h, and soft ground is dissected more finely.
 */
struct LandscapeLaw
{
  double Erodibility = 1e-3;   ///< K [m^(1 - 2m) / a], not negative
  double AreaExponent = 0.5;   ///< m, 0 to 2: the concavity of rivers
  double Diffusivity = 10.0;   ///< D [m^2 / a], not negative
  double ThresholdSlope = 1.0; ///< S_c, that no slope to a receiver exceeds [m/m], positive
  double MinimumSlope = 1e-6;  ///< least slope to a receiver, of what rivers lay down [m/m], not negative
};

/// Factors by place, one a point; 1 everywhere where there are none: rivers of a steady state then have the steepness
/// U f / (K e).
struct RockFactors
{
  std::vector<double> Erodibility; ///< e, factor of K, positive
  std::vector<double> Uplift;      ///< f, factor of U, positive
};

/// Why the law is invalid, with the name of the parameter; empty when it is not.
std::string WhyInvalid(const LandscapeLaw& law);

/// Implicit time step [a], stable for any: two passes of Gauss and Seidel from the outlets upstream, each point after
/// its receiver. `uplift` is U [m/a], `hardness` h at each point, positive; the rim stays.
void StepLandscape(const PointMesh& mesh, const MeshDrainage& drainage, const LandscapeLaw& law, double uplift,
  const std::vector<double>& hardness, double time, std::vector<double>& heights,
  const ParallelFor& parallel = SerialFor, const RockFactors& factors = {}, const Poll& poll = NoPoll);

}

#endif
