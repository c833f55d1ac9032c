// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCylindricalProjection_h
#define LittoralCylindricalProjection_h

#include "Geometry/TextureImage.h"
#include "Numerics/Parallel.h"
#include "Plants/Plant.h"

namespace littoral
{

/// A mesh with colors, multiplied by a texture if there is one.
struct TexturedMesh
{
  const PlantMesh& Mesh;
  const TextureImage* Texture = nullptr;
};

/**
 * View of a crown by an eye that circles around its axis (Setas et al., section 4.1.2). A texel at (u, v) stands for
 * rays towards the axis, horizontal, from the direction 2 pi u and at the height v of the crown. It has the mean color
 * of the outermost leaves that the rays hit before they reach the axis, and is opaque in the share of rays that hit.
 */
TextureImage CylindricalProjection(
  const TexturedMesh& leaves, const CrownVolume& crown, int columns, int rows, const Poll& poll = NoPoll);

}

#endif
