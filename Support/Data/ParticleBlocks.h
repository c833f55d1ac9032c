// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportParticleBlocks_h
#define LittoralSupportParticleBlocks_h

// The arrays of particles in a level of detail, from runs in the order of their groups. Private: never installed, never
// wrapped. Array: vtkFloatArray or vtkDoubleArray, that of the places.

#include "Data/FrameArrays.h"
#include "Particles/ParticleGroups.h"
#include "Particles/ParticleLevels.h"
#include "Pipeline/Ranges.h"

#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace littoral
{

/// A selection with what tells where its particles are.
struct ShownParticles
{
  const ParticleSelection& Selection;
  const ParticleGroups& Groups;
  const PlaceList& Places;
  vtkDataArray* Sorted; ///< places in the order of the groups; null where they are not at hand
  Vector3 Way;          ///< from these to the places [m]
  bool AreScattered;    ///< slaves
  const littoral::View& View;
  const ParticleLevelOptions& Options;
};

/// Number of particles in a level.
std::size_t SizeOf(const ParticleSelection& selection, ParticleLevel kind);

/// The arrays of the input, in the order of the groups, at the particles of a level.
void CarryArrays(
  const ShownParticles& shown, ParticleLevel kind, vtkPointData* ordered, FrameArrays& memory, vtkPointData* to);

/// All places in the order of the groups.
template <typename Array>
vtkSmartPointer<vtkDataArray> SortedPlaces(const PlaceList& places, const ParticleGroups& groups);

/// The points of a level; those of scattered slaves about their masters. The ranges of their sorted places are found
/// where they are not known yet.
template <typename Array>
vtkSmartPointer<vtkPoints> PointsOf(
  const ShownParticles& shown, ParticleLevel kind, std::optional<TupleRanges>& sorted, FrameArrays& memory);

/// Places of the masters of all in the level Middle in its block; -1 for those with orbits.
vtkSmartPointer<vtkIdTypeArray> MastersOf(const ShownParticles& shown, FrameArrays& memory);

/// Particles of a level, in a cluster, whose opacities go by distance.
struct BlendedRun
{
  ShownRun Run;
  std::size_t Cluster;
  std::size_t Place; ///< of the first in the block
};

/// Opacities of a selection in a level.
struct LevelBlends
{
  std::vector<BlendedRun> Runs;
  ValueRange Others; ///< of opacities that do not go by distance
};

LevelBlends BlendsOf(const ShownParticles& shown, ParticleLevel kind);

/// The opacities of a level. Those that do not go by distance stay in arrays of the same state, which numbers the
/// selections and levels, from 1 on.
template <typename Array>
vtkSmartPointer<vtkFloatArray> AlphasOf(
  const ShownParticles& shown, ParticleLevel kind, const LevelBlends& blends, std::size_t state, FrameArrays& memory);

/// The arrays that tell how a level is moved.
void AddLevelArrays(const ShownParticles& shown, ParticleLevel kind, FrameArrays& memory, vtkPointData* arrays);

/// The offsets of slaves from their masters, in the type of the points. They are those at rest where these are at hand,
/// so that they stay from frame to frame.
template <typename Array>
vtkSmartPointer<Array> OffsetsOf(
  const ShownParticles& shown, vtkPoints* places, vtkIdTypeArray* masterIds, FrameArrays& memory);

}

#endif
