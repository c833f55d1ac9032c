// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCurveEnvelope_h
#define LittoralCurveEnvelope_h

#include "Numerics/Parallel.h"
#include "Numerics/WorkShare.h"
#include "Patterns/ObservationWindow.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace littoral
{

/**
 * Envelope test of a measured curve against those of simulated patterns.
 *
 * The global test is that of extreme rank lengths (Myllymäki et al. 2017). At each distance a curve has the rank 1 if
 * it is the lowest or the highest of all, 2 next to these, and so on, the mean of the ranks of curves that are equal
 * there. Curves are ordered by their smallest rank, then by their next smallest, and so on. p = (curves that are as
 * extreme as the measured one or more, itself among them) / (all curves): if the law is true, p <= level has a
 * probability of at most the level, whatever the number of distances. The global band is spanned by the curves that
 * are left when as many of the most extreme are taken as the level allows; a curve leaves it somewhere if p <= level.
 */
struct CurveEnvelope
{
  /// Pointwise envelope: the k-th smallest of the simulated curves, k = level (simulations + 1) / 2, at least 1.
  std::vector<double> Low;
  std::vector<double> High; ///< pointwise envelope: the k-th largest
  std::vector<double> Mean; ///< mean of the simulated curves
  std::vector<double> GlobalLow;
  std::vector<double> GlobalHigh;
  double PValue = 1.0;
  double Level = 0.05;
  bool IsRejected = false; ///< p <= level
  /// The distances at which the measured curve is outside the global band, by their numbers.
  std::vector<std::size_t> Outside;
};

/// Why there cannot be a test: fewer simulations than 1 / level - 1, or a level that is no probability. Empty if there
/// can.
std::string WhyNoEnvelope(int simulations, double level);

/// Compares a measured curve with simulated ones of the same length. Distances at which any curve is not finite are
/// left out; their bands are NaN.
CurveEnvelope FindCurveEnvelope(
  const std::vector<double>& measured, const std::vector<std::vector<double>>& simulated, double level = 0.05);

/// Null model: makes the pattern of a number 0, 1, 2... from its own random numbers.
using PatternOfNumber = std::function<std::vector<PlanePosition>(int number, const ParallelFor& parallel)>;

/// Summary function of a pattern, a curve of a fixed length.
using CurveOfPattern =
  std::function<std::vector<double>(const std::vector<PlanePosition>& points, const ParallelFor& parallel)>;

/// Curve of a simulation of a number.
using CurveOfNumber = std::function<std::vector<double>(int number, const ParallelFor& parallel)>;

/// The poll of simulations comes so many times, each time after a part of them.
inline constexpr int PollsOfCurves = 4;

/// Curves of so many simulations, side by side on all threads of the loop; or, where the first takes longer than a
/// batch of a loop should, one by one, each on all threads, so that the loop can be ended within one. Processes share
/// them: the first gets those of the others, which have their own alone.
NumberRows SimulateCurves(const CurveOfNumber& curve, int simulations, const Poll& poll = NoPoll,
  const ParallelFor& parallel = SerialFor, const WorkShare& share = {});

/// Curves of so many patterns of a null model.
NumberRows SimulateCurves(const PatternOfNumber& law, const CurveOfPattern& curve, int simulations,
  const Poll& poll = NoPoll, const ParallelFor& parallel = SerialFor, const WorkShare& share = {});

/// Binomial point process of so many points in a window: pattern `number` of a seed.
std::vector<PlanePosition> UniformPattern(const ObservationWindow& window, std::size_t points, int seed, int number);

/// Random permutation of so many things: permutation `number` of a seed, as for random labelling.
std::vector<std::size_t> RandomOrder(std::size_t count, int seed, int number);

/// Seed of simulation `number` of a null model that has a seed of its own: seeds of different simulations are
/// unrelated.
int SeedOfSimulation(int seed, int number);

}

#endif
