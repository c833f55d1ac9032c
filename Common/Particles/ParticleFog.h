// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralParticleFog_h
#define LittoralParticleFog_h

#include "Numerics/Parallel.h"
#include "Numerics/Vector3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace littoral
{

/// Samples of a fog on a grid, its faces included.
struct FogGrid
{
  Vector3 Origin{ 0.0, 0.0, 0.0 };
  Vector3 Spacing{ 1.0, 1.0, 1.0 };    ///< [m], positive
  std::array<int, 3> Count{ 2, 2, 2 }; ///< samples along x, y, z, 2 or more

  std::size_t NumberOfSamples() const
  {
    return static_cast<std::size_t>(this->Count[0]) * this->Count[1] * this->Count[2];
  }
};

/// Extinction cross section of a particle, and its place.
struct FogParticle
{
  Vector3 Place;
  double CrossSection; ///< [m2]
};

/// Writes the particles [begin, end) to a list; called by several threads.
using FogParticles = std::function<void(std::size_t begin, std::size_t end, FogParticle* particles)>;

/// A particle in a cell of its layer of cells. In single precision, since to write and to read it takes most of the
/// time.
struct LocatedFogParticle
{
  float Values[4];      ///< where in the cell, 0 to 1 along each axis, and the cross section [m2]
  std::uint32_t Sample; ///< the cell's first one in the layer of samples below
};

/// Memory that fogs take in turn: new memory costs as long as to share out the particles in it.
class FogMemory
{
public:
  /// Room for particles, not filled.
  LocatedFogParticle* Take(std::size_t count);

  /// Gives back what is more than for a number of particles.
  void Limit(std::size_t count);

private:
  std::unique_ptr<LocatedFogParticle[]> Particles;
  std::size_t Size = 0;
};

/// Bounds of the places of particles whose sides are no shorter than a thickness [m].
std::array<double, 6> Thickened(const std::array<double, 6>& bounds, double thickness);

/**
 * The extinction [1/m] of particles that cannot be told apart: cross sections by volume (Coulais et al., 3.3.3 draw a
 * texture instead). Each particle is shared out among the eight samples about it, by distance along each axis, so that
 * the integral of the field, linear between samples, is the sum of the cross sections. Particles outside of the grid
 * are left out and counted.
 */
class ParticleFog
{
public:
  ParticleFog(const FogGrid& grid, std::size_t count, const FogParticles& particles, FogMemory& memory,
    const ParallelFor& parallelFor = SerialFor, const Poll& poll = NoPoll);

  /// x fastest [1/m].
  const std::vector<float>& GetExtinction() const { return this->Extinction; }

  long long GetOutside() const { return this->Outside; }

private:
  std::vector<float> Extinction;
  long long Outside = 0;
};

/// Integral of the extinction, linear between samples, over the grid [m2].
double TotalCrossSection(const FogGrid& grid, const std::vector<float>& extinction, const Poll& onRow = NoPoll);

}

#endif
