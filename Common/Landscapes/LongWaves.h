// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLongWaves_h
#define LittoralLongWaves_h

#include "Drainage/DrainageCarving.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/**
 * Random heights with the radial spectrum, the plane and the distribution of a place, whose long waves a landscape is
 * to follow. They are corrected ring by ring by what the landscape makes of them.
 */
class LongWaves
{
public:
  /// Waves of a terrain whose spectrum is set to the target's; waves that it lacks are added by the seed. Rings above
  /// `shortest` [cycles/m] are never corrected.
  LongWaves(const GridSamples& terrain, const CarvingTarget& target, double shortest, int seed,
    const ParallelFor& parallel = SerialFor);

  /// Heights with the gains of now.
  GridSamples Heights(const ParallelFor& parallel = SerialFor) const;

  /// Multiplies gains by (wanted power / power of the landscape)^(1/4), a mean of nearby rings.
  void Correct(const GridSamples& landscape, const ParallelFor& parallel = SerialFor);

private:
  RingSpectrum Wanted;
  GridSamples Coefficients;
  PlaneTrend Plane;
  double Step = 0.0;
  double Shortest;
  std::vector<double> Gains;
};

/// Grid with margins of so many cells, into which it goes on by reflection in the points of its edge, 2 z(edge) -
/// z(mirrored): heights and slopes have no jump there. Margins are shorter than the grid.
GridSamples WithMargins(const GridSamples& grid, int before, int afterX, int afterY);

/// Part of a grid.
GridSamples PartOf(const GridSamples& grid, int x, int y, int width, int height);

/// Means of squares of `factor` times `factor` cells, of which the grid has whole numbers.
GridSamples BlockMeans(const GridSamples& grid, int factor);

/// Values at twice as many cells along each axis, linear between the middles of cells.
std::vector<double> Refined(const std::vector<double>& values, int width, int height);

}

#endif
