// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralMeshDrainage_h
#define LittoralMeshDrainage_h

#include "Landscapes/MeshCourses.h"
#include "Landscapes/PointMesh.h"
#include "Numerics/Parallel.h"

#include <vector>

namespace littoral
{

/// Ways of the water over a mesh, whose rim points are its outlets.
struct MeshDrainage
{
  std::vector<CellIndex> Link;  ///< link to the receiver of each point; -1 at outlets
  std::vector<CellIndex> Order; ///< all points, each after its receiver
  std::vector<double> Area;     ///< drainage area, the point's own included [m^2]
};

/**
 * Receivers of steepest descent, max (z - z_r) / d over the neighbours. Points of depressions drain over the spill
 * points: by steepest descent on the filled heights, and on their flats along the priority-flood's way (Barnes, Lehman
 * & Mulla 2014).
 *
 * Points of given rivers drain along them, uphill too, and no point drains to one of a ridge. Water that ridges enclose
 * leaves over their lowest point, and a river that ends where all ways out cross it leaves its course there.
 */
MeshDrainage DrainMesh(const PointMesh& mesh, const std::vector<double>& heights,
  const ParallelFor& parallel = SerialFor, const MeshCourses& courses = {}, const Poll& poll = NoPoll);

}

#endif
