// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSwaySpecies_h
#define LittoralSwaySpecies_h

#include "Plants/Skeleton.h"
#include "Plants/WoodParameters.h"
#include "Sway/LeafMotion.h"
#include "Sway/PlantSway.h"
#include "Sway/TrunkModes.h"

#include <array>
#include <vector>

namespace littoral
{

/// Parameters of swaying plants.
struct SwaySettings
{
  SwayOptions Options;        ///< with the wood of plants that do not tell theirs
  bool WoodFromPlants = true; ///< whether plants may tell their wood
  LeafMotionOptions Leaves;
  int Pictures = 8;                           ///< pictures of a crown, at equal times of a swing; 1: a still one
  std::array<int, 2> TextureSize{ 256, 128 }; ///< columns and rows of a picture [texels]

  /// Options of a plant of a wood.
  SwayOptions With(const WoodParameters& wood) const;
};

/// Data that all plants of a species share: the prototype at rest.
struct SwaySpecies
{
  Skeleton Rest; ///< of the prototype; without nodes, plants of the species stand still
  WoodParameters Wood;
  std::vector<LeafCorners> Leaves;                 ///< of the prototype's leaf mesh
  std::vector<double> LeafAreas;                   ///< by node of the skeleton [m2]
  std::vector<std::array<double, 2>> CrownTCoords; ///< of the Medium crown's vertices in its own picture

  TrunkMeasures Trunk;
  Skeleton TrunkRest;          ///< the first branch alone
  double SwingFrequency = 0.0; ///< of the trunk's first mode [Hz]
};

/// The species of a prototype: measures of its trunk and its leaves. The skeleton and the wood must be valid.
SwaySpecies MakeSpecies(const Skeleton& rest, const WoodParameters& wood, const std::vector<LeafCorners>& leaves,
  const SwaySettings& settings);

/// Measures of the trunk of a plant of a species that is wider and thicker by a factor. Leaves have an area as if
/// upright.
TrunkMeasures WideTrunk(const SwaySpecies& species, double girth, const SwaySettings& settings);

/// Whether the trunk has the modes of a beam. It has not if its radii are so unlike that the stiffness of one segment
/// hides that of the others in rounding.
bool HasModes(const SwaySpecies& species, const SwaySettings& settings);

}

#endif
