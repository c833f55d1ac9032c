// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCrownCards_h
#define LittoralCrownCards_h

#include "Geometry/TextureImage.h"
#include "Plants/PlantPicture.h"
#include "Plants/Skeleton.h"

#include <vector>

namespace littoral
{

/// Polygons of a crown of cards, at most, and of its wood, about.
inline constexpr int MaximumCards = 400;
inline constexpr int MaximumWoodPolygons = 160;

/// A parallelogram that stands for many leaves.
struct CrownCard
{
  Vector3 Center{ 0.0, 0.0, 0.0 }; ///< [m]
  Vector3 Right{ 1.0, 0.0, 0.0 };  ///< from the center to the middle of the right edge [m]
  Vector3 Up{ 0.0, 0.0, 1.0 };     ///< to that of the upper edge [m]
  std::array<Vector3, 4> Normals;  ///< for light: below on the left, on the right, above on the right, on the left
  Color Tint{ 0, 0, 0 };
  bool ShowsSecond = false; ///< the right half of the texture, else the left
};

/// Cards and their texture, which is two pictures side by side.
struct CrownCards
{
  std::vector<CrownCard> Cards;
  TextureImage Texture;
};

/**
 * A thinned crown, after Cook et al., Stochastic Simplification of Aggregate Detail (2007): each leaf that is kept is
 * larger and stands for its neighbours. The cards with their edges times a factor.
 */
PlantMesh MeshOf(const std::vector<CrownCard>& cards, double scale);

/// One leaf in each run of leaves of one size, the same for the same seed, as a card with a tuft of the whole run. The
/// cards' sides are a first guess. The leaf mesh has kites in runs of neighbours.
std::vector<CrownCard> TuftCards(const PlantMesh& leaves, int seed);

/// Two tufts of leaves side by side, each in a square, from the picture of one leaf: grey, transparent where there is
/// no leaf.
TextureImage TuftPicture(const TextureImage& leaf, int leavesInTuft, int columns, int rows, int seed);

/// The trunk and the thickest limbs as a skin without texture coordinates and joints.
PlantMesh MainLimbs(const Skeleton& wood, const Color& bark);

/// The mesh of cards with those sizes and colors for which, with the wood, as much is covered and the mean color is the
/// same as of the plant in full, in the mean over six directions.
PlantMesh MatchedMesh(
  const CrownCards& crown, const PlantMesh& trunk, const std::vector<DrawnMesh>& full, const PlantExtent& extent);

/// The mean of the opaque texels of a crown's cards in each channel, the same for all plants.
inline constexpr float CardTextureMean = 0.6f;

/// Scales the colors of a texture so that they have this mean.
void ScaleToCardMean(TextureImage& texture);

/// The mean color of a texture's opaque texels, 0 to 1; white where there are none.
ColorSum MeanOf(const TextureImage& texture);

}

#endif
