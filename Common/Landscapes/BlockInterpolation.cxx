// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/BlockInterpolation.h"

#include "Landscapes/LongWaves.h"
#include "Numerics/PolledMemory.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace littoral
{

namespace
{

/// Weights of four neighbours, the first at `First`, for a place between the middles of cells.
struct CubicWeights
{
  int First;
  std::array<double, 4> Weight;
};

CubicWeights WeightsAt(double place)
{
  const double below = std::floor(place);
  const double t = place - below;
  const double tt = t * t;
  const double ttt = tt * t;
  return { static_cast<int>(below) - 1,
    { 0.5 * (-ttt + 2.0 * tt - t), 0.5 * (3.0 * ttt - 5.0 * tt + 2.0), 0.5 * (-3.0 * ttt + 4.0 * tt + t),
      0.5 * (ttt - tt) } };
}

/// Weights at the middles of all fine cells along an axis.
std::vector<CubicWeights> WeightsAlong(int coarse, int factor)
{
  std::vector<CubicWeights> weights;
  for (int n = 0; n < coarse * factor; ++n)
  {
    weights.push_back(WeightsAt((n + 0.5) / factor - 0.5));
  }
  return weights;
}

/// sum w_k v(n + k), v beyond the edge by reflection in the point there.
template <typename Values>
double Interpolated(const CubicWeights& weights, int count, const Values& at)
{
  double sum = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    const int n = weights.First + k;
    const int last = count - 1;
    const double value = n < 0 ? 2.0 * at(0) - at(std::min(-n, last))
      : n > last               ? 2.0 * at(last) - at(std::max(2 * last - n, 0))
                               : at(n);
    sum += weights.Weight[k] * value;
  }
  return sum;
}

}

GridSamples CubicRefinement(const GridSamples& coarse, int factor, const ParallelFor& parallel, const Poll& poll)
{
  const std::vector<CubicWeights> across = WeightsAlong(coarse.Width, factor);
  const std::vector<CubicWeights> along = WeightsAlong(coarse.Height, factor);
  GridSamples rows;
  rows.Width = coarse.Width * factor;
  rows.Height = coarse.Height;
  Lengthen(rows.Values, static_cast<std::size_t>(rows.Width) * rows.Height, poll);
  parallel(static_cast<std::size_t>(rows.Height), [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
    {
      for (int i = 0; i < rows.Width; ++i)
      {
        rows.At(i, j) = Interpolated(across[i], coarse.Width, [&](int n) { return coarse.At(n, j); });
      }
    }
  });
  GridSamples fine;
  fine.Width = rows.Width;
  fine.Height = coarse.Height * factor;
  fine.Spacing = { coarse.Spacing[0] / factor, coarse.Spacing[1] / factor };
  Lengthen(fine.Values, static_cast<std::size_t>(fine.Width) * fine.Height, poll);
  parallel(static_cast<std::size_t>(fine.Height), [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
    {
      for (int i = 0; i < fine.Width; ++i)
      {
        fine.At(i, j) = Interpolated(along[j], rows.Height, [&](int n) { return rows.At(i, n); });
      }
    }
  });
  return fine;
}

void HoldBlockMeans(
  GridSamples& fine, const GridSamples& coarse, int factor, int passes, const ParallelFor& parallel, const Poll& poll)
{
  for (int pass = 0; pass < passes; ++pass)
  {
    GridSamples missing = BlockMeans(fine, factor, poll);
    for (std::size_t n = 0; n < missing.Values.size(); ++n)
    {
      missing.Values[n] = coarse.Values[n] - missing.Values[n];
    }
    const GridSamples change = CubicRefinement(missing, factor, parallel, poll);
    poll();
    parallel(fine.Values.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        fine.Values[n] += change.Values[n];
      }
    });
  }
}

void LimitBlockShifts(
  GridSamples& fine, const GridSamples& coarse, int factor, const std::vector<double>& limits, const Poll& poll)
{
  const GridSamples means = BlockMeans(fine, factor, poll);
  for (int j = 0; j < fine.Height; ++j)
  {
    poll();
    for (int i = 0; i < fine.Width; ++i)
    {
      const std::size_t block = static_cast<std::size_t>(j / factor) * coarse.Width + i / factor;
      const double shift = means.Values[block] - coarse.Values[block];
      fine.At(i, j) += std::clamp(shift, -limits[block], limits[block]) - shift;
    }
  }
}

}
