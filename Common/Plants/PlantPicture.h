// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantPicture_h
#define LittoralPlantPicture_h

#include "Geometry/TextureImage.h"
#include "Plants/PlantMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace littoral
{

/// Red, green and blue, 0 to 1 or as sums.
using ColorSum = std::array<float, 3>;

/// A mesh as renderers draw it: vertex color * texel / mean of the texture, cut out where the texel's alpha is below a
/// half.
struct DrawnMesh
{
  const PlantMesh& Mesh;
  const TextureImage* Texture = nullptr;
  ColorSum TextureMean{ 1.0f, 1.0f, 1.0f };
};

/// A number other than 0 that tells what is drawn apart.
std::uint64_t KeyOf(const std::vector<DrawnMesh>& meshes);

/// An orthographic camera: a rectangle about a center, at right angles to the direction towards the eye. The three
/// directions are of unit length and right-handed.
struct PictureFrame
{
  Vector3 Center{ 0.0, 0.0, 0.0 }; ///< [m]
  Vector3 Right{ 0.0, 1.0, 0.0 };
  Vector3 Up{ 0.0, 0.0, 1.0 };
  Vector3 Towards{ 1.0, 0.0, 0.0 }; ///< the eye
  double HalfWidth = 1.0;           ///< [m]
  double HalfHeight = 1.0;          ///< [m]
};

/// The frame that looks at a center from an azimuth and an elevation [rad], with z up; from straight above, up is
/// where the azimuth's far side is.
PictureFrame FrameTowards(const Vector3& center, double azimuth, double elevation);

/// Surface seen in a texel.
struct SeenTexel
{
  float Coverage = 0.0f;              ///< share of the samples that meet a mesh
  ColorSum Color{ 0.0f, 0.0f, 0.0f }; ///< mean of these, 0 to 1, without light
  Vector3 Normal{ 0.0, 0.0, 0.0 };    ///< mean of these in the frame: right, up, towards the eye; not of unit length
};

/// Samples along an edge of a texel.
inline constexpr int PictureSamples = 2;

/// Draws meshes with a depth buffer; rows from below. The colors and normals of a mesh must be there.
std::vector<SeenTexel> PictureOf(
  const std::vector<DrawnMesh>& meshes, const PictureFrame& frame, int columns, int rows);

/// The part of such a picture that the meshes cover [texels], in less time.
double CoverageOf(const std::vector<DrawnMesh>& meshes, const PictureFrame& frame, int columns, int rows);

/// Sums of a picture.
struct PictureSum
{
  double Coverage = 0.0; ///< [texels]
  std::array<double, 3> Color{ 0.0, 0.0, 0.0 };

  void Add(const std::vector<SeenTexel>& picture);
};

}

#endif
