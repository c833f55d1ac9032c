// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/AirLayers.h"

#include "Numerics/Constants.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

constexpr double MoleculeHeight = 8.0;
constexpr double AerosolHeight = 1.2;
constexpr double AerosolAlbedo = 0.9;
constexpr double AngstromExponent = 1.3;
constexpr double SunRadius = 0.2665 * Degree;
const Vector3 MoleculeScattering(8.396e-3, 13.558e-3, 33.1e-3);
const Vector3 OzoneOf300Units(2.010e-3, 1.881e-3, 0.085e-3);
const Vector3 Wavelengths(620.0, 550.0, 440.0);

constexpr double LongestStep = 0.3; // optical thickness
// Parts of a line: so much of their weight is what the air of this scale height has of the line, the rest what is seen.
constexpr double HighShare = 0.6;
constexpr double HighAir = 30.0;

constexpr int SunRows = 64;     // by the root of the altitude
constexpr int SunColumns = 128; // by the root of the height of the sun's cosine above that of the horizon

/// Line through the air in steps along which it changes little, from its begin on.
struct March
{
  double Radius;
  double CosView;
  double Whole; ///< length to the end
  bool MeetsGround;
  double Begin = 0.0; ///< of the step
  double Length = 0.0;
  double Altitude = 0.0; ///< of the step's middle

  March(double altitude, double cosView)
    : Radius(EarthRadius + altitude)
    , CosView(cosView)
  {
    const double across = this->Radius * this->Radius * (cosView * cosView - 1.0);
    const double reach = across + EarthRadius * EarthRadius;
    const double top = EarthRadius + AirHeight;
    this->MeetsGround = cosView < 0.0 && reach >= 0.0;
    this->Whole =
      -this->Radius * cosView + (this->MeetsGround ? -std::sqrt(reach) : std::sqrt(std::max(0.0, across + top * top)));
  }

  double RadiusAt(double s) const
  {
    return std::sqrt(std::max(0.0, this->Radius * this->Radius + s * (s + 2.0 * this->Radius * this->CosView)));
  }

  /// Angle at the earth's center, of which these are cosine and sine.
  double CosTurn(double s) const { return (this->Radius + s * this->CosView) / this->RadiusAt(s); }
  double SinTurn(double s) const
  {
    return s * std::sqrt(std::max(0.0, 1.0 - this->CosView * this->CosView)) / this->RadiusAt(s);
  }

  /// Goes on, by at most a length; false at the end.
  bool Step(double longest)
  {
    this->Begin += this->Length;
    const double left = this->Whole - this->Begin;
    if (left <= 1e-9 * this->Whole || left <= 0.0)
    {
      return false;
    }
    // Altitude changes by at most a: a = |c| s + s2 / (2 r)
    const double r = this->RadiusAt(this->Begin);
    const double c = std::abs(this->Begin + this->Radius * this->CosView) / r;
    const double a = 0.12 + 0.05 * std::max(0.0, r - EarthRadius);
    const double s = 2.0 * a / (c + std::sqrt(c * c + 2.0 * a / r));
    this->Length = std::min({ s, longest, left });
    this->Altitude = std::max(0.0, this->RadiusAt(this->Begin + 0.5 * this->Length) - EarthRadius);
    return true;
  }
};

/// Step along a line of sight.
struct LineStep
{
  double Place;
  double High; ///< its weight as high air
  Vector3 Molecules;
  Vector3 Aerosols;

  double Seen() const { return std::max(glm::dot(Vector3(1.0), this->Molecules + this->Aerosols), 1e-300); }
};

/// Steps as one part, where the mean of what is seen of them is.
SightPart PartOf(const March& march, const LineStep* begin, const LineStep* end)
{
  SightPart part{};
  double seen = 0.0;
  double place = 0.0;
  for (const LineStep* step = begin; step != end; ++step)
  {
    part.Molecules += step->Molecules;
    part.Aerosols += step->Aerosols;
    seen += step->Seen();
    place += step->Seen() * step->Place;
  }
  const double s = place / seen;
  const double r = march.RadiusAt(s);
  part.Altitude = std::clamp(r - EarthRadius, 0.0, AirHeight);
  part.CosView = std::clamp((s + march.Radius * march.CosView) / r, -1.0, 1.0);
  part.CosTurn = march.CosTurn(s);
  part.SinTurn = march.SinTurn(s);
  return part;
}

/// Parts of a line of about the same weight.
std::vector<SightPart> PartsOf(const March& march, const std::vector<LineStep>& steps, int count)
{
  double seen = 0.0;
  double high = 0.0;
  for (const LineStep& step : steps)
  {
    seen += step.Seen();
    high += step.High;
  }
  std::vector<SightPart> parts;
  double weight = 0.0;
  std::size_t first = 0;
  for (std::size_t n = 0; n < steps.size(); ++n)
  {
    const int part = static_cast<int>(weight * count);
    weight += (1.0 - HighShare) * steps[n].Seen() / seen + HighShare * steps[n].High / high;
    if (n + 1 == steps.size() || static_cast<int>(weight * count) > part)
    {
      parts.push_back(PartOf(march, steps.data() + first, steps.data() + n + 1));
      first = n + 1;
    }
  }
  return parts;
}

}

/// p(c) = 3 (1 + c2) / (16 pi)  (Rayleigh)
double MoleculePhase(double cosine)
{
  return 3.0 / (16.0 * Pi) * (1.0 + cosine * cosine);
}

/// p(c) = (1 - g2) / (4 pi (1 + g2 - 2 g c)^(3/2))  (Henyey and Greenstein)
double AerosolPhase(double cosine)
{
  constexpr double g = AerosolAsymmetry;
  const double root = std::sqrt(1.0 + g * g - 2.0 * g * cosine);
  return (1.0 - g * g) / (4.0 * Pi * root * root * root);
}

AirLayers::AirLayers(const AirParameters& parameters, const ParallelFor& parallel)
  : OzoneAbsorption(parameters.Ozone / 300.0 * OzoneOf300Units)
{
  // Aerosols are T - 1 times as thick as molecules at 550 nm; tau ~ wavelength^-1.3 (Angstrom)
  const double thickness = (parameters.Turbidity - 1.0) * MoleculeScattering.y * MoleculeHeight;
  this->AerosolScattering =
    AerosolAlbedo * thickness / AerosolHeight * glm::pow(Vector3(550.0) / Wavelengths, Vector3(AngstromExponent));
  this->ThicknessToTop.resize(static_cast<std::size_t>(SunRows) * SunColumns);
  parallel(SunRows, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      const double root = static_cast<double>(row) / (SunRows - 1);
      const double altitude = AirHeight * root * root;
      const double horizon = CosHorizon(altitude);
      for (int column = 0; column < SunColumns; ++column)
      {
        const double t = static_cast<double>(column) / (SunColumns - 1);
        this->ThicknessToTop[row * SunColumns + column] =
          this->Thickness(altitude, std::min(1.0, horizon + 1e-9 + (1.0 - horizon) * t * t));
      }
    }
  });
}

AirLayers::Coefficients AirLayers::At(double altitude) const
{
  Coefficients c;
  c.Molecules = std::exp(-altitude / MoleculeHeight) * MoleculeScattering;
  c.Aerosols = std::exp(-altitude / AerosolHeight) * this->AerosolScattering;
  const double ozone = std::max(0.0, 1.0 - std::abs(altitude - 25.0) / 15.0);
  c.Extinction = c.Molecules + 1.0 / AerosolAlbedo * c.Aerosols + ozone * this->OzoneAbsorption;
  return c;
}

/// tau = integral of the extinction
Vector3 AirLayers::Thickness(double altitude, double cosView) const
{
  Vector3 thickness(0.0);
  for (March march(altitude, cosView); march.Step(1e9);)
  {
    thickness += march.Length * this->At(march.Altitude).Extinction;
  }
  return thickness;
}

SightLine AirLayers::Line(double altitude, double cosView, int parts) const
{
  SightLine line;
  std::vector<LineStep> steps;
  March march(altitude, cosView);
  double longest = LongestStep / this->At(altitude).Extinction.y;
  while (march.Step(longest))
  {
    const Coefficients c = this->At(march.Altitude);
    longest = LongestStep / c.Extinction.y;
    // Of the step's source comes (1 - exp(-sigma s)) / sigma, through what is before it
    const Vector3 kept = glm::exp(-march.Length * c.Extinction);
    const Vector3 seen = line.Through * (1.0 - kept) / glm::max(c.Extinction, Vector3(1e-30));
    steps.push_back({ march.Begin + 0.5 * march.Length, march.Length * std::exp(-march.Altitude / HighAir),
      c.Molecules * seen, c.Aerosols * seen });
    line.Through *= kept;
  }
  line.Parts = PartsOf(march, steps, parts);
  line.MeetsGround = march.MeetsGround;
  line.CosTurn = march.CosTurn(march.Whole);
  line.SinTurn = march.SinTurn(march.Whole);
  return line;
}

double AirLayers::CosHorizon(double altitude)
{
  const double ratio = EarthRadius / (EarthRadius + altitude);
  return -std::sqrt(std::max(0.0, 1.0 - ratio * ratio));
}

double AirLayers::CosSunset(double altitude)
{
  return CosHorizon(altitude) - SunRadius;
}

Vector3 AirLayers::SunAt(double altitude, double cosSun) const
{
  const double horizon = CosHorizon(altitude);
  // Part of the disk that is above the horizon
  const double t = std::clamp((cosSun - horizon) / (2.0 * SunRadius) + 0.5, 0.0, 1.0);
  if (t <= 0.0)
  {
    return Vector3(0.0);
  }
  const double x = std::sqrt(std::clamp((cosSun - horizon) / (1.0 - horizon), 0.0, 1.0)) * (SunColumns - 1);
  const double y = std::sqrt(std::clamp(altitude / AirHeight, 0.0, 1.0)) * (SunRows - 1);
  const int i = std::min(static_cast<int>(x), SunColumns - 2);
  const int j = std::min(static_cast<int>(y), SunRows - 2);
  const Vector3* at = this->ThicknessToTop.data() + static_cast<std::size_t>(j) * SunColumns + i;
  const double u = x - i;
  const double v = y - j;
  const Vector3 thickness =
    (1.0 - v) * ((1.0 - u) * at[0] + u * at[1]) + v * ((1.0 - u) * at[SunColumns] + u * at[SunColumns + 1]);
  return t * t * (3.0 - 2.0 * t) * glm::exp(-thickness);
}

}
