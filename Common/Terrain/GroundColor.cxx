// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/GroundColor.h"

#include "Numerics/Constants.h"
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

/// Smooth step from 0 at low to 1 at high, without kinks.
double Step(double low, double high, double x)
{
  const double t = glm::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}

Color GroundColor(const GroundPlace& place)
{
  const double dry = Step(0.1, 0.9, 0.7 * place.Reflectance + 0.3 * place.Height);
  Vector3 color = glm::mix(Meadow, DryGrass, dry);
  color = glm::mix(color, Upland, 0.7 * Step(0.5, 1.0, place.Height));
  color = glm::mix(color, Lush, Step(Moist, Wet, place.Wetness));
  color = glm::mix(color, Rock, Step(GrassHolds, GrassEnds, place.Slope));
  return { static_cast<unsigned char>(color.x), static_cast<unsigned char>(color.y),
    static_cast<unsigned char>(color.z) };
}

}
