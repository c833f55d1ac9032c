// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/HeightQuantiles.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace littoral
{

namespace
{

/// Beyond the outermost quantiles heights go on by this part of the range for each unit of probability.
constexpr double OuterSlope = 1e-3;

/// Parts of the cells that are counted by themselves, whatever the number of threads; an abort is heard between them.
constexpr std::size_t Parts = 64;

/// Mean number of heights in an interval, which are sorted by comparison.
constexpr std::size_t HeightsOfInterval = 256;

struct RankedHeight
{
  double Height;
  std::int32_t Cell;

  bool operator<(const RankedHeight& other) const
  {
    return this->Height != other.Height ? this->Height < other.Height : this->Cell < other.Cell;
  }
};

/// Intervals of height of equal length between the lowest and the highest.
struct HeightIntervals
{
  explicit HeightIntervals(const std::vector<double>& heights)
    : Count(heights.size() / HeightsOfInterval + 1)
  {
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    this->Lowest = *low;
    this->PerHeight = *high > *low ? static_cast<double>(this->Count) / (*high - *low) : 0.0;
  }

  std::size_t Of(double height) const
  {
    const double interval = (height - this->Lowest) * this->PerHeight;
    return interval < static_cast<double>(this->Count) ? static_cast<std::size_t>(interval) : this->Count - 1;
  }

  std::size_t Count;
  double Lowest;
  double PerHeight;
};

/// Cells in the order of their heights: put into intervals of height by counting, which are then sorted one by one.
std::unique_ptr<RankedHeight[]> SortedHeights(const std::vector<double>& heights, const ParallelFor& parallel)
{
  const HeightIntervals intervals(heights);
  const std::size_t count = heights.size();
  const auto forParts = [&](const auto& visit) {
    parallel(Parts, [&](std::size_t begin, std::size_t end) {
      for (std::size_t part = begin; part < end; ++part)
      {
        for (std::size_t n = count * part / Parts; n < count * (part + 1) / Parts; ++n)
        {
          visit(part, n);
        }
      }
    });
  };
  // First place of each part in each interval: those of an interval follow each other.
  std::vector<std::uint32_t> next(Parts * intervals.Count, 0);
  forParts([&](std::size_t part, std::size_t n) { ++next[part * intervals.Count + intervals.Of(heights[n])]; });
  std::vector<std::size_t> first;
  first.reserve(intervals.Count + 1);
  std::uint32_t sum = 0;
  for (std::size_t interval = 0; interval < intervals.Count; ++interval)
  {
    first.push_back(sum);
    for (std::size_t part = 0; part < Parts; ++part)
    {
      sum += std::exchange(next[part * intervals.Count + interval], sum);
    }
  }
  first.push_back(sum);
  std::unique_ptr<RankedHeight[]> ranked(new RankedHeight[count]); // not set: that of a large grid takes long
  forParts([&](std::size_t part, std::size_t n) {
    ranked[next[part * intervals.Count + intervals.Of(heights[n])]++] = { heights[n], static_cast<std::int32_t>(n) };
  });
  // About as many heights each time, however few lie in an interval.
  const std::size_t parts = intervals.Count / HeightsOfInterval + 1;
  const auto intervalFrom = [&](std::size_t part) {
    return std::lower_bound(first.begin(), first.end(), count * part / parts) - first.begin();
  };
  parallel(parts, [&](std::size_t begin, std::size_t end) {
    const auto after = intervalFrom(end);
    for (auto interval = intervalFrom(begin); interval < after; ++interval)
    {
      std::sort(ranked.get() + first[interval], ranked.get() + first[interval + 1]);
    }
  });
  return ranked;
}

/// The lognormal distribution (e^(s z) - 1) / s of a normal z, truncated at both ends at the same probability.
struct TruncatedLognormal
{
  static constexpr int Points = 400;

  TruncatedLognormal(double shape, const std::vector<double>& gaussians)
  {
    for (int point = 0; point <= Points; ++point)
    {
      this->Values[point] = std::expm1(shape * gaussians[point]) / shape;
      this->Mean += Weight(point) * this->Values[point];
    }
    double second = 0.0;
    double third = 0.0;
    for (int point = 0; point <= Points; ++point)
    {
      const double value = this->Values[point] - this->Mean;
      second += Weight(point) * value * value;
      third += Weight(point) * value * value * value;
    }
    this->Deviation = std::sqrt(second);
    this->Skew = third / (second * this->Deviation);
    this->Integral = (this->Mean - this->Values[0]) / (this->Values[Points] - this->Values[0]);
  }

  /// Probability of a point, closer to each other towards the ends: p = t^3 (10 - 15 t + 6 t^2).
  static double Position(int point)
  {
    const double t = static_cast<double>(point) / Points;
    return t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
  }
  /// Weight of a point in the trapezoid rule.
  static double Weight(int point)
  {
    return 0.5 * (Position(std::min(point + 1, Points)) - Position(std::max(point - 1, 0)));
  }

  double Values[Points + 1];
  double Mean = 0.0;
  double Deviation;
  double Skew;
  double Integral;
};

constexpr double MinimumShape = 1e-4;
constexpr double MaximumShape = 4.0;
constexpr double MinimumCut = 1e-8;
constexpr double MaximumCut = 0.1;

/// Root of an increasing function of a positive number, whose logarithm is sought; the bound beyond which it lies.
template <typename Function>
double RootBetween(double low, double high, const Function& function)
{
  const double atLow = function(low);
  const double atHigh = function(high);
  if (atLow >= 0.0 || atHigh <= 0.0)
  {
    return atLow >= 0.0 ? low : high;
  }
  std::uintmax_t steps = 100;
  const auto [below, above] =
    boost::math::tools::toms748_solve([&](double logarithm) { return function(std::exp(logarithm)); }, std::log(low),
      std::log(high), atLow, atHigh, boost::math::tools::eps_tolerance<double>(48), steps);
  return std::exp(0.5 * (below + above));
}

/// Truncated distribution of a skewness, not negative, with the probability `cut` left out at each end.
TruncatedLognormal WithSkew(double skew, double cut)
{
  const boost::math::normal_distribution<double> normal;
  std::vector<double> gaussians;
  for (int point = 0; point <= TruncatedLognormal::Points; ++point)
  {
    gaussians.push_back(boost::math::quantile(normal, cut + (1.0 - 2.0 * cut) * TruncatedLognormal::Position(point)));
  }
  const double shape = RootBetween(
    MinimumShape, MaximumShape, [&](double tried) { return TruncatedLognormal(tried, gaussians).Skew - skew; });
  return { shape, gaussians };
}

}

double HeightQuantiles::At(double probability) const
{
  return this->Below(this->After(probability), probability);
}

std::size_t HeightQuantiles::After(double probability) const
{
  return std::upper_bound(this->Probabilities.begin(), this->Probabilities.end(), probability) -
    this->Probabilities.begin();
}

double HeightQuantiles::Below(std::size_t next, double probability) const
{
  const double outer = OuterSlope * (this->Heights.back() - this->Heights.front());
  if (next == 0)
  {
    return this->Heights.front() - (this->Probabilities.front() - probability) * outer;
  }
  if (next == this->Probabilities.size())
  {
    return this->Heights.back() + (probability - this->Probabilities.back()) * outer;
  }
  const double part =
    (probability - this->Probabilities[next - 1]) / (this->Probabilities[next] - this->Probabilities[next - 1]);
  return this->Heights[next - 1] + part * (this->Heights[next] - this->Heights[next - 1]);
}

HeightQuantiles QuantilesOf(const std::vector<double>& heights)
{
  std::vector<double> sorted = heights;
  std::sort(sorted.begin(), sorted.end());
  HeightQuantiles quantiles;
  const auto count = static_cast<double>(sorted.size());
  for (auto first = sorted.begin(); first != sorted.end();)
  {
    const auto last = std::upper_bound(first, sorted.end(), *first);
    const auto ranks = static_cast<double>((first - sorted.begin()) + (last - sorted.begin()));
    quantiles.Probabilities.push_back(0.5 * ranks / count);
    quantiles.Heights.push_back(*first);
    first = last;
  }
  return quantiles;
}

std::array<double, 2> HypsometricIntegralRange(double skew)
{
  // The integral grows with what is cut off as long as the longer tail is above.
  const double size = std::abs(skew);
  const double least = WithSkew(size, MinimumCut).Integral;
  const double most = WithSkew(size, MaximumCut).Integral;
  return skew < 0.0 ? std::array<double, 2>{ 1.0 - most, 1.0 - least } : std::array<double, 2>{ least, most };
}

HeightQuantiles LognormalQuantiles(double mean, double deviation, double integral, double skew)
{
  // A negative skew is the mirror image of a positive one.
  const double sign = skew < 0.0 ? -1.0 : 1.0;
  const double size = std::abs(skew);
  const double wanted = skew < 0.0 ? 1.0 - integral : integral;
  const TruncatedLognormal cut = WithSkew(
    size, RootBetween(MinimumCut, MaximumCut, [&](double tried) { return WithSkew(size, tried).Integral - wanted; }));
  HeightQuantiles quantiles;
  for (int n = 0; n <= TruncatedLognormal::Points; ++n)
  {
    const int point = sign > 0.0 ? n : TruncatedLognormal::Points - n;
    const double p = TruncatedLognormal::Position(point);
    const double height = mean + sign * deviation * (cut.Values[point] - cut.Mean) / cut.Deviation;
    if (quantiles.Heights.empty() || height > quantiles.Heights.back())
    {
      quantiles.Probabilities.push_back(sign > 0.0 ? p : 1.0 - p);
      quantiles.Heights.push_back(height);
    }
  }
  return quantiles;
}

void MapQuantiles(std::vector<double>& heights, const HeightQuantiles& quantiles, const ParallelFor& parallel)
{
  const std::unique_ptr<RankedHeight[]> ranked = SortedHeights(heights, parallel);
  const auto count = static_cast<double>(heights.size());
  parallel(heights.size(), [&](std::size_t begin, std::size_t end) {
    std::size_t next = quantiles.After((static_cast<double>(begin) + 0.5) / count);
    for (std::size_t n = begin; n < end; ++n)
    {
      const double probability = (static_cast<double>(n) + 0.5) / count;
      while (next < quantiles.Probabilities.size() && quantiles.Probabilities[next] <= probability)
      {
        ++next;
      }
      heights[ranked[n].Cell] = quantiles.Below(next, probability);
    }
  });
}

}
