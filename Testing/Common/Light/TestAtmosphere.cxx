// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Luminance of the sky against paths of light drawn at random, conserved light, illuminances of nature, twilight.
#include "../OnThreads.h"
#include "Light/Atmosphere.h"
#include "Light/SkyTables.h"
#include "Light/SunPosition.h"
#include "Numerics/Constants.h"
#include "SkyMonteCarlo.h"
#include "SkyTruth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <vector>

namespace
{

using littoral::AirParameters;
using littoral::Atmosphere;
using littoral::DirectionOf;
using littoral::LuminanceOf;
using littoral::SkyTables;
using littoral::TabulateSky;
using littoral::Vector3;
using littoral::testing::SkyMonteCarlo;

AirParameters Air(double turbidity)
{
  AirParameters air;
  air.Turbidity = turbidity;
  return air;
}

/// Air that several cases share.
const Atmosphere& Shared(double turbidity)
{
  static std::map<double, Atmosphere> airs;
  return airs.try_emplace(turbidity, Air(turbidity)).first->second;
}

/// Luminance [kcd/m2] and its standard error, by paths of light.
SkyMonteCarlo::Estimate ByPaths(const littoral::testing::SkyCase& sky, int paths, int seed)
{
  constexpr std::array<double, 3> parts{ 0.2126, 0.7152, 0.0722 };
  SkyMonteCarlo::Estimate sum;
  for (int channel = 0; channel < 3; ++channel)
  {
    const SkyMonteCarlo::Estimate one =
      SkyMonteCarlo::Channel(channel, sky.Turbidity)
        .Luminance(DirectionOf({ sky.Elevation, sky.Azimuth }), DirectionOf({ sky.SunElevation, 180.0 }), paths, seed);
    sum.Mean += 128.0 * parts[channel] * one.Mean;
    sum.Error = std::hypot(sum.Error, 128.0 * parts[channel] * one.Error);
  }
  return sum;
}

TEST(Atmosphere, SkyIsThatOfPathsOfLight)
{
  struct Bound
  {
    double Turbidity, Worst, RootMeanSquare;
  };
  for (const Bound bound : { Bound{ 2.0, 0.008, 0.004 }, Bound{ 5.0, 0.015, 0.007 }, Bound{ 10.0, 0.035, 0.015 } })
  {
    const Atmosphere& air = Shared(bound.Turbidity);
    double squares = 0.0;
    for (const littoral::testing::SkyCase& sky : littoral::testing::SkyTruth)
    {
      if (sky.Turbidity == bound.Turbidity)
      {
        const double ours = LuminanceOf(
          air.SkyLuminance(DirectionOf({ sky.Elevation, sky.Azimuth }), DirectionOf({ sky.SunElevation, 180.0 })));
        EXPECT_NEAR(ours / sky.Luminance, 1.0, bound.Worst)
          << bound.Turbidity << ", sun " << sky.SunElevation << ": " << sky.Elevation << " " << sky.Azimuth;
        squares += std::pow(ours / sky.Luminance - 1.0, 2.0);
      }
    }
    EXPECT_LT(std::sqrt(squares / 36.0), bound.RootMeanSquare) << bound.Turbidity;
  }
}

TEST(Atmosphere, RecordedPathsAreThoseOfToday)
{
  for (std::size_t n = 0; n < littoral::testing::SkyTruth.size(); n += 9)
  {
    const SkyMonteCarlo::Estimate paths = ByPaths(littoral::testing::SkyTruth[n], 1000, 3);
    EXPECT_NEAR(littoral::testing::SkyTruth[n].Luminance, paths.Mean, 4.5 * paths.Error) << n;
  }
}

TEST(Atmosphere, RecordedPathsAreThoseOfManyMore)
{
  for (const littoral::testing::SkyCase& sky : littoral::testing::SkyTruth)
  {
    const SkyMonteCarlo::Estimate paths = ByPaths(sky, 20000, 4);
    EXPECT_NEAR(sky.Luminance, paths.Mean, 4.5 * paths.Error)
      << sky.Turbidity << ", sun " << sky.SunElevation << ": " << sky.Elevation << " " << sky.Azimuth;
  }
}

TEST(Atmosphere, LightIsConservedWhereNothingTakesIt)
{
  // At any height as much goes down as up: white ground, no aerosols, no ozone.
  AirParameters clear = Air(1.0);
  clear.Ozone = 0.0;
  clear.GroundAlbedo = 1.0;
  for (const double altitude : { 0.0, 10000.0 })
  {
    clear.Altitude = altitude;
    const Atmosphere air(clear);
    for (const double elevation : { 80.0, 40.0 })
    {
      const SkyTables sky = TabulateSky(air, DirectionOf({ elevation, 70.0 }));
      const Vector3 down = sky.LightOn({ 0.0, 0.0, 1.0 }) + sky.Sun.z * sky.SunLight;
      const Vector3 up = sky.LightOn({ 0.0, 0.0, -1.0 });
      for (int channel = 0; channel < 3; ++channel)
      {
        EXPECT_NEAR(up[channel] / down[channel], 1.0, altitude > 0.0 ? 0.007 : 0.003)
          << altitude << " " << elevation << " " << channel;
      }
    }
  }
}

/// Luminance of a clear sky at sunset, as the formulas of Preetham, Shirley and Smits 1999 have it [kcd/m2].
double PreethamAtSunset(double turbidity, const Vector3& direction, const Vector3& sun)
{
  const double T = turbidity;
  const double A = 0.1787 * T - 1.4630;
  const double B = -0.3554 * T + 0.4275;
  const double C = -0.0227 * T + 5.3251;
  const double D = 0.1206 * T - 2.5771;
  const double E = -0.0670 * T + 0.3703;
  const auto perez = [&](double cosZenith, double cosSun) {
    return (1.0 + A * std::exp(B / cosZenith)) * (1.0 + C * std::exp(D * std::acos(cosSun)) + E * cosSun * cosSun);
  };
  const double zenith = -0.2155 * T + 2.4192; // the tangent of chi is 0
  return zenith * perez(direction.z, glm::dot(direction, sun)) / perez(1.0, sun.z);
}

TEST(Atmosphere, PreethamsSunsetIsNoneOfNature)
{
  // 16 klx on level ground, where nature has 0.4 to 1
  double light = 0.0;
  constexpr int rows = 90;
  constexpr int columns = 180;
  for (int n = 0; n < rows * columns; ++n)
  {
    const double z = (n / columns + 0.5) / rows;
    const double across = std::sqrt(1.0 - z * z);
    const double around = littoral::TwoPi * (n % columns + 0.5) / columns;
    light += littoral::TwoPi / (rows * columns) * z *
      PreethamAtSunset(2.0, { across * std::cos(around), across * std::sin(around), z }, { 1.0, 0.0, 0.0 });
  }
  EXPECT_NEAR(light, 16.0, 1.0);
}

/// Light on level ground of the sky, and with the sun [klx].
std::array<double, 2> OnLevelGround(const Atmosphere& air, double elevation)
{
  const SkyTables sky = TabulateSky(air, DirectionOf({ elevation, 250.0 }));
  const double diffuse = LuminanceOf(sky.LightOn({ 0.0, 0.0, 1.0 }));
  return { diffuse, diffuse + std::max(0.0, sky.Sun.z) * LuminanceOf(sky.SunLight) };
}

TEST(Atmosphere, LightOnTheGroundIsThatOfNature)
{
  const Atmosphere& air = Shared(2.0);
  const std::array<double, 2> noon = OnLevelGround(air, 60.0);
  EXPECT_NEAR(noon[0], 17.0, 0.5);  // 10 to 20
  EXPECT_NEAR(noon[1], 101.0, 1.0); // 100 to 110
  // Sunset 0.4 to 1 klx; the end of civil twilight 3 lx, of which this has twice as much without refraction
  EXPECT_NEAR(OnLevelGround(air, 0.0)[1], 0.93, 0.03);
  EXPECT_NEAR(OnLevelGround(air, -6.0)[1], 0.006, 0.0005);
}

TEST(Atmosphere, TwilightIsThatOfPathsOfLight)
{
  const Atmosphere& air = Shared(2.0);
  for (const littoral::testing::SkyCase& sky : { littoral::testing::SkyCase{ 2.0, 0.0, 75.0, 180.0, 0.0 },
         { 2.0, 0.0, 10.0, 180.0, 0.0 }, { 2.0, -3.0, 75.0, 180.0, 0.0 }, { 2.0, -3.0, 10.0, 180.0, 0.0 } })
  {
    const SkyMonteCarlo::Estimate paths = ByPaths(sky, 4000, 5);
    const double ours = LuminanceOf(
      air.SkyLuminance(DirectionOf({ sky.Elevation, sky.Azimuth }), DirectionOf({ sky.SunElevation, 180.0 })));
    EXPECT_NEAR(ours / paths.Mean, 1.0, 0.02 + 3.0 * paths.Error / paths.Mean)
      << sky.SunElevation << " " << sky.Elevation;
  }
}

TEST(Atmosphere, TwilightFadesWithoutAJump)
{
  for (const double turbidity : { 1.0, 2.0, 10.0 })
  {
    const Atmosphere& air = Shared(turbidity);
    for (const Vector3& direction : { DirectionOf({ 90.0, 0.0 }), DirectionOf({ 5.0, 180.0 }),
           DirectionOf({ 20.0, 270.0 }), DirectionOf({ 0.5, 0.0 }) })
    {
      double last = std::numeric_limits<double>::quiet_NaN();
      for (double elevation = 3.0; elevation >= -25.0; elevation -= 0.05)
      {
        const Vector3 color = air.SkyLuminance(direction, DirectionOf({ elevation, 180.0 }));
        EXPECT_GE(std::min({ color.x, color.y, color.z }), 2e-7);
        const double luminance = LuminanceOf(color);
        ASSERT_TRUE(std::isfinite(luminance)) << elevation;
        if (std::isfinite(last))
        {
          EXPECT_NEAR(luminance / last, 1.0, 0.2) << turbidity << " " << elevation;
        }
        if (elevation < 1.0)
        {
          EXPECT_LE(luminance, 1.001 * last) << turbidity << " " << elevation;
        }
        last = luminance;
      }
      EXPECT_GT(last, 2e-7); // 0.0002 cd/m2, of a night without a moon
      EXPECT_LT(last, 2.5e-7);
    }
  }
}

TEST(Atmosphere, HasNoSideButTheSuns)
{
  const Atmosphere& air = Shared(2.0);
  // Turned with the sun, and mirrored at its plane; straight up from all sides
  const Vector3 one = air.SkyLuminance(DirectionOf({ 20.0, 70.0 }), DirectionOf({ 30.0, 40.0 }));
  const Vector3 turned = air.SkyLuminance(DirectionOf({ 20.0, 230.0 }), DirectionOf({ 30.0, 200.0 }));
  const Vector3 mirrored = air.SkyLuminance(DirectionOf({ 20.0, 10.0 }), DirectionOf({ 30.0, 40.0 }));
  EXPECT_NEAR(glm::length(turned - one), 0.0, 1e-5 * glm::length(one));
  EXPECT_NEAR(glm::length(mirrored - one), 0.0, 1e-5 * glm::length(one));
  const Vector3 zenith = air.SkyLuminance({ 0.0, 0.0, 1.0 }, DirectionOf({ 30.0, 40.0 }));
  for (const double azimuth : { 0.0, 130.0 })
  {
    const Vector3 near = air.SkyLuminance(DirectionOf({ 89.9999, azimuth }), DirectionOf({ 30.0, 40.0 }));
    EXPECT_NEAR(glm::length(near - zenith), 0.0, 1e-3 * glm::length(zenith));
  }
  // A sun in the zenith has no azimuth
  const Vector3 east = air.SkyLuminance(DirectionOf({ 20.0, 90.0 }), { 0.0, 0.0, 1.0 });
  EXPECT_NEAR(glm::length(air.SkyLuminance(DirectionOf({ 20.0, 200.0 }), { 0.0, 0.0, 1.0 }) - east), 0.0, 1e-9);
}

TEST(Atmosphere, RowsAreTheSameAsOneByOne)
{
  const Atmosphere& air = Shared(2.0);
  const Vector3 sun = DirectionOf({ 12.0, 200.0 });
  const std::vector<Vector3> row{ DirectionOf({ 7.0, 20.0 }), DirectionOf({ 7.0, 190.0 }),
    DirectionOf({ 7.0, 290.0 }) };
  const std::vector<Vector3> together = air.SkyLuminances(row, sun);
  for (std::size_t n = 0; n < row.size(); ++n)
  {
    EXPECT_NEAR(glm::length(together[n] - air.SkyLuminance(row[n], sun)), 0.0, 1e-9);
  }
  EXPECT_TRUE(air.SkyLuminances({}, sun).empty());
}

TEST(Atmosphere, SameBytesOnAnyThreads)
{
  const Vector3 sun = DirectionOf({ 8.0, 100.0 });
  const SkyTables one = TabulateSky(Shared(5.0), sun);
  for (const int threads : { 3 })
  {
    const littoral::ParallelFor parallel = littoral::testing::OnThreads(threads);
    const SkyTables other = TabulateSky(Atmosphere(Air(5.0), parallel), sun, parallel);
    EXPECT_EQ(
      std::memcmp(one.Dome.Colors.data(), other.Dome.Colors.data(), one.Dome.Colors.size() * sizeof(Vector3)), 0);
    EXPECT_EQ(
      std::memcmp(one.Light.Colors.data(), other.Light.Colors.data(), one.Light.Colors.size() * sizeof(Vector3)), 0);
  }
}

TEST(Atmosphere, NamesBadParameters)
{
  EXPECT_EQ(WhyInvalid(AirParameters{}), "");
  EXPECT_EQ(WhyInvalid(AirParameters{ 0.9, 0.2, 0.0, 300.0 }).rfind("Turbidity", 0), 0U);
  EXPECT_EQ(WhyInvalid(AirParameters{ 2.0, 1.1, 0.0, 300.0 }).rfind("GroundAlbedo", 0), 0U);
  EXPECT_EQ(WhyInvalid(AirParameters{ 2.0, 0.2, -1.0, 300.0 }).rfind("Altitude", 0), 0U);
  EXPECT_EQ(WhyInvalid(AirParameters{ 2.0, 0.2, 0.0, std::nan("") }).rfind("Ozone", 0), 0U);
}

}
