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

/// Assignment of species, by point or by cluster.
enum class SpeciesGrouping
{
  Points = 0,   ///< each point has a species of its own: species share their clusters, so they attract each other
  Clusters = 1, ///< all points of a cluster are of one species: species have clusters of their own
};

/// Seed, intensity and species of a simulated pattern.
struct ProcessOptions
{
  int Seed = 1;
  const IntensityRaster* Raster = nullptr; ///< raster of the intensity, or of the activity; null: homogeneous
  std::vector<double> SpeciesShares;       ///< weights of the species, not negative, not all zero; empty: one species
  SpeciesGrouping Grouping = SpeciesGrouping::Points;
  /// Interaction gamma_12 of two points of different species of a Strauss process, 0 (hard core) to 1 (none).
  double CrossInteraction = 1.0;
};

/// Random numbers of a point; no two points share them.
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
  bool IsExact = true; ///< false: the last state of a Markov chain, not of coupling from the past
};

/// Longest coupling from the past of a Strauss process, and burn-in of a simulation that is not exact [mean lifetimes].
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
 * Simulates a process in a window, which must be valid together. All but the last two are processes of the plane, of
 * which the window shows a part: the points in two windows are the same where the windows overlap. A Strauss process
 * has no points farther than twice its Distance from the bounding box of the window.
 *
 * - Poisson, Thomas, Matern cluster: Poisson counts of points or parents in squares, all parents in reach of the
 *   window.
 * - Matern II: dependent thinning of Poisson points by their ages.
 * - Log-Gaussian Cox: the Gaussian field by turning bands of 128 lines, constant on squares of Range / 16.
 * - Strauss: perfect simulation by dominated coupling from the past (Kendall and Moller 2000): a birth-death process
 *   between an upper and a lower one; once these coincide in the window, their state is an exact draw. Where they have
 *   not after MaximumCouplingTime lifetimes, or where Activity (1 - Interaction) pi Distance^2 is 4 or more, the
 *   pattern is that of one birth-death process after BurnIn lifetimes from an empty window, and IsExact is false.
 * - Soft core: Metropolis sampling from random places on a torus, the bounding box of the window and twice Distance on
 *   each side, by 20 to 200 sweeps, the more crowded the more; IsExact is false.
 *
 * A raster makes the process inhomogeneous by independent thinning of that of the highest intensity, which keeps
 * inhibition distances; for a Strauss process the activity is inhomogeneous.
 */
ProcessPattern SimulateProcess(const PointProcessParameters& process, const ProcessOptions& options,
  const ObservationWindow& window, const Poll& poll = NoPoll, const ParallelFor& parallel = SerialFor);

/// Options of the marks, log-normal and positive.
struct MarkOptions
{
  int Seed = 1;
  double Mean = 1.0;      ///< mean, positive
  double Variation = 0.3; ///< coefficient of variation, 0 to 3
  /// Part of the variance of the logarithm that the points of a cluster share, 0 to 1; of no effect without clusters.
  double ClusterCorrelation = 0.0;
};

/// Why marks cannot be drawn so; empty when they can.
std::string WhyInvalid(const MarkOptions& options);

/// Log-normal marks of the points, functions of the seed and the points' identities, ln m = ln Mean - s^2 / 2 + s
/// (rho^(1/2) z_cluster + (1 - rho)^(1/2) z_point), with s^2 = ln(1 + Variation^2), rho = ClusterCorrelation and
/// standard normal z.
std::vector<double> DrawMarks(
  const ProcessPattern& pattern, const MarkOptions& options, const ParallelFor& parallel = SerialFor);

}

#endif
