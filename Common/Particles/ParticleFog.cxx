// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Particles/ParticleFog.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace littoral
{

namespace
{

/// The cell of a place, and where in it, 0 to 1 along each axis.
struct Location
{
  std::array<int, 3> Cell;
  Vector3 Part;
};

/// False for places outside of the grid.
bool Locate(const FogGrid& grid, const Vector3& place, Location& location)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double x = (place[axis] - grid.Origin[axis]) / grid.Spacing[axis];
    const int last = grid.Count[axis] - 1;
    // The faces belong to the grid, with the rounding of the places on them.
    constexpr double tolerance = 1e-9;
    if (!(x >= -tolerance && x <= last + tolerance))
    {
      return false;
    }
    location.Cell[axis] = std::clamp(static_cast<int>(x), 0, last - 1);
    location.Part[axis] = std::clamp(x - location.Cell[axis], 0.0, 1.0);
  }
  return true;
}

/// The volume that a sample stands for: less on the faces of the grid.
double VolumeOf(const FogGrid& grid, int i, int j, int k)
{
  const int index[3] = { i, j, k };
  double volume = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool onFace = index[axis] == 0 || index[axis] == grid.Count[axis] - 1;
    volume *= grid.Spacing[axis] * (onFace ? 0.5 : 1.0);
  }
  return volume;
}

std::size_t SampleOf(const FogGrid& grid, int i, int j, int k)
{
  return (static_cast<std::size_t>(k) * grid.Count[1] + j) * grid.Count[0] + i;
}

/// A particle and its location.
struct Located
{
  Location Where;
  double CrossSection;
};

/// Particles that one thread locates at a time.
constexpr std::size_t ParticlesAtOnce = 1 << 14;

/// Some of the particles by layer of cells, in their order.
struct Run
{
  std::vector<std::vector<Located>> Layers;
  long long Outside = 0;
};

/// The particles in runs, one after the other.
std::vector<Run> RunsOf(const FogGrid& grid, const std::vector<FogParticle>& particles, const ParallelFor& parallelFor)
{
  std::vector<Run> runs((particles.size() + ParticlesAtOnce - 1) / ParticlesAtOnce);
  parallelFor(runs.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t run = first; run < last; ++run)
    {
      runs[run].Layers.resize(grid.Count[2] - 1);
      const std::size_t end = std::min(particles.size(), (run + 1) * ParticlesAtOnce);
      for (std::size_t n = run * ParticlesAtOnce; n < end; ++n)
      {
        Location where;
        if (Locate(grid, particles[n].Place, where))
        {
          runs[run].Layers[where.Cell[2]].push_back({ where, particles[n].CrossSection });
        }
        else
        {
          ++runs[run].Outside;
        }
      }
    }
  });
  return runs;
}

/// Adds to the samples of a layer what the particles of the cells above (side 0) or below (side 1) give to it.
void AddLayer(const FogGrid& grid, const std::vector<Located>& particles, int side, std::vector<double>& layer)
{
  for (const Located& particle : particles)
  {
    const Vector3& part = particle.Where.Part;
    const double up = side == 0 ? 1.0 - part.z : part.z;
    for (int corner = 0; corner < 4; ++corner)
    {
      const int i = corner & 1;
      const int j = corner >> 1;
      // Trilinear weight of a particle at a sample
      const double weight = (i == 0 ? 1.0 - part.x : part.x) * (j == 0 ? 1.0 - part.y : part.y) * up;
      const std::size_t sample =
        static_cast<std::size_t>(particle.Where.Cell[1] + j) * grid.Count[0] + particle.Where.Cell[0] + i;
      layer[sample] += weight * particle.CrossSection;
    }
  }
}

}

std::array<double, 6> BoundsOf(const std::vector<FogParticle>& particles, double thickness)
{
  std::array<double, 6> bounds;
  for (int axis = 0; axis < 3; ++axis)
  {
    double low = particles.empty() ? 0.0 : std::numeric_limits<double>::infinity();
    double high = particles.empty() ? 1.0 : -low;
    for (const FogParticle& particle : particles)
    {
      low = std::min(low, particle.Place[axis]);
      high = std::max(high, particle.Place[axis]);
    }
    const double missing = std::max(0.0, thickness - (high - low));
    bounds[2 * axis] = low - 0.5 * missing;
    bounds[2 * axis + 1] = high + 0.5 * missing;
  }
  return bounds;
}

ParticleFog::ParticleFog(
  const FogGrid& grid, const std::vector<FogParticle>& particles, const ParallelFor& parallelFor, const Poll& poll)
  : Extinction(grid.NumberOfSamples(), 0.0f)
{
  // Layers of cells keep the order of the particles; a layer of samples adds the cells below, then those above. So the
  // order of sums is that of the particles, on any threads.
  poll();
  const std::vector<Run> runs = RunsOf(grid, particles, parallelFor);
  for (const Run& run : runs)
  {
    this->Outside += run.Outside;
  }
  parallelFor(static_cast<std::size_t>(grid.Count[2]), [&](std::size_t begin, std::size_t end) {
    std::vector<double> layer(static_cast<std::size_t>(grid.Count[0]) * grid.Count[1]);
    for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k)
    {
      std::fill(layer.begin(), layer.end(), 0.0);
      for (std::size_t run = 0; k > 0 && run < runs.size(); ++run)
      {
        AddLayer(grid, runs[run].Layers[k - 1], 1, layer);
      }
      for (std::size_t run = 0; k < grid.Count[2] - 1 && run < runs.size(); ++run)
      {
        AddLayer(grid, runs[run].Layers[k], 0, layer);
      }
      for (int j = 0; j < grid.Count[1]; ++j)
      {
        for (int i = 0; i < grid.Count[0]; ++i)
        {
          // sigma = sum of w C / V [1/m]: weights w, cross sections C, volume V of the sample
          const double section = layer[static_cast<std::size_t>(j) * grid.Count[0] + i];
          this->Extinction[SampleOf(grid, i, j, k)] = static_cast<float>(section / VolumeOf(grid, i, j, k));
        }
      }
    }
  });
}

double TotalCrossSection(const FogGrid& grid, const std::vector<float>& extinction, const Poll& onRow)
{
  double total = 0.0;
  for (int k = 0; k < grid.Count[2]; ++k)
  {
    for (int j = 0; j < grid.Count[1]; ++j)
    {
      onRow();
      for (int i = 0; i < grid.Count[0]; ++i)
      {
        total += VolumeOf(grid, i, j, k) * extinction[SampleOf(grid, i, j, k)];
      }
    }
  }
  return total;
}

}
