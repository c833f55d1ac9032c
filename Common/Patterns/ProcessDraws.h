// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralProcessDraws_h
#define LittoralProcessDraws_h

// Simulation of each process in a box, for ProcessPattern.

#include "Numerics/Parallel.h"
#include "Patterns/IntensityRaster.h"
#include "Patterns/ProcessLattice.h"
#include "Patterns/ProcessPattern.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace littoral
{

/// A process in the bounding box of a window.
struct ProcessScene
{
  PointProcessParameters Process; ///< process of the highest intensity of the raster
  const ProcessOptions& Options;
  IntensityFactor Factor;
  PatternArea Box;
  const Poll& Called;
  const ParallelFor& Parallel;
};

/// Side of the squares in which points of an intensity are drawn: four in each, on the average.
double DrawingSide(double intensity);

/// Side of the squares on which the field of a log-Gaussian Cox process is constant.
inline double FieldSide(const PointProcessParameters& process)
{
  return process.Range / 16.0;
}

/// Maximum distance of the points of a cluster from their parent [m].
double ClusterReach(const PointProcessParameters& process);

/// Margin around the box of a window in which a Strauss or soft-core process is simulated too [m].
inline double StraussMargin(const PointProcessParameters& process)
{
  return 2.0 * process.Distance;
}

/// Number of Metropolis sweeps, 20 to 200: the more crowded, the more.
int SoftCoreSweeps(const PointProcessParameters& process);

/// Draws the points of one square.
using SquareTask = std::function<void(long long i, long long j, ProcessPattern& pattern)>;

/// Draws the squares of a block in parallel, some squares of `each` points at a time, and joins their points in order.
ProcessPattern DrawSquares(
  const ProcessScene& scene, const CellBlock& block, double each, const std::function<SquareTask()>& makeTask);

/// Joins parts of a pattern, and frees them.
ProcessPattern Joined(std::vector<ProcessPattern>& parts, const ParallelFor& parallel);

/// Adds a point if it lies in the box and is not thinned by the raster.
void KeepPoint(
  const ProcessScene& scene, const PlanePosition& point, const PointIdentity& identity, ProcessPattern& pattern);

ProcessPattern DrawPoisson(const ProcessScene& scene);
ProcessPattern DrawClusters(const ProcessScene& scene);
ProcessPattern DrawCox(const ProcessScene& scene);
ProcessPattern DrawMaternII(const ProcessScene& scene);
ProcessPattern DrawStrauss(const ProcessScene& scene);
ProcessPattern DrawSoftCore(const ProcessScene& scene);

}

#endif
