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
 * Power of a field by wave number, over rings of the cosine transform: the transform of the grid mirrored at its edges,
 * which makes no jump there. Power is a density, mean |c|^2 times the area of a cell, so that grids of other size and
 * spacing can be compared.
 */
struct RingSpectrum
{
  double Step = 0.0;         ///< width of a ring [cycles/m]
  std::vector<double> Power; ///< [m^4] of ring r, centered at r Step; 0 in rings without waves

  /// Linear between rings; that of the last ring beyond it.
  double At(double waveNumber) const;
};

/// The coefficients of the cosine transform, orthonormal: their squares sum to those of the values. In place.
void CosineTransform(GridSamples& values, const ParallelFor& parallel = SerialFor);
void InverseCosineTransform(GridSamples& values, const ParallelFor& parallel = SerialFor);

/// Of the coefficients of a field whose plane was removed.
RingSpectrum SpectrumOfCoefficients(const GridSamples& coefficients, const ParallelFor& parallel = SerialFor);

/// Multiplies each coefficient by a gain that depends on its wave number: gains of rings of a width [cycles/m], linear
/// between.
void MultiplyRings(
  GridSamples& coefficients, double step, const std::vector<double>& gains, const ParallelFor& parallel = SerialFor);

}

#endif
