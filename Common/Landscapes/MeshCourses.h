// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralMeshCourses_h
#define LittoralMeshCourses_h

#include "Landscapes/GivenGround.h"
#include "Landscapes/PointMesh.h"

#include <cstdint>
#include <vector>

namespace littoral
{

/// Rivers and ridges along the links of a mesh; no numbers at all where none are given.
struct MeshCourses
{
  std::vector<CellIndex> Link;       ///< from each point of a river to its next; -1 where water finds its way
  std::vector<std::uint8_t> IsRidge; ///< 1 where no water comes from another point

  bool IsEmpty() const { return this->Link.empty(); }
};

/**
 * Courses of rivers and ridges, whose places are from the mesh's first cell's middle. A river that comes to another one
 * goes on with it; rivers that would run in a circle end where they close it. Where a river and a ridge share a point,
 * as on a mesh that is coarser than their distance, it is the river's.
 */
MeshCourses CoursesOn(const PointMesh& mesh, const GivenGround& given);

/**
 * Lowers points of rivers to the lowest neighbour that is of no river, but not below their next, and to a least slope
 * [m/m] from the point before, and raises those of ridges to their highest neighbour: else a river on a height would
 * take no water, cut nothing, and grow into a ridge. Outlets stay.
 */
void CarveCourses(const PointMesh& mesh, const MeshCourses& courses, double leastSlope, std::vector<double>& heights);

/// Places of the given lines in the cells of a mesh: points that stand there have the lines as links.
std::vector<HeldPoint> PointsOnLines(
  const GivenGround& given, int width, int height, const std::array<double, 2>& spacing);

}

#endif
