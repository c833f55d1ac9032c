// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGroundColor_h
#define LittoralGroundColor_h

#include "Geometry/TextureImage.h"

namespace littoral
{

/// Conditions that determine the color of the ground at a place.
struct GroundPlace
{
  double Slope = 0.0;       ///< from level ground [rad]
  double Height = 0.0;      ///< share of the way from the lowest to the highest place
  double Reflectance = 0.5; ///< 0 to 1: meadow where low, dry grass where high
  double Wetness = 0.0;     ///< topographic wetness index ln(a / tan(slope)), a in metres: lush meadows where high
};

/// The color of a temperate country: meadows below, lush ones beside streams, dry grass above, rock where it is
/// steep.
Color GroundColor(const GroundPlace& place);

}

#endif
