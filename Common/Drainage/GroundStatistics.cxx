// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/GroundStatistics.h"

#include "Drainage/FlowRouting.h"
#include "Drainage/LeastSquaresLine.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr std::size_t ThresholdPercent = 99;
constexpr int ReliefCells = 10;

/// Sorts in runs, which are merged.
void SortPolled(std::vector<double>& values, const Poll& poll)
{
  constexpr std::size_t run = std::size_t{ 1 } << 16;
  const auto at = [&](std::size_t place) {
    return values.begin() + static_cast<std::ptrdiff_t>(std::min(place, values.size()));
  };
  for (std::size_t begin = 0; begin < values.size(); begin += run)
  {
    poll();
    std::sort(at(begin), at(begin + run));
  }
  for (std::size_t length = run; length < values.size(); length *= 2)
  {
    for (std::size_t begin = 0; begin + length < values.size(); begin += 2 * length)
    {
      poll();
      std::inplace_merge(at(begin), at(begin + length), at(begin + 2 * length));
    }
  }
}

/// Calls visit(cell) for the cells that have all four neighbours, row by row.
template <typename Visit>
void ForEachInner(const GridSamples& heights, const Visit& visit, const Poll& poll = NoPoll)
{
  for (int j = 1; j < heights.Height - 1; ++j)
  {
    poll();
    for (int i = 1; i < heights.Width - 1; ++i)
    {
      visit(static_cast<std::size_t>(j) * heights.Width + i);
    }
  }
}

/// k_s of the line of least squares through the logarithms of slope and area.
double SteepnessOf(const GroundMeasures& measures, double cellArea)
{
  std::vector<double> logAreas;
  std::vector<double> logSlopes;
  for (const SlopeAreaBin& bin : measures.SlopeArea)
  {
    logAreas.push_back(std::log(bin.Cells * cellArea));
    logSlopes.push_back(std::log(bin.Slope));
  }
  // ln S = ln k_s - theta ln A
  return std::isnan(measures.Concavity) ? measures.Concavity : std::exp(LineThrough(logAreas, logSlopes).Intercept);
}

}

SampleShape ShapeOf(const std::vector<double>& values, const Poll& poll)
{
  SampleShape shape;
  if (values.empty())
  {
    return shape;
  }
  const auto count = static_cast<double>(values.size());
  poll();
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  shape.Minimum = *least;
  shape.Maximum = *most;
  double sum = 0.0;
  ForPolled(values.size(), poll, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      sum += values[n] - shape.Minimum;
    }
  });
  shape.Mean = shape.Minimum + sum / count;
  double squares = 0.0;
  double cubes = 0.0;
  ForPolled(values.size(), poll, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const double rest = values[n] - shape.Mean;
      squares += rest * rest;
      cubes += rest * rest * rest;
    }
  });
  // g = m3/m2^(3/2)
  shape.StandardDeviation = std::sqrt(squares / count);
  shape.Skew = shape.Maximum > shape.Minimum ? cubes / count / std::pow(squares / count, 1.5)
                                             : std::numeric_limits<double>::quiet_NaN();
  return shape;
}

std::vector<double> GradientsOf(const GridSamples& heights, const Poll& poll)
{
  std::vector<double> slopes;
  const std::vector<double>& z = heights.Values;
  const std::size_t row = heights.Width;
  const auto add = [&](std::size_t cell) {
    // |grad z|, z_x = (z_e - z_w)/2dx, z_y = (z_n - z_s)/2dy
    const double x = (z[cell + 1] - z[cell - 1]) / (2.0 * heights.Spacing[0]);
    const double y = (z[cell + row] - z[cell - row]) / (2.0 * heights.Spacing[1]);
    slopes.push_back(std::sqrt(x * x + y * y));
  };
  slopes.reserve(z.size());
  ForEachInner(heights, add, poll);
  poll();
  return PresentValues(slopes);
}

std::vector<double> LaplaciansOf(const GridSamples& heights, const Poll& poll)
{
  std::vector<double> curvatures;
  const std::vector<double>& z = heights.Values;
  const std::size_t row = heights.Width;
  const auto add = [&](std::size_t cell) {
    // (z_e - 2z + z_w)/dx^2 + (z_n - 2z + z_s)/dy^2
    const double x = (z[cell + 1] - z[cell]) - (z[cell] - z[cell - 1]);
    const double y = (z[cell + row] - z[cell]) - (z[cell] - z[cell - row]);
    curvatures.push_back(x / (heights.Spacing[0] * heights.Spacing[0]) + y / (heights.Spacing[1] * heights.Spacing[1]));
  };
  ForEachInner(heights, add, poll);
  return PresentValues(curvatures);
}

std::vector<double> EvenQuantiles(std::vector<double> values, int count, const Poll& poll)
{
  if (values.empty())
  {
    return {};
  }
  SortPolled(values, poll);
  std::vector<double> quantiles;
  for (int k = 0; k < count; ++k)
  {
    const double place = static_cast<double>(k) / (count - 1) * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    const double rest = place - static_cast<double>(below);
    quantiles.push_back((1.0 - rest) * values[below] + rest * values[above]);
  }
  return quantiles;
}

double HackExponent(const std::vector<double>& lengths, const std::vector<CellIndex>& accumulation, CellIndex threshold)
{
  std::vector<double> logAreas;
  std::vector<double> logLengths;
  for (std::size_t cell = 0; cell < lengths.size(); ++cell)
  {
    if (accumulation[cell] >= threshold && lengths[cell] > 0.0)
    {
      logAreas.push_back(std::log(accumulation[cell]));
      logLengths.push_back(std::log(lengths[cell]));
    }
  }
  return LineThrough(logAreas, logLengths).Slope;
}

GroundStatistics DescribeGround(const GridSamples& heights, const OutletMask& outlets, CellIndex threshold,
  const ParallelFor& parallel, const Poll& poll, const GeomorphonSearch& search)
{
  const CellLattice lattice(heights);
  GroundStatistics ground;
  ground.Measures = MeasureGround(heights, outlets, parallel, poll);
  ground.Steepness = SteepnessOf(ground.Measures, lattice.CellArea());
  const std::vector<double> slopes = GradientsOf(heights);
  ground.Slopes = ShapeOf(slopes);
  ground.ThresholdSlope =
    slopes.empty() ? std::numeric_limits<double>::quiet_NaN() : EvenQuantiles(slopes, 101)[ThresholdPercent];
  ground.Curvature = ShapeOf(LaplaciansOf(heights));
  poll();
  const FlowRouting routing = RouteFlow(heights, outlets, parallel, poll, FlatWays::Shortest);
  const std::vector<CellIndex> cells = FlowAccumulation(routing);
  poll();
  ground.Hack = HackExponent(LongestFlowLengths(routing, lattice), cells, threshold);
  ground.Streams = ClassesByOrder(FindStreams(heights, routing, cells, threshold).Rivers);
  ground.Horton = RatiosOf(ground.Streams);
  ground.Channels = ChannelsOf(heights, routing, cells);
  ground.Relief = HeightsAboveStreams(heights, routing, cells, threshold, ReliefCells);
  ground.Forms = SharesOf(GeomorphonsOf(heights, search, parallel));
  return ground;
}

}
