// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantLevels_h
#define LittoralPlantLevels_h

#include "Numerics/WorkShare.h"
#include "Plants/CrownCards.h"
#include "Plants/PlantPrototype.h"

#include <cstdint>
#include <functional>
#include <string>

namespace littoral
{

/// Stand-ins for the crown at the level Medium.
enum class MediumCrown
{
  Leaves = 0,   ///< cards with tufts of leaves
  Envelope = 1, ///< a closed surface with a picture of the crown (Setas et al., section 4.1.2)
};

inline constexpr int NumberOfMediumCrowns = 2;

/// Options of the levels of detail of a plant.
struct PlantLevelOptions
{
  MediumCrown Crown = MediumCrown::Leaves;
  int TextureColumns = 256; ///< of the crown's texture; of an envelope around the plant
  int TextureRows = 128;    ///< of the crown's texture; of an envelope from its foot to its top
  double CrownJitter = 0.0; ///< largest move inwards of the envelope's vertices, as part of the radius
  int Seed = 1;             ///< of the jitter and the cards
  ParallelFor Parallel = SerialFor;
  Poll OnStep = NoPoll;
  /// Share in the pictures of a plant of this key, of processes that each grow one; null: alone.
  std::function<WorkShare(std::uint64_t key)> ShareOf;
};

/// Why there are no such levels, with the name of the property; empty when there are.
std::string WhyInvalid(const PlantLevelOptions& options);

/// Data of a plant that its lower levels need.
struct PlantOutline
{
  CrownVolume Crown;
  Color Bark{ 105, 88, 70 };
};

/// A closed cone from the foot of the first branch to its tip.
PlantMesh TrunkCone(const Skeleton& wood, const Color& bark);

/// A closed mesh inside the bounding volume, with texture coordinates by cylindrical projection: u around the axis from
/// 0 to 1, v from foot to top.
PlantMesh CrownEnvelope(const CrownVolume& crown, const PlantLevelOptions& options);

/// Adds Medium and Low to a prototype of which High is there. `makeCards` is asked for the crown's cards where these
/// are wanted.
void AddLowerLevels(PlantPrototype& prototype, const PlantOutline& outline, const PlantLevelOptions& options,
  const std::function<CrownCards()>& makeCards);

/// All levels of a plant. The plant must be valid.
PlantPrototype LevelsOf(const Plant& plant, const PlantLevelOptions& options);

}

#endif
