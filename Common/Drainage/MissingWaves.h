// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralMissingWaves_h
#define LittoralMissingWaves_h

#include "Drainage/RingSpectrum.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

namespace littoral
{

/// Adds waves of random size and phase to the rings in which a terrain has less than a tenth of the wanted power.
void AddMissingWaves(GridSamples& terrain, const RingSpectrum& wanted, int seed,
  const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

}

#endif
