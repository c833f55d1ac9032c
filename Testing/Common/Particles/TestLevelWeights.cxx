// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Weights of many particles at once are those of each: to the bit, in both precisions, whatever the view.
#include "Particles/LevelWeights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

using namespace littoral;

namespace
{

/// Distances from 0 to 15 m from the eye, in all directions.
template <typename Real>
std::vector<Real> SpreadPlaces(std::size_t count)
{
  std::vector<Real> numbers;
  for (std::size_t n = 0; n < count; ++n)
  {
    const double radius = 15.0 * static_cast<double>(n) / static_cast<double>(count);
    const double turn = 2.4 * static_cast<double>(n);
    for (const double part : { 0.6 * std::cos(turn), 0.6 * std::sin(turn), 0.8 })
    {
      numbers.push_back(static_cast<Real>(radius * part));
    }
  }
  return numbers;
}

template <typename Real>
void ExpectSame(const View& view, const ParticleLevelOptions& options)
{
  const std::size_t count = 203; // no multiple of what is computed side by side
  const std::vector<Real> numbers = SpreadPlaces<Real>(count);
  const PlaceList places(numbers.data(), count);
  const Vector3 way(0.3, -0.1, 0.02);
  for (const ParticleLevel level : { ParticleLevel::Near, ParticleLevel::Middle, ParticleLevel::Far })
  {
    for (const bool areSlaves : { false, true })
    {
      std::vector<float> weights(count, -1.0f);
      WeighAll(level, areSlaves, places, way, view, options, weights.data());
      for (std::size_t n = 0; n < count; ++n)
      {
        const double own = WeightIn(level, areSlaves, LevelDistance(view, way + places[n]), options);
        ASSERT_EQ(weights[n], static_cast<float>(own)) << "at " << n << " in level " << static_cast<int>(level);
      }
    }
  }
}

void ExpectSameInBoth(const View& view, const ParticleLevelOptions& options)
{
  ExpectSame<float>(view, options);
  ExpectSame<double>(view, options);
}

}

TEST(LevelWeights, AreThoseOfEachParticle)
{
  View view;
  view.Point = Vector3(0.2, 0.1, -0.4);
  view.DetailFactor = 1.3;
  ExpectSameInBoth(view, {});
  view.IsParallel = true;
  view.ParallelScale = 3.0;
  ExpectSameInBoth(view, {});
}

TEST(LevelWeights, StepWithoutABandAndAreWholeWithoutLevels)
{
  ParticleLevelOptions options;
  options.BlendDistance = 0.0;
  ExpectSameInBoth({}, options);
  options.UseLevels = false;
  options.BlendDistance = 0.5;
  ExpectSameInBoth({}, options);
}

TEST(LevelWeights, AreTheSmoothStepInTheBand)
{
  const double places[] = { 11.5, 0.0, 0.0, 11.75, 0.0, 0.0, 12.0, 0.0, 0.0, 12.5, 0.0, 0.0 };
  float weights[4];
  WeighAll(ParticleLevel::Far, true, PlaceList(places, 4), Vector3(0.0), {}, {}, weights);
  // t^2 (3 - 2 t) at 0, 1/4, 1/2 and 1
  EXPECT_EQ(std::vector<float>(weights, weights + 4), (std::vector<float>{ 0.0f, 0.15625f, 0.5f, 1.0f }));
}
