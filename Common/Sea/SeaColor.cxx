// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/SeaColor.h"

#include "Numerics/SmoothStep.h"

#include <glm/common.hpp>

#include <cmath>

namespace littoral
{
namespace
{

constexpr Vector3 Trough{ 8.0, 50.0, 72.0 };
constexpr Vector3 Crest{ 30.0, 104.0, 112.0 };
constexpr Vector3 Foam{ 238.0, 243.0, 245.0 };
constexpr Vector3 Horizon{ 174.0, 203.0, 236.0 };
constexpr Vector3 Zenith{ 84.0, 134.0, 196.0 };

constexpr double FoamIsWhite = 0.1;    ///< Jacobian
constexpr double SightLength = 1800.0; ///< of light in haze, 1/extinction [m]

}

double WaterReflectance(double cosine)
{
  const double rest = 1.0 - glm::clamp(cosine, 0.0, 1.0);
  return 0.02 + 0.98 * rest * rest * rest * rest * rest;
}

Color SeaColor(const SeaPlace& place)
{
  const Vector3 water = glm::mix(Trough, Crest, SmoothStep(-0.6, 0.7, place.Height));
  // The sky along the mirrored ray, r = 2 (n . v) n - v; below the horizon there is the sea, which mirrors it again.
  const double cosine = glm::dot(place.Normal, place.ToEye);
  const Vector3 mirrored = 2.0 * cosine * place.Normal - place.ToEye;
  const Vector3 sky = glm::mix(Horizon, Zenith, std::sqrt(glm::clamp(std::abs(mirrored.z), 0.0, 1.0)));
  Vector3 color = glm::mix(water, sky, WaterReflectance(cosine));
  color = glm::mix(Foam, color, SmoothStep(FoamIsWhite, FoamBegins, place.Jacobian));
  color = glm::mix(Horizon, color, std::exp(-place.Distance / SightLength));
  return { static_cast<unsigned char>(color.x), static_cast<unsigned char>(color.y),
    static_cast<unsigned char>(color.z) };
}

}
