// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Particles/LevelWeights.h"

#include "Numerics/SimdClones.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

/// A weight as one + middle * m + far * f, of the blends m and f beyond both distances.
struct WeightRule
{
  Vector3 Way;
  Vector3 Eye;
  double Detail;
  double Middle; ///< [m]
  double Far;    ///< [m]
  double Width;  ///< [m]
  double Parts[3];
};

WeightRule RuleOf(
  ParticleLevel level, bool areSlaves, const Vector3& way, const View& view, const ParticleLevelOptions& options)
{
  WeightRule rule{ way, view.Point, view.DetailFactor, options.MiddleDistance, options.FarDistance,
    options.BlendDistance, { 1.0, 0.0, -1.0 } };
  const double ofFar[3] = { 0.0, 0.0, 1.0 };
  const double ofNear[3] = { 1.0, -1.0, 0.0 };
  const double ofMiddle[3] = { 0.0, 1.0, -1.0 };
  const double* parts = level == ParticleLevel::Far ? ofFar : level == ParticleLevel::Near ? ofNear : ofMiddle;
  if (areSlaves || level == ParticleLevel::Far)
  {
    std::copy_n(parts, 3, rule.Parts);
  }
  return rule;
}

/// BlendAt(): t^2 (3 - 2 t), t = (x / width + 1) / 2, from 0 to 1.
LITTORAL_INLINE double Blend(double x, double width)
{
  const double t = std::min(std::max(0.5 * (x / width + 1.0), 0.0), 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Weights, without the blends whose part is 0: to compute these takes most of the time.
template <bool HasMiddle, bool HasFar, typename Real>
LITTORAL_INLINE void WeighParts(const WeightRule& rule, const Real* places, std::size_t count, float* weights)
{
  LITTORAL_INDEPENDENT
  for (std::size_t n = 0; n < count; ++n)
  {
    const double x = rule.Way.x + static_cast<double>(places[3 * n]) - rule.Eye.x;
    const double y = rule.Way.y + static_cast<double>(places[3 * n + 1]) - rule.Eye.y;
    const double z = rule.Way.z + static_cast<double>(places[3 * n + 2]) - rule.Eye.z;
    const double distance = std::sqrt(x * x + y * y + z * z) / rule.Detail;
    const double middle = HasMiddle ? Blend(distance - rule.Middle, rule.Width) : 0.0;
    const double far = HasFar ? Blend(distance - rule.Far, rule.Width) : 0.0;
    weights[n] = static_cast<float>(rule.Parts[0] + rule.Parts[1] * middle + rule.Parts[2] * far);
  }
}

template <typename Real>
LITTORAL_INLINE void Weigh(const WeightRule& rule, const Real* places, std::size_t count, float* weights)
{
  if (rule.Parts[1] == 0.0)
  {
    WeighParts<false, true>(rule, places, count, weights);
  }
  else if (rule.Parts[2] == 0.0)
  {
    WeighParts<true, false>(rule, places, count, weights);
  }
  else
  {
    WeighParts<true, true>(rule, places, count, weights);
  }
}

LITTORAL_WIDE_SIMD_CLONES void WeighSingles(
  const WeightRule& rule, const float* places, std::size_t count, float* weights)
{
  Weigh(rule, places, count, weights);
}

LITTORAL_WIDE_SIMD_CLONES void WeighDoubles(
  const WeightRule& rule, const double* places, std::size_t count, float* weights)
{
  Weigh(rule, places, count, weights);
}

}

void WeighAll(ParticleLevel level, bool areSlaves, const PlaceList& places, const Vector3& way, const View& view,
  const ParticleLevelOptions& options, float* weights)
{
  if (view.IsParallel || !options.UseLevels || !(options.BlendDistance > 0.0))
  {
    for (std::size_t n = 0; n < places.Size(); ++n)
    {
      const double distance = LevelDistance(view, way + places[n]);
      weights[n] = static_cast<float>(WeightIn(level, areSlaves, distance, options));
    }
    return;
  }
  const WeightRule rule = RuleOf(level, areSlaves, way, view, options);
  places.GetSingles() ? WeighSingles(rule, places.GetSingles(), places.Size(), weights)
                      : WeighDoubles(rule, places.GetDoubles(), places.Size(), weights);
}

}
