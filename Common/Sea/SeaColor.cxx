// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/SeaColor.h"

#include "Numerics/Vector3.h"

#include <glm/common.hpp>

#include <cmath>

namespace littoral
{
namespace
{

constexpr Vector3 Trough{ 12.0, 52.0, 74.0 };
constexpr Vector3 Crest{ 38.0, 108.0, 116.0 };
constexpr Vector3 Foam{ 236.0, 242.0, 244.0 };
constexpr Vector3 Horizon{ 176.0, 204.0, 222.0 };

constexpr double FoamBegins = 0.42; ///< Jacobian
constexpr double FoamIsWhite = 0.1;
constexpr double SightLength = 1800.0; ///< of light in haze, 1/extinction [m]

/// From 0 at low to 1 at high, without kinks.
double Step(double low, double high, double x)
{
  const double t = glm::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}

Color SeaColor(const SeaPlace& place)
{
  Vector3 color = glm::mix(Trough, Crest, Step(-0.6, 0.7, place.Height));
  color = glm::mix(Foam, color, Step(FoamIsWhite, FoamBegins, place.Jacobian));
  color = glm::mix(Horizon, color, std::exp(-place.Distance / SightLength));
  return { static_cast<unsigned char>(color.x), static_cast<unsigned char>(color.y),
    static_cast<unsigned char>(color.z) };
}

}
