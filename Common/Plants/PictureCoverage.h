// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPictureCoverage_h
#define LittoralPictureCoverage_h

#include "Geometry/TextureImage.h"

#include <array>

namespace littoral
{

/// Texture coordinates of the corners of a triangle.
using PictureTriangle = std::array<std::array<double, 2>, 3>;

/// Part of a triangle that is leaf: whose texels are at least half opaque, where renderers cut a leaf out. 1 without a
/// picture; beyond its edges the picture repeats itself.
double CoverageOf(const TextureImage& picture, const PictureTriangle& triangle);

}

#endif
