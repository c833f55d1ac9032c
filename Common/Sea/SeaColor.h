// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaColor_h
#define LittoralSeaColor_h

#include "Geometry/TextureImage.h"

namespace littoral
{

/// What the color of the sea's surface depends on.
struct SeaPlace
{
  double Jacobian = 1.0; ///< by which the surface is stretched, see SurfaceJacobian
  double Height = 0.0;   ///< over the mean level [significant wave heights]
  double Distance = 0.0; ///< from the eye [m]
};

/// The color of a sea by day: deep blue in troughs, green in crests, where light shines through; foam where the surface
/// nearly folds; and far away that of the sky at the horizon.
Color SeaColor(const SeaPlace& place);

}

#endif
