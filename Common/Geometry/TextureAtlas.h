// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTextureAtlas_h
#define LittoralTextureAtlas_h

#include "Geometry/TextureImage.h"

#include <algorithm>
#include <array>
#include <vector>

namespace littoral
{

/// Area of a texture in an atlas, in texture coordinates of the atlas.
struct AtlasArea
{
  double Corner[2] = { 0.0, 0.0 };
  double Size[2] = { 1.0, 1.0 };

  /// Coordinates in the texture, drawn to its edge where they are outside, as coordinates in the atlas.
  std::array<double, 2> Map(double u, double v) const
  {
    return { this->Corner[0] + this->Size[0] * std::clamp(u, 0.0, 1.0),
      this->Corner[1] + this->Size[1] * std::clamp(v, 0.0, 1.0) };
  }
};

/// Textures one above the other, the first at the foot, so that one picture serves all. Each has a border that repeats
/// its edge, so that interpolation does not mix neighbours.
struct TextureAtlas
{
  TextureImage Image;
  std::vector<AtlasArea> Areas;
};

/// Columns and rows of the atlas of textures with these columns and rows.
std::array<long long, 2> AtlasSize(const std::vector<std::array<int, 2>>& sizes);

/**
 * Textures that are drawn divided by their means, one mean for all: where the means, 0 to 1, are not the same, texels
 * are darkened to the smallest of each color. An empty texture counts as white. The common mean.
 */
std::array<float, 3> ShareMean(std::vector<TextureImage>& textures, const std::vector<std::array<float, 3>>& means);

/// An empty texture counts as a white, opaque one.
TextureAtlas StackTextures(const std::vector<TextureImage>& textures);

}

#endif
