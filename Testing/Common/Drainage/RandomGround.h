// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTestRandomGround_h
#define LittoralTestRandomGround_h

#include "Numerics/RandomStream.h"
#include "Terrain/GridSamples.h"

#include <cmath>

namespace littoral::testing
{

/// Heights of a function of the position [m].
template <typename Function>
GridSamples Ground(int width, int height, std::array<double, 2> spacing, const Function& heightAt)
{
  GridSamples ground;
  ground.Width = width;
  ground.Height = height;
  ground.Spacing = spacing;
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      ground.Values.push_back(heightAt(i * spacing[0], j * spacing[1]));
    }
  }
  return ground;
}

/// Noise with as many pits as can be; in whole steps, so that there are flats and ties too, if `step` is not 0.
inline GridSamples RandomGround(int width, int height, std::array<double, 2> spacing, int seed, double step = 0.0)
{
  const RandomStream random(seed, RandomPurpose::ElevationLines);
  int n = 0;
  return Ground(width, height, spacing, [&](double x, double) {
    const double value = 10.0 * random.UniformPair(n++, 0)[0] + 0.05 * x;
    return step > 0.0 ? step * std::floor(value / step) : value;
  });
}

}

#endif
