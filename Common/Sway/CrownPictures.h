// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCrownPictures_h
#define LittoralCrownPictures_h

#include "Geometry/TextureImage.h"
#include "Plants/Plant.h"
#include "Plants/PlantMesh.h"
#include "Plants/Skinning.h"
#include "Sway/SwaySpecies.h"
#include "Wind/FrozenWind.h"

#include <optional>
#include <vector>

namespace littoral
{

/// A prototype's crown as the pictures of the level Medium need it.
struct CrownModel
{
  std::optional<CrownVolume> Volume; ///< of the crown's envelope; none: there is no envelope
  TextureImage StillPicture;         ///< of the envelope; empty: white
  PlantMesh Leaves;                  ///< points, colors and texture coordinates, at rest
  RestSkin LeafSkin;                 ///< the same points
  SkinBinding LeafBinding;           ///< and the joints that they follow
  TextureImage LeafTexture;          ///< factor of the leaves' colors; empty: none
};

/**
 * Pictures of a swaying crown (Setas et al., section 4.2) at equal times of a swing of its trunk, in the wind above
 * `middle` [m]. The eye circles around the crown and sways along with the trunk. Still ones where the species has no
 * skeleton or no leaves, or the crown no envelope.
 */
std::vector<TextureImage> CrownPictures(const SwaySpecies& species, const CrownModel& crown, const FrozenWind& wind,
  const Vector3& middle, const SwaySettings& settings);

/**
 * Number of the picture that a crown shows at a time [s] after the arrival of the wind, from 0. Pictures follow each
 * other with the trunk's frequency [Hz], rounded to a whole number of swings, at least one, in a period of the wind
 * [s].
 */
int CrownPictureAt(double time, double frequency, double period, int pictures);

}

#endif
