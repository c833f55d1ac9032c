// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Light on planes against integrals of the sky itself and closed forms; the dome between its places.
#include "Light/SkyTables.h"
#include "Light/SunPosition.h"
#include "Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace
{

using littoral::AirParameters;
using littoral::Atmosphere;
using littoral::Degree;
using littoral::DirectionOf;
using littoral::LuminanceOf;
using littoral::Pi;
using littoral::SkyTables;
using littoral::TabulateSky;
using littoral::TwoPi;
using littoral::Vector3;

/// Normals of twelve planes: level, upside down, steep, upright.
std::vector<Vector3> Planes()
{
  std::vector<Vector3> normals{ { 0.0, 0.0, 1.0 }, { 0.0, 0.0, -1.0 } };
  for (const double azimuth : { 10.0, 100.0, 190.0, 280.0 })
  {
    normals.push_back(DirectionOf({ 0.0, azimuth }));
    normals.push_back(DirectionOf({ 50.0, azimuth + 33.0 }));
  }
  normals.push_back(DirectionOf({ -40.0, 190.0 }));
  normals.push_back(DirectionOf({ -40.0, 20.0 }));
  return normals;
}

/// Tables of a sky of one color by the elevation.
SkyTables SkyOf(const std::function<double(double sinElevation)>& luminance, const Vector3& sun = { 0.6, 0.0, 0.8 })
{
  return TabulateSky(
    [&](const std::vector<Vector3>& directions) {
      std::vector<Vector3> colors;
      for (const Vector3& direction : directions)
      {
        colors.emplace_back(luminance(direction.z));
      }
      return colors;
    },
    sun, Vector3(0.0));
}

TEST(SkyTables, WhiteFurnaceIsWhite)
{
  const SkyTables sky = SkyOf([](double) { return 2.5; });
  for (const Vector3& normal : Planes())
  {
    EXPECT_NEAR(sky.LightOn(normal).y, 2.5 * Pi, 0.005 * 2.5 * Pi);
    EXPECT_NEAR(sky.LuminanceAt(normal).y, 2.5, 1e-12);
  }
}

TEST(SkyTables, UniformSkyOverGroundIsTheClosedForm)
{
  // E = pi L (1 + cos b) / 2 + albedo pi L (1 - cos b) / 2
  constexpr double albedo = 0.3;
  const SkyTables sky = SkyOf([](double z) { return z >= 0.0 ? 4.0 : albedo * 4.0; });
  for (const Vector3& normal : Planes())
  {
    const double light = 4.0 * Pi * (0.5 * (1.0 + normal.z) + albedo * 0.5 * (1.0 - normal.z));
    EXPECT_NEAR(sky.LightOn(normal).y, light, 0.01 * light);
  }
}

TEST(SkyTables, OvercastSkyIsTheClosedForm)
{
  // L = Lz (1 + 2 sin e) / 3 (Moon and Spencer 1942): level ground 7 pi Lz / 9, upright planes Lz (pi / 6 + 4 / 9)
  const SkyTables sky = SkyOf([](double z) { return z >= 0.0 ? 3.0 * (1.0 + 2.0 * z) / 3.0 : 0.0; });
  EXPECT_NEAR(sky.LightOn({ 0.0, 0.0, 1.0 }).x, 3.0 * 7.0 * Pi / 9.0, 0.05);
  EXPECT_NEAR(sky.LightOn({ 0.6, 0.8, 0.0 }).x, 3.0 * (Pi / 6.0 + 4.0 / 9.0), 0.02);
}

/// Light on planes by the sky's own luminances, in parts dense at the horizon and at the sun.
std::vector<double> LightByIntegral(const Atmosphere& air, const Vector3& sun, const std::vector<Vector3>& normals)
{
  std::vector<double> light(normals.size(), 0.0);
  constexpr int rows = 160;
  constexpr int columns = 160;
  const double from = std::atan2(sun.y, sun.x);
  for (int row = 0; row < rows; ++row)
  {
    const double t = (2.0 * row + 1.0) / rows - 1.0;
    const double z = t * std::abs(t);
    std::vector<Vector3> directions;
    std::vector<double> angles;
    for (int column = 0; column < columns; ++column)
    {
      const double u = (2.0 * column + 1.0) / columns - 1.0;
      const double around = from + Pi * u * std::abs(u);
      directions.emplace_back(std::sqrt(1.0 - z * z) * std::cos(around), std::sqrt(1.0 - z * z) * std::sin(around), z);
      angles.push_back(2.0 * std::abs(t) * 2.0 / rows * TwoPi * std::abs(u) * 2.0 / columns);
    }
    const std::vector<Vector3> colors = air.SkyLuminances(directions, sun);
    for (int column = 0; column < columns; ++column)
    {
      for (std::size_t n = 0; n < normals.size(); ++n)
      {
        light[n] +=
          std::max(0.0, glm::dot(normals[n], directions[column])) * angles[column] * LuminanceOf(colors[column]);
      }
    }
  }
  return light;
}

TEST(SkyTables, LightOnPlanesIsTheIntegralOfTheSky)
{
  const std::vector<Vector3> normals = Planes();
  for (const double turbidity : { 2.0, 6.0 })
  {
    AirParameters parameters;
    parameters.Turbidity = turbidity;
    const Atmosphere air(parameters);
    for (const double elevation : { 60.0, 5.0, -4.0 })
    {
      const Vector3 sun = DirectionOf({ elevation, 130.0 });
      const SkyTables sky = TabulateSky(air, sun);
      const std::vector<double> truth = LightByIntegral(air, sun, normals);
      for (std::size_t n = 0; n < normals.size(); ++n)
      {
        EXPECT_NEAR(LuminanceOf(sky.LightOn(normals[n])), truth[n], 0.02 * truth[n])
          << turbidity << ", sun " << elevation << ": plane " << n;
      }
    }
  }
}

TEST(SkyTables, DomeIsTheSkyBetweenItsPlaces)
{
  const Atmosphere air(AirParameters{});
  const Vector3 sun = DirectionOf({ 15.0, 200.0 });
  const SkyTables sky = TabulateSky(air, sun);
  EXPECT_NEAR(glm::length(sky.SunLight - air.SunLight(sun)), 0.0, 1e-12);
  for (const double elevation : { 85.0, 44.0, 21.0, 15.0, 9.0, 3.1, 0.7, -0.7, -3.1, -20.0, -70.0 })
  {
    for (const double azimuth : { 3.0, 95.0, 170.0, 200.0, 206.0, 290.0 })
    {
      const Vector3 direction = DirectionOf({ elevation, azimuth });
      const double truth = LuminanceOf(air.SkyLuminance(direction, sun));
      EXPECT_NEAR(LuminanceOf(sky.LuminanceAt(direction)), truth, 0.02 * truth) << elevation << " " << azimuth;
    }
  }
}

}
