// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCrownCylinder_h
#define LittoralCrownCylinder_h

#include "Plants/CanopyCells.h"
#include "Plants/CanopyProfile.h"

namespace littoral
{

/// A tree without leaves of its own: an upright cylinder from the ground to its top.
struct CrownCylinder
{
  Vector3 Foot{ 0.0, 0.0, 0.0 }; ///< [m]
  double Height = 1.0;           ///< [m]
  double Diameter = 1.0;         ///< [m]
};

/// Area [m2] that a circle about the origin of a radius [m] has in the rectangle from the origin to (x, y), signed by x
/// y: sums and differences of four of them are areas in any rectangle.
double CircleWithin(double radius, double x, double y);

/// Takes the part of a tree in a cell, 0 to 1; Outside is the index of all that lies beyond the grid.
using TakeShare = std::function<void(std::size_t cell, double share)>;

/// Shares a tree between cells: by the profile along the height, evenly across. The shares add up to 1.
void ShareBetweenCells(
  const CanopyGrid& grid, const CrownCylinder& crown, const CanopyProfile& profile, const TakeShare& take);

}

#endif
