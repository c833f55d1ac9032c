// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralParticleLevels_h
#define LittoralParticleLevels_h

#include "Geometry/ViewFrustum.h"
#include "Numerics/Parallel.h"
#include "Numerics/Vector3.h"
#include "Particles/ParticleGroups.h"
#include "Particles/PlaceList.h"
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
  int Place;    ///< in the order of the groups
  int Master;   ///< place of its master in the level; -1 for a particle with an orbit of its own
  int Trains;   ///< number of trains that move it; 0 for a slave, and for fog
  float Weight; ///< 0 for a master that is needed for its slaves alone
  float Error;  ///< bound of its distance from where all trains would have it [m]
};

bool operator==(const ShownParticle& a, const ShownParticle& b);

/// Particles of a level: some one by one, between runs of the order of the groups that are shown alike.
class ShownLevel
{
public:
  /// Adds a particle.
  void Add(const ShownParticle& particle) { this->Listed.push_back(particle); }

  /// Adds the particles from begin up to end in the order of the groups, moved by so many trains, with weight 1 and
  /// without an error. All runs of a level have the same number of trains.
  void AddRun(std::size_t begin, std::size_t end, int trains);

  std::size_t Size() const { return this->Listed.size() + this->InRuns; }

  /// Calls `whole(begin, end, place, trains)` for each run and `one(particle, place)` for each other particle, with
  /// their places in the level.
  template <typename Whole, typename One>
  void ForEach(const Whole& whole, const One& one) const
  {
    std::size_t place = 0;
    auto next = this->Listed.begin();
    const auto list = [&](std::size_t end) {
      for (; next != this->Listed.begin() + static_cast<std::ptrdiff_t>(end); ++next)
      {
        one(*next, place++);
      }
    };
    for (const Run& run : this->Runs)
    {
      list(run.Before);
      whole(run.Begin, run.End, place, this->TrainsOfRuns);
      place += run.End - run.Begin;
    }
    list(this->Listed.size());
  }

  bool operator==(const ShownLevel& other) const;

private:
  struct Run
  {
    std::size_t Begin;
    std::size_t End;
    std::size_t Before; ///< listed particles before it
  };

  std::vector<ShownParticle> Listed;
  std::vector<Run> Runs;
  std::size_t InRuns = 0;
  int TrainsOfRuns = 0;
};

/// Numbers of a selection.
struct ParticleCounts
{
  long long CellsShown = 0;
  long long Near = 0;
  long long Masters = 0; ///< of Middle, and those that follow none
  long long Slaves = 0;  ///< of Middle
  long long Far = 0;
  long long TrainSum = 0;         ///< number of trains, summed over orbits: the work
  long long Shown = 0;            ///< particles with a weight in Near or Middle
  double MaximumSlaveError = 0.0; ///< largest error of a slave [m]
};

/// Particles of some cells. The level Middle are the masters of all parts, and those that follow none, then all slaves.
struct ParticlePart
{
  ShownLevel Near;
  std::vector<ShownParticle> Masters;
  std::vector<ShownParticle> Slaves;
  std::vector<double> OffsetErrors; ///< of the slaves, by their offsets alone [m]
  ShownLevel Far;
  ParticleCounts Before; ///< of the parts before
};

struct ParticleSelection : ParticleCounts
{
  std::vector<ParticlePart> Parts;
  long long CellsInAll = 0;
  long long Orbits() const { return this->Near + this->Masters; } ///< that are to be computed
};

/**
 * Particles that a view needs, of the cells from firstCell up to endCell. Cells are tested first, particles then: with
 * the ball that holds the orbit, so that what may be seen is never lost. A cell that is in the view and in one level as
 * a whole is not looked at by particles. Particles that are left out keep their places; the selection depends on the
 * view of the moment alone.
 *
 * A master is at the same place in Near and Middle, and changes between them without a band. Masters outside of the
 * view are in Middle, with weight 0, where slaves need them. Particles may have moved since they were grouped: shift
 * holds the ways of all.
 */
ParticleSelection SelectParticles(const PlaceList& places, const ParticleGroups& groups, const TrainTable& table,
  const ViewFrustum& frustum, const ParticleLevelOptions& options, std::size_t firstCell, std::size_t endCell,
  const ParallelFor& parallelFor = SerialFor, const Box& shift = {});

}

#endif
