// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/HeightMatching.h"

#include "Numerics/Constants.h"
#include "Numerics/PolledMemory.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

/// Parts of the ranks, shorter towards the lowest and the highest: p_k = (1 - cos(pi k / n)) / 2.
constexpr int Parts = 20;

/// Part of a straight line in the map, so that it grows where the distribution has a flat.
constexpr double StraightPart = 1e-3;

struct Knot
{
  double From;
  double To;
  double Slope = 0.0;
};

/// Quantiles of the heights and of the distribution at each part, without those that are no higher than the last.
std::vector<Knot> KnotsOf(std::vector<double> heights, const HeightQuantiles& quantiles, const Poll& poll)
{
  SteppedPoll steps(poll, 1 << 20);
  const auto isLower = [&](double one, double other) {
    steps.Step();
    return one < other;
  };
  std::vector<Knot> knots;
  auto sorted = heights.begin(); // what is before is no higher
  for (int part = 0; part <= Parts; ++part)
  {
    const double rank = 0.5 * (1.0 - std::cos(Pi * part / Parts));
    const auto at = heights.begin() + static_cast<std::ptrdiff_t>(rank * static_cast<double>(heights.size() - 1));
    std::nth_element(sorted, at, heights.end(), isLower);
    sorted = at;
    const double from = *at;
    if (knots.empty() || from > knots.back().From)
    {
      knots.push_back({ from, quantiles.At(rank) });
    }
  }
  return knots;
}

/// Secant from a knot to the next.
double SecantOf(const std::vector<Knot>& knots, std::size_t n)
{
  return (knots[n + 1].To - knots[n].To) / (knots[n + 1].From - knots[n].From);
}

/// Slopes at the knots: harmonic means of the secants at both sides, weighted by their lengths; 0 beside a flat.
void SetSlopes(std::vector<Knot>& knots)
{
  const std::size_t last = knots.size() - 1;
  knots.front().Slope = SecantOf(knots, 0);
  knots.back().Slope = SecantOf(knots, last - 1);
  for (std::size_t n = 1; n < last; ++n)
  {
    const double before = knots[n].From - knots[n - 1].From;
    const double after = knots[n + 1].From - knots[n].From;
    const double left = SecantOf(knots, n - 1);
    const double right = SecantOf(knots, n);
    // m = (w1 + w2) / (w1 / s1 + w2 / s2),  w1 = 2 h2 + h1, w2 = h2 + 2 h1
    const double first = 2.0 * after + before;
    const double second = after + 2.0 * before;
    knots[n].Slope = left > 0.0 && right > 0.0 ? (first + second) / (first / left + second / right) : 0.0;
  }
}

/// Hermite's cubic of the part in which a height lies.
double MapHeight(const std::vector<Knot>& knots, double height)
{
  const auto above = std::upper_bound(
    knots.begin() + 1, knots.end() - 1, height, [](double value, const Knot& knot) { return value < knot.From; });
  const Knot& high = *above;
  const Knot& low = *(above - 1);
  const double length = high.From - low.From;
  const double t = (height - low.From) / length;
  const double s = 1.0 - t;
  // z = s^2 (1 + 2t) z0 + s^2 t h m0 + t^2 (3 - 2t) z1 - t^2 s h m1
  return s * s * ((1.0 + 2.0 * t) * low.To + t * length * low.Slope) +
    t * t * ((3.0 - 2.0 * t) * high.To - s * length * high.Slope);
}

}

void MatchHeights(
  std::vector<double>& heights, const HeightQuantiles& quantiles, const ParallelFor& parallel, const Poll& poll)
{
  std::vector<Knot> knots = KnotsOf(CopyOf(heights, poll), quantiles, poll);
  if (knots.size() < 2)
  {
    return;
  }
  SetSlopes(knots);
  const Knot low = knots.front();
  const double straight = (knots.back().To - low.To) / (knots.back().From - low.From);
  parallel(heights.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const double line = low.To + straight * (heights[n] - low.From);
      heights[n] = (1.0 - StraightPart) * MapHeight(knots, heights[n]) + StraightPart * line;
    }
  });
}

}
