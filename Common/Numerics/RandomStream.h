// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRandomStream_h
#define LittoralRandomStream_h

#include <array>
#include <cstddef>
#include <cstdint>

namespace littoral
{

/// Purposes of random numbers. Two purposes never share a number, so that a new draw in one place leaves every other
/// place as it was. Values are part of the results: never renumber them.
enum class RandomPurpose : std::uint32_t
{
  ElevationLines = 1,
  ReflectanceLines = 2,
  QuadratCounts = 3,
  QuadratOrder = 4,
  QuadratPositions = 5,
  SimulationSeeds = 13,
  UniformPoints = 14,
  MarkOrder = 15,
  TreeBranches = 16,
  TreeLeaves = 17,
  ForkBranches = 18,
  ForkLeaves = 19,
  GardnerQuadrics = 20,
  PlantSpecies = 21,
  PlantScale = 22,
  PlantAzimuth = 23,
  PlantTint = 24,
  CrownJitter = 25,
  CrownCards = 26,
  LeafTufts = 27,
  GrassBlades = 28,
  WindAlong = 32,
  WindAcross = 33,
  WindUp = 34,
  LeafFlutter = 40,
  WaveDirections = 48,
  WavePhases = 49,
  RippleWaves = 50,
  SeaweedFronds = 52,
  SeaweedBlades = 53,
  ParticlePositions = 64,
  ParticleSizes = 65,
  ParticleOrientations = 66,
  SlaveOffsets = 72,
  DatumShortWaves = 76,
  DatumErrors = 77,
  DrainageWaves = 80,
  LandscapePoints = 81,
  LandscapeRoughness = 82,
  LandscapePieces = 83,
  LandscapeChannels = 84,
  StandDiameters = 90,
  StandHeights = 91,
  SitePreferences = 92,
  ProcessCells = 96,
  ProcessParents = 97,
  ProcessClusters = 98,
  ProcessPoints = 99,
  ProcessThinning = 100,
  ProcessBirths = 101,
  ProcessLives = 102,
  ProcessField = 103,
  ProcessSpecies = 104,
  ProcessMarks = 105,
  ProcessMoves = 106,
  ProcessChances = 107,
};

/**
 * Counter-based random numbers (Philox 4x32-10, Salmon et al. 2011). A number is a pure function of the user's seed,
 * the purpose, the object it belongs to (a line, a plant, a particle) and the index of the draw: there is no state,
 * hence the same numbers for any thread, rank, order or part of the domain.
 */
class RandomStream
{
public:
  RandomStream(int seed, RandomPurpose purpose)
    : Key{ static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(purpose) }
  {
  }

  /// Four independent 32-bit words.
  std::array<std::uint32_t, 4> Words(std::uint64_t object, std::uint64_t draw) const;

  /// The words of draws draw, draw + 1, ... draw + count - 1 one after the other, several draws at a time.
  void FillWords(std::uint64_t object, std::uint64_t draw, std::size_t count, std::uint32_t* words) const;

  /// Two independent numbers, uniform on the open interval (0, 1), with 52 random bits each.
  std::array<double, 2> UniformPair(std::uint64_t object, std::uint64_t draw) const;

  /// The numbers of UniformPair() for many objects and draws, several side by side.
  void UniformPairs(
    std::size_t count, const std::uint64_t* objects, const std::uint64_t* draws, double* first, double* second) const;

  /// Two independent standard normal numbers (Box-Muller, so that no standard library has a say).
  std::array<double, 2> NormalPair(std::uint64_t object, std::uint64_t draw) const;

private:
  void FillBits(std::size_t count, const std::uint64_t* objects, const std::uint64_t* draws, std::uint64_t* first,
    std::uint64_t* second) const;

  std::array<std::uint32_t, 2> Key;
};

}

#endif
