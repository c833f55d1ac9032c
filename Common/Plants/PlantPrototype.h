// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantPrototype_h
#define LittoralPlantPrototype_h

#include "Geometry/TextureImage.h"
#include "Plants/Plant.h"
#include "Plants/SeaweedSegment.h"
#include "Plants/WoodParameters.h"

namespace littoral
{

/// A plant at three levels of detail. The colors of a mesh alone are a fair picture. LeafTexture multiplies the
/// colors of Leaves; CrownTexture replaces those of Crown.
struct PlantPrototype
{
  // High
  Skeleton Wood;
  std::vector<SeaweedSegment> Segments; ///< of each node of a seaweed, else empty
  WoodParameters Timber;                ///< what the skeleton is made of
  PlantMesh Skin;
  PlantMesh Leaves;
  TextureImage LeafTexture;
  // Medium
  PlantMesh Trunk;
  PlantMesh Crown;
  TextureImage CrownTexture;
  // Low
  PlantMesh Low;
};

}

#endif
