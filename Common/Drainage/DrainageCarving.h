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

/// Statistics that the carved terrain is to have.
struct CarvingTarget
{
  HeightQuantiles Heights;                 ///< distribution of heights
  RingSpectrum Spectrum;                   ///< power by wave number of the heights less their plane
  PlaneTrend Plane;                        ///< plane that is restored; flatter on a terrain that is longer than Sides
  std::array<double, 2> Sides{ 0.0, 0.0 }; ///< lengths of the terrain that it is the plane of [m]
  double CellArea = 0.0;                   ///< area of a cell of that terrain [m^2]
  GroundMeasures Measures;                 ///< hypsometry, semivariance and concavity to be met
};

/// Target given by statistics. Spectrum, plane, mean and standard deviation stay the terrain's own.
struct TargetStatistics
{
  bool KeepsHypsometry = true;      ///< keeps the distribution of heights too; else that of the next two
  double HypsometricIntegral = 0.4; ///< (mean - lowest) / (highest - lowest), within HypsometricIntegralRange()
  double ElevationSkewness = 0.4;   ///< skewness of the heights, -2 to 2
  double Concavity = 0.45;          ///< concavity index theta of the channels, 0 to 1
};

/// Parameters of carving.
struct CarvingParameters
{
  DrainageOutlets Outlets;
  int ErosionSteps = 10;          ///< steps of stream power before the iterations, 0 to 100
  double Incision = 2.0;          ///< K A^m dt / d of a step at a drainage area of 100 cells, above 0, at most 100
  int MaximumIterations = 40;     ///< 1 to 100
  double ChannelThreshold = 50.0; ///< drainage area of channel heads, hillslopes below [cells], 1 to 1e6
  double ValleyWidth = 3.0;       ///< standard deviation over which changes are spread [cells], 0.5 to 50
  BreachPath Path = BreachPath::LeastCost;
  int Seed = 1; ///< seed of the waves that a terrain lacks
};

/// Tolerances of the statistics of carved terrain against its target.
struct CarvingTolerances
{
  double DepressionFraction = 0.05;
  double HypsometricIntegral = 0.03;
  double ElevationSkewness = 0.15;
  double Semivariance = 0.1; ///< relative, at each lag
  double Concavity = 0.1;
  double CurvatureSkewness = 1.0; ///< largest absolute value, whatever the target's
};

/// Result of carving.
struct CarvingReport
{
  GroundMeasures Before;
  GroundMeasures After;
  int Iterations = 0;        ///< iterations made, at most MaximumIterations
  bool HasConverged = false; ///< all tolerances are met
  std::string UnmetTargets;  ///< else the statistics that are not met, in words
};

/// Callback with the part that is done, 0 to 1. It may end the work by an exception.
using CarvingProgress = std::function<void(double)>;

inline void NoProgress(double) {}

/// Why a terrain cannot be a target: missing values, too few rows, all heights equal; empty when it can.
std::string WhyNoTarget(const GridSamples& place);

/// Target by the statistics of another terrain, as a measured one. Its grid may have another size and spacing.
CarvingTarget TargetOf(
  const GridSamples& place, const DrainageOutlets& outlets = {}, const ParallelFor& parallel = SerialFor);

/// Target by given statistics, for a terrain.
CarvingTarget TargetOf(const GridSamples& terrain, const TargetStatistics& numbers, const DrainageOutlets& outlets = {},
  const ParallelFor& parallel = SerialFor);

/// Why statistics contradict each other, or are out of range; empty when they are good.
std::string WhyInvalid(const TargetStatistics& numbers);

/// Why a terrain cannot be carved with these parameters; empty when it can.
std::string WhyInvalid(const GridSamples& terrain, const CarvingParameters& parameters);

/// Memory that carving takes beside the terrain and the target [bytes].
double CarvingMemory(int width, int height);

/// Largest deviation of the statistics from the target over its tolerance; at most 1 when all are met.
double Misfit(const GroundMeasures& measures, const CarvingTarget& target, const CarvingTolerances& tolerances = {});

/// Statistics that are not within their tolerances of the target's, in words; empty when all are.
std::string UnmetTargets(const GroundMeasures& measures, const GroundMeasures& target);

/**
 * Carves drained valleys into a terrain, with the statistics of the target (Documentation/design/drainage.md).
 *
 * First, unless the depression fraction is within its tolerance already, which is the case of terrain with valleys:
 * - random waves are added to the rings in which the terrain has less than a tenth of the target's power;
 * - each of ErosionSteps steps sets the spectrum and the heights to the target's (1 and 2 below), breaches depressions
 *   in flood order, and takes an implicit step of the stream power law.
 *
 * Then each iteration
 * 1. multiplies the spectrum ring by ring to the target's, and restores the plane;
 * 2. maps heights to the target's distribution by quantile mapping;
 * 3. breaches depressions, routes flow, and grades heights along the flow paths to slopes of at least S = k_s A^-theta
 *    (GradeAlong), between cut and fill;
 * 4. spreads the change over the width of a valley, so that no channel is a slot.
 * The graded heights, mapped once more, drain everywhere, since a monotone map of heights changes no flow path. Where
 * their statistics meet the target they are the result; else theta and the gains of the spectrum are corrected by the
 * deviations, and the next iteration begins. After the last one the best of all is the result.
 *
 * The whole grid is worked on. The result does not depend on the threads.
 */
CarvingReport CarveDrainage(GridSamples& terrain, const CarvingTarget& target, const CarvingParameters& parameters,
  const ParallelFor& parallel = SerialFor, const CarvingProgress& progress = NoProgress);

/// The same for terrain with missing heights: they are filled smoothly, carved along as what is outside, and taken out
/// again. The report is of what is there.
CarvingReport CarveAround(GridSamples& terrain, const CarvingTarget& target, const CarvingParameters& parameters,
  const ParallelFor& parallel = SerialFor, const CarvingProgress& progress = NoProgress);

}

#endif
