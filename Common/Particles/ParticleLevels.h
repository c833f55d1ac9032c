// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralParticleLevels_h
#define LittoralParticleLevels_h

#include "Geometry/ViewFrustum.h"
#include "Numerics/Parallel.h"
#include "Numerics/Vector3.h"
#include "Particles/ParticleGroups.h"
#include "Sea/TrainSelection.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// Levels of detail of particles (Coulais et al., 3.3) and what of them a view needs.
struct ParticleLevelOptions
{
  bool UseLevels = true;        ///< masters, slaves and fog; else each particle has its orbit
  bool UseCulling = true;       ///< leave out what the view cannot show
  double MiddleDistance = 2.0;  ///< distance from which particles follow masters [m]
  double FarDistance = 12.0;    ///< distance from which they are fog [m], not below MiddleDistance
  double BlendDistance = 0.5;   ///< half the width of the bands in which levels change [m]
  double VisibleDistance = 0.0; ///< beyond which there is nothing [m]; 0: no limit
  double Margin = 0.01;         ///< about the view, for the size of particles [m]
  double FogMargin = 1.0;       ///< about the view, for the cells of the fog [m]
};

/// Why these are no options, in words for a user; empty when they are.
std::string WhyInvalid(const ParticleLevelOptions& options);

/// Weights of the levels in the display of a particle; their sum is 1.
struct LevelWeights
{
  double Near;
  double Middle;
  double Far;
};

LevelWeights WeightsAt(double distance, const ParticleLevelOptions& options);

/// 0 before -width, 1 beyond width, smooth between; a step for a width of 0.
double BlendAt(double x, double width);

/// A particle that a level shows.
struct ShownParticle
{
  int Particle;
  int Master;   ///< place of its master in the level; -1 for a particle with an orbit of its own
  int Trains;   ///< number of trains that move it; 0 for a slave, and for fog
  float Weight; ///< 0 for a master that is needed for its slaves alone
  float Error;  ///< bound of its distance from where all trains would have it [m]
};

struct ParticleSelection
{
  std::vector<ShownParticle> Near;
  std::vector<ShownParticle> Middle; ///< particles at the level Middle, those with orbits first
  std::vector<ShownParticle> Far;
  long long CellsShown = 0;
  long long CellsInAll = 0;
  long long Orbits = 0;           ///< orbits that are to be computed
  long long TrainSum = 0;         ///< number of trains, summed over orbits: the work
  long long Shown = 0;            ///< particles with a weight in Near or Middle
  double MaximumSlaveError = 0.0; ///< largest error of a slave [m]
};

/**
 * Particles that a view needs, of the cells from firstCell up to endCell. Cells are tested first, particles then: with
 * the ball that holds the orbit, so that what may be seen is never lost. Particles that are left out keep their places;
 * the selection depends on the view of the moment alone.
 *
 * A master is at the same place in Near and Middle, and changes between them without a band. Masters outside of the
 * view are in Middle, with weight 0, where slaves need them.
 */
ParticleSelection SelectParticles(const std::vector<Vector3>& places, const ParticleGroups& groups,
  const TrainTable& table, const ViewFrustum& frustum, const ParticleLevelOptions& options, std::size_t firstCell,
  std::size_t endCell, const ParallelFor& parallelFor = SerialFor);

}

#endif
