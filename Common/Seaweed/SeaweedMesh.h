// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaweedMesh_h
#define LittoralSeaweedMesh_h

#include "Plants/PlantLevels.h"
#include "Seaweed/SeaweedGrowth.h"

namespace littoral
{

/// Resolution of the mesh of a blade.
struct RibbonOptions
{
  int MaximumRows = 200;    ///< of polygons along a blade
  bool HasRuffles = true;   ///< waves of the edges, and the columns that they need
  bool HasJoints = true;    ///< whether vertices say which segments they follow
  double RowsOfSegment = 2; ///< along a segment where there are no waves
};

/**
 * Ribbons of quadrangles on the blades: on a smooth curve through their nodes, as wide as the blade's profile, with
 * waves along the edges. u runs from 0 to 1 across, v along a blade. A vertex follows its segment, near a joint that of
 * the neighbour as well, half and half on the joint.
 */
PlantMesh RibbonsOf(const Seaweed& seaweed, const RibbonOptions& options);

/// Cylinders on holdfast and stipes, spheroids on floats, and the haptera of a kelp, which follow the holdfast.
PlantMesh StipesOf(const Seaweed& seaweed);

/// Picture of a blade face on, in a color: u across, v from foot to tip; opaque.
TextureImage BladePicture(SeaweedForm form, const Color& color, int columns, int rows);

/**
 * All levels of a seaweed. High: Skin is what is round, Leaves are the blades, LeafTexture the relief of a blade in
 * grey. Medium: Trunk has fewer corners, Crown are blades without waves, CrownTexture is a blade in color. Low: four
 * upright ellipses, one for each side of the plant, that lean as the side does. The area of each is that of what it
 * stands for, as far as there is room.
 */
PlantPrototype LevelsOf(const Seaweed& seaweed, const PlantLevelOptions& options);

}

#endif
