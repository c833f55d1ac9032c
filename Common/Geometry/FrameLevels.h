// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFrameLevels_h
#define LittoralFrameLevels_h

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace littoral
{

/// The part of a texel that a plant covers, and the means of what is seen of it there.
struct FrameTexel
{
  float Coverage = 0.0F;
  glm::vec3 Albedo = glm::vec3(0.0F); ///< linear
  glm::vec3 Normal = glm::vec3(0.0F);
  float Transmittance = 0.0F;
  float Depth = 0.0F; ///< towards the viewer
};

/// A square picture of a plant.
struct FramePicture
{
  int Side = 0;
  std::vector<FrameTexel> Texels; ///< by rows

  explicit FramePicture(int side)
    : Side(side)
    , Texels(static_cast<std::size_t>(side) * side)
  {
  }
  FrameTexel& At(int column, int row) { return this->Texels[static_cast<std::size_t>(row) * this->Side + column]; }
  const FrameTexel& At(int column, int row) const
  {
    return this->Texels[static_cast<std::size_t>(row) * this->Side + column];
  }
};

/// Pictures of samples, from a side of so many texels down to one texel, each of half the side of that before it; both
/// sides are powers of 2. Texels that nothing covers have what covers those around them, so that interpolation finds
/// nothing else.
std::vector<FramePicture> FrameLevels(FramePicture samples, int side);

/**
 * Scales coverages so that where they are cut at a half the picture covers the same area as without a cut (Castano,
 * Computing alpha mipmaps, 2010): else thin leaves vanish from small pictures.
 */
void KeepCoverage(FramePicture& picture);

}

#endif
