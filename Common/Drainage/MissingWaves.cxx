// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/MissingWaves.h"

#include "Numerics/RandomStream.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace littoral
{

namespace
{

/// Minimum power of a ring over the wanted one, below which waves are added.
constexpr double MinimumPowerFraction = 0.1;

/// Standard deviations of the coefficients that each ring lacks; 0 where it has enough.
std::vector<double> MissingSizes(const RingSpectrum& spectrum, const RingSpectrum& wanted, double cellArea)
{
  std::vector<double> sizes(spectrum.Power.size(), 0.0);
  for (std::size_t ring = 1; ring < sizes.size(); ++ring)
  {
    const double power = spectrum.Power[ring];
    const double full = wanted.At(static_cast<double>(ring) * spectrum.Step);
    sizes[ring] = power < MinimumPowerFraction * full ? std::sqrt((full - power) / cellArea) : 0.0;
  }
  return sizes;
}

}

void AddMissingWaves(
  GridSamples& terrain, const RingSpectrum& wanted, int seed, const ParallelFor& parallel, const Poll& poll)
{
  GridSamples field = CopyOf(terrain, poll);
  RemovePlane(field, poll);
  CosineTransform(field, parallel);
  const RingSpectrum spectrum = SpectrumOfCoefficients(field, parallel);
  const std::vector<double> sizes = MissingSizes(spectrum, wanted, terrain.Spacing[0] * terrain.Spacing[1]);
  if (std::all_of(sizes.begin(), sizes.end(), [](double size) { return size == 0.0; }))
  {
    return;
  }
  const RandomStream random(seed, RandomPurpose::DrainageWaves);
  parallel(field.Values.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      field.Values[n] = random.NormalPair(n, 0)[0];
    }
  });
  MultiplyRings(field, spectrum.Step, sizes, parallel);
  InverseCosineTransform(field, parallel);
  parallel(field.Values.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      terrain.Values[n] += field.Values[n];
    }
  });
}

}
