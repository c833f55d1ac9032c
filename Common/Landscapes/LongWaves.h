// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLongWaves_h
#define LittoralLongWaves_h

#include "Drainage/DrainageCarving.h"
#include "Drainage/SemivarianceBands.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/**
 * Random heights with the radial spectrum, the plane and the distribution of a place, whose long waves a landscape is
 * to follow. They are corrected by the semivariances that the landscape makes of them.
 */
class LongWaves
{
public:
  /// Waves of a terrain whose spectrum is set to the target's; waves that it lacks are added by the seed. Waves above
  /// `shortest` [cycles/m] are never corrected.
  LongWaves(const GridSamples& terrain, const CarvingTarget& target, double shortest, int seed,
    const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

  /// Heights with the gains of now.
  GridSamples Heights(const ParallelFor& parallel = SerialFor) const;

  /// Multiplies gains by the roots of those that would bring a landscape's semivariances to the target's (GainsFor).
  void Correct(const GridSamples& landscape, const GroundMeasures& target, const ParallelFor& parallel = SerialFor,
    const Poll& poll = NoPoll);

private:
  GridSamples Coefficients;
  PlaneTrend Plane;
  double Step = 0.0;
  double Shortest;
  BandGains Gains{ {}, { 1, 1, 1, 1, 1, 1, 1, 1, 1 }, 1.0 };
};

/// Grid with margins of so many cells, into which it goes on by reflection in the points of its edge, 2 z(edge) -
/// z(mirrored): heights and slopes have no jump there. Margins are shorter than the grid.
GridSamples WithMargins(const GridSamples& grid, int before, int afterX, int afterY, const Poll& poll = NoPoll);

/// Grid with margins that go on as its edge is.
GridSamples WithEdges(const GridSamples& grid, int before, int afterX, int afterY);

/// Part of a grid.
GridSamples PartOf(const GridSamples& grid, int x, int y, int width, int height, const Poll& poll = NoPoll);

/// Means of squares of `factor` times `factor` cells, of which the grid has whole numbers.
GridSamples BlockMeans(const GridSamples& grid, int factor, const Poll& poll = NoPoll);

/// Values at twice as many cells along each axis, linear between the middles of cells.
std::vector<double> Refined(const std::vector<double>& values, int width, int height);

}

#endif
