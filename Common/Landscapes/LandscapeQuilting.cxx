// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/LandscapeQuilting.h"

#include "Drainage/CoarseGround.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/FlowRouting.h"
#include "Drainage/GroundStatistics.h"
#include "Drainage/ValleySpreading.h"
#include "Landscapes/GroundQuilt.h"
#include "Landscapes/LongWaves.h"
#include "Landscapes/PlaceMatching.h"
#include "Landscapes/QuiltDrainage.h"
#include "Landscapes/RiverSteepness.h"
#include "Landscapes/ShallowDepressions.h"
#include "Landscapes/StreamLikeness.h"
#include "Numerics/ParameterCheck.h"
#include "Terrain/GridHoles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace littoral
{

namespace
{

constexpr int MaximumRounds = 8;
constexpr double SemivarianceTolerance = 0.1;
constexpr double SlopeTolerance = 0.05;
constexpr double SteepnessTolerance = 0.15;

/// Quilts of small ground from which the one with the place's streams is taken: as many as have so many cells, but one
/// at least and not more than these.
constexpr double DrawnCells = 900000.0;
constexpr int MostDraws = 16;

/// Least side of a coarse place and of coarse ground [cells], and the part of the work of a quilt that is done when the
/// coarse one is made.
constexpr int LeastSide = 80;
constexpr double CoarseWork = 0.3;

/// Cells of ground whose streams have 1000 cells and more, and not 100.
constexpr std::size_t LargeGround = 100000;

/// Part of the work of a quilt that is done when its pieces are laid.
constexpr double QuiltWork = 0.5;

/// Least slope of rivers over the place's mean slope.
constexpr double LeastSlopeFactor = 0.002;

/// Part of a depression that is cut at first, and its correction over what the mean slope lacks.
constexpr double FirstCut = 0.75;
constexpr double CutGain = 2.0;

/// Greatest roughness of the ground by which water finds its way, over the place's mean fall from cell to cell.
constexpr double RoughnessFactor = 0.1;

/// Limit of the slopes of rivers over the place's: the greatest, which is the first, and the least one.
constexpr double GreatestLimit = 4.0;
constexpr double LeastLimit = 1.0;

/// Share of cells in depressions that is aimed at, over the place's, the greatest share that is let be for it, as
/// draining takes some of them too, and the share that any ground may have.
constexpr double SunkAim = 0.9;
constexpr double MostLetBe = 2.0;
constexpr double SunkTolerance = 0.05;
constexpr double LeastSunk = 1e-6; ///< no 0 is divided by

/// Cells whose sizes differ by less are of one size.
constexpr double SpacingTolerance = 1e-3;

double MeanSlope(const GridSamples& ground, const Poll& poll)
{
  return ShapeOf(GradientsOf(ground, poll), poll).Mean;
}

std::string WhyOfOtherCells(const GridSamples& terrain, const GridSamples& place)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    if (std::abs(terrain.Spacing[axis] / place.Spacing[axis] - 1.0) > SpacingTolerance)
    {
      return "The terrain and the target have cells of other sizes; pieces need those of the target, " +
        TextOf(place.Spacing[0]) + " x " + TextOf(place.Spacing[1]) + " m.";
    }
  }
  return "";
}

GridSamples Smooth(GridSamples ground, double deviation, const ParallelFor& parallel)
{
  SmoothGrid(ground.Values, ground.Width, ground.Height, deviation, parallel);
  return ground;
}

/// The grid of a ground with other heights.
GridSamples WithHeights(const GridSamples& ground, std::vector<double> heights)
{
  return { ground.Width, ground.Height, ground.Spacing, std::move(heights) };
}

/// A ground and the long waves that it lacks.
GridSamples Sum(GridSamples ground, const GridSamples& waves, const GridSamples& smooth, const ParallelFor& parallel)
{
  parallel(ground.Values.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      ground.Values[n] += waves.Values[n] - smooth.Values[n];
    }
  });
  return ground;
}

void Add(std::vector<double>& heights, const std::vector<double>& depths, double factor, const ParallelFor& parallel)
{
  parallel(heights.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      heights[n] += factor * depths[n];
    }
  });
}

/// Share of the cells of a ground that lie below another.
double ShareBelow(const GridSamples& ground, const GridSamples& other, const Poll& poll)
{
  std::size_t below = 0;
  ForPolled(ground.Values.size(), poll, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      below += ground.Values[n] < other.Values[n];
    }
  });
  return static_cast<double>(below) / static_cast<double>(ground.Values.size());
}

/// A quilt that is drained.
struct Quilted
{
  GridSamples Ground;
  double SemivarianceMisfit = 0.0; ///< over its tolerance
  int Rounds = 0;
};

/// Quilts of a place.
class Quilting
{
public:
  Quilting(const GridSamples& place, int seed, const ParallelFor& parallel, const Poll& poll)
    : Place(place)
    , Target(TargetOf(place, {}, parallel))
    , Matching(place, this->Target)
    , Rivers(place, parallel, poll)
    , SlopeOfPlace(MeanSlope(place, poll))
    , Smoothing(GuideSmoothing(place))
    , Seed(seed)
    , Parallel(parallel)
  {
  }

  const GroundMeasures& Wanted() const { return this->Target.Measures; }

  /// The quilt of a draw along the long waves of a terrain.
  Quilted Draw(const GridSamples& terrain, int draw, const CarvingProgress& progress) const;

private:
  const GridSamples& Place;
  CarvingTarget Target;
  PlaceMatching Matching;
  RiverSteepness Rivers;
  double SlopeOfPlace;
  double Smoothing; ///< of the guide [cells]
  int Seed;
  const ParallelFor& Parallel;
};

Quilted Quilting::Draw(const GridSamples& terrain, int draw, const CarvingProgress& progress) const
{
  double done = 0.0;
  const Poll poll = [&] { progress(done); };
  const ParallelFor& parallel = this->Parallel;
  const double shortest = 1.0 / (4.0 * this->Smoothing * std::max(terrain.Spacing[0], terrain.Spacing[1]));
  LongWaves waves(terrain, this->Target, shortest, this->Seed, parallel, poll);
  GridSamples guide = Smooth(waves.Heights(parallel), this->Smoothing, parallel);
  const GridSamples quilt = QuiltGround(
    this->Place, guide, PieceSideFor(this->Place), this->Seed, parallel,
    [&](double part) { progress(QuiltWork * part); }, draw);
  done = QuiltWork;
  const GridSamples smooth = Smooth(quilt, this->Smoothing, parallel);
  const double greatest = RoughnessFactor * this->SlopeOfPlace * std::sqrt(terrain.Spacing[0] * terrain.Spacing[1]);
  const std::vector<float> roughness = WayRoughness(quilt.Values.size(), greatest, this->Seed, draw, parallel);
  double least = std::numeric_limits<double>::infinity();
  double cut = FirstCut;
  double limit = GreatestLimit;
  const OutletMask border = BorderOutlets(terrain.Width, terrain.Height);
  const double sunkOfPlace = this->Wanted().DepressionFraction;
  double letBe = sunkOfPlace;
  FlowRouting routing;
  Quilted best;
  while (true)
  {
    done = QuiltWork + (1.0 - QuiltWork) * best.Rounds / MaximumRounds;
    GridSamples ground = Sum(quilt, guide, smooth, parallel);
    this->Matching.Match(ground, 1.0, parallel, poll);
    GridSamples filled = WithHeights(ground,
      routing.Order.empty() ? FloodDepressions(ground, border, poll).SpillElevation
                            : SpillElevationsBy(routing, ground, poll));
    std::vector<double> pits = ShallowDepressions(ground, filled.Values, letBe, poll);
    Add(ground.Values, pits, 1.0, parallel);
    filled.Values = std::vector<double>();
    routing = {};
    routing = DrainQuilt(
      ground, roughness, LeastSlopeFactor * this->SlopeOfPlace, cut, this->Rivers.Law(limit), parallel, poll);
    Add(ground.Values, pits, -1.0, parallel);
    pits = std::vector<double>();
    if (this->Rivers.IsKnown())
    {
      this->Matching.Match(ground, 1.0, parallel, poll); // a monotone map turns no water
    }
    const double steep = MeanSlope(ground, poll) / this->SlopeOfPlace;
    filled.Values = SpillElevationsBy(routing, ground, poll);
    const double steepOfRivers = this->Rivers.RatioOf(filled, parallel, poll);
    const double sunk = ShareBelow(ground, filled, poll);
    filled.Values = std::vector<double>();
    const double semivarianceMisfit = this->Matching.SemivarianceError(ground, parallel) / SemivarianceTolerance;
    const double misfit = std::max({ semivarianceMisfit, std::abs(steep - 1.0) / SlopeTolerance,
      std::abs(steepOfRivers - 1.0) / SteepnessTolerance, sunk / std::max(SunkTolerance, sunkOfPlace) });
    ++best.Rounds;
    const bool isLast = misfit <= 1.0 || best.Rounds == MaximumRounds;
    if (!isLast)
    {
      // what is filled is flat, and what is cut is steep
      cut = std::clamp(cut + CutGain * (1.0 - steep), 0.0, 1.0);
      limit = std::clamp(limit / steepOfRivers, LeastLimit, GreatestLimit);
      letBe = std::min(MostLetBe * sunkOfPlace, letBe * SunkAim * sunkOfPlace / std::max(sunk, LeastSunk));
      waves.Correct(ground, this->Wanted(), parallel, poll);
      guide = Smooth(waves.Heights(parallel), this->Smoothing, parallel);
    }
    if (misfit < least)
    {
      least = misfit;
      best.SemivarianceMisfit = semivarianceMisfit;
      best.Ground = std::move(ground);
    }
    if (isLast)
    {
      return best;
    }
  }
}

int DrawsOf(const GridSamples& terrain)
{
  const auto cells = static_cast<double>(terrain.Values.size());
  return static_cast<int>(std::clamp(DrawnCells / cells, 1.0, static_cast<double>(MostDraws)));
}

/// The first draw whose streams are the place's, or the one whose misfits are least.
Quilted LikestOf(const Quilting& quilting, const GridSamples& place, const GridSamples& terrain,
  const ParallelFor& parallel, const CarvingProgress& progress)
{
  const int draws = DrawsOf(terrain);
  double done = 0.0;
  const Poll poll = [&] { progress(done); };
  const auto drawn = [&](int draw) {
    done = static_cast<double>(draw) / draws;
    return quilting.Draw(terrain, draw, [&](double part) { progress(done + part / draws); });
  };
  if (draws == 1)
  {
    return drawn(0);
  }
  const bool isLarge = std::min(place.Values.size(), terrain.Values.size()) >= LargeGround;
  const auto measuresOf = [&](const GridSamples& ground) {
    return MeasureStreams(ground, isLarge ? 1000 : 100, parallel, poll);
  };
  const StreamMeasures streams = measuresOf(place);
  Quilted likest;
  std::vector<double> least;
  const auto isMet = [](double misfit) { return misfit <= 1.0; };
  for (int draw = 0; draw == 0 || (draw < draws && !std::all_of(least.begin(), least.end(), isMet)); ++draw)
  {
    Quilted quilted = drawn(draw);
    std::vector<double> misfits = StreamMisfits(measuresOf(quilted.Ground), streams);
    misfits.push_back(quilted.SemivarianceMisfit);
    if (draw == 0 || SumOfMisfits(misfits) < SumOfMisfits(least))
    {
      least = std::move(misfits);
      likest = std::move(quilted);
    }
  }
  return likest;
}

/// Terrain with the long waves of a coarse quilt, of the place with half as many cells along each side, whose pieces
/// are longer: trunk valleys and ranges come first.
GridSamples WithCoarseQuilt(
  GridSamples terrain, const GridSamples& place, int seed, const ParallelFor& parallel, const CarvingProgress& progress)
{
  if (std::min({ terrain.Width, terrain.Height, place.Width, place.Height }) < 2 * LeastSide)
  {
    return terrain;
  }
  double done = 0.0;
  const Poll poll = [&] { progress(done); };
  const GridSamples coarsePlace = BlockMeans(place, 2, poll);
  const GridSamples coarse = WithCoarseQuilt(CoarseGround(terrain, parallel, poll), coarsePlace, seed, parallel,
    [&](double part) { progress(CoarseWork * part); });
  done = CoarseWork;
  const Quilting quilting(coarsePlace, seed, parallel, poll);
  const Quilted likest = LikestOf(
    quilting, coarsePlace, coarse, parallel, [&](double part) { progress(CoarseWork + (1.0 - CoarseWork) * part); });
  done = 1.0;
  TakeLongWaves(terrain, likest.Ground, parallel, poll);
  return terrain;
}

}

std::string WhyNoQuilt(const GridSamples& terrain, const GridSamples& place)
{
  ParameterCheck check;
  check.Require(WhyTooSmall(terrain, "The terrain"));
  check.Require(WhyTooSmall(place, "The target"));
  check.Require(WhyOfOtherCells(terrain, place));
  return check.Reason();
}

double QuiltMemory(int width, int height)
{
  constexpr double bytesPerCell = 150.0; // channels, waves, guide, quilt, the best, and one more to match
  return bytesPerCell * width * height;
}

CarvingReport QuiltLandscape(GridSamples& terrain, const GridSamples& measured, int seed, const ParallelFor& parallel,
  const CarvingProgress& progress)
{
  double done = 0.0;
  const Poll poll = [&] { progress(done); };
  GridSamples place = CopyOf(measured, poll);
  FillHoles(place, poll);
  const GridSamples given = CopyOf(terrain, poll);
  const OutletMask rim = RimOutlets(given);
  FillHoles(terrain, poll);
  terrain =
    WithCoarseQuilt(std::move(terrain), place, seed, parallel, [&](double part) { progress(CoarseWork * part); });
  done = CoarseWork;
  const Quilting quilting(place, seed, parallel, poll);
  Quilted likest = LikestOf(
    quilting, place, terrain, parallel, [&](double part) { progress(CoarseWork + (1.0 - CoarseWork) * part); });
  done = 1.0;
  terrain = std::move(likest.Ground);
  TakeHoles(given, terrain, poll);
  CarvingReport report;
  report.Iterations = likest.Rounds;
  const GroundMeasures& wanted = quilting.Wanted();
  report.Before = MeasureGround(given, rim, parallel, poll, wanted.MaximumArea);
  report.After = MeasureGround(terrain, rim, parallel, poll, wanted.MaximumArea);
  report.UnmetTargets = UnmetTargets(report.After, wanted);
  report.HasConverged = report.UnmetTargets.empty();
  return report;
}

}
