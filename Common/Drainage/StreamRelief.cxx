// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/StreamRelief.h"

#include "Drainage/LeastSquaresLine.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

constexpr double BinsAnOctave = 2.0;
constexpr double LargestPart = 0.1;  ///< of the grid
constexpr std::size_t BinsASide = 3; ///< at least, of each line

/// Distance between two cells [m].
double DistanceOf(const GridSamples& heights, CellIndex one, CellIndex other)
{
  const double x = (one % heights.Width - other % heights.Width) * heights.Spacing[0];
  const double y = (one / heights.Width - other / heights.Width) * heights.Spacing[1];
  return std::sqrt(x * x + y * y);
}

/// Sum of the squares of ln S about the least-squares line of a part of the bins, and its slope.
struct PartialLine
{
  double Slope;
  double Rest = 0.0;

  PartialLine(const std::vector<SlopeAreaBin>& bins, std::size_t begin, std::size_t end)
  {
    std::vector<double> areas;
    std::vector<double> slopes;
    for (std::size_t n = begin; n < end; ++n)
    {
      areas.push_back(std::log(bins[n].Cells));
      slopes.push_back(std::log(bins[n].Slope));
    }
    const auto line = LineThrough(areas, slopes);
    this->Slope = line.Slope;
    for (std::size_t n = 0; n < areas.size(); ++n)
    {
      const double rest = slopes[n] - line.Intercept - line.Slope * areas[n];
      this->Rest += rest * rest;
    }
  }
};

}

double BreakOfSlopes(const std::vector<SlopeAreaBin>& bins)
{
  double least = std::numeric_limits<double>::infinity();
  double found = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t n = BinsASide; n + BinsASide <= bins.size(); ++n)
  {
    const PartialLine before(bins, 0, n);
    const PartialLine beyond(bins, n, bins.size());
    const double rest = before.Rest + beyond.Rest;
    if (rest < least)
    {
      least = rest;
      found = beyond.Slope < before.Slope ? std::sqrt(bins[n - 1].Cells * bins[n].Cells)
                                          : std::numeric_limits<double>::quiet_NaN();
    }
  }
  return found;
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
