// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/CurveEnvelope.h"

#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

namespace littoral
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
/// level * (simulations + 1) is a whole number but for rounding.
constexpr double RoundingSlack = 1e-9;
/// Time of a curve above which curves are made one by one.
constexpr std::chrono::milliseconds LongestCurve(25);
/// Time of curves one after the other, up to which one loop makes all.
constexpr std::chrono::seconds ShortLoop(1);

/// The two-sided ranks of numbers, 1 for the lowest and the highest; equal ones have the mean of theirs.
std::vector<double> TwoSidedRanks(const std::vector<double>& values)
{
  const std::size_t count = values.size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(count, 0.0);
  for (std::size_t begin = 0, end = 0; begin < count; begin = end)
  {
    while (end < count && !(values[order[begin]] < values[order[end]]))
    {
      ++end;
    }
    // From below begin + 1 ... end, from above count + 1 minus them.
    const double mean = 0.5 * static_cast<double>(begin + 1 + end);
    for (std::size_t n = begin; n < end; ++n)
    {
      ranks[order[n]] = std::min(mean, static_cast<double>(count + 1) - mean);
    }
  }
  return ranks;
}

/// Two-sided ranks of each curve at all distances, smallest first. Curves are rows; column k is `valuesAt(k)`.
template <typename ValuesAt>
std::vector<std::vector<double>> SortedRanks(
  std::size_t curves, const std::vector<std::size_t>& columns, const ValuesAt& valuesAt)
{
  std::vector<std::vector<double>> sorted(curves);
  for (const std::size_t k : columns)
  {
    const std::vector<double> ranks = TwoSidedRanks(valuesAt(k));
    for (std::size_t n = 0; n < curves; ++n)
    {
      sorted[n].push_back(ranks[n]);
    }
  }
  for (std::vector<double>& ranks : sorted)
  {
    std::sort(ranks.begin(), ranks.end());
  }
  return sorted;
}

/// p of each curve: the part of the curves that come before it or with it in the order of extreme rank lengths.
std::vector<double> RankLengthValues(const std::vector<std::vector<double>>& sortedRanks)
{
  const std::size_t count = sortedRanks.size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sortedRanks[a] < sortedRanks[b]; });
  std::vector<double> values(count);
  for (std::size_t begin = 0, end = 0; begin < count; begin = end)
  {
    while (end < count && sortedRanks[order[end]] == sortedRanks[order[begin]])
    {
      ++end;
    }
    for (std::size_t n = begin; n < end; ++n)
    {
      values[order[n]] = static_cast<double>(end) / static_cast<double>(count);
    }
  }
  return values;
}

}

std::string WhyNoEnvelope(int simulations, double level)
{
  ParameterCheck check;
  check.Within("Level", level, ValueInterval::Between(0.0, 1.0));
  if (check.IsGood() && !(level * (simulations + 1.0) >= 1.0 - RoundingSlack))
  {
    return "NumberOfSimulations is " + std::to_string(simulations) + ", too few for Level " + TextOf(level) +
      "; it must be at least " + TextOf(std::ceil(1.0 / level - 1.0 - RoundingSlack)) + ".";
  }
  return check.Reason();
}

CurveEnvelope FindCurveEnvelope(
  const std::vector<double>& measured, const std::vector<std::vector<double>>& simulated, double level)
{
  const std::size_t distances = measured.size();
  const std::size_t curves = simulated.size() + 1; // the measured one is the last
  const auto valuesAt = [&](std::size_t k) {
    std::vector<double> values;
    for (const std::vector<double>& curve : simulated)
    {
      values.push_back(curve[k]);
    }
    values.push_back(measured[k]);
    return values;
  };
  CurveEnvelope envelope;
  envelope.Level = level;
  for (auto* band : { &envelope.Low, &envelope.High, &envelope.Mean, &envelope.GlobalLow, &envelope.GlobalHigh })
  {
    band->assign(distances, NaN);
  }
  const double nth = std::floor(0.5 * level * static_cast<double>(curves) + RoundingSlack);
  const std::size_t skipped = static_cast<std::size_t>(std::max(1.0, nth)) - 1;
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < distances; ++k)
  {
    std::vector<double> values = valuesAt(k);
    if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
    {
      continue;
    }
    columns.push_back(k);
    values.pop_back();
    envelope.Mean[k] = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    std::sort(values.begin(), values.end());
    envelope.Low[k] = values[skipped];
    envelope.High[k] = values[values.size() - 1 - skipped];
  }
  if (columns.empty())
  {
    return envelope;
  }
  const std::vector<double> extremeness = RankLengthValues(SortedRanks(curves, columns, valuesAt));
  envelope.PValue = extremeness.back();
  envelope.IsRejected = envelope.PValue <= level + RoundingSlack;
  for (const std::size_t k : columns)
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t n = 0; n < curves; ++n)
    {
      if (extremeness[n] > level + RoundingSlack)
      {
        const double value = n + 1 < curves ? simulated[n][k] : measured[k];
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
    envelope.GlobalLow[k] = low;
    envelope.GlobalHigh[k] = high;
    if (measured[k] < low || measured[k] > high)
    {
      envelope.Outside.push_back(k);
    }
  }
  return envelope;
}

NumberRows SimulateCurves(
  const CurveOfNumber& curve, int simulations, const Poll& poll, const ParallelFor& parallel, const WorkShare& share)
{
  using Clock = std::chrono::steady_clock;
  NumberRows curves(static_cast<std::size_t>(simulations));
  const std::size_t own = share.OwnOf(curves.size());
  const auto simulate = [&](std::size_t n, const ParallelFor& inner) {
    const std::size_t number = share.RowOf(n);
    curves[number] = curve(static_cast<int>(number), inner);
  };
  const Clock::time_point begin = Clock::now();
  if (own > 0)
  {
    simulate(0, parallel);
  }
  const auto first = Clock::now() - begin;
  const bool isSlow = first > LongestCurve;
  // Each loop ends with threads that wait for the last one.
  const std::size_t longestLoop = first * own < ShortLoop ? own : (own + PollsOfCurves - 1) / PollsOfCurves;
  std::size_t done = std::min<std::size_t>(own, 1);
  for (std::size_t part = 1; part <= PollsOfCurves; ++part)
  {
    const std::size_t end = std::min(own, part * longestLoop);
    for (; done < end && isSlow; ++done)
    {
      simulate(done, parallel);
    }
    ForRanges(parallel, end - std::min(done, end), 1, [&](std::size_t from, std::size_t to) {
      for (std::size_t n = done + from; n < done + to; ++n)
      {
        simulate(n, SerialFor);
      }
    });
    done = std::max(done, end);
    poll();
  }
  share.CompleteFirst(curves);
  return curves;
}

NumberRows SimulateCurves(const PatternOfNumber& law, const CurveOfPattern& curve, int simulations, const Poll& poll,
  const ParallelFor& parallel, const WorkShare& share)
{
  const auto one = [&](int number, const ParallelFor& inner) { return curve(law(number, inner), inner); };
  return SimulateCurves(one, simulations, poll, parallel, share);
}

std::vector<PlanePosition> UniformPattern(const ObservationWindow& window, std::size_t points, int seed, int number)
{
  const RandomStream random(seed, RandomPurpose::UniformPoints);
  const PlanePosition& low = window.GetLow();
  const PlanePosition& high = window.GetHigh();
  std::vector<PlanePosition> pattern;
  pattern.reserve(points);
  // Those of the bounding box that fall into the window.
  for (std::uint64_t draw = 0; pattern.size() < points; ++draw)
  {
    const auto u = random.UniformPair(static_cast<std::uint64_t>(number), draw);
    const PlanePosition point{ low[0] + u[0] * (high[0] - low[0]), low[1] + u[1] * (high[1] - low[1]) };
    if (window.Contains(point))
    {
      pattern.push_back(point);
    }
  }
  return pattern;
}

std::vector<std::size_t> RandomOrder(std::size_t count, int seed, int number)
{
  const RandomStream random(seed, RandomPurpose::MarkOrder);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  // Fisher and Yates.
  for (std::size_t last = count; last > 1; --last)
  {
    const double u = random.UniformPair(static_cast<std::uint64_t>(number), last)[0];
    const std::size_t other = std::min(last - 1, static_cast<std::size_t>(u * static_cast<double>(last)));
    std::swap(order[last - 1], order[other]);
  }
  return order;
}

int SeedOfSimulation(int seed, int number)
{
  const RandomStream random(seed, RandomPurpose::SimulationSeeds);
  return static_cast<int>(random.Words(static_cast<std::uint64_t>(number), 0)[0] >> 1);
}

}
