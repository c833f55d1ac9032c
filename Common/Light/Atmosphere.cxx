// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/Atmosphere.h"

#include "Light/AirLayers.h"
#include "Light/LaterLight.h"
#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double SunBeforeAir = 128.0; // light at right angles to the sun above the air [klx]
constexpr double NightSky = 2e-7;      // luminance of stars and airglow [kcd/m2]
constexpr int SightParts = 48;

}

std::string WhyInvalid(const AirParameters& p)
{
  ParameterCheck check;
  check.Range("Turbidity", p.Turbidity, 1.0, 10.0);
  check.Range("GroundAlbedo", p.GroundAlbedo, 0.0, 1.0);
  check.Range("Altitude", p.Altitude, 0.0, 10000.0, "m");
  check.Range("Ozone", p.Ozone, 0.0, 1000.0, "Dobson units");
  return check.Reason();
}

double LuminanceOf(const Vector3& color)
{
  return 0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z;
}

struct Atmosphere::State
{
  AirParameters Parameters;
  double Altitude; ///< of the eye [km]
  AirLayers Layers;
  LaterLight Later;

  /// Luminance of the air and of the ground along a line, per light of the sun before the air.
  Vector3 Along(const SightLine& line, const Vector3& direction, const Vector3& sun) const
  {
    const double cosine = glm::dot(direction, sun);
    const double molecules = MoleculePhase(cosine);
    const double aerosols = AerosolPhase(cosine);
    // Part of the sun across the line's begin, in the azimuth of the line
    const double side = std::hypot(direction.x, direction.y);
    const double across = side > 0.0 ? (direction.x * sun.x + direction.y * sun.y) / side : 0.0;
    Vector3 luminance(0.0);
    for (const SightPart& part : line.Parts)
    {
      const double cosSun = part.CosTurn * sun.z + part.SinTurn * across;
      luminance += this->Layers.SunAt(part.Altitude, cosSun) * (molecules * part.Molecules + aerosols * part.Aerosols) +
        this->Later.Sent(part.Altitude, part.CosView, cosSun, cosine) * (part.Molecules + part.Aerosols);
    }
    if (line.MeetsGround)
    {
      // L = albedo E / pi
      const double cosSun = line.CosTurn * sun.z + line.SinTurn * across;
      const Vector3 light = std::max(0.0, cosSun) * this->Layers.SunAt(0.0, cosSun) + this->Later.OnGround(cosSun);
      luminance += this->Parameters.GroundAlbedo / Pi * line.Through * light;
    }
    return luminance;
  }
};

Atmosphere::Atmosphere(const AirParameters& parameters, const ParallelFor& parallel)
{
  const AirLayers layers(parameters, parallel);
  this->Air = std::make_shared<const State>(
    State{ parameters, std::max(1e-3 * parameters.Altitude, 1e-3), layers, LaterLight(layers, parameters, parallel) });
}

Vector3 Atmosphere::SunLight(const Vector3& sun) const
{
  return SunBeforeAir * this->Air->Layers.SunAt(this->Air->Altitude, glm::normalize(sun).z);
}

Vector3 Atmosphere::SkyLuminance(const Vector3& direction, const Vector3& sun) const
{
  return this->SkyLuminances({ direction }, sun).front();
}

std::vector<Vector3> Atmosphere::SkyLuminances(const std::vector<Vector3>& directions, const Vector3& sun) const
{
  std::vector<Vector3> luminances;
  if (!directions.empty())
  {
    const Vector3 towards = glm::normalize(sun);
    const SightLine line = this->Air->Layers.Line(this->Air->Altitude, directions.front().z, SightParts);
    const double night = NightSky * (line.MeetsGround ? this->Air->Parameters.GroundAlbedo : 1.0);
    for (const Vector3& direction : directions)
    {
      luminances.push_back(night + SunBeforeAir * this->Air->Along(line, direction, towards));
    }
  }
  return luminances;
}

}
