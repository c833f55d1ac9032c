// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantPrototype_h
#define LittoralPlantPrototype_h

#include "Plant.h"

#include <array>
#include <cstddef>
#include <vector>

namespace littoral
{

/// A picture with transparency; texture coordinates (0, 0) are the first texel's corner, u runs along a row.
struct TextureImage
{
  int Columns = 0;
  int Rows = 0;
  std::vector<std::array<unsigned char, 4>> Texels; ///< red, green, blue, opacity

  std::array<unsigned char, 4>& At(int column, int row)
  {
    return this->Texels[static_cast<std::size_t>(row) * this->Columns + column];
  }
};

/// A plant at three levels of detail. A texture multiplies the colours of the mesh before it; without a texture the
/// colours alone are a fair picture.
struct PlantPrototype
{
  // High
  Skeleton Wood;
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
