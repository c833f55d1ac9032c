// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSuspendedParticles_h
#define LittoralSuspendedParticles_h

#include "Geometry/TextureImage.h"
#include "Numerics/Vector3.h"

#include <array>
#include <string>
#include <vector>

namespace littoral
{

/// Kinds of particles, by their looks. Values are part of the data: never renumber.
enum class ParticleKind
{
  Diatom = 0,  ///< a round alga with a pattern of rays
  Flake = 1,   ///< marine snow: a ragged lump of what has died above
  Grain = 2,   ///< a mineral
  Copepod = 3, ///< a small crustacean
};

inline constexpr int ParticleKinds = 4;

/// A word for a kind.
const char* ParticleKindName(ParticleKind kind);

/// A box in which particles of one kind hang at random places (Coulais et al., section 3.1).
struct ParticleBox
{
  std::string Name;
  Vector3 Lower{ -5.0, -5.0, -5.0 }; ///< [m]
  Vector3 Upper{ 5.0, 5.0, 0.0 };    ///< [m]
  ParticleKind Kind = ParticleKind::Flake;
  double Diameter = 0.005;             ///< median [m]
  double Amount = 5.0;                 ///< particles per cubic metre, or in the box
  double Color[3] = { 0.8, 0.8, 0.7 }; ///< 0 to 1
};

/// Why a box cannot be filled, in words for a user; empty if it can. `index` is what it is called by.
std::string WhyInvalid(const ParticleBox& box, int index);

/// Number of particles in a box: the amount itself, or the amount times the volume, rounded.
double NumberIn(const ParticleBox& box, bool amountIsCount);

/// A sea with kinds where they live.
enum class ParticleScene
{
  CoastalSea = 1, ///< some of all
  OpenOcean = 2,  ///< clear: snow, few animals, algae deeper down
  Bloom = 3,      ///< green: algae in the uppermost third
  StormyBed = 4,  ///< brown: sand and silt whirled up
};

inline constexpr int NumberOfParticleScenes = 4;

/// The name of a scene, as users see it.
const char* ParticleSceneName(ParticleScene scene);

/// The boxes of a scene between two corners; the upper one is at the surface, the lower one on the bed.
std::vector<ParticleBox> BoxesOf(ParticleScene scene, const Vector3& lower, const Vector3& upper);

/// A particle, a function of the seed, the number of its box and its own number in it.
struct SuspendedParticle
{
  Vector3 Place;
  double Radius = 0.0; ///< [m]
  std::array<unsigned char, 3> Color{ 0 };
};
SuspendedParticle ParticleOf(const ParticleBox& box, int boxId, long long index, double sizeSpread, int seed);

/// Two directions at a right angle in which a particle's picture lies, uniform over all orientations.
struct PictureAxes
{
  Vector3 Right;
  Vector3 Up;
};
PictureAxes OrientationOf(int boxId, long long index, int seed);

/// Columns and rows of the picture of a particle.
inline constexpr int ParticlePictureSize = 96;

/// Picture of a particle: nearly white where it is lit, to be colored; transparent where it is not.
TextureImage ParticlePicture(ParticleKind kind);

}

#endif
