// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/GroundColor.h"

#include "Numerics/Constants.h"
#include "Numerics/SmoothStep.h"
#include "Numerics/Vector3.h"

#include <glm/common.hpp>

namespace littoral
{
namespace
{

constexpr Vector3 Meadow{ 100.0, 122.0, 56.0 };
constexpr Vector3 DryGrass{ 148.0, 144.0, 86.0 };
constexpr Vector3 Upland{ 116.0, 114.0, 80.0 };
constexpr Vector3 Lush{ 62.0, 98.0, 44.0 };
constexpr Vector3 Rock{ 128.0, 122.0, 112.0 };

constexpr double GrassHolds = 30.0 * Pi / 180.0; ///< on all slopes to here [rad]
constexpr double GrassEnds = 45.0 * Pi / 180.0;

/// Wetness from which a meadow begins to be lush, and at which it is.
constexpr double Moist = 6.0;
constexpr double Wet = 9.0;

}

Color GroundColor(const GroundPlace& place)
{
  const double dry = SmoothStep(0.1, 0.9, 0.7 * place.Reflectance + 0.3 * place.Height);
  Vector3 color = glm::mix(Meadow, DryGrass, dry);
  color = glm::mix(color, Upland, 0.7 * SmoothStep(0.5, 1.0, place.Height));
  color = glm::mix(color, Lush, SmoothStep(Moist, Wet, place.Wetness));
  color = glm::mix(color, Rock, SmoothStep(GrassHolds, GrassEnds, place.Slope));
  return { static_cast<unsigned char>(color.x), static_cast<unsigned char>(color.y),
    static_cast<unsigned char>(color.z) };
}

}
