// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/Atmosphere.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace littoral
{

namespace
{

// Lengths in kilometres.
constexpr double EarthRadius = 6360.0;
constexpr double TopRadius = 6460.0;
constexpr double MoleculeHeight = 8.0;
constexpr double AerosolHeight = 1.2;
constexpr double AerosolAlbedo = 0.9;
constexpr double AngstromExponent = 1.3;
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
  return check.Reason();
}

double LuminanceOf(const Vector3& color)
{
  return 0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z;
}

void Atmosphere::Moments::Add(double weight, const Moments& other)
{
  this->Mean += weight * other.Mean;
  this->FluxX += weight * other.FluxX;
  this->FluxZ += weight * other.FluxZ;
  this->XX += weight * other.XX;
  this->ZZ += weight * other.ZZ;
  this->XZ += weight * other.XZ;
}

void Atmosphere::Moments::AddLuminance(double weight, const Vector3& direction, const Vector3& luminance)
{
  const Vector3 part = weight * luminance;
  this->Mean += part;
  this->FluxX += direction.x * part;
  this->FluxZ += direction.z * part;
  this->XX += direction.x * direction.x * part;
  this->ZZ += direction.z * direction.z * part;
  this->XZ += direction.x * direction.z * part;
}

Atmosphere::Medium Atmosphere::MediumAt(double altitude) const
{
  Medium medium;
  medium.Molecules = std::exp(-altitude / MoleculeHeight) * MoleculeScattering;
  medium.Aerosols = std::exp(-altitude / AerosolHeight) * this->AerosolScattering;
  const double ozone = std::max(0.0, 1.0 - std::abs(altitude - 25.0) / 15.0);
  medium.Extinction =
    medium.Molecules + (1.0 / AerosolAlbedo - ForwardPart) * medium.Aerosols + ozone * OzoneAbsorption;
  return medium;
}

double Atmosphere::PathLength(const Vector3& from, const Vector3& direction, bool& meetsGround) const
{
  const double radius = glm::length(from);
  const double cosZenith = glm::dot(from, direction) / radius;
  const double reach = radius * radius * (cosZenith * cosZenith - 1.0) + EarthRadius * EarthRadius;
  meetsGround = cosZenith < 0.0 && reach >= 0.0;
  return meetsGround ? -radius * cosZenith - std::sqrt(reach) : DistanceOut(TopRadius, radius, cosZenith);
}

// The table is dense where the air is: by the distance to the top of the air (Bruneton and Neyret 2008).
void Atmosphere::MakeTransmittance(const ParallelFor& parallel)
{
  const double longest = std::sqrt(TopRadius * TopRadius - EarthRadius * EarthRadius);
  this->TransmittanceTable.resize(static_cast<std::size_t>(TransmittanceColumns) * TransmittanceRows);
  this->AerosolTable.resize(this->TransmittanceTable.size());
  parallel(TransmittanceRows, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      const double horizon = longest * static_cast<double>(row) / (TransmittanceRows - 1);
      const double r = std::sqrt(horizon * horizon + EarthRadius * EarthRadius);
      for (int column = 0; column < TransmittanceColumns; ++column)
      {
        const double least = TopRadius - r;
        const double d = least + (horizon + longest - least) * column / (TransmittanceColumns - 1);
        // cos z of a line of the length d to the top
        const double cosZenith =
          d > 0.0 ? std::clamp((TopRadius * TopRadius - r * r - d * d) / (2.0 * r * d), -1.0, 1.0) : 1.0;
        Vector3 thickness(0.0);
        double aerosols = 0.0;
        for (int n = 0; n < TransmittanceSteps; ++n)
        {
          // Short steps near the lower end: s = d t2
          const double t = (n + 0.5) / TransmittanceSteps;
          const double s = d * t * t;
          const double altitude = std::sqrt(std::max(0.0, r * r + s * s + 2.0 * r * s * cosZenith)) - EarthRadius;
          const Medium medium = this->MediumAt(std::max(altitude, 0.0));
          thickness += 2.0 * d * t / TransmittanceSteps * medium.Extinction;
          aerosols += 2.0 * d * t / TransmittanceSteps * medium.Aerosols.y;
        }
        this->AerosolTable[row * TransmittanceColumns + column] = aerosols;
        this->TransmittanceTable[row * TransmittanceColumns + column] = glm::exp(-thickness);
      }
    }
  });
}

Vector3 Atmosphere::Transmittance(double radius, double cosZenith) const
{
  return this->ToTop(this->TransmittanceTable, radius, cosZenith);
}

template <typename Value>
Value Atmosphere::ToTop(const std::vector<Value>& table, double radius, double cosZenith) const
{
  const double horizon = std::sqrt(std::max(0.0, radius * radius - EarthRadius * EarthRadius));
  const double longest = std::sqrt(TopRadius * TopRadius - EarthRadius * EarthRadius);
  const double least = TopRadius - radius;
  const double most = horizon + longest;
  const double d = DistanceOut(TopRadius, radius, cosZenith);
  const auto [i, u] = Between((d - least) / (most - least) * (TransmittanceColumns - 1), TransmittanceColumns);
  const auto [j, v] = Between(horizon / longest * (TransmittanceRows - 1), TransmittanceRows);
  const Value* at = table.data() + static_cast<std::size_t>(j) * TransmittanceColumns + i;
  return (1.0 - v) * ((1.0 - u) * at[0] + u * at[1]) +
    v * ((1.0 - u) * at[TransmittanceColumns] + u * at[TransmittanceColumns + 1]);
}

Atmosphere::Moments Atmosphere::MomentsAt(const std::vector<Moments>& table, double altitude, double cosSun) const
{
  const double up = std::cbrt(std::clamp(altitude / (TopRadius - EarthRadius), 0.0, 1.0));
  const double across = 0.5 + 0.5 * std::copysign(std::sqrt(std::abs(cosSun)), cosSun);
  const auto [j, v] = Between(up * (LaterRows - 1), LaterRows);
  const auto [i, u] = Between(across * (LaterColumns - 1), LaterColumns);
  const Moments* at = table.data() + static_cast<std::size_t>(j) * LaterColumns + i;
  Moments between;
  between.Add((1.0 - v) * (1.0 - u), at[0]);
  between.Add((1.0 - v) * u, at[1]);
  between.Add(v * (1.0 - u), at[LaterColumns]);
  between.Add(v * u, at[LaterColumns + 1]);
  return between;
}

/// Luminance from the sources along a line, and from the ground at its end.
template <typename Source, typename GroundLight>
Vector3 Atmosphere::Along(const Vector3& from, const Vector3& direction, const Vector3& sun, int steps,
  const Source& source, const GroundLight& groundLight) const
{
  bool meetsGround = false;
  const double whole = this->PathLength(from, direction, meetsGround);
  Vector3 luminance(0.0);
  Vector3 through(1.0);
  double aerosols = 0.0;
  for (int n = 0; n < steps; ++n)
  {
    // Short steps near the eye: s = S t2
    const double begin = static_cast<double>(n) / steps;
    const double end = static_cast<double>(n + 1) / steps;
    const Vector3 at = from + 0.5 * whole * (begin * begin + end * end) * direction;
    const double radius = std::max(glm::length(at), EarthRadius);
    const Vector3 up = at / radius;
    const Place place{ whole * (end * end - begin * begin), radius - EarthRadius, glm::dot(up, sun), up,
      this->MediumAt(radius - EarthRadius), aerosols };
    // Integral of the source over the step: (1 - exp(-sigma s)) / sigma
    const Vector3 kept = glm::exp(-place.Length * place.Air.Extinction);
    luminance += through * source(place) * (1.0 - kept) / place.Air.Extinction;
    through *= kept;
    aerosols += place.Length * place.Air.Aerosols.y;
  }
  if (meetsGround)
  {
    const Vector3 up = glm::normalize(from + whole * direction);
    luminance += through * this->Parameters.GroundAlbedo / Pi * groundLight(glm::dot(up, sun));
  }
  return luminance;
}

/// Light of the sun at a place, per light before the air.
Vector3 Atmosphere::LitOnce(const Place& place) const
{
  const double radius = EarthRadius + place.Altitude;
  const double shown = DiskAboveHorizon(radius, place.CosSun);
  return shown > 0.0 ? shown * this->Transmittance(radius, place.CosSun) : Vector3(0.0);
}

/// Light that a place sends in a direction, of the light that comes from all around.
Vector3 Atmosphere::Scattered(
  const Moments& moments, const Place& place, const Vector3& direction, const Vector3& sun) const
{
  // The axes of the moments: up, and across it towards the sun
  const double z = glm::dot(direction, place.Up);
  const Vector3 across = sun - place.CosSun * place.Up;
  const double length = glm::length(across);
  const double x = length > 1e-9 ? glm::dot(direction, across) / length : 0.0;
  const double y2 = std::max(0.0, 1.0 - z * z - x * x);
  // Molecules: mean of L 3/4 (1 + c2), c2 = sum of w_i w_j d_i d_j; the moments of a unit sphere have the trace 1
  const Vector3 YY = moments.Mean - moments.XX - moments.ZZ;
  const Vector3 squares = x * x * moments.XX + y2 * YY + z * z * moments.ZZ + 2.0 * x * z * moments.XZ;
  const Vector3 molecules = 0.75 * (moments.Mean + squares);
  // Aerosols without their forward peak: mean of L (1 + 3 g' c)
  const Vector3 aerosols = moments.Mean + 3.0 * RestAsymmetry * (x * moments.FluxX + z * moments.FluxZ);
  return place.Air.Molecules * molecules + (1.0 - ForwardPart) * place.Air.Aerosols * glm::max(aerosols, Vector3(0.0));
}

void Atmosphere::MakeLater(const ParallelFor& parallel)
{
  const std::size_t count = static_cast<std::size_t>(LaterColumns) * LaterRows;
  const auto pass = [&](const auto& luminanceFrom) {
    std::vector<Moments> order(count);
    parallel(count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t node = begin; node < end; ++node)
      {
        const double altitude = AltitudeOf(static_cast<double>(node / LaterColumns));
        const Vector3 from{ 0.0, 0.0, EarthRadius + std::clamp(altitude, 1e-3, TopRadius - EarthRadius - 1e-3) };
        const double cosSun = CosSunOf(static_cast<double>(node % LaterColumns));
        const Vector3 sun{ std::sqrt(std::max(0.0, 1.0 - cosSun * cosSun)), 0.0, cosSun };
        for (int k = 0; k < Elevations * Azimuths; ++k)
        {
          // Dense at the horizon: z = t |t|, whose part of the sphere is |t| dt
          const double t = (2.0 * (k / Azimuths) + 1.0) / Elevations - 1.0;
          const double z = t * std::abs(t);
          const double around = Pi * (k % Azimuths + 0.5) / Azimuths;
          const double across = std::sqrt(1.0 - z * z);
          const Vector3 direction{ across * std::cos(around), across * std::sin(around), z };
          order[node].AddLuminance(
            2.0 * std::abs(t) / (Elevations * Azimuths), direction, luminanceFrom(from, direction, sun));
        }
      }
    });
    return order;
  };
  // First order: of the sun, by the phase functions without the forward peak
  std::vector<Moments> order = pass([&](const Vector3& from, const Vector3& direction, const Vector3& sun) {
    const double cosine = glm::dot(direction, sun);
    const double molecules = MoleculePhase(cosine);
    const double aerosols = (1.0 - ForwardPart) * std::max(0.0, 1.0 + 3.0 * RestAsymmetry * cosine) / (4.0 * Pi);
    return this->Along(
      from, direction, sun, LaterSteps,
      [&](const Place& place) {
        return this->LitOnce(place) * (molecules * place.Air.Molecules + aerosols * place.Air.Aerosols);
      },
      [&](double cosSun) { return std::max(cosSun, 0.0) * this->Transmittance(EarthRadius, std::max(cosSun, 0.0)); });
  });
  this->Later = order;
  for (int n = 1; n < LaterOrders; ++n)
  {
    order = pass([&](const Vector3& from, const Vector3& direction, const Vector3& sun) {
      return this->Along(
        from, direction, sun, LaterSteps,
        [&](const Place& place) {
          return this->Scattered(this->MomentsAt(order, place.Altitude, place.CosSun), place, direction, sun);
        },
        [&](double cosSun) { return this->MomentsAt(order, 0.0, cosSun).Mean; });
    });
    for (std::size_t node = 0; node < count; ++node)
    {
      this->Later[node].Add(1.0, order[node]);
    }
  }
}

Atmosphere::Atmosphere(const AirParameters& parameters, const ParallelFor& parallel)
  : Parameters(parameters)
  , EyeRadius(EarthRadius + std::max(1e-3 * parameters.Altitude, 1e-3))
{
  const AirLayers layers(parameters, parallel);
  this->Air = std::make_shared<const State>(
    State{ parameters, std::max(1e-3 * parameters.Altitude, 1e-3), layers, LaterLight(layers, parameters, parallel) });
}

Vector3 Atmosphere::SunLight(const Vector3& sun) const
{
  const Vector3 towards = glm::normalize(sun);
  const double cosZenith = std::max(towards.z, 0.0);
  const double d = DistanceOut(TopRadius, this->EyeRadius, cosZenith);
  constexpr int steps = 400;
  Vector3 thickness(0.0);
  for (int n = 0; n < steps; ++n)
  {
    const double t = (n + 0.5) / steps;
    const double s = d * t * t;
    const double r = this->EyeRadius;
    const Medium medium = this->MediumAt(std::sqrt(r * r + s * s + 2.0 * r * s * cosZenith) - EarthRadius);
    thickness += 2.0 * d * t / steps * (medium.Extinction + ForwardPart * medium.Aerosols);
  }
  return SunBeforeAir * DiskAboveHorizon(this->EyeRadius, towards.z) * glm::exp(-thickness);
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
