// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralParticleMotion_h
#define LittoralParticleMotion_h

#include "Geometry/ViewFrustum.h"
#include "Numerics/Parallel.h"
#include "Particles/PlaceList.h"

namespace littoral
{

/// Motion that particles have in common.
struct ParticleMotion
{
  Box Shift;               ///< bounds of the ways of all [m]
  double MeanHeight = 0.0; ///< where they are [m]
  bool IsFinite = true;    ///< else the others mean nothing

  /// The largest difference of two ways along an axis [m].
  double Spread() const;
};

/// The motion of particles, at least one, from some places to others. Sums are those of any number of threads.
ParticleMotion MotionOf(const PlaceList& from, const PlaceList& to, const ParallelFor& parallelFor = SerialFor);

/// The motion of all by one way [m] after another motion, of places in single precision that were in a box.
ParticleMotion Shifted(const ParticleMotion& motion, const Vector3& way, const Box& box);

}

#endif
