// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGroundRoughness_h
#define LittoralGroundRoughness_h

#include "Drainage/RingSpectrum.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

namespace littoral
{

/// Roughness of a place from cell to cell, which neither rivers nor creep make: rock, soil, and what a survey or a
/// radar adds to them.
struct GroundRoughness
{
  RingSpectrum Spectrum;      ///< of the place without its plane
  double SlopeExponent = 0.0; ///< p of its power V ~ q^p with the squared slope q about it, 0 to 1.5
  double CurvaturePart = 0.0; ///< its part in the variance of curvature after a Gauss filter of two cells, 0 to 1
  double ShortWave = 0.0;     ///< shortest wavelength that the place tells of, along its diagonals [m]
};

/// Roughness of a grid without missing values.
GroundRoughness RoughnessOf(const GridSamples& place, const ParallelFor& parallel = SerialFor);

/**
 * Adds waves at random, counter-based, where ground has less power than the place at wavelengths under ten cells, in
 * full under five: a field of the missing spectrum, times sqrt(w / w_mean), w = q^p / (1 + (A / A_r)^2), with the
 * squared slope q about each cell and its drainage area A: water smooths its bed, A_r = 50 cells. Ground that drained
 * does so along the same paths, which are graded to the least slope [m/m] where roughness dams them. Ground that has
 * the place's spectrum stays as it is. The poll may end it by an exception.
 */
void AddRoughness(GridSamples& ground, const GroundRoughness& roughness, double minimumSlope, int seed,
  const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

}

#endif
