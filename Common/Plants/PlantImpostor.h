// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantImpostor_h
#define LittoralPlantImpostor_h

#include "Numerics/Parallel.h"
#include "Numerics/WorkShare.h"
#include "Plants/PlantPicture.h"

#include <array>
#include <vector>

namespace littoral
{

/// Views of an impostor: azimuths around the plant at each of the elevations 0, 22.5, 45 and 67.5 degrees, and one from
/// straight above. Their pictures are squares of an atlas, row by row from below.
inline constexpr int ImpostorAzimuths = 6;
inline constexpr int ImpostorElevations = 4;
inline constexpr int ImpostorViews = ImpostorAzimuths * ImpostorElevations + 1;
inline constexpr int ImpostorSide = 5; ///< pictures along an edge of the atlas
static_assert(ImpostorSide * ImpostorSide == ImpostorViews, "the atlas is full");
inline constexpr int ImpostorSize = 96; ///< columns and rows of a picture [texels]

/// The outline of a plant by direction.
struct ImpostorShape
{
  PlantExtent Extent;
  std::array<double, ImpostorViews> Areas{}; ///< areas that are covered in each picture [m2]
};

/**
 * Pictures of a plant in full from several directions, without light. A picture is the cylinder's outline from there;
 * alpha is such that the alpha test at a half keeps the covered area of each picture. Texels are colors divided by
 * their mean over all pictures, times TextureMean.
 */
struct PlantImpostor
{
  ImpostorShape Shape;
  TextureImage Pictures;
  std::vector<Color> Normals; ///< of each texel in the frame of its picture, n / 2 + 1/2
  Color Mean{ 0, 0, 0 };
  ColorSum TextureMean{ 1.0f, 1.0f, 1.0f };
};

/// The impostor of what the meshes show; processes that have the same meshes share the views.
PlantImpostor ImpostorOf(const std::vector<DrawnMesh>& meshes, const PlantExtent& extent,
  const ParallelFor& parallel = SerialFor, const WorkShare& share = {});

/// A rectangle that shows a picture of an impostor.
struct ImpostorCard
{
  int View = 0;
  std::array<Vector3, 4> Corners; ///< [m], counter-clockwise as seen by the eye, from below on the left
  std::array<Vector3, 4> Normals; ///< for light without normals of texels, as if the plant were round
};

/**
 * The rectangle at right angles to a direction of view, through the middle of the plant, with the picture whose
 * direction is nearest. Its height is drawn to the area between the elevations of two pictures, and its width to that
 * between two azimuths. `towards` is the direction to the eye in the plant's frame, of unit length.
 */
ImpostorCard CardTowards(const ImpostorShape& shape, const Vector3& towards);

/// Texture coordinates of the corners of a card in the atlas.
std::array<std::array<double, 2>, 4> CardTCoords(int view);

/// The plant for all directions at once: three upright cards with a common axis, and a flat one across them.
PlantMesh CrossedCards(const PlantImpostor& impostor);

}

#endif
