// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPointMesh_h
#define LittoralPointMesh_h

#include "Drainage/CellLattice.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <array>
#include <vector>

namespace littoral
{

/**
 * Irregular points, one in each cell of a grid and with the index of that cell, and their neighbours in the Delaunay
 * triangulation. Water that runs along its edges prefers no direction, as it does on a grid. Points at the rim of the
 * grid are in the middle of their cells.
 */
struct PointMesh
{
  int Width = 0;
  int Height = 0;
  std::array<double, 2> Spacing{ 1.0, 1.0 };     ///< [m]
  std::vector<std::array<double, 2>> Points;     ///< from the first cell's middle [m]
  std::vector<CellIndex> First;                  ///< links of point n are First[n] to First[n + 1]
  std::vector<CellIndex> Neighbour;              ///< of each link
  std::vector<double> Distance;                  ///< length of each link [m]
  std::vector<double> EdgeRatio;                 ///< length of the edge of Voronoi's cells over Distance
  std::vector<double> Area;                      ///< area of Voronoi's cell of each point [m^2]
  std::vector<std::array<CellIndex, 3>> Corners; ///< of each triangle

  CellIndex Count() const { return static_cast<CellIndex>(this->Points.size()); }
  bool IsRim(CellIndex point) const;
};

/// Place at which the point of a cell shall stand [m].
struct HeldPoint
{
  CellIndex Cell;
  std::array<double, 2> Place;
};

/// Points that are uniform in the inner nine tenths of each cell's sides, by a seed and a draw: meshes of two draws
/// share no numbers. Points that are held stand at their places, or as near to them as these inner parts go.
PointMesh JitteredMesh(int width, int height, const std::array<double, 2>& spacing, int seed, int draw = 0,
  const std::vector<HeldPoint>& held = {}, const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

/// Grid of the heights of a mesh: linear in each triangle, at every half cell, then smoothed over half a cell.
GridSamples GridOf(const PointMesh& mesh, const std::vector<double>& heights, const ParallelFor& parallel = SerialFor,
  const Poll& poll = NoPoll);

}

#endif
