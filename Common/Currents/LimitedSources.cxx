// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/LimitedSources.h"

#include "Numerics/SimdDouble4.h"

#include <algorithm>

namespace littoral
{

namespace
{

using Source = LimitedSources::Source;

/// A number of four sources, a lane each.
template <typename Number>
LITTORAL_INLINE SimdDouble4 Lanes(const Source* const sources[LaneCount], const Number& number)
{
  return { number(*sources[0]), number(*sources[1]), number(*sources[2]), number(*sources[3]) };
}

/// Distance of a place beyond the ends of the boxes along an axis; 0 within.
LITTORAL_INLINE SimdDouble4 Beyond(const Source* const sources[LaneCount], int axis, const SimdDouble4& place)
{
  const SimdDouble4 below = Lanes(sources, [axis](const Source& one) { return one.Whole.Low[axis]; }) - place;
  const SimdDouble4 above = place - Lanes(sources, [axis](const Source& one) { return one.Whole.High[axis]; });
  return Max(Max(below, above), SimdDouble4(0.0));
}

LITTORAL_SIMD_CLONES void AddFlowOf(
  const Source* all, const int* begin, const int* end, const double place[3], double sum[3])
{
  const SimdDouble4 x(place[0]);
  const SimdDouble4 y(place[1]);
  const SimdDouble4 z(place[2]);
  for (const int* first = begin; first < end; first += LaneCount)
  {
    const auto count = static_cast<int>(std::min<std::ptrdiff_t>(LaneCount, end - first));
    const Source* sources[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      sources[lane] = all + first[std::min(lane, count - 1)];
    }
    // (1 - (d / margin)^2)^2 at a distance d from the box
    const SimdDouble4 awayX = Beyond(sources, 0, x);
    const SimdDouble4 awayY = Beyond(sources, 1, y);
    const SimdDouble4 awayZ = Beyond(sources, 2, z);
    const SimdDouble4 squaredAway = awayX * awayX + awayY * awayY + awayZ * awayZ;
    const SimdDouble4 inverseMargin = Lanes(sources, [](const Source& one) { return one.InverseMargin; });
    const SimdDouble4 inside = Max(SimdDouble4(0.0), SimdDouble4(1.0) - squaredAway * inverseMargin);
    const SimdDouble4 share = inside * inside;
    // Q R / (4 pi (R^2 + e^2)^(3/2))
    const SimdDouble4 armX = x - Lanes(sources, [](const Source& one) { return one.Center.x; });
    const SimdDouble4 armY = y - Lanes(sources, [](const Source& one) { return one.Center.y; });
    const SimdDouble4 armZ = z - Lanes(sources, [](const Source& one) { return one.Center.z; });
    const SimdDouble4 softened =
      armX * armX + armY * armY + armZ * armZ + Lanes(sources, [](const Source& one) { return one.CoreSquared; });
    const SimdDouble4 factor = share * Lanes(sources, [](const Source& one) { return one.Factor; });
    const SimdDouble4 over = factor / (softened * Sqrt(softened));
    const SimdDouble4 flow[3] = { over * armX, over * armY, over * armZ };
    for (int lane = 0; lane < count; ++lane)
    {
      if (share.Values[lane] > 0.0)
      {
        sum[0] += flow[0].Values[lane];
        sum[1] += flow[1].Values[lane];
        sum[2] += flow[2].Values[lane];
      }
    }
  }
}

}

void LimitedSources::AddFlow(const int* begin, const int* end, const Vector3& place, Vector3& sum) const
{
  AddFlowOf(this->Sources.data(), begin, end, &place.x, &sum.x);
}

}
