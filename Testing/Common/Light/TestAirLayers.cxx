// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Transmittance of air in layers against closed forms and own integrals; three wavelengths against the whole spectrum.
#include "Light/AirLayers.h"
#include "Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace
{

using littoral::AirLayers;
using littoral::AirParameters;
using littoral::Degree;
using littoral::LuminanceOf;
using littoral::Pi;
using littoral::SightLine;
using littoral::Vector3;

AirParameters Air(double turbidity, double ozone = 300.0)
{
  AirParameters air;
  air.Turbidity = turbidity;
  air.Ozone = ozone;
  return air;
}

/// Integral of a density, by the altitude, along a line from the ground up [km], by the midpoint rule in s = S t2.
double Column(double elevation, const std::function<double(double)>& density)
{
  constexpr double earth = 6360.0;
  constexpr double top = 6460.0;
  constexpr int steps = 20000;
  const double z = std::sin(elevation * Degree);
  const double whole = -earth * z + std::sqrt(earth * earth * (z * z - 1.0) + top * top);
  double sum = 0.0;
  for (int n = 0; n < steps; ++n)
  {
    const double t = (n + 0.5) / steps;
    const double s = whole * t * t;
    sum += 2.0 * whole * t / steps * density(std::sqrt(earth * earth + s * s + 2.0 * earth * s * z) - earth);
  }
  return sum;
}

double Molecules(double altitude)
{
  return std::exp(-altitude / 8.0);
}
double Aerosols(double altitude)
{
  return std::exp(-altitude / 1.2);
}
double Ozone(double altitude)
{
  return std::max(0.0, 1.0 - std::abs(altitude - 25.0) / 15.0);
}

TEST(AirLayers, StraightUpIsTheClosedForm)
{
  // tau = beta H (1 - exp(-100 / H)), ozone 15 km of its densest; turbidity 3: aerosols scatter twice as
  // much at 550 nm
  const double molecules = 8.0 * (1.0 - std::exp(-12.5));
  EXPECT_NEAR(AirLayers(Air(1.0, 0.0)).SunAt(0.0, 1.0).y, std::exp(-13.558e-3 * molecules), 2e-4);
  EXPECT_NEAR(AirLayers(Air(1.0, 0.0)).SunAt(0.0, 1.0).z, std::exp(-33.1e-3 * molecules), 2e-4);
  EXPECT_NEAR(
    AirLayers(Air(1.0, 600.0)).SunAt(0.0, 1.0).x, std::exp(-8.396e-3 * molecules - 2.0 * 15.0 * 2.010e-3), 2e-4);
  EXPECT_NEAR(AirLayers(Air(3.0, 0.0)).SunAt(0.0, 1.0).y, std::exp(-13.558e-3 * (molecules + 2.0 * 8.0)), 2e-4);
}

TEST(AirLayers, LowSunIsTheIntegralOnARoundEarth)
{
  const AirLayers layers(Air(3.0));
  for (const double elevation : { 60.0, 20.0, 7.0, 3.0, 1.0 })
  {
    const double thickness = 13.558e-3 * Column(elevation, Molecules) +
      2.0 * 13.558e-3 * 8.0 / 1.2 * Column(elevation, Aerosols) + 1.881e-3 * Column(elevation, Ozone);
    EXPECT_NEAR(std::log(layers.SunAt(0.0, std::sin(elevation * Degree)).y), -thickness, 0.004 * thickness)
      << elevation;
  }
}

TEST(AirLayers, TheDiskSetsBehindTheHorizon)
{
  const AirLayers layers(Air(1.0));
  for (const double altitude : { 0.0, 1.0, 10.0 })
  {
    const double dip = std::acos(6360.0 / (6360.0 + altitude)) / Degree;
    const auto redAt = [&](double elevation) { return layers.SunAt(altitude, std::sin((elevation - dip) * Degree)).x; };
    EXPECT_EQ(redAt(-0.28), 0.0);
    EXPECT_GT(redAt(-0.2), 0.0);
    EXPECT_NEAR(redAt(0.0) / redAt(1e-6), 1.0, 1e-3);
    EXPECT_GT(redAt(0.28), redAt(0.0));
  }
}

TEST(AirLayers, PartsOfALineAreAllOfIt)
{
  // Without absorption, what is scattered and what comes through is all.
  const AirLayers layers(Air(1.0, 0.0));
  for (const double altitude : { 1e-3, 2.0, 40.0 })
  {
    for (const double cosView : { 1.0, 0.3, 0.01, -0.02, -0.2, -1.0 })
    {
      for (const int parts : { 7, 50 })
      {
        const SightLine line = layers.Line(altitude, cosView, parts);
        Vector3 sum = line.Through;
        for (const littoral::SightPart& part : line.Parts)
        {
          sum += part.Molecules + part.Aerosols;
          EXPECT_NEAR(part.CosTurn * part.CosTurn + part.SinTurn * part.SinTurn, 1.0, 1e-9);
          EXPECT_NEAR(std::acos(part.CosView), std::acos(cosView) - std::asin(part.SinTurn), 1e-5);
        }
        EXPECT_NEAR(sum.x, 1.0, 1e-9);
        EXPECT_NEAR(sum.z, 1.0, 1e-9);
        EXPECT_LE(line.Parts.size(), static_cast<std::size_t>(parts + 1));
        EXPECT_EQ(line.MeetsGround, cosView < -std::sqrt(1.0 - std::pow(6360.0 / (6360.0 + altitude), 2.0)));
      }
    }
  }
}

TEST(AirLayers, PhaseFunctionsHaveTheirMoments)
{
  // Integrals over the sphere of 1, c and c2: 1, 0, 2/5 and 1, g, (1 + 2 g2) / 3
  std::array<double, 6> sums{};
  constexpr int steps = 100000;
  for (int n = 0; n < steps; ++n)
  {
    const double c = -1.0 + (2.0 * n + 1.0) / steps;
    const double part = 4.0 * Pi / steps;
    for (int k = 0; k < 3; ++k)
    {
      sums[k] += part * littoral::MoleculePhase(c) * std::pow(c, k);
      sums[3 + k] += part * littoral::AerosolPhase(c) * std::pow(c, k);
    }
  }
  const std::array<double, 6> truth{ 1.0, 0.0, 0.4, 1.0, 0.8, (1.0 + 2.0 * 0.64) / 3.0 };
  for (int k = 0; k < 6; ++k)
  {
    EXPECT_NEAR(sums[k], truth[k], 1e-6) << k;
  }
}

// The eye's functions of Wyman, Sloan and Shirley 2013, and the ozone of Serdyuchenko et al. 2014.

double Lobe(double x, double mean, double below, double above)
{
  const double t = (x - mean) / (x < mean ? below : above);
  return std::exp(-0.5 * t * t);
}

Vector3 EyeAt(double wavelength)
{
  return { 1.056 * Lobe(wavelength, 599.8, 37.9, 31.0) + 0.362 * Lobe(wavelength, 442.0, 16.0, 26.7) -
      0.065 * Lobe(wavelength, 501.1, 20.4, 26.2),
    0.821 * Lobe(wavelength, 568.8, 46.9, 40.5) + 0.286 * Lobe(wavelength, 530.9, 16.3, 31.1),
    1.217 * Lobe(wavelength, 437.0, 11.8, 36.0) + 0.681 * Lobe(wavelength, 459.0, 26.0, 13.8) };
}

double OzoneAt(double wavelength) // [1e-25 m2]
{
  constexpr std::array<double, 41> sections{ 0.00282, 0.00664, 0.0153, 0.0276, 0.0552, 0.0845, 0.158, 0.232, 0.367,
    0.492, 0.775, 0.902, 1.48, 1.60, 2.14, 2.76, 3.09, 3.50, 4.27, 4.67, 4.40, 4.70, 5.02, 4.31, 3.74, 3.22, 2.66, 2.24,
    1.85, 1.47, 1.21, 0.942, 0.746, 0.657, 0.511, 0.415, 0.423, 0.324, 0.245, 0.280, 0.253 }; // 380, 390 ... 780 nm
  const double x = (wavelength - 380.0) / 10.0;
  const int i = std::min(static_cast<int>(x), 39);
  return sections[i] + (x - i) * (sections[i + 1] - sections[i]);
}

/// Color of the sun, white before the air, under a low sun, of all wavelengths.
Vector3 SunOfSpectrum(double turbidity, double elevation)
{
  const double molecules = Column(elevation, Molecules);
  const double aerosols = Column(elevation, Aerosols);
  const double ozone = Column(elevation, Ozone);
  const auto colorOf = [](const Vector3& e) {
    return Vector3(3.2406 * e.x - 1.5372 * e.y - 0.4986 * e.z, -0.9689 * e.x + 1.8758 * e.y + 0.0415 * e.z,
      0.0557 * e.x - 0.2040 * e.y + 1.0570 * e.z);
  };
  Vector3 before(0.0);
  Vector3 after(0.0);
  for (double wavelength = 382.5; wavelength < 780.0; wavelength += 5.0)
  {
    const double planck = std::pow(wavelength, -5.0) / (std::exp(1.43878e7 / (wavelength * 5778.0)) - 1.0);
    const double thickness = 13.558e-3 * std::pow(550.0 / wavelength, 4.0) * molecules +
      (turbidity - 1.0) * 13.558e-3 * 8.0 / 1.2 * std::pow(550.0 / wavelength, 1.3) * aerosols +
      1.881e-3 * OzoneAt(wavelength) / 3.5 * ozone;
    before += planck * EyeAt(wavelength);
    after += planck * std::exp(-thickness) * EyeAt(wavelength);
  }
  return colorOf(after) / colorOf(before);
}

TEST(AirLayers, ThreeWavelengthsStandForTheSpectrum)
{
  for (const double turbidity : { 1.0, 2.0, 5.0 })
  {
    const AirLayers layers(Air(turbidity));
    for (const double elevation : { 90.0, 30.0, 10.0, 6.0, 4.0 })
    {
      const Vector3 truth = SunOfSpectrum(turbidity, elevation);
      const Vector3 ours = layers.SunAt(0.0, std::sin(elevation * Degree));
      EXPECT_NEAR(LuminanceOf(ours) / LuminanceOf(truth), 1.0, 0.03) << turbidity << " " << elevation;
      if (turbidity < 5.0 && elevation >= 10.0)
      {
        EXPECT_NEAR(ours.x / ours.y, truth.x / truth.y, 0.1 * truth.x / truth.y) << turbidity << " " << elevation;
      }
    }
  }
}

}
