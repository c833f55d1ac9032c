// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantLevels_h
#define LittoralPlantLevels_h

#include "Plants/PlantPrototype.h"

#include <string>

namespace littoral
{

/// How the levels of detail of a plant are made.
struct PlantLevelOptions
{
  int TextureColumns = 256; ///< of the crown's texture, around the plant
  int TextureRows = 128;    ///< of the crown's texture, from its foot to its top
  double CrownJitter = 0.0; ///< by which the envelope's vertices move inwards at most, as part of the radius
  int Seed = 1;             ///< of the jitter
};

/// Why there are no such levels, with the name of the property; empty when there are.
std::string WhyInvalid(const PlantLevelOptions& options);

/// Colors and sizes that the lower levels take from a plant.
struct PlantOutline
{
  CrownVolume Crown;
  Color Leaf{ 112, 146, 60 };
  Color Bark{ 105, 88, 70 };
};

/// A closed cone from the foot of the first branch to its tip.
PlantMesh TrunkCone(const Skeleton& wood, const Color& bark);

/// A closed mesh inside the bounding volume, with texture coordinates by cylindrical projection: u around the axis from
/// 0 to 1, v from foot to top.
PlantMesh CrownEnvelope(const CrownVolume& crown, const PlantLevelOptions& options);

/// The lowest level: exactly four untextured polygons, two crossed rectangles for the trunk and two crossed triangles
/// (cone) or ellipses (ellipsoid) for the crown, which has the colors of its picture, from foot to top.
PlantMesh LowPlant(const PlantOutline& outline, const Skeleton& wood, const TextureImage& seen);

/// Adds Medium and Low to a prototype of which High is there.
void AddLowerLevels(PlantPrototype& prototype, const PlantOutline& outline, const PlantLevelOptions& options);

/// All levels of a plant. The plant must be valid.
PlantPrototype LevelsOf(const Plant& plant, const PlantLevelOptions& options);

}

#endif
