// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/CoarseGround.h"

#include "Drainage/RingSpectrum.h"
#include "Numerics/PolledMemory.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

int HalfOf(int cells)
{
  return (cells + 1) / 2;
}

/// Puts the waves that both grids have into another of the same area: of orthonormal transforms c' = c sqrt(N' / N).
void CopyWaves(const GridSamples& from, GridSamples& to, const Poll& poll)
{
  const double scale = std::sqrt(static_cast<double>(to.Values.size()) / static_cast<double>(from.Values.size()));
  for (int j = 0; j < std::min(from.Height, to.Height); ++j)
  {
    poll();
    for (int i = 0; i < std::min(from.Width, to.Width); ++i)
    {
      to.At(i, j) = scale * from.At(i, j);
    }
  }
}

/// Cells of the coarse grid that cover a cell of a mask; an empty mask stays so.
OutletMask CoarseMask(const OutletMask& mask, const GridSamples& ground)
{
  const int width = HalfOf(ground.Width);
  const int height = HalfOf(ground.Height);
  OutletMask coarse(mask.empty() ? 0 : static_cast<std::size_t>(width) * height, 0);
  for (std::size_t cell = 0; cell < mask.size(); ++cell)
  {
    // the coarse cell in which the middle of the cell lies
    const auto i = static_cast<std::size_t>((2 * (cell % ground.Width) + 1) * width / (2 * ground.Width));
    const auto j = static_cast<std::size_t>((2 * (cell / ground.Width) + 1) * height / (2 * ground.Height));
    coarse[j * width + i] = mask[cell] ? 1 : coarse[j * width + i];
  }
  return coarse;
}

}

GridSamples CoarseGround(const GridSamples& ground, const ParallelFor& parallel, const Poll& poll)
{
  GridSamples field = CopyOf(ground, poll);
  const PlaneTrend plane = RemovePlane(field, poll);
  CosineTransform(field, parallel);
  GridSamples coarse;
  coarse.Width = HalfOf(ground.Width);
  coarse.Height = HalfOf(ground.Height);
  coarse.Spacing = { ground.Spacing[0] * ground.Width / coarse.Width,
    ground.Spacing[1] * ground.Height / coarse.Height };
  coarse.Values.resize(static_cast<std::size_t>(coarse.Width) * coarse.Height);
  CopyWaves(field, coarse, poll);
  InverseCosineTransform(coarse, parallel);
  AddPlane(coarse, plane, parallel);
  return coarse;
}

void TakeLongWaves(GridSamples& ground, const GridSamples& coarse, const ParallelFor& parallel, const Poll& poll)
{
  // Changes of the plane are added as a plane, those of the rest as waves.
  GridSamples before = CoarseGround(ground, parallel, poll);
  GridSamples waves = coarse;
  PlaneTrend plane = RemovePlane(waves, poll);
  const PlaneTrend old = RemovePlane(before, poll);
  plane.Mean -= old.Mean;
  plane.Slope = { plane.Slope[0] - old.Slope[0], plane.Slope[1] - old.Slope[1] };
  parallel(waves.Values.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      waves.Values[n] -= before.Values[n];
    }
  });
  CosineTransform(waves, parallel);
  GridSamples change{ ground.Width, ground.Height, ground.Spacing, {} };
  Lengthen(change.Values, ground.Values.size(), poll);
  CopyWaves(waves, change, poll);
  InverseCosineTransform(change, parallel);
  AddPlane(change, plane, parallel);
  parallel(ground.Values.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      ground.Values[n] += change.Values[n];
    }
  });
}

DrainageOutlets CoarseOutlets(const DrainageOutlets& outlets, const GridSamples& ground)
{
  DrainageOutlets coarse = outlets;
  coarse.Cells = CoarseMask(outlets.Cells, ground);
  coarse.Outside = CoarseMask(outlets.Outside, ground);
  return coarse;
}

}
