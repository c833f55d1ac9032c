// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLevelWeights_h
#define LittoralLevelWeights_h

#include "Geometry/ViewFrustum.h"
#include "Particles/ParticleLevels.h"
#include "Particles/PlaceList.h"

namespace littoral
{

/// Weights in a level of masters at some places that have gone a way [m], or of their slaves: those of WeightIn().
void WeighAll(ParticleLevel level, bool areSlaves, const PlaceList& places, const Vector3& way, const View& view,
  const ParticleLevelOptions& options, float* weights);

}

#endif
