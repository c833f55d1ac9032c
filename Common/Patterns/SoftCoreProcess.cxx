// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/RandomStream.h"
#include "Patterns/ProcessDraws.h"
#include "Patterns/SoftCoreChain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

int SoftCoreSweeps(const PointProcessParameters& process)
{
  const double crowding = process.Intensity * process.Distance * process.Distance;
  return static_cast<int>(std::min(200.0, std::round(20.0 + 400.0 * crowding)));
}

ProcessPattern DrawSoftCore(const ProcessScene& scene)
{
  const PatternArea domain = scene.Box.Grown(StraussMargin(scene.Process));
  SoftCoreChain chain(scene.Process, domain, scene.Options.Seed);
  // The number of points has the intensity as its mean: a fraction is one with its probability.
  const RandomStream counts(scene.Options.Seed, RandomPurpose::ProcessCells);
  const double mean = scene.Process.Intensity * domain.Measure();
  chain.Fill(static_cast<std::size_t>(mean + counts.UniformPair(0, 0)[0]));
  for (int sweep = 0; sweep < SoftCoreSweeps(scene.Process); ++sweep)
  {
    chain.Sweep(sweep);
    scene.Called();
  }
  ProcessPattern pattern;
  for (std::size_t n = 0; n < chain.GetPlaces().size(); ++n)
  {
    const PlanePosition& place = chain.GetPlaces()[n];
    KeepPoint(scene, { domain.Origin[0] + place[0], domain.Origin[1] + place[1] }, { 0, n }, pattern);
  }
  pattern.IsExact = false;
  return pattern;
}

}
