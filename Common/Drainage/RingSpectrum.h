// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRingSpectrum_h
#define LittoralRingSpectrum_h

#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/**
 * Radially averaged power spectral density, over rings of wave number of the cosine transform: the transform of the
 * grid mirrored at its edges, which makes no jump there. P = <|c|^2> dx dy, so that grids of other size and spacing can
 * be compared.
 */
struct RingSpectrum
{
  double Step = 0.0;         ///< width of a ring [cycles/m]
  std::vector<double> Power; ///< density of ring r, centered at r Step [m^4]; 0 in rings without waves

  /// Density at a wave number [cycles/m], linear between rings; that of the last ring beyond it.
  double At(double waveNumber) const;
};

/// Orthonormal cosine transform in place, X_k = sqrt((2 - [k = 0]) / N) sum x_n cos(pi k (n + 1/2) / N) along each
/// axis.
void CosineTransform(GridSamples& values, const ParallelFor& parallel = SerialFor);
void InverseCosineTransform(GridSamples& values, const ParallelFor& parallel = SerialFor);

/// Spectrum by the coefficients of the cosine transform of a field without its plane.
RingSpectrum SpectrumOfCoefficients(const GridSamples& coefficients, const ParallelFor& parallel = SerialFor);

/// Radial filter: multiplies each coefficient by the gain at its wave number, linear between gains at rings of a width
/// [cycles/m].
void MultiplyRings(
  GridSamples& coefficients, double step, const std::vector<double>& gains, const ParallelFor& parallel = SerialFor);

}

#endif
