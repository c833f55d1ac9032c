// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/TerrainZoom.h"

#include "Drainage/DepressionBreaching.h"
#include "Landscapes/BlockInterpolation.h"
#include "Landscapes/HeightCorrection.h"
#include "Landscapes/LandscapeMeasures.h"
#include "Landscapes/LandscapeStep.h"
#include "Landscapes/LongWaves.h"
#include "Landscapes/VoronoiTiles.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/PolledMemory.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace littoral
{

namespace
{

/// Margin about the coarse terrain that is grown along and cut off [coarse cells].
constexpr int Margin = 8;

constexpr int Steps = 12;      ///< of growth
constexpr int FirstPasses = 8; ///< that hold the means of the interpolation
constexpr int LastPasses = 3;  ///< and of what has grown
constexpr int LimitRounds = 4; ///< of breaching within the limits of shifts
constexpr double MostCells = 2e9;

/// Area exponents that a place may tell, and the one where it does not.
constexpr double LeastExponent = 0.35;
constexpr double GreatestExponent = 0.75;
constexpr double UsualExponent = 0.45;

/// Slope of channels over the mean slope where the place tells none.
constexpr double ChannelSlopeFactor = 0.3;

/// Diffusivity by the curvature at two coarse cells, D = 1 / (f s): ridges of fine cells are sharper.
constexpr double CurvatureFactor = 90.0;

/// Threshold slope over the steepest thousandth of the coarse ground, and least slope of rivers over its mean.
constexpr double ThresholdFactor = 3.0;
constexpr std::size_t SteepQuantile = 999;
constexpr double LeastSlopeFactor = 0.002;

/// Curvature of two cells at least, over mean slope and spacing: a plane has none, and no ridges to round.
constexpr double LeastCurvature = 1e-3;

double MeanSpacing(const GridSamples& grid)
{
  return 0.5 * (grid.Spacing[0] + grid.Spacing[1]);
}

/// Prime factors from the least on.
std::vector<int> FactorsOf(int number)
{
  std::vector<int> factors;
  for (int divisor = 2; number > 1; ++divisor)
  {
    for (; number % divisor == 0; number /= divisor)
    {
      factors.push_back(divisor);
    }
  }
  return factors;
}

void Breach(GridSamples& ground, const Poll& poll)
{
  BreachDepressions(ground, BorderOutlets(ground.Width, ground.Height), BreachPath::LeastCost, poll);
}

/// Lets rivers and hillslopes run over a fine ground that keeps the means of coarse cells.
void GrowWithin(GridSamples& fine, const GridSamples& coarse, int factor, const ZoomParameters& parameters,
  const LandscapeMeasures& measures, const ParallelFor& parallel, const CarvingProgress& progress)
{
  const LandscapeLaw law = LawForZoom(coarse, measures);
  const double time = parameters.Growth * measures.MeanSlope * MeanSpacing(coarse) / Steps;
  double done = 0.0;
  const Poll poll = [&] { progress(done); };
  PointMesh mesh = JitteredMesh(fine.Width, fine.Height, fine.Spacing, parameters.Seed, factor, {}, parallel, poll);
  // heights of the points, each in its cell
  GridSamples heights = CopyOf(fine, poll);
  parallel(heights.Values.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      heights.Values[n] = HeightAt(fine, mesh.Points[n]);
    }
  });
  std::vector<double> rock = CopyOf(heights.Values, poll);
  std::fill(rock.begin(), rock.end(), 1.0);
  for (int step = 0; step < Steps; ++step)
  {
    done = static_cast<double>(step) / Steps;
    const MeshDrainage drainage = DrainMesh(mesh, heights.Values, parallel, {}, poll);
    StepLandscape(mesh, drainage, law, 0.0, rock, time, heights.Values, parallel, {}, poll);
    HoldBlockMeans(heights, coarse, factor, 1, parallel, poll);
  }
  fine = GridOf(mesh, heights.Values, parallel, poll);
  GiveBack(mesh.Corners, poll);
  GiveBack(mesh.EdgeRatio, poll);
  GiveBack(mesh.Distance, poll);
  GiveBack(mesh.Neighbour, poll);
}

/// Zooms by one factor a terrain without missing heights.
GridSamples ZoomOnce(const GridSamples& terrain, int factor, const ZoomParameters& parameters,
  const ParallelFor& parallel, const CarvingProgress& progress)
{
  double done = 0.0;
  const Poll poll = [&] { progress(done); };
  const int margin = std::min({ Margin, terrain.Width - 1, terrain.Height - 1 });
  const GridSamples coarse = WithMargins(terrain, margin, margin, margin, poll);
  GridSamples fine = CubicRefinement(coarse, factor, parallel, poll);
  HoldBlockMeans(fine, coarse, factor, FirstPasses, parallel, poll);
  Breach(fine, poll);
  const LandscapeMeasures measures =
    parameters.Growth > 0.0 ? MeasureLandscape(terrain, parallel, poll) : LandscapeMeasures();
  if (measures.MeanSlope > 0.0) // rows that go up and down in turn have none
  {
    GrowWithin(fine, coarse, factor, parameters, measures, parallel, progress);
    HoldBlockMeans(fine, coarse, factor, LastPasses, parallel, poll);
  }
  done = 1.0;
  GridSamples ground =
    PartOf(fine, margin * factor, margin * factor, terrain.Width * factor, terrain.Height * factor, poll);
  Breach(ground, poll);
  return ground;
}

/// Brings shifts of coarse heights within their limits; breaching goes as far as they allow.
void LimitShifts(GridSamples& fine, const GridSamples& coarse, int factor, double share, const Poll& poll)
{
  std::vector<double> limits = ReliefAround(coarse);
  std::transform(limits.begin(), limits.end(), limits.begin(), [&](double relief) { return share * relief; });
  for (int round = 0; round < LimitRounds; ++round)
  {
    LimitBlockShifts(fine, coarse, factor, limits, poll);
    Breach(fine, poll);
  }
  LimitBlockShifts(fine, coarse, factor, limits, poll);
}

/// Measures shifts, and makes missing what is missing in the coarse terrain.
void Finish(ZoomedTerrain& zoomed, const GridSamples& given, const GridSamples& filled, int factor, const Poll& poll)
{
  const GridSamples means = BlockMeans(zoomed.Heights, factor, poll);
  const std::vector<double> relief = ReliefAround(filled);
  for (std::size_t n = 0; n < relief.size(); ++n)
  {
    const double shift = std::isnan(given.Values[n]) ? 0.0 : std::abs(means.Values[n] - filled.Values[n]);
    zoomed.LargestShift = std::max(zoomed.LargestShift, shift);
    zoomed.LargestShare = relief[n] > 0.0 ? std::max(zoomed.LargestShare, shift / relief[n]) : zoomed.LargestShare;
  }
  for (int j = 0; j < zoomed.Heights.Height; ++j)
  {
    poll();
    for (int i = 0; i < zoomed.Heights.Width; ++i)
    {
      const double height = given.At(i / factor, j / factor);
      zoomed.Heights.At(i, j) = std::isnan(height) ? height : zoomed.Heights.At(i, j);
    }
  }
}

}

std::string WhyInvalid(const ZoomParameters& parameters)
{
  ParameterCheck check;
  check.Count("Factor", parameters.Factor, 2, 16);
  check.Range("Growth", parameters.Growth, 0.0, 10.0);
  check.Range("MaximumShift", parameters.MaximumShift, 0.0, 1.0);
  return check.Reason();
}

std::string WhyInvalid(const GridSamples& coarse, const ZoomParameters& parameters)
{
  ParameterCheck check;
  check.Require(WhyInvalid(parameters));
  check.Require(coarse.Width >= 3 && coarse.Height >= 3
      ? ""
      : "The terrain has fewer than 3 rows or columns; no slope can be measured there.");
  const double cells = static_cast<double>(coarse.Width) * coarse.Height * parameters.Factor * parameters.Factor;
  check.Require(cells < MostCells ? "" : "The zoomed terrain has 2e9 cells or more; take a part of it.");
  const std::array<double, 2> range = RangeOf(coarse.Values);
  check.Require(std::isnan(range[0]) ? "The terrain has no heights." : "");
  check.Require(range[0] < range[1] ? "" : "The terrain is constant; water has no way to run there.");
  return check.Reason();
}

double ZoomMemory(int width, int height, int factor, const std::array<double, 2>& spacing)
{
  // of long cells Boost's diagram is of all points, as in GrowthMemory()
  const double bytesPerPoint = AreTiled(spacing) ? 350.0 : 900.0;
  return bytesPerPoint * factor * factor * (width + 2.0 * Margin) * (height + 2.0 * Margin);
}

LandscapeLaw LawForZoom(const GridSamples& coarse, const LandscapeMeasures& measures)
{
  LandscapeLaw law;
  const bool hasLaw = measures.Concavity > 0.1 && measures.Concavity < 1.0 && measures.ChannelSlope > 0.0;
  law.AreaExponent = hasLaw ? std::clamp(measures.Concavity, LeastExponent, GreatestExponent) : UsualExponent;
  // K A_ref^m = U / S_ref
  const double slope = hasLaw ? measures.ChannelSlope : ChannelSlopeFactor * measures.MeanSlope;
  const double area = LandscapeMeasures::ReferenceCells * coarse.Spacing[0] * coarse.Spacing[1];
  law.Erodibility = std::pow(area, -law.AreaExponent) / slope;
  const double least = LeastCurvature * measures.MeanSlope / MeanSpacing(coarse);
  law.Diffusivity = 1.0 / (CurvatureFactor * std::max(measures.CurvatureDeviation, least));
  law.ThresholdSlope = ThresholdFactor * measures.Slopes[SteepQuantile * (measures.Slopes.size() - 1) / 1000];
  law.MinimumSlope = LeastSlopeFactor * measures.MeanSlope;
  return law;
}

std::vector<double> ReliefAround(const GridSamples& heights)
{
  std::vector<double> relief;
  for (int j = 0; j < heights.Height; ++j)
  {
    for (int i = 0; i < heights.Width; ++i)
    {
      double least = heights.At(i, j);
      double most = least;
      for (int y = std::max(j - 1, 0); y <= std::min(j + 1, heights.Height - 1); ++y)
      {
        for (int x = std::max(i - 1, 0); x <= std::min(i + 1, heights.Width - 1); ++x)
        {
          least = std::min(least, heights.At(x, y));
          most = std::max(most, heights.At(x, y));
        }
      }
      relief.push_back(most - least);
    }
  }
  return relief;
}

ZoomedTerrain ZoomTerrain(const GridSamples& given, const ZoomParameters& parameters, const ParallelFor& parallel,
  const CarvingProgress& progress)
{
  GridSamples coarse = given;
  FillHoles(coarse);
  ZoomedTerrain zoomed;
  zoomed.Heights = coarse;
  // most of the work is that of the last factor, which has most cells
  double work = 0.0;
  int done = 1;
  const double all = parameters.Factor * parameters.Factor;
  for (const int factor : FactorsOf(parameters.Factor))
  {
    done *= factor;
    const double part = std::max(done * done / all - work, 0.0);
    zoomed.Heights = ZoomOnce(
      zoomed.Heights, factor, parameters, parallel, [&](double now) { progress(std::min(work + part * now, 1.0)); });
    work += part;
  }
  const Poll poll = [&] { progress(1.0); };
  LimitShifts(zoomed.Heights, coarse, parameters.Factor, parameters.MaximumShift, poll);
  Finish(zoomed, given, coarse, parameters.Factor, poll);
  return zoomed;
}

}
