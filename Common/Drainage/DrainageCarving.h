// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDrainageCarving_h
#define LittoralDrainageCarving_h

#include "Drainage/DepressionBreaching.h"
#include "Drainage/DrainageOutlets.h"
#include "Drainage/GroundMeasures.h"
#include "Drainage/HeightQuantiles.h"
#include "Drainage/RingSpectrum.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <array>
#include <functional>
#include <string>

namespace littoral
{

/// What carved ground shall be like.
struct CarvingTarget
{
  HeightQuantiles Heights; ///< distribution of heights
  RingSpectrum Spectrum;   ///< power by wave number of the heights less their plane
  PlaneTrend Plane;        ///< the plane that is restored; flatter on a terrain that is longer than Sides
  std::array<double, 2> Sides{ 0.0, 0.0 }; ///< of the ground of which it is the plane [m]
  double CellArea = 0.0;                   ///< of that ground [m^2]
  GroundMeasures Measures;                 ///< hypsometry, semivariance and concavity to be met
};

/// A target in numbers. Spectrum, plane, mean and standard deviation stay the terrain's own.
struct TargetStatistics
{
  bool KeepsHypsometry = true; ///< the distribution of heights stays the terrain's own too; else that of the two that follow
  double HypsometricIntegral = 0.4; ///< (mean - lowest) / (highest - lowest), within HypsometricIntegralRange()
  double ElevationSkewness = 0.4;          ///< from -2 to 2
  double Concavity = 0.45;          ///< from 0 to 1
};

/// How to carve.
struct CarvingParameters
{
  DrainageOutlets Outlets;
  int ErosionSteps = 10;      ///< steps of stream power before the rounds, 0 to 100
  double Incision = 2.0;      ///< K A^m dt / d of a step at a drainage area of 100 cells, above 0, at most 100
  int MaximumIterations = 40;        ///< 1 to 100
  double ChannelThreshold = 50.0; ///< drainage area from which the channel law rules, hillslopes below [cells], 1 to 1e6
  double ValleyWidth = 3.0;   ///< standard deviation of the width over which a cut is spread [cells], 0.5 to 50
  BreachPath Path = BreachPath::LeastCost;
  int Seed = 1; ///< of the waves that a terrain lacks
};

/// What is still allowed between carved ground and its target.
struct CarvingTolerances
{
  double DepressionFraction = 0.05;
  double HypsometricIntegral = 0.03;
  double ElevationSkewness = 0.15;
  double Semivariance = 0.1; ///< part of the target's, at each lag
  double Concavity = 0.1;
  double CurvatureSkewness = 1.0; ///< in size, whatever the target's
};

/// What came of it.
struct CarvingReport
{
  GroundMeasures Before;
  GroundMeasures After;
  int Iterations = 0;                ///< that were needed, or made in vain
  bool HasConverged = false; ///< all tolerances are met
  std::string UnmetTargets;            ///< else the measures that are not, in words
};

/// Part that is done, 0 to 1. It may end the work by an exception.
using CarvingProgress = std::function<void(double)>;

inline void NoProgress(double) {}

/// Why ground cannot be a target: holes, too few rows, all heights equal; empty when it can.
std::string WhyNoTarget(const GridSamples& place);

/// The target that a measured place, or any other ground, sets. Its grid may have another size and spacing.
CarvingTarget TargetOf(
  const GridSamples& place, const DrainageOutlets& outlets = {}, const ParallelFor& parallel = SerialFor);

/// The target that numbers set for a terrain.
CarvingTarget TargetOf(const GridSamples& terrain, const TargetStatistics& numbers, const DrainageOutlets& outlets = {},
  const ParallelFor& parallel = SerialFor);

/// Why numbers contradict each other, or are out of range; empty when they are good.
std::string WhyInvalid(const TargetStatistics& numbers);

/// Why a terrain cannot be carved so; empty when it can.
std::string WhyInvalid(const GridSamples& terrain, const CarvingParameters& parameters);

/// Memory that carving takes beside the terrain and the target [bytes].
double CarvingMemory(int width, int height);

/// How far from the target measures are: the largest deviation over its tolerance, at most 1 when all are met.
double Misfit(const GroundMeasures& measures, const CarvingTarget& target, const CarvingTolerances& tolerances = {});

/**
 * Carves valleys that drain into a terrain, and keeps its measured statistics (Documentation/design/drainage.md).
 *
 * Waves of which the terrain has less than a tenth of the target's power are made up at random, so that no other step
 * has to blow up what is not there. Then rivers cut into it: in each of some steps the spectrum and the heights are
 * made the target's (1 and 2 below), depressions are breached in the order of the flood, and every cell takes an
 * implicit step of stream power. Ground of which no more than the tolerated share is sunk has its valleys and is spared
 * this.
 *
 * At last each round
 * 1. multiplies the spectrum ring by ring to the target's, and restores the plane;
 * 2. maps heights to the target's distribution by their ranks;
 * 3. breaches depressions, routes water, and grades the ground along its ways: no slope is below the steady state of
 *    stream power, S = k_s A^-theta from the channel cells on. Of the ground that is cut for it and the ground that is
 *    filled for it the graded ground is the mean;
 * 4. spreads the change over the width of a valley, so that no channel is a slot.
 * The ground graded by itself and mapped once more is measured: it drains everywhere, since a map that grows with
 * height changes no way of water. When the measures meet the target it is the result; else theta and the spectrum's
 * gains are corrected by what is missing, and the next round begins. After the last round the best of all is the
 * result.
 *
 * The whole grid is worked on. The result does not depend on the threads.
 */
CarvingReport CarveDrainage(GridSamples& terrain, const CarvingTarget& target, const CarvingParameters& parameters,
  const ParallelFor& parallel = SerialFor, const CarvingProgress& progress = NoProgress);

}

#endif
