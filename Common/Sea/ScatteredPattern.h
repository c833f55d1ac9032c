// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralScatteredPattern_h
#define LittoralScatteredPattern_h

#include <vector>

namespace littoral
{

/// Water that light passes.
struct ScatteringWay
{
  double Length = 0.0;     ///< of the way [m]
  double Scattering = 0.0; ///< [1/m]
  double Forward = 0.9;    ///< mean cosine of scattering (Henyey and Greenstein), above 0 and below 1
};

/**
 * Contrast that a pattern of parallel light keeps on its way, by its wave number [rad/m]: most light is scattered by a
 * few degrees only, which blurs small patterns and leaves wide ones (Wells 1969).
 */
double ContrastAfter(double waveNumber, const ScatteringWay& way);

/// A pattern on a square that repeats itself, by rows of so many places along its side [m], after a way. Its mean
/// stays.
std::vector<double> ScatteredPattern(
  const std::vector<double>& light, int places, double side, const ScatteringWay& way);

}

#endif
