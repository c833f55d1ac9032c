// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaColor_h
#define LittoralSeaColor_h

#include "Geometry/TextureImage.h"
#include "Numerics/Vector3.h"

namespace littoral
{

/// Conditions that determine the color of the sea's surface.
struct SeaPlace
{
  Vector3 Normal{ 0.0, 0.0, 1.0 }; ///< of length 1
  Vector3 ToEye{ 0.0, 0.0, 1.0 };  ///< of length 1
  double Distance = 0.0;           ///< of the eye [m]
  double Jacobian = 1.0;           ///< stretch of the surface, see SurfaceJacobian
  double Height = 0.0;             ///< over the mean level [significant wave heights]
};

/// Foam begins where the Jacobian is below [1].
constexpr double FoamBegins = 0.42;

/// The share of light that water reflects, at an angle of incidence of this cosine: Schlick's approximation of
/// Fresnel's equations, 0.02 + 0.98 (1 - cos)^5.
double WaterReflectance(double cosine);

/// The color of a sea by day: of the water, blue in troughs and green in crests, where light shines through; of the sky
/// that it reflects; white foam where the surface nearly folds; and of the haze far away.
Color SeaColor(const SeaPlace& place);

}

#endif
