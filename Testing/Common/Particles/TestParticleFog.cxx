// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Fog that hides as much as its particles do.
#include "../OnThreads.h"
#include "Numerics/Constants.h"
#include "ParticleScenes.h"
#include "Particles/ParticleFog.h"
#include "Particles/ParticleLevels.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

using namespace littoral;
using namespace littoral::testing;

namespace
{

/// Extinction [1/m] between the samples of a grid, by trilinear interpolation.
double ExtinctionAt(const FogGrid& grid, const std::vector<float>& extinction, const Vector3& place)
{
  const Vector3 index = (place - grid.Origin) / grid.Spacing;
  std::array<int, 3> low;
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = std::clamp(static_cast<int>(std::floor(index[axis])), 0, grid.Count[axis] - 2);
  }
  const Vector3 part = index - Vector3(low[0], low[1], low[2]);
  const auto alongX = [&](int j, int k) {
    const std::size_t first = (static_cast<std::size_t>(k) * grid.Count[1] + j) * grid.Count[0] + low[0];
    return glm::mix<double>(extinction[first], extinction[first + 1], part.x);
  };
  const auto alongY = [&](int k) { return glm::mix(alongX(low[1], k), alongX(low[1] + 1, k), part.y); };
  return glm::mix(alongY(low[2]), alongY(low[2] + 1), part.z);
}

ParticleFog FogOf(
  const FogGrid& grid, const std::vector<FogParticle>& particles, const ParallelFor& parallel = SerialFor)
{
  const auto read = [&particles](std::size_t begin, std::size_t end, FogParticle* to) {
    std::copy(
      particles.begin() + static_cast<std::ptrdiff_t>(begin), particles.begin() + static_cast<std::ptrdiff_t>(end), to);
  };
  FogMemory memory;
  return ParticleFog(grid, particles.size(), read, memory, parallel);
}

}

TEST(ParticleFog, BoundsAreThatThick)
{
  using Bounds = std::array<double, 6>;
  EXPECT_EQ(Thickened({ 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 }, 0.5), (Bounds{ 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 }));
  EXPECT_EQ(Thickened({ 1.0, 4.0, 5.0, 5.0, -2.0, -1.75 }, 0.5), (Bounds{ 1.0, 4.0, 4.75, 5.25, -2.125, -1.625 }));
}

TEST(ParticleFog, KeepsTheSumOfCrossSections)
{
  const FogGrid grid{ { -1.0, 2.0, -3.0 }, { 0.5, 0.25, 1.0 }, { 7, 9, 4 } };
  const std::vector<Vector3> places = Places(5000, { { -1.0, 2.0, -3.0 }, { 2.0, 4.0, 0.0 } });
  std::vector<FogParticle> particles;
  double sum = 0.0;
  for (const Vector3& place : places)
  {
    particles.push_back({ place, 1e-4 * (1.0 + place.x * place.x) });
    sum += particles.back().CrossSection;
  }
  const ParticleFog fog = FogOf(grid, particles);
  EXPECT_EQ(fog.GetOutside(), 0);
  EXPECT_NEAR(TotalCrossSection(grid, fog.GetExtinction()) / sum, 1.0, 1e-6);

  // One particle: the integral of the field about it, and its first moment.
  const FogParticle one{ { 0.13, 3.04, -1.3 }, 2e-3 };
  const ParticleFog alone = FogOf(grid, { one });
  Vector3 moment(0.0);
  for (int k = 0; k < grid.Count[2]; ++k)
  {
    for (int j = 0; j < grid.Count[1]; ++j)
    {
      for (int i = 0; i < grid.Count[0]; ++i)
      {
        const double e = alone.GetExtinction()[(static_cast<std::size_t>(k) * 9 + j) * 7 + i];
        moment += 0.125 * e * (grid.Origin + Vector3(0.5 * i, 0.25 * j, 1.0 * k));
      }
    }
  }
  EXPECT_LT(glm::distance(moment / one.CrossSection, one.Place), 1e-6);

  particles.push_back({ { 2.01, 3.0, -1.0 }, 1.0 });
  const ParticleFog again = FogOf(grid, particles, OnThreads(2));
  EXPECT_EQ(again.GetOutside(), 1);
  EXPECT_EQ(again.GetExtinction(), fog.GetExtinction());
}

// More layers and particles than one thread takes at a time, against a sum over all particles in their order.
TEST(ParticleFog, LayersKeepTheOrderOfTheParticles)
{
  const FogGrid grid{ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, { 3, 3, 21 } };
  const std::vector<Vector3> places = Places(9000, { { -0.1, 0.0, 0.0 }, { 2.0, 2.0, 20.0 } });
  std::vector<FogParticle> particles;
  std::vector<double> below(grid.NumberOfSamples(), 0.0); // of the particles under a sample
  std::vector<double> above(grid.NumberOfSamples(), 0.0);
  long long outside = 0;
  for (const Vector3& p : places)
  {
    particles.push_back({ p, 1e-3 * (1.0 + p.z) });
    if (p.x < 0.0)
    {
      ++outside;
      continue;
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      const int at[3] = { static_cast<int>(p.x) + corner % 2, static_cast<int>(p.y) + corner / 2 % 2,
        static_cast<int>(p.z) + corner / 4 };
      double share = 1.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        share *= 1.0 - std::abs(p[axis] - at[axis]);
      }
      const std::size_t sample = static_cast<std::size_t>((at[2] * 3 + at[1]) * 3 + at[0]);
      (corner / 4 > 0 ? below : above)[sample] += share * particles.back().CrossSection;
    }
  }
  const ParticleFog fog = FogOf(grid, particles);
  EXPECT_EQ(fog.GetOutside(), outside);
  EXPECT_GT(outside, 0);
  EXPECT_EQ(FogOf(grid, particles, OnThreads(3)).GetExtinction(), fog.GetExtinction());
  for (std::size_t n = 0; n < below.size(); ++n)
  {
    const int at[3] = { static_cast<int>(n % 3), static_cast<int>(n / 3 % 3), static_cast<int>(n / 9) };
    const double volume = (at[0] == 1 ? 1.0 : 0.5) * (at[1] == 1 ? 1.0 : 0.5) * (at[2] % 20 > 0 ? 1.0 : 0.5);
    EXPECT_FLOAT_EQ(fog.GetExtinction()[n], static_cast<float>((below[n] + above[n]) / volume));
  }
}

TEST(ParticleFog, MemoryOfFormerFogsDoesNotShow)
{
  const FogGrid grid{ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, { 3, 3, 3 } };
  FogMemory memory;
  for (const int count : { 500, 20, 9000 })
  {
    std::vector<FogParticle> particles;
    for (const Vector3& place : Places(count, { { 0.0, 0.0, 0.0 }, { 2.0, 2.0, 2.0 } }))
    {
      particles.push_back({ place, 1e-3 });
    }
    const auto read = [&particles](std::size_t begin, std::size_t end, FogParticle* to) {
      std::copy(particles.data() + begin, particles.data() + end, to);
    };
    EXPECT_EQ(
      ParticleFog(grid, particles.size(), read, memory).GetExtinction(), FogOf(grid, particles).GetExtinction());
    memory.Limit(400);
  }
}

TEST(ParticleFog, SpreadsParticlesOverTheVolumeOfTheirSample)
{
  // On a sample, its cross section over the part of the cells around that is in the grid.
  const FogGrid grid{ { 0.0, 0.0, 0.0 }, { 0.5, 0.25, 1.0 }, { 5, 5, 5 } };
  for (int faces = 0; faces <= 3; ++faces)
  {
    const int i = faces > 0 ? 0 : 2;
    const int j = faces > 1 ? 4 : 2;
    const int k = faces > 2 ? 4 : 2;
    const ParticleFog fog = FogOf(grid, { { { 0.5 * i, 0.25 * j, 1.0 * k }, 2e-3 } });
    const double volume = 0.125 * std::pow(0.5, faces);
    EXPECT_NEAR(fog.GetExtinction()[(static_cast<std::size_t>(k) * 5 + j) * 5 + i] * volume, 2e-3, 1e-9);
  }
}

namespace
{

constexpr int Rays = 160; // a side

/// Place of a ray along x or z [m].
double RayAt(int index)
{
  const double from = 0.2;
  const double step = 3.6 / Rays;
  return from + (index + 0.5) * step;
}

/// Particles of a radius that each ray along y meets.
std::vector<std::vector<int>> ParticlesOfRays(const std::vector<Vector3>& places, double radius)
{
  std::vector<std::vector<int>> columns(Rays * Rays);
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    for (int i = 0; i < Rays; ++i)
    {
      const double x = RayAt(i);
      if (std::abs(places[n].x - x) > radius)
      {
        continue;
      }
      for (int j = 0; j < Rays; ++j)
      {
        const double z = RayAt(j);
        if (std::hypot(places[n].x - x, places[n].z - z) <= radius)
        {
          columns[i * Rays + j].push_back(static_cast<int>(n));
        }
      }
    }
  }
  return columns;
}

}

TEST(ParticleFog, HidesAsMuchAsItsParticlesDo)
{
  // Light along y through a box of particles: the part of rays that meet none, against the fog. Some particles are
  // drawn in part, as where levels change: drawn and fog together must hide as much.
  const Box box{ { 0.0, 0.0, 0.0 }, { 4.0, 10.0, 4.0 } };
  const double diameter = 0.04;
  const double section = 0.25 * Pi * diameter * diameter;
  const std::vector<Vector3> places = Places(9000, box, 5);
  const FogGrid grid{ box.Low, { 0.2, 0.2, 0.2 }, { 21, 51, 21 } };
  ParticleLevelOptions options;
  options.FarDistance = 5.0;
  options.BlendDistance = 2.0;
  std::vector<FogParticle> particles;
  for (const Vector3& place : places)
  {
    particles.push_back({ place, section * WeightsAt(place.y, options).Far });
  }
  std::vector<FogParticle> all = particles;
  for (FogParticle& particle : all)
  {
    particle.CrossSection = section;
  }
  const std::vector<float> blended = FogOf(grid, particles).GetExtinction();
  const std::vector<float> whole = FogOf(grid, all).GetExtinction();

  double drawn = 0.0;
  double fog = 0.0;
  double both = 0.0;
  const std::vector<std::vector<int>> columns = ParticlesOfRays(places, 0.5 * diameter);
  for (int i = 0; i < Rays; ++i)
  {
    for (int j = 0; j < Rays; ++j)
    {
      const double x = RayAt(i);
      const double z = RayAt(j);
      double depth = 0.0;
      double depthBlended = 0.0;
      for (double y = 0.05; y < 10.0; y += 0.1)
      {
        depth += 0.1 * ExtinctionAt(grid, whole, { x, y, z });
        depthBlended += 0.1 * ExtinctionAt(grid, blended, { x, y, z });
      }
      double through = 1.0;
      for (const int particle : columns[i * Rays + j])
      {
        through *= 1.0 - (1.0 - WeightsAt(places[particle].y, options).Far);
      }
      drawn += columns[i * Rays + j].empty();
      fog += std::exp(-depth);
      both += through * std::exp(-depthBlended);
    }
  }
  drawn /= Rays * Rays;
  fog /= Rays * Rays;
  both /= Rays * Rays;
  std::printf("transmittance: particles %.4f, fog %.4f, half and half %.4f, uniform %.4f\n", drawn, fog, both,
    std::exp(-9000.0 / 160.0 * section * 10.0));
  EXPECT_LT(drawn, 0.7);
  EXPECT_NEAR(fog / drawn, 1.0, 0.05);
  EXPECT_NEAR(both / drawn, 1.0, 0.05);
}
