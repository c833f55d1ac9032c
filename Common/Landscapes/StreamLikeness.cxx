// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/StreamLikeness.h"

#include "Drainage/CellLattice.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/DrainageOutlets.h"
#include "Drainage/FlowRouting.h"
#include "Drainage/GroundStatistics.h"
#include "Drainage/TrunkValleys.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

constexpr CellIndex HackCells = 100;
constexpr int ReliefCells = 10;

constexpr double ConcavityTolerance = 0.1;
constexpr double SteepnessTolerance = 0.15;
constexpr double DensityTolerance = 0.2;
constexpr double ReliefTolerance = 0.2;
constexpr double HackTolerance = 0.05;
constexpr double TrunkTolerance = 0.25;
constexpr double LeastTrunkTolerance = 0.1;
constexpr double IntegralTolerance = 0.03;
constexpr double SkewTolerance = 0.15;
constexpr double SunkTolerance = 0.05;

/// Mean over the bins of ln S + c ln A; NaN where there are none.
double LogSteepness(const std::vector<SlopeAreaBin>& bins, double concavity)
{
  double sum = 0.0;
  for (const SlopeAreaBin& bin : bins)
  {
    sum += std::log(bin.Slope) + concavity * std::log(bin.Cells);
  }
  return sum / static_cast<double>(bins.size());
}

/// Largest |r - 1| of the ratios of heights off streams, each over its ground's deviation.
double ReliefOff(const StreamMeasures& ground, const StreamMeasures& place)
{
  double most = 0.0;
  for (std::size_t n = 0; n < std::min(ground.Relief.size(), place.Relief.size()); ++n)
  {
    const double ratio = ground.Relief[n].Height / ground.Heights.StandardDeviation /
      (place.Relief[n].Height / place.Heights.StandardDeviation);
    most = std::max(most, std::abs(ratio - 1.0));
  }
  return ground.Relief.empty() ? std::numeric_limits<double>::quiet_NaN() : most;
}

}

StreamMeasures MeasureStreams(
  const GridSamples& ground, CellIndex streamCells, const ParallelFor& parallel, const Poll& poll)
{
  const OutletMask border = BorderOutlets(ground.Width, ground.Height);
  StreamMeasures measures;
  measures.Heights = MeasureGround(ground, border, parallel, poll);
  FlowRouting routing = RouteFlow(ground, border, parallel, poll, FlatWays::Shortest);
  std::vector<CellIndex> cells = FlowAccumulation(routing, poll);
  measures.Hack = HackExponent(LongestFlowLengths(routing, CellLattice(ground)), cells, HackCells);
  measures.Relief = HeightsAboveStreams(ground, routing, cells, streamCells, ReliefCells);
  GridSamples filled = ground;
  filled.Values = FloodDepressions(ground, border, poll).SpillElevation;
  measures.Filled = MeasureGround(filled, border, parallel, poll);
  routing = RouteFlow(filled, border, parallel, poll, FlatWays::Shortest);
  cells = FlowAccumulation(routing, poll);
  measures.Density = ChannelsOf(filled, routing, cells).Density;
  measures.Trunks = TrunkValleyLength(filled, cells);
  return measures;
}

std::vector<double> StreamMisfits(const StreamMeasures& ground, const StreamMeasures& place)
{
  std::vector<double> misfits;
  const auto add = [&](double of, double wanted, double tolerance) {
    if (!std::isnan(wanted))
    {
      misfits.push_back(std::isnan(of) ? std::numeric_limits<double>::infinity() : std::abs(of - wanted) / tolerance);
    }
  };
  const double concavity = place.Filled.Concavity;
  add(ground.Filled.Concavity, concavity, ConcavityTolerance);
  if (!std::isnan(concavity))
  {
    const double ratio =
      std::exp(LogSteepness(ground.Filled.SlopeArea, concavity) - LogSteepness(place.Filled.SlopeArea, concavity));
    add(ratio, 1.0, SteepnessTolerance);
  }
  add(ground.Density, place.Density, DensityTolerance * place.Density);
  if (!place.Relief.empty())
  {
    add(ReliefOff(ground, place), 0.0, ReliefTolerance);
  }
  add(ground.Hack, place.Hack, HackTolerance);
  add(ground.Trunks, place.Trunks, std::max(TrunkTolerance * place.Trunks, LeastTrunkTolerance));
  add(ground.Heights.HypsometricIntegral, place.Heights.HypsometricIntegral, IntegralTolerance);
  add(ground.Heights.ElevationSkewness, place.Heights.ElevationSkewness, SkewTolerance);
  add(ground.Heights.DepressionFraction, 0.0, std::max(SunkTolerance, place.Heights.DepressionFraction));
  return misfits;
}

double SumOfMisfits(const std::vector<double>& misfits)
{
  double sum = 0.0;
  for (const double misfit : misfits)
  {
    sum += std::isinf(misfit) ? 1.0 : misfit * misfit / (1.0 + misfit * misfit);
  }
  return sum;
}

}
