// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Particles/ParticleMotion.h"

#include "Numerics/SimdClones.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace littoral
{

namespace
{

/// Particles that a thread compares at a time.
constexpr std::size_t ParticlesAtOnce = 1 << 18;
/// Numbers that are compared side by side: eight particles.
constexpr std::size_t Lanes = 24;

/// Sums and bounds of some particles, by lanes, of which each third one belongs to the same axis.
struct Compared
{
  double Low[Lanes];
  double High[Lanes];
  double Sum[Lanes];    ///< of coordinates
  double Checks[Lanes]; ///< no number as soon as a coordinate is none

  Compared()
  {
    std::fill_n(this->Low, Lanes, std::numeric_limits<double>::infinity());
    std::fill_n(this->High, Lanes, -std::numeric_limits<double>::infinity());
    std::fill_n(this->Sum, Lanes, 0.0);
    std::fill_n(this->Checks, Lanes, 0.0);
  }
};

template <typename From, typename To>
LITTORAL_INLINE void CompareLane(const From* from, const To* to, std::size_t lane, Compared& all)
{
  const double now = static_cast<double>(to[lane]);
  const double way = now - static_cast<double>(from[lane]);
  all.Low[lane] = way < all.Low[lane] ? way : all.Low[lane];
  all.High[lane] = way > all.High[lane] ? way : all.High[lane];
  all.Sum[lane] += now;
  all.Checks[lane] += way - way; // NOLINT(misc-redundant-expression): NaN where it is not finite
}

template <typename From, typename To>
LITTORAL_INLINE void CompareAll(const From* from, const To* to, std::size_t numbers, Compared& all)
{
  std::size_t next = 0;
  for (; next + Lanes <= numbers; next += Lanes)
  {
    for (std::size_t lane = 0; lane < Lanes; ++lane)
    {
      CompareLane(from + next, to + next, lane, all);
    }
  }
  for (std::size_t lane = 0; next + lane < numbers; ++lane)
  {
    CompareLane(from + next, to + next, lane, all);
  }
}

LITTORAL_WIDE_SIMD_CLONES void CompareSingles(const float* from, const float* to, std::size_t numbers, Compared& all)
{
  CompareAll(from, to, numbers, all);
}

LITTORAL_WIDE_SIMD_CLONES void CompareDoubles(const double* from, const double* to, std::size_t numbers, Compared& all)
{
  CompareAll(from, to, numbers, all);
}

void CompareMixed(const PlaceList& from, const PlaceList& to, std::size_t begin, std::size_t end, Compared& all)
{
  for (std::size_t n = begin; n < end; ++n)
  {
    const Vector3 before = from[n];
    const Vector3 now = to[n];
    CompareAll(&before.x, &now.x, 3, all);
  }
}

Compared Compare(const PlaceList& from, const PlaceList& to, std::size_t begin, std::size_t end)
{
  Compared all;
  if (from.GetSingles() && to.GetSingles())
  {
    CompareSingles(from.GetSingles() + 3 * begin, to.GetSingles() + 3 * begin, 3 * (end - begin), all);
  }
  else if (from.GetDoubles() && to.GetDoubles())
  {
    CompareDoubles(from.GetDoubles() + 3 * begin, to.GetDoubles() + 3 * begin, 3 * (end - begin), all);
  }
  else
  {
    CompareMixed(from, to, begin, end, all);
  }
  return all;
}

}

double ParticleMotion::Spread() const
{
  const Vector3 size = this->Shift.High - this->Shift.Low;
  return std::max({ size.x, size.y, size.z });
}

ParticleMotion MotionOf(const PlaceList& from, const PlaceList& to, const ParallelFor& parallelFor)
{
  std::vector<Compared> parts((to.Size() + ParticlesAtOnce - 1) / ParticlesAtOnce);
  ForRanges(parallelFor, to.Size(), ParticlesAtOnce,
    [&](std::size_t begin, std::size_t end) { parts[begin / ParticlesAtOnce] = Compare(from, to, begin, end); });
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ParticleMotion motion;
  motion.Shift = { Vector3(infinity), Vector3(-infinity) };
  double checks = 0.0;
  for (const Compared& part : parts)
  {
    for (std::size_t lane = 0; lane < Lanes; ++lane)
    {
      const int axis = static_cast<int>(lane % 3);
      motion.Shift.Low[axis] = std::min(motion.Shift.Low[axis], part.Low[lane]);
      motion.Shift.High[axis] = std::max(motion.Shift.High[axis], part.High[lane]);
      motion.MeanHeight += axis == 2 ? part.Sum[lane] / static_cast<double>(to.Size()) : 0.0;
      checks += part.Checks[lane];
    }
  }
  motion.IsFinite = checks == 0.0;
  return motion;
}

ParticleMotion Shifted(const ParticleMotion& motion, const Vector3& way, const Box& box)
{
  ParticleMotion shifted = motion;
  shifted.MeanHeight += way.z;
  for (int axis = 0; axis < 3; ++axis)
  {
    // A sum of single precision is rounded by at most 2^-24 of itself.
    const double largest = std::max(std::abs(box.Low[axis]), std::abs(box.High[axis])) + std::abs(way[axis]);
    const double rounding = way[axis] == 0.0 ? 0.0 : 0x1p-24 * largest;
    shifted.Shift.Low[axis] += way[axis] - rounding;
    shifted.Shift.High[axis] += way[axis] + rounding;
  }
  return shifted;
}

}
