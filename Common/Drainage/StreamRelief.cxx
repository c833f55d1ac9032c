// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/StreamRelief.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

constexpr double BinsAnOctave = 2.0;
constexpr double LargestPart = 0.1; ///< of the grid
constexpr std::size_t LeastBins = 6;
constexpr double SmallestExponent = 0.05;
constexpr double LargestExponent = 3.0;

/// Distance between two cells [m].
double DistanceOf(const GridSamples& heights, CellIndex one, CellIndex other)
{
  const double x = (one % heights.Width - other % heights.Width) * heights.Spacing[0];
  const double y = (one / heights.Width - other / heights.Width) * heights.Spacing[1];
  return std::sqrt(x * x + y * y);
}

/// Mean square of ln S about S = S_0 / (1 + (A / A_c)^theta) with the S_0 that leaves the least, cell by cell.
double RestOf(const std::vector<SlopeAreaBin>& bins, double logArea, double exponent)
{
  double weight = 0.0;
  double mean = 0.0;
  double squares = 0.0;
  for (const SlopeAreaBin& bin : bins)
  {
    const double rest = std::log(bin.Slope) + std::log1p(std::exp(exponent * (std::log(bin.Cells) - logArea)));
    const double before = rest - mean;
    weight += bin.Count;
    mean += before * bin.Count / weight;
    squares += bin.Count * before * (rest - mean);
  }
  return squares / weight;
}

struct Minimum
{
  double At;
  double Value;
};

/// Least value between two places, by golden sections.
template <typename Function>
Minimum LeastBetween(double low, double high, const Function& of)
{
  constexpr double Part = 0.6180339887498949;
  Minimum left{ high - Part * (high - low), 0.0 };
  Minimum right{ low + Part * (high - low), 0.0 };
  left.Value = of(left.At);
  right.Value = of(right.At);
  while (high - low > 1e-4)
  {
    const bool isLeft = left.Value < right.Value;
    (isLeft ? high : low) = isLeft ? right.At : left.At;
    Minimum& kept = isLeft ? left : right;
    Minimum& made = isLeft ? right : left;
    made = kept;
    kept.At = isLeft ? high - Part * (high - low) : low + Part * (high - low);
    kept.Value = of(kept.At);
  }
  return left.Value < right.Value ? left : right;
}

}

double BreakOfSlopes(const std::vector<SlopeAreaBin>& bins)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (bins.size() < LeastBins)
  {
    return nan;
  }
  const auto exponentAt = [&](double logArea) {
    return LeastBetween(
      SmallestExponent, LargestExponent, [&](double exponent) { return RestOf(bins, logArea, exponent); });
  };
  const auto restAt = [&](double logArea) { return exponentAt(logArea).Value; };
  constexpr double Step = 0.25;
  const double largest = std::log(bins.back().Cells);
  Minimum best{ 0.0, restAt(0.0) };
  for (double logArea = Step; logArea < largest + Step; logArea += Step)
  {
    const double at = std::min(logArea, largest);
    const double rest = restAt(at);
    best = rest < best.Value ? Minimum{ at, rest } : best;
  }
  const bool isWithin = best.At > 0.0 && best.At < largest;
  if (!isWithin || exponentAt(best.At).At < SmallestExponent + 0.01)
  {
    return nan;
  }
  return std::exp(LeastBetween(best.At - Step, std::min(best.At + Step, largest), restAt).At);
}

std::vector<SlopeAreaBin> SlopesByArea(
  const GridSamples& heights, const FlowRouting& routing, const std::vector<CellIndex>& accumulation)
{
  const double most = LargestPart * static_cast<double>(accumulation.size());
  std::vector<SlopeAreaBin> bins(
    static_cast<std::size_t>(std::max(0.0, BinsAnOctave * std::log2(std::max(1.0, most)))));
  for (std::size_t n = 0; n < accumulation.size(); ++n)
  {
    const auto bin = static_cast<std::size_t>(BinsAnOctave * std::log2(accumulation[n]));
    const CellIndex receiver = routing.Receiver[n];
    if (bin < bins.size() && receiver != static_cast<CellIndex>(n) && !std::isnan(heights.Values[n]))
    {
      // S = max(0, z - z_r) / d
      const double fall = std::max(0.0, heights.Values[n] - heights.Values[receiver]);
      bins[bin].Cells += accumulation[n];
      bins[bin].Slope += fall / DistanceOf(heights, static_cast<CellIndex>(n), receiver);
      ++bins[bin].Count;
    }
  }
  bins.erase(
    std::remove_if(bins.begin(), bins.end(), [](const SlopeAreaBin& bin) { return !(bin.Slope > 0.0); }), bins.end());
  for (SlopeAreaBin& bin : bins)
  {
    bin.Cells /= bin.Count;
    bin.Slope /= bin.Count;
  }
  return bins;
}

ChannelDensity ChannelsOf(
  const GridSamples& heights, const FlowRouting& routing, const std::vector<CellIndex>& accumulation)
{
  ChannelDensity channels;
  channels.HeadCells = BreakOfSlopes(SlopesByArea(heights, routing, accumulation));
  std::vector<bool> hasDonor(accumulation.size(), false);
  double length = 0.0;
  for (std::size_t n = 0; n < accumulation.size(); ++n)
  {
    const CellIndex receiver = routing.Receiver[n];
    if (accumulation[n] >= channels.HeadCells && receiver != static_cast<CellIndex>(n))
    {
      hasDonor[receiver] = true;
      length += DistanceOf(heights, static_cast<CellIndex>(n), receiver);
    }
  }
  for (std::size_t n = 0; n < accumulation.size(); ++n)
  {
    channels.Heads += accumulation[n] >= channels.HeadCells && !hasDonor[n] ? 1.0 : 0.0;
  }
  const double area = static_cast<double>(Moments(heights).Count) * heights.Spacing[0] * heights.Spacing[1];
  channels.Density = std::isnan(channels.HeadCells) ? channels.HeadCells : length / area;
  return channels;
}

std::vector<StreamDistanceBin> HeightsAboveStreams(const GridSamples& heights, const FlowRouting& routing,
  const std::vector<CellIndex>& accumulation, CellIndex threshold, int most)
{
  const double cell = std::sqrt(heights.Spacing[0] * heights.Spacing[1]);
  std::vector<StreamDistanceBin> bins(most);
  std::vector<CellIndex> stream(accumulation.size(), -1);
  for (const CellIndex n : routing.Order)
  {
    // each cell comes after its receiver
    stream[n] = accumulation[n] >= threshold ? n : (routing.Receiver[n] == n ? -1 : stream[routing.Receiver[n]]);
    if (stream[n] >= 0 && stream[n] != n)
    {
      const double distance = DistanceOf(heights, n, stream[n]);
      const double cells = std::round(distance / cell);
      if (cells >= 1.0 && cells <= most)
      {
        StreamDistanceBin& bin = bins[static_cast<std::size_t>(cells) - 1];
        bin.Distance += distance;
        bin.Height += heights.Values[n] - heights.Values[stream[n]];
        ++bin.Count;
      }
    }
  }
  bins.erase(std::remove_if(bins.begin(), bins.end(), [](const StreamDistanceBin& bin) { return bin.Count == 0.0; }),
    bins.end());
  for (StreamDistanceBin& bin : bins)
  {
    bin.Distance /= bin.Count;
    bin.Height /= bin.Count;
  }
  return bins;
}

}
