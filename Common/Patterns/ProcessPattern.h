// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralProcessPattern_h
#define LittoralProcessPattern_h

#include "Numerics/Parallel.h"
#include "Patterns/IntensityRaster.h"
#include "Patterns/ObservationWindow.h"
#include "Patterns/PointProcess.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace littoral
{

/// What belongs to a cluster as a whole, or to each point by itself.
enum class SpeciesGrouping
{
  Points = 0,   ///< each point has a species of its own: species share their clusters, so they attract each other
  Clusters = 1, ///< all points of a cluster are of one species: species have clusters of their own
};

/// What a simulated pattern is besides its process.
struct ProcessOptions
{
  int Seed = 1;
  const IntensityRaster* Raster = nullptr; ///< of the intensity, or of the activity; null: the same everywhere
  std::vector<double> SpeciesShares;       ///< of the points, not negative, not all zero; empty: one species
  SpeciesGrouping Grouping = SpeciesGrouping::Points;
  /// Interaction of two points of different species of a Strauss process, 0 (they avoid each other strictly) to 1
  /// (none)
  double CrossInteraction = 1.0;
};

/// Where the random numbers of a point come from; no two points share them.
struct PointIdentity
{
  std::uint64_t Object = 0; ///< a square of the plane
  std::uint64_t Draw = 0;   ///< number in it; in a cluster that of the parent times 2^32, plus that of the point
};

/// Points in the order of the squares of the plane.
struct ProcessPattern
{
  std::vector<PlanePosition> Points;     ///< [m]
  std::vector<PointIdentity> Identities; ///< of the points
  std::vector<int> Species;              ///< of the points, 0 to number of shares - 1; empty with one species
  bool HasClusters = false;
  bool IsExact = true; ///< false where the birth-death process of a Strauss process was only followed for BurnIn
};

/// Lifetimes before the bounds of the exact simulation of a Strauss process are no longer waited for, and those after
/// which a pattern is taken that is not exact.
inline constexpr int MaximumCouplingTime = 128;
inline constexpr int BurnIn = 32;

/// Why there is no pattern of the process in the window, or one that takes too long, in words for a user; empty when
/// there is one.
std::string WhyInvalid(
  const PointProcessParameters& process, const ProcessOptions& options, const ObservationWindow& window);

/// Mean number of points, parents or cells of a field that are drawn for a pattern, for a check of memory.
double ExpectedDraws(
  const PointProcessParameters& process, const ProcessOptions& options, const ObservationWindow& window);

/**
 * The points of a process in a window, which must be valid together. All but the last two are processes of the plane,
 * of which the window shows a part: the points in two windows are the same where the windows overlap. A Strauss process
 * has no points farther than twice its Distance from the bounding box of the window.
 *
 * - Poisson, Thomas, Matern cluster: counts of points or parents in squares, all parents in reach of the window.
 * - Matern II: ages of random points; an older one nearer than Distance ends a point.
 * - Log-Gaussian Cox: the Gaussian field by turning bands of 128 lines, constant on squares of Range / 16.
 * - Strauss: dominated coupling from the past (Kendall and Moller 2000). The random births and deaths of an infinite
 *   time are bounded from above and below; once the bounds have met in the window, what they have met in is a draw from
 *   the process, free of any error. Where they have not met after MaximumCouplingTime lifetimes, or cannot be hoped
 *   to since Activity (1 - Interaction) pi Distance^2 is 4 or more, the pattern is that of one birth-death process
 * after BurnIn lifetimes from an empty window, and IsExact is false.
 *
 * - Soft core: the points of a torus, the bounding box of the window and twice Distance on each side, of which each is
 *   moved 20 to 200 times, the more crowded the more, by the rule of Metropolis from random places; IsExact is false.
 *
 * A raster keeps each point of the process of the highest intensity with the share of its place, which keeps distances
 * of inhibition; for a Strauss process it is the activity that changes from place to place.
 */
ProcessPattern SimulateProcess(const PointProcessParameters& process, const ProcessOptions& options,
  const ObservationWindow& window, const Poll& poll = NoPoll, const ParallelFor& parallel = SerialFor);

/// How marks are drawn: log-normal, positive.
struct MarkOptions
{
  int Seed = 1;
  double Mean = 1.0;      ///< positive
  double Variation = 0.3; ///< standard deviation over mean, 0 to 3
  double ClusterCorrelation = 0.0; ///< part of the variance of the logarithm that the points of a cluster share, 0 to 1; 0 without
};

/// Why marks cannot be drawn so; empty when they can.
std::string WhyInvalid(const MarkOptions& options);

/// A mark for each point, a function of the seed and its identity.
std::vector<double> DrawMarks(const ProcessPattern& pattern, const MarkOptions& options);

}

#endif
