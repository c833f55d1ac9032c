// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCurveEnvelope_h
#define LittoralCurveEnvelope_h

#include "Numerics/Parallel.h"
#include "Patterns/ObservationWindow.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace littoral
{

/**
 * What curves of simulated patterns say about a measured one.
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
  std::vector<double>
    Low; ///< pointwise: the k-th smallest of the simulated, k = level (simulations + 1) / 2, at least 1
  std::vector<double> High; ///< pointwise: the k-th largest
  std::vector<double> Mean; ///< of the simulated
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

/// A law: makes the pattern of a number 0, 1, 2... from its own random numbers.
using PatternOfNumber = std::function<std::vector<PlanePosition>(int number)>;

/// What is measured of a pattern, a curve of a fixed length.
using CurveOfPattern = std::function<std::vector<double>(const std::vector<PlanePosition>& points)>;

/// The curve of a simulation of a number.
using CurveOfNumber = std::function<std::vector<double>(int number)>;

/// The curves of so many simulations, on all threads that the loop has.
std::vector<std::vector<double>> SimulateCurves(
  const CurveOfNumber& curve, int simulations, const ParallelFor& parallel = SerialFor);

/// The curves of so many patterns of a law.
std::vector<std::vector<double>> SimulateCurves(
  const PatternOfNumber& law, const CurveOfPattern& curve, int simulations, const ParallelFor& parallel = SerialFor);

/// So many points, uniform in a window and independent of each other: pattern `number` of a seed.
std::vector<PlanePosition> UniformPattern(const ObservationWindow& window, std::size_t points, int seed, int number);

/// A random order of so many things, each equally likely: order `number` of a seed.
std::vector<std::size_t> RandomOrder(std::size_t count, int seed, int number);

/// The seed of simulation `number` of a law that has a seed of its own: seeds of different simulations are unrelated.
int SeedOfSimulation(int seed, int number);

}

#endif
