// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralBranchSkin_h
#define LittoralBranchSkin_h

#include "Plants/PlantMesh.h"
#include "Plants/Skeleton.h"

namespace littoral
{

/// Resolution of the surfaces of branches.
struct BranchSkinOptions
{
  int MaximumSides = 12;     ///< of the thickest branch; thinner ones get fewer, at least 3
  double BarkLength = 1.0;   ///< [m] of branch for one repeat of the bark texture
  Color Bark{ 110, 90, 70 }; ///< color of the trunk; twigs are darker
};

/// Sides of a branch of a radius [m], when the thickest has another.
int NumberOfSides(double radius, double thickest, int maximumSides);

/**
 * Generalised cylinders: a ring of vertices at each node, at right angles to the branch, carried along without twist, a
 * point at the tip, and a flat end at the foot. Triangles, a closed surface for each branch: places that have two
 * texture coordinates, at the seam, or two normals, around the foot, have two vertices. A ring follows the joints of
 * the segments that meet there, half and half; the first ring its own joint, the tip that of the last segment. A joint
 * moves the segment that starts at its node. The skeleton must be valid.
 */
PlantMesh SkinOf(const Skeleton& skeleton, const BranchSkinOptions& options);

}

#endif
