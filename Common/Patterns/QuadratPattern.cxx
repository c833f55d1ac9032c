// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/QuadratPattern.h"

#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace littoral
{

namespace
{

std::vector<int> SampledCounts(const QuadratLawParameters& law, long long quadrats, int seed, SteppedPoll poll)
{
  std::vector<double> cumulative = MassFunction(law);
  std::partial_sum(cumulative.begin(), cumulative.end(), cumulative.begin());
  const RandomStream random(seed, RandomPurpose::QuadratCounts);
  std::vector<int> counts(static_cast<std::size_t>(quadrats));
  for (std::size_t q = 0; q < counts.size(); ++q)
  {
    const double u = random.UniformPair(q, 0)[0] * cumulative.back();
    poll.Step();
    counts[q] = static_cast<int>(std::upper_bound(cumulative.begin(), cumulative.end(), u) - cumulative.begin());
  }
  return counts;
}

/// Counts in a random order of the quadrats (Fisher and Yates).
std::vector<int> QuotaCounts(const QuadratLawParameters& law, long long quadrats, int seed, SteppedPoll poll)
{
  const std::vector<long long> frequency = QuotaFrequencies(law, quadrats);
  std::vector<int> counts;
  counts.reserve(static_cast<std::size_t>(quadrats));
  for (std::size_t r = 0; r < frequency.size(); ++r)
  {
    counts.insert(counts.end(), static_cast<std::size_t>(frequency[r]), static_cast<int>(r));
  }
  const RandomStream random(seed, RandomPurpose::QuadratOrder);
  for (std::size_t q = counts.size(); q > 1; --q)
  {
    poll.Step();
    const auto other = static_cast<std::size_t>(random.UniformPair(q, 0)[0] * static_cast<double>(q));
    std::swap(counts[q - 1], counts[std::min(other, q - 1)]);
  }
  return counts;
}

}

std::string WhyInvalid(const QuadratGrid& grid)
{
  ParameterCheck check;
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::string component = "[" + std::to_string(axis) + "]";
    check.Finite("Origin" + component, grid.Origin[axis]);
    check.Positive("Size" + component, grid.Size[axis]);
    check.Count("Quadrats" + component, grid.Count[axis], 1, std::numeric_limits<int>::max());
  }
  return check.Reason();
}

std::vector<long long> QuotaFrequencies(const QuadratLawParameters& law, long long quadrats)
{
  std::vector<double> share = MassFunction(law);
  std::partial_sum(share.begin(), share.end(), share.begin());
  // Quadrats with at most r points, rounded down: all points are the sum over r of those with more.
  const double all = static_cast<double>(quadrats);
  std::vector<long long> below(share.size(), quadrats);
  std::vector<double> rest(share.size() - 1);
  long long points = 0;
  for (std::size_t r = 0; r < rest.size(); ++r)
  {
    const double exact = all * std::min(1.0, share[r] / share.back());
    below[r] = static_cast<long long>(exact);
    rest[r] = exact - static_cast<double>(below[r]);
    points += quadrats - below[r];
  }
  // As many as make points too many are rounded up: those with the largest remainders, of equal ones the last, so that
  // they still rise with r.
  std::vector<std::size_t> order(rest.size());
  std::iota(order.rbegin(), order.rend(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rest[a] > rest[b]; });
  const long long excess = points - std::llround(all * law.Mean);
  for (long long n = 0; n < std::min<long long>(excess, static_cast<long long>(order.size())); ++n)
  {
    ++below[order[static_cast<std::size_t>(n)]];
  }
  std::adjacent_difference(below.begin(), below.end(), below.begin());
  return below;
}

std::vector<int> QuadratCounts(
  const QuadratLawParameters& law, long long quadrats, QuadratMode mode, int seed, const Poll& poll)
{
  const SteppedPoll steps(poll);
  return mode == QuadratMode::Quota ? QuotaCounts(law, quadrats, seed, steps)
                                    : SampledCounts(law, quadrats, seed, steps);
}

std::array<double, 2> QuadratPosition(const QuadratGrid& grid, long long quadrat, int index, int seed)
{
  const RandomStream random(seed, RandomPurpose::QuadratPositions);
  const auto u = random.UniformPair(static_cast<std::uint64_t>(quadrat), static_cast<std::uint64_t>(index));
  const double i = static_cast<double>(quadrat % grid.Count[0]);
  const double j = static_cast<double>(quadrat / grid.Count[0]);
  return { grid.Origin[0] + grid.Size[0] * (i + u[0]) / grid.Count[0],
    grid.Origin[1] + grid.Size[1] * (j + u[1]) / grid.Count[1] };
}

long long QuadratOf(const QuadratGrid& grid, double x, double y)
{
  const double u = (x - grid.Origin[0]) / grid.Size[0];
  const double v = (y - grid.Origin[1]) / grid.Size[1];
  if (!(u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0))
  {
    return -1;
  }
  const int i = std::min(grid.Count[0] - 1, static_cast<int>(u * grid.Count[0]));
  const int j = std::min(grid.Count[1] - 1, static_cast<int>(v * grid.Count[1]));
  return static_cast<long long>(j) * grid.Count[0] + i;
}

}
