// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantPrototype_h
#define LittoralPlantPrototype_h

#include "Geometry/TextureImage.h"
#include "Plants/Plant.h"
#include "Plants/PlantImpostor.h"
#include "Plants/SeaweedSegment.h"
#include "Plants/WoodParameters.h"

namespace littoral
{

/// A plant at three levels of detail. The colors of a mesh alone are a fair picture. LeafTexture multiplies the
/// colors of Leaves; CrownTexture divided by its mean those of Crown; the pictures of the impostor those of Low.
struct PlantPrototype
{
  // High
  Skeleton Wood;
  std::vector<SeaweedSegment> Segments; ///< of each node of a seaweed, else empty
  WoodParameters Timber;                ///< wood of the skeleton
  PlantMesh Skin;
  PlantMesh Leaves;
  TextureImage LeafTexture;
  // Medium
  PlantMesh Trunk;
  PlantMesh Crown;
  TextureImage CrownTexture;
  ColorSum CrownTextureMean{ 1.0f, 1.0f, 1.0f };
  bool CrownIsEnvelope = false; ///< the texture is a cylindrical projection
  // Low
  PlantMesh Low;
  PlantImpostor Impostor; ///< without pictures where Low is not cards
};

}

#endif
