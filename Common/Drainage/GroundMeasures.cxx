// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/GroundMeasures.h"

#include "Drainage/CellLattice.h"
#include "Drainage/FlowRouting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

constexpr int SlopeAreaBins = 20;
constexpr double MinimumCells = 100.0;

/// Largest drainage area of the slope-area relation [cells]: a tenth of the grid, or less where that is asked for; 0
/// where it is less than a decade.
double MaximumCellsOf(double count, double most)
{
  const double tenth = 0.1 * count;
  if (most * (1.0 + 1e-9) >= tenth) // that of a grid of the same area
  {
    return tenth;
  }
  return most < 10.0 * MinimumCells ? 0.0 : most;
}

/// Count and central moments of a set of values.
struct CentralMoments
{
  CentralMoments(const std::vector<double>& values, const Poll& poll)
  {
    const auto count = static_cast<double>(values.size());
    ForPolled(values.size(), poll, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        this->Mean += values[n] / count;
      }
    });
    double third = 0.0;
    ForPolled(values.size(), poll, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        const double less = values[n] - this->Mean;
        this->Variance += less * less / count;
        third += less * less * less / count;
      }
    });
    this->Skew = this->Variance > 0.0 ? third / (this->Variance * std::sqrt(this->Variance)) : 0.0;
  }

  double Mean = 0.0;
  double Variance = 0.0;
  double Skew = 0.0;
};

/// z_xx + z_yy at inner cells; NaN beside missing heights.
std::vector<double> Laplacians(const GridSamples& heights, const ParallelFor& parallel)
{
  const auto width = static_cast<std::size_t>(heights.Width - 2);
  std::vector<double> curvature(width * (heights.Height - 2));
  const double x2 = heights.Spacing[0] * heights.Spacing[0];
  const double y2 = heights.Spacing[1] * heights.Spacing[1];
  parallel(heights.Height - 2, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      const int j = static_cast<int>(row) + 1;
      for (int i = 1; i < heights.Width - 1; ++i)
      {
        const double twice = 2.0 * heights.At(i, j);
        curvature[row * width + i - 1] = (heights.At(i - 1, j) + heights.At(i + 1, j) - twice) / x2 +
          (heights.At(i, j - 1) + heights.At(i, j + 1) - twice) / y2;
      }
    }
  });
  return curvature;
}

/// Sum of squared differences of pairs, and how many have both heights.
struct PairSum
{
  double Squares = 0.0;
  double Pairs = 0.0;

  void AddPresent(const double* from, const double* to, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      const double difference = to[i] - from[i];
      this->Squares += std::isnan(difference) ? 0.0 : difference * difference;
      this->Pairs += std::isnan(difference) ? 0.0 : 1.0;
    }
  }
};

/// Pairs of a row with the heights from another place on.
struct RowPairs
{
  const double* To = nullptr;
  int Count = 0;
};

/// Sums of some lags that are taken side by side, as each waits for its last addition.
constexpr std::size_t LagsAtOnce = 4;
using LagSums = std::array<PairSum, LagsAtOnce>;

/// Adds the pairs of a row to the sums, each in the order of the row.
void AddPairs(const double* from, const std::array<RowPairs, LagsAtOnce>& pairs, LagSums& sums)
{
  std::array<double, LagsAtOnce> squares{};
  int common = pairs[0].Count;
  for (std::size_t n = 0; n < LagsAtOnce; ++n)
  {
    squares[n] = sums[n].Squares;
    common = std::min(common, pairs[n].Count);
  }
  for (int i = 0; i < common; ++i)
  {
    for (std::size_t n = 0; n < LagsAtOnce; ++n)
    {
      const double difference = pairs[n].To[i] - from[i];
      squares[n] += difference * difference;
    }
  }
  for (std::size_t n = 0; n < LagsAtOnce; ++n)
  {
    for (int i = std::max(0, common); i < pairs[n].Count; ++i)
    {
      const double difference = pairs[n].To[i] - from[i];
      squares[n] += difference * difference;
    }
    if (std::isnan(squares[n]))
    {
      sums[n].AddPresent(from, pairs[n].To, pairs[n].Count);
      continue;
    }
    sums[n].Squares = squares[n];
    sums[n].Pairs += std::max(0, pairs[n].Count);
  }
}

/// Measures the slope-area relation up to a drainage area [cells].
void MeasureSlopeArea(const GridSamples& heights, const FlowRouting& routing, const OutletMask& outlets,
  double maximumCells, const ParallelFor& parallel, const Poll& poll, GroundMeasures& measures)
{
  SteppedPoll steps(poll, 1 << 16);
  const std::vector<CellIndex> cells = FlowAccumulation(routing, poll);
  const std::vector<double> slopes = SlopesToReceivers(heights, routing, parallel);
  const double first = std::log(MinimumCells);
  const double last = std::log(maximumCells);
  std::vector<SlopeAreaBin> bins(SlopeAreaBins);
  SlopeAreaBin reference;
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    steps.Step();
    if (outlets[n] || cells[n] < MinimumCells)
    {
      continue;
    }
    const double position = (std::log(static_cast<double>(cells[n])) - first) / (last - first) * SlopeAreaBins;
    const auto add = [&](SlopeAreaBin& bin) {
      bin.Cells += cells[n];
      bin.Slope += std::max(0.0, slopes[n]); // water stands in depressions
      bin.Count += 1.0;
    };
    if (last > first && position >= 0.0 && position < SlopeAreaBins)
    {
      add(bins[static_cast<std::size_t>(position)]);
    }
    if (cells[n] <= 2.0 * MinimumCells && slopes[n] > 0.0)
    {
      add(reference);
    }
  }
  // Least squares of ln S over ln A, every bin alike.
  double n = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  for (SlopeAreaBin& bin : bins)
  {
    if (bin.Slope > 0.0)
    {
      bin.Cells /= bin.Count;
      bin.Slope /= bin.Count;
      measures.SlopeArea.push_back(bin);
      const double a = std::log(bin.Cells);
      const double s = std::log(bin.Slope);
      n += 1.0;
      x += a;
      y += s;
      xx += a * a;
      xy += a * s;
    }
  }
  measures.Concavity = n >= 3.0 ? -(n * xy - x * y) / (n * xx - x * x) : std::numeric_limits<double>::quiet_NaN();
  measures.ChannelSlope = reference.Count > 0.0 ? reference.Slope / reference.Count : 0.0;
}

}

double GroundMeasures::SemivarianceAt(double lag) const
{
  const auto at = std::lower_bound(this->Lags.begin(), this->Lags.end(), lag * (1.0 - 1e-9));
  if (at == this->Lags.end() || lag <= 0.0)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const std::size_t n = at - this->Lags.begin();
  if (n == 0 || *at <= lag * (1.0 + 1e-9))
  {
    return this->Semivariance[n];
  }
  const double part = std::log(lag / this->Lags[n - 1]) / std::log(this->Lags[n] / this->Lags[n - 1]);
  return std::pow(this->Semivariance[n - 1], 1.0 - part) * std::pow(this->Semivariance[n], part);
}

std::vector<int> SemivarianceLags(int width, int height)
{
  const int most = std::clamp(std::min(width, height) / 2, 1, 100);
  std::vector<int> lags;
  for (int lag = 1; lag < most; lag = std::max(lag + 1, lag * 5 / 4))
  {
    lags.push_back(lag);
  }
  lags.push_back(most);
  return lags;
}

std::vector<double> SemivarianceAlongAxes(
  const GridSamples& heights, const std::vector<int>& lags, const ParallelFor& parallel)
{
  // Sums of each row, then over the rows in order: whatever the threads.
  const auto rows = static_cast<std::size_t>(heights.Height);
  std::vector<PairSum> sums(rows * lags.size());
  parallel(rows, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      const double* here = &heights.Values[row * heights.Width];
      for (std::size_t first = 0; first < lags.size(); first += LagsAtOnce)
      {
        const std::size_t count = std::min(LagsAtOnce, lags.size() - first);
        std::array<RowPairs, LagsAtOnce> along;
        std::array<RowPairs, LagsAtOnce> across;
        for (std::size_t n = 0; n < LagsAtOnce; ++n) // the last lag again where there are no more
        {
          const int lag = lags[first + std::min(n, count - 1)];
          along[n] = { here + lag, heights.Width - lag };
          if (static_cast<int>(row) + lag < heights.Height)
          {
            across[n] = { here + static_cast<std::size_t>(lag) * heights.Width, heights.Width };
          }
        }
        LagSums sum;
        AddPairs(here, along, sum);
        AddPairs(here, across, sum);
        std::copy_n(sum.begin(), count, sums.begin() + static_cast<std::ptrdiff_t>(row * lags.size() + first));
      }
    }
  });
  std::vector<double> semivariance;
  for (std::size_t n = 0; n < lags.size(); ++n)
  {
    PairSum all;
    for (std::size_t row = 0; row < rows; ++row)
    {
      all.Squares += sums[row * lags.size() + n].Squares;
      all.Pairs += sums[row * lags.size() + n].Pairs;
    }
    semivariance.push_back(all.Pairs > 0.0 ? 0.5 * all.Squares / all.Pairs : 0.0);
  }
  return semivariance;
}

GroundMeasures MeasureGround(const GridSamples& heights, const OutletMask& outlets, const ParallelFor& parallel,
  const Poll& poll, double maximumArea)
{
  GroundMeasures measures;
  const std::vector<double> present = PresentValues(heights.Values);
  const auto count = static_cast<double>(present.size());
  const CentralMoments moments(present, poll);
  poll();
  const auto [low, high] = RangeOf(present);
  measures.Lowest = low;
  measures.Highest = high;
  measures.StandardDeviation = std::sqrt(moments.Variance);
  measures.HypsometricIntegral = high > low ? (moments.Mean - low) / (high - low) : 0.0;
  measures.ElevationSkewness = moments.Skew;
  measures.CurvatureSkewness = CentralMoments(PresentValues(Laplacians(heights, parallel)), poll).Skew;
  const std::vector<int> lags = SemivarianceLags(heights.Width, heights.Height);
  measures.Semivariance = SemivarianceAlongAxes(heights, lags, parallel);
  for (const int lag : lags)
  {
    measures.Lags.push_back(0.5 * (heights.Spacing[0] + heights.Spacing[1]) * lag);
  }

  const FlowRouting routing = RouteFlow(heights, outlets, parallel, poll);
  const double area = heights.Spacing[0] * heights.Spacing[1];
  measures.DepressionFraction = static_cast<double>(routing.DepressionCells) / count;
  measures.RelativeFillDepth =
    measures.StandardDeviation > 0.0 ? routing.Volume / (area * count) / measures.StandardDeviation : 0.0;
  const double maximumCells = MaximumCellsOf(count, maximumArea / area);
  measures.MaximumArea = maximumCells * area;
  MeasureSlopeArea(heights, routing, outlets, maximumCells, parallel, poll, measures);
  return measures;
}

std::vector<SlopeAreaBin> SlopeAreaOf(const GridSamples& heights, const OutletMask& outlets,
  const ParallelFor& parallel, double maximumArea, const Poll& poll)
{
  const double most = maximumArea / (heights.Spacing[0] * heights.Spacing[1]);
  const double maximumCells = MaximumCellsOf(static_cast<double>(heights.Values.size()), most);
  GroundMeasures measures;
  const FlowRouting routing = RouteFlow(heights, outlets, parallel, poll);
  MeasureSlopeArea(heights, routing, outlets, maximumCells, parallel, poll, measures);
  return measures.SlopeArea;
}

}
