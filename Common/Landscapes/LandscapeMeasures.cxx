// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/LandscapeMeasures.h"

#include "Drainage/DepressionFilling.h"
#include "Drainage/DrainageOutlets.h"
#include "Drainage/GroundMeasures.h"
#include "Drainage/GroundStatistics.h"
#include "Drainage/LeastSquaresLine.h"
#include "Drainage/ValleySpreading.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace littoral
{

namespace
{

constexpr int BlocksAlong = 10; ///< along the shorter side
constexpr double CurvatureCells = 2.0;
constexpr int SlopeQuantiles = 1001;

/// Deviation over mean of the mean slopes of square blocks, without what is left over at the far sides.
double BlockVariationOf(const std::vector<double>& slopes, int width, int height)
{
  const int side = std::max(1, std::min(width, height) / BlocksAlong);
  const int columns = width / side;
  std::vector<double> sums(static_cast<std::size_t>(columns) * (height / side), 0.0);
  for (int j = 0; j < height / side * side; ++j)
  {
    for (int i = 0; i < columns * side; ++i)
    {
      sums[static_cast<std::size_t>(j / side) * columns + i / side] += slopes[static_cast<std::size_t>(j) * width + i];
    }
  }
  const SampleShape shape = ShapeOf(sums);
  return shape.Mean > 0.0 ? shape.StandardDeviation / shape.Mean : 0.0;
}

/// Slope of the law through the slope-area relation at ReferenceCells.
double ReferenceSlope(const GroundMeasures& ground)
{
  std::vector<double> areas;
  std::vector<double> slopes;
  for (const SlopeAreaBin& bin : ground.SlopeArea)
  {
    areas.push_back(std::log(bin.Cells / LandscapeMeasures::ReferenceCells));
    slopes.push_back(std::log(bin.Slope));
  }
  // ln S = ln S_ref - theta ln (A / A_ref)
  return std::isnan(ground.Concavity) ? 0.0 : std::exp(LineThrough(areas, slopes).Intercept);
}

}

LandscapeMeasures MeasureLandscape(const GridSamples& heights, const ParallelFor& parallel, const Poll& poll)
{
  LandscapeMeasures measures;
  const std::vector<double> slopes = GradientsOf(heights, poll);
  measures.MeanSlope = ShapeOf(slopes, poll).Mean;
  measures.Slopes = EvenQuantiles(slopes, SlopeQuantiles, poll);
  const auto gentle =
    std::count_if(slopes.begin(), slopes.end(), [&](double slope) { return slope < 0.25 * measures.MeanSlope; });
  measures.GentleFraction = static_cast<double>(gentle) / static_cast<double>(slopes.size());
  measures.BlockVariation = BlockVariationOf(slopes, heights.Width - 2, heights.Height - 2);
  poll();
  GridSamples smooth = heights;
  SmoothGrid(smooth.Values, smooth.Width, smooth.Height, CurvatureCells, parallel);
  measures.CurvatureDeviation = ShapeOf(LaplaciansOf(smooth, poll), poll).StandardDeviation;
  const OutletMask border = BorderOutlets(heights.Width, heights.Height);
  GridSamples filled = heights;
  filled.Values = FloodDepressions(heights, border, poll).SpillElevation;
  const GroundMeasures ground = MeasureGround(filled, border, parallel, poll);
  measures.Concavity = ground.Concavity;
  measures.ChannelSlope = ReferenceSlope(ground);
  return measures;
}

double KolmogorovDistance(const std::vector<double>& one, const std::vector<double>& other)
{
  // max |F(x) - G(x)| at the quantiles of F: F is the share of those up to x
  const auto last = static_cast<double>(one.size() - 1);
  double most = 0.0;
  for (std::size_t n = 0; n < one.size(); ++n)
  {
    const auto low = std::lower_bound(other.begin(), other.end(), one[n]) - other.begin();
    const auto high = std::upper_bound(other.begin(), other.end(), one[n]) - other.begin();
    const double share = static_cast<double>(n);
    most = std::max({ most, (static_cast<double>(low) - share) / last, (share - static_cast<double>(high)) / last });
  }
  return most;
}

double AspectShare(const GridSamples& heights, int folds)
{
  std::complex<double> turned = 0.0;
  double all = 0.0;
  for (int j = 1; j < heights.Height - 1; ++j)
  {
    for (int i = 1; i < heights.Width - 1; ++i)
    {
      const double x = (heights.At(i + 1, j) - heights.At(i - 1, j)) / heights.Spacing[0];
      const double y = (heights.At(i, j + 1) - heights.At(i, j - 1)) / heights.Spacing[1];
      const double slope = std::hypot(x, y);
      turned += std::polar(slope, folds * std::atan2(y, x));
      all += slope;
    }
  }
  return all > 0.0 ? std::abs(turned) / all : 0.0;
}

}
