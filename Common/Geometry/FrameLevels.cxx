// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/FrameLevels.h"

#include <algorithm>
#include <utility>

namespace littoral
{

namespace
{

/// Mean of four texels, by what each of them covers.
FrameTexel MeanOf(const FramePicture& fine, int column, int row)
{
  FrameTexel mean;
  for (int k = 0; k < 4; ++k)
  {
    const FrameTexel& part = fine.At(2 * column + k % 2, 2 * row + k / 2);
    mean.Coverage += 0.25F * part.Coverage;
    mean.Albedo += part.Coverage * part.Albedo;
    mean.Normal += part.Coverage * part.Normal;
    mean.Transmittance += part.Coverage * part.Transmittance;
    mean.Depth += part.Coverage * part.Depth;
  }
  const float share = mean.Coverage > 0.0F ? 0.25F / mean.Coverage : 0.0F;
  mean.Albedo *= share;
  mean.Normal *= share;
  mean.Transmittance *= share;
  mean.Depth *= share;
  return mean;
}

FramePicture HalfOf(const FramePicture& fine)
{
  FramePicture half(fine.Side / 2);
  for (int row = 0; row < half.Side; ++row)
  {
    for (int column = 0; column < half.Side; ++column)
    {
      half.At(column, row) = MeanOf(fine, column, row);
    }
  }
  return half;
}

/// Gives texels that nothing covers what the coarser picture has there.
void FillFrom(const FramePicture& coarse, FramePicture& fine)
{
  for (int row = 0; row < fine.Side; ++row)
  {
    for (int column = 0; column < fine.Side; ++column)
    {
      FrameTexel& texel = fine.At(column, row);
      if (texel.Coverage <= 0.0F)
      {
        texel = coarse.At(column / 2, row / 2);
        texel.Coverage = 0.0F;
      }
    }
  }
}

/// Area that all texels cover [texels].
double CoverageOf(const FramePicture& picture)
{
  double sum = 0.0;
  for (const FrameTexel& texel : picture.Texels)
  {
    sum += texel.Coverage;
  }
  return sum;
}

/// Texels that cover a half where coverages are scaled and then blurred by 1/4, 1/2, 1/4 in both directions, as by
/// interpolation and between frames.
double CutCoverage(const FramePicture& picture, float scale)
{
  constexpr float weights[3] = { 0.25F, 0.5F, 0.25F };
  int count = 0;
  for (int row = 1; row < picture.Side - 1; ++row)
  {
    for (int column = 1; column < picture.Side - 1; ++column)
    {
      float sum = 0.0F;
      for (int k = 0; k < 9; ++k)
      {
        const float coverage = picture.At(column + k % 3 - 1, row + k / 3 - 1).Coverage;
        sum += weights[k % 3] * weights[k / 3] * std::min(1.0F, scale * coverage);
      }
      count += sum >= 0.5F;
    }
  }
  return count;
}

}

//----------------------------------------------------------------------------
std::vector<FramePicture> FrameLevels(FramePicture samples, int side)
{
  while (samples.Side > side)
  {
    samples = HalfOf(samples);
  }
  std::vector<FramePicture> levels;
  levels.push_back(std::move(samples));
  while (levels.back().Side > 1)
  {
    levels.push_back(HalfOf(levels.back()));
  }
  for (std::size_t level = levels.size() - 1; level > 0; --level)
  {
    FillFrom(levels[level], levels[level - 1]);
  }
  return levels;
}

//----------------------------------------------------------------------------
void KeepCoverage(FramePicture& picture)
{
  const double wanted = CoverageOf(picture);
  double low = 0.0;
  double high = 8.0;
  for (int step = 0; step < 10; ++step)
  {
    const double middle = 0.5 * (low + high);
    (CutCoverage(picture, static_cast<float>(middle)) < wanted ? low : high) = middle;
  }
  for (FrameTexel& texel : picture.Texels)
  {
    texel.Coverage = std::min(1.0F, static_cast<float>(high) * texel.Coverage);
  }
}

}
