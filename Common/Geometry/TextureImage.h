// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTextureImage_h
#define LittoralTextureImage_h

#include <array>
#include <cstddef>
#include <vector>

namespace littoral
{

/// Red, green and blue, 0 to 255.
using Color = std::array<unsigned char, 3>;

/// Red, green, blue and opacity, 0 to 255.
using Texel = std::array<unsigned char, 4>;

/// A picture with transparency. Texture coordinates (0, 0) are the outer corner of the first texel; u runs along a row.
struct TextureImage
{
  int Columns = 0;
  int Rows = 0;
  std::vector<Texel> Texels;

  TextureImage() = default;
  TextureImage(int columns, int rows)
    : Columns(columns)
    , Rows(rows)
    , Texels(static_cast<std::size_t>(columns) * rows)
  {
  }

  Texel& At(int column, int row) { return this->Texels[static_cast<std::size_t>(row) * this->Columns + column]; }
  const Texel& At(int column, int row) const
  {
    return this->Texels[static_cast<std::size_t>(row) * this->Columns + column];
  }
};

}

#endif
