// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGardnerPlant_h
#define LittoralGardnerPlant_h

#include "Plants/GardnerTexture.h"
#include "Plants/PlantLevels.h"

#include <string>
#include <vector>

namespace littoral
{

/// Plants with numbers of their own.
enum class GardnerPreset
{
  Custom = 0,
  Tree = 1,
  Cypress = 2,
  StonePine = 3,
  Bush = 4,
};

/// A plant of a kind; individuals differ by seed.
struct GardnerPlantParameters
{
  double Height = 11.0;     ///< [m]
  double CrownRadius = 4.6; ///< largest [m]
  double CrownBase = 2.0;   ///< height of the lowest leaves [m]
  double TrunkRadius = 0.3; ///< at the ground [m]
  int NumberOfQuadrics = 24;
  int Shells = 3;                   ///< of each quadric
  GardnerTextureParameters Texture; ///< FrequencyY and Origin are the plant's own
  double Variation = 0.2;           ///< standard deviation of sizes and places, as part of their means
  Color Leaf{ 138, 168, 84 };
  Color Bark{ 105, 88, 70 };
  int Seed = 1;
};

inline constexpr int NumberOfGardnerPresets = 5;

/// The row of a preset.
struct GardnerPresetTraits
{
  const char* Name; ///< as in the enumeration
  GardnerPlantParameters (*Parameters)();
};

/// The row of a preset, which must be one of the enumeration.
const GardnerPresetTraits& TraitsOf(GardnerPreset preset);

/// The numbers of a preset; those of Custom are the defaults.
GardnerPlantParameters PresetParameters(GardnerPreset preset);

/// Why there is no such plant, with the name of the parameter; empty when there is.
std::string WhyInvalid(const GardnerPlantParameters& parameters);

/// The volume that bounds the crown of a valid plant.
CrownVolume CrownOf(const GardnerPlantParameters& parameters);

/// An upright ellipsoid of leaves.
struct Quadric
{
  Vector3 Center{ 0.0, 0.0, 0.0 }; ///< [m]
  Vector3 Axes{ 1.0, 1.0, 1.0 };   ///< semi-axes [m]
  double Azimuth = 0.0;            ///< of the first axis [rad]
  int Node = 0;                    ///< of the skeleton that carries it
  double Tints[2] = { 0.0, 0.0 };  ///< normal deviates of its brightness and warmth
};

/// The place of a point of the unit sphere that the quadric is an image of.
Vector3 PointOf(const Quadric& quadric, const Vector3& ofSphere);

/// The outward direction of the quadric there.
Vector3 Outward(const Quadric& quadric, const Vector3& ofSphere);

/// A plant of textured quadrics.
struct GardnerPlant
{
  Skeleton Wood;
  std::vector<Quadric> Quadrics;
  GardnerPlantParameters Parameters; ///< with the texture of this individual
};

/**
 * Trees and shrubs after Gardner (1984): quadrics around the inside of the bounding ellipsoid, each on a limb of the
 * trunk. Each number is a function of the seed and of the quadric it belongs to. The parameters must be valid.
 */
GardnerPlant GrowGardnerPlant(const GardnerPlantParameters& parameters);

/// Sections through the middle of a quadric, spread over all directions.
inline constexpr int NumberOfSections = 9;

/// The shells and sections of all quadrics, triangles that show the picture; those on which it is transparent all over
/// are left out. A quadric follows the joint of the node that carries it.
PlantMesh QuadricMesh(const GardnerPlant& plant, const TextureImage& picture);

/// The squares around some of the sections, as cards for the level Medium; the texture shows the two sections.
CrownCards SectionCards(const GardnerPlant& plant, const TextureImage& picture, int columns, int rows);

/// The crown as far as it is seen, for the lower levels: as much smaller than the bounding volume as disks of the same
/// opaque area are than the outlines of the quadrics at its rim.
CrownVolume SeenCrown(const GardnerPlant& plant, const TextureImage& picture);

/// All levels of a plant.
PlantPrototype LevelsOf(const GardnerPlant& plant, const PlantLevelOptions& options);

}

#endif
