// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/TextureAtlas.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// Texels of the border on each side.
constexpr int Border = 2;
/// Side of what stands for no texture.
constexpr int WhiteSide = 4;

std::array<int, 2> FilledSize(const std::array<int, 2>& size)
{
  return size[0] > 0 && size[1] > 0 ? size : std::array<int, 2>{ WhiteSide, WhiteSide };
}

void CopyWithBorder(const TextureImage& from, int columns, int rows, int firstRow, TextureImage& to)
{
  for (int row = -Border; row < rows + Border; ++row)
  {
    for (int column = -Border; column < to.Columns - Border; ++column)
    {
      to.At(column + Border, firstRow + row) = from.Texels.empty()
        ? Texel{ 255, 255, 255, 255 }
        : from.At(std::clamp(column, 0, columns - 1), std::clamp(row, 0, rows - 1));
    }
  }
}

}

std::array<long long, 2> AtlasSize(const std::vector<std::array<int, 2>>& sizes)
{
  std::array<long long, 2> all{ 0, 0 };
  for (const std::array<int, 2>& size : sizes)
  {
    const std::array<int, 2> filled = FilledSize(size);
    all[0] = std::max<long long>(all[0], filled[0] + 2 * Border);
    all[1] += filled[1] + 2 * Border;
  }
  return all;
}

std::array<float, 3> ShareMean(std::vector<TextureImage>& textures, const std::vector<std::array<float, 3>>& means)
{
  std::array<float, 3> common{ 1.0f, 1.0f, 1.0f };
  for (const std::array<float, 3>& mean : means)
  {
    std::transform(mean.begin(), mean.end(), common.begin(), common.begin(),
      [](float one, float other) { return std::min(one, other); });
  }
  for (std::size_t i = 0; i < textures.size(); ++i)
  {
    TextureImage& texture = textures[i];
    if (means[i] == common)
    {
      continue;
    }
    if (texture.Texels.empty())
    {
      texture = TextureImage(WhiteSide, WhiteSide);
      std::fill(texture.Texels.begin(), texture.Texels.end(), Texel{ 255, 255, 255, 255 });
    }
    for (Texel& texel : texture.Texels)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        const float part = common[channel] / means[i][channel];
        texel[channel] = static_cast<unsigned char>(std::lround(part * static_cast<float>(texel[channel])));
      }
    }
  }
  return common;
}

TextureAtlas StackTextures(const std::vector<TextureImage>& textures)
{
  std::vector<std::array<int, 2>> sizes;
  sizes.reserve(textures.size());
  for (const TextureImage& texture : textures)
  {
    sizes.push_back(FilledSize({ texture.Columns, texture.Rows }));
  }
  const std::array<long long, 2> all = AtlasSize(sizes);
  const auto width = static_cast<double>(all[0]);
  const auto height = static_cast<double>(all[1]);
  TextureAtlas atlas;
  atlas.Image = TextureImage(static_cast<int>(all[0]), static_cast<int>(all[1]));
  int firstRow = Border;
  for (std::size_t i = 0; i < textures.size(); ++i)
  {
    const auto [columns, rows] = sizes[i];
    CopyWithBorder(textures[i], columns, rows, firstRow, atlas.Image);
    AtlasArea area;
    area.Corner[0] = Border / width;
    area.Corner[1] = firstRow / height;
    area.Size[0] = columns / width;
    area.Size[1] = rows / height;
    atlas.Areas.push_back(area);
    firstRow += rows + 2 * Border;
  }
  return atlas;
}

}
