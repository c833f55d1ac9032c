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

/// Weight of particles in a level.
enum class RunWeight
{
  None,      ///< masters that are needed for their slaves alone
  One,       ///< all
  ByDistance ///< by the distance of each, or of its master: see WeightIn()
};

/// Particles that a level shows alike, from Begin up to End in the order of the groups.
struct ShownRun
{
  std::size_t Begin;
  std::size_t End;
  int Trains; ///< number of trains that move each of them; 0 for slaves, and for fog
  RunWeight Weight;
  float Error; ///< bound of their distance from where all trains would have them [m]

  std::size_t Size() const { return this->End - this->Begin; }
};

bool operator==(const ShownRun& a, const ShownRun& b);

using ShownRuns = std::vector<ShownRun>;

/// Numbers of a selection.
struct ParticleCounts
{
  long long CellsShown = 0;
  long long Near = 0;
  long long Masters = 0; ///< of Middle, with those that follow none
  long long Slaves = 0;  ///< of Middle
  long long Far = 0;
  long long TrainSum = 0;         ///< number of trains, summed over orbits: the work
  long long Shown = 0;            ///< particles in Near or Middle, but for masters that slaves alone need
  double MaximumSlaveError = 0.0; ///< largest error of a slave [m]
};

/// Particles that a view needs of a cluster. The level Middle are the orbits of all parts, then all slaves.
struct ParticlePart
{
  std::size_t Cluster = 0;
  ShownRuns Near;
  ShownRuns Orbits; ///< of Middle: masters, and particles that follow none
  ShownRuns Slaves; ///< of Middle
  ShownRuns Far;
  ParticleCounts Before; ///< of the parts before
};

struct ParticleSelection : ParticleCounts
{
  std::vector<ParticlePart> Parts;
  long long CellsInAll = 0;
  long long Orbits() const { return this->Near + this->Masters; } ///< that are to be computed
};

/// Levels as they weigh particles.
enum class ParticleLevel
{
  Near,
  Middle,
  Far
};

/// The weight in a level at the distance of a master [m], of itself or of its slaves: a master is in Near and Middle at
/// the same place, so it is whole in the one that shows it.
double WeightIn(ParticleLevel level, bool isSlave, double distance, const ParticleLevelOptions& options);

/**
 * Particles that a view needs, of the cells from firstCell up to endCell. A cluster that is in the view and in one
 * level as a whole is taken at once, else each of its cells that is; in the others the distance of a master tells the
 * levels of its group, and the ball that holds all orbits of the group whether it may be seen. So what may be seen is
 * never lost, and none of a group is without its master. Trains and errors are those of the nearest and highest place
 * of what is taken at once. Far cells are taken as a whole where the view needs a part of them.
 *
 * Particles may have gone some way from their places: shift holds the ways of all, and the selection is that of all
 * ways in it. So it stays as it is from frame to frame as long as they are in the same shift; where levels change,
 * weights go by distance. Particles that are left out keep their places; the selection depends on the view of the
 * moment alone. A master changes at once between Near and Middle. Masters in Near are in Middle, too, where slaves need
 * them.
 */
ParticleSelection SelectParticles(const ParticleGroups& groups, const TrainTable& table, const ViewFrustum& frustum,
  const ParticleLevelOptions& options, std::size_t firstCell, std::size_t endCell,
  const ParallelFor& parallelFor = SerialFor, const Box& shift = {});

}

#endif
