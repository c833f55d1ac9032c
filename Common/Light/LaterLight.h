// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLaterLight_h
#define LittoralLaterLight_h

#include "Light/AirLayers.h"
#include "Numerics/Parallel.h"
#include "Numerics/Vector3.h"

#include <vector>

namespace littoral
{

/**
 * Light of the sun that the air scatters for the second time or later, per light of the sun before the air: what a
 * place sends to where it is seen from, in a table by the altitude, the direction and the height of the sun (E.
 * Bruneton and F. Neyret, Precomputed atmospheric scattering, 2008), and the light of the sky on level ground.
 *
 * An order of scattering is made of the one before: the light around a place, along lines to all sides, is taken apart
 * into spherical harmonics, of which a phase function is a factor of each degree, and put together again. The more
 * turbid the air, the more orders; those after the last one are a geometric series.
 */
class LaterLight
{
public:
  LaterLight(const AirLayers& air, const AirParameters& parameters, const ParallelFor& parallel = SerialFor);

  /// Light that a place sends along a line, but what comes from the sun itself, per scattering coefficient; cosBetween
  /// of the angle between the line's direction and the sun.
  Vector3 Sent(double altitude, double cosView, double cosSun, double cosBetween) const;

  /// Light on level ground, but that of the sun itself.
  Vector3 OnGround(double cosSun) const;

  /// Red, green, blue, and a number that is not used.
  typedef float ColorLanes __attribute__((vector_size(4 * sizeof(float))));

private:
  std::vector<ColorLanes> SentTable;
  std::vector<ColorLanes> GroundTable;
};

}

#endif
