// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTestSkyMonteCarlo_h
#define LittoralTestSkyMonteCarlo_h

#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"
#include "Numerics/Vector3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace littoral::testing
{

/// Luminance of a clear sky per light of the sun before the air at one wavelength, by paths of light drawn at random:
/// no table, no plane, no moment. Lengths in kilometres.
class SkyMonteCarlo
{
public:
  double Molecules = 13.558e-3; ///< scattering at the ground [1/km]
  double Aerosols = 0.0;        ///< scattering at the ground [1/km]
  double Ozone = 1.881e-3;      ///< absorption at 25 km [1/km]
  double AerosolAlbedo = 0.9;
  double Asymmetry = 0.8;
  double GroundAlbedo = 0.2;
  double Altitude = 1e-3; ///< of the eye

  struct Estimate
  {
    double Mean = 0.0;
    double Error = 0.0; ///< standard error
  };

  /// Red, green or blue of turbid air: wavelengths 620, 550 and 440 nm.
  static SkyMonteCarlo Channel(int channel, double turbidity)
  {
    constexpr std::array<double, 3> wavelengths{ 620.0, 550.0, 440.0 };
    constexpr std::array<double, 3> molecules{ 8.396e-3, 13.558e-3, 33.1e-3 };
    constexpr std::array<double, 3> ozone{ 2.010e-3, 1.881e-3, 0.085e-3 };
    SkyMonteCarlo air;
    air.Molecules = molecules[channel];
    air.Ozone = ozone[channel];
    air.Aerosols =
      air.AerosolAlbedo * (turbidity - 1.0) * molecules[1] * 8.0 / 1.2 * std::pow(550.0 / wavelengths[channel], 1.3);
    return air;
  }

  /// Light that was scattered once by a fine sum, all later times by paths.
  Estimate Luminance(const Vector3& direction, const Vector3& sun, int paths, int seed) const
  {
    const Vector3 eye(0.0, 0.0, Earth + this->Altitude);
    bool meetsGround = false;
    const double whole = Whole(eye, direction, meetsGround);
    // Cumulated chance to be scattered along the line, in steps that are short at the eye
    constexpr int steps = 2000;
    std::vector<double> chance(steps + 1, 0.0);
    std::vector<double> place(steps + 1, 0.0);
    double thickness = 0.0;
    double once = 0.0;
    const double cosine = glm::dot(direction, sun);
    for (int n = 0; n < steps; ++n)
    {
      const double t = (n + 0.5) / steps;
      place[n + 1] = whole * (n + 1.0) * (n + 1.0) / (1.0 * steps * steps);
      const double length = place[n + 1] - place[n];
      const Vector3 at = eye + whole * t * t * direction;
      const Coefficients c = this->At(at);
      const double through =
        std::exp(-thickness) * (c.Total() > 0.0 ? -std::expm1(-length * c.Total()) / c.Total() : 0.0);
      chance[n + 1] = chance[n] + through * c.Scattering();
      once += through * this->SunAt(at, sun) * (c.Molecules * Rayleigh(cosine) + c.Aerosols * this->Henyey(cosine));
      thickness += length * c.Total();
    }
    const double toGround = meetsGround ? std::exp(-thickness) : 0.0;
    if (meetsGround)
    {
      const Vector3 at = eye + whole * direction;
      once +=
        toGround * this->GroundAlbedo / Pi * std::max(0.0, glm::dot(glm::normalize(at), sun)) * this->SunAt(at, sun);
    }
    Draws draw{ RandomStream(seed, RandomPurpose::UniformPoints) };
    double sum = 0.0;
    double squares = 0.0;
    for (int path = 0; path < paths; ++path)
    {
      draw.Begin(static_cast<std::uint64_t>(path));
      // Stratified along the line
      const double total = chance.back() + toGround;
      const double u = (path + draw()) / paths * total;
      double light = 0.0;
      if (u >= chance.back())
      {
        light = this->Path(eye + whole * direction, direction, sun, draw, true);
      }
      else
      {
        const auto n = std::min<std::size_t>(
          std::upper_bound(chance.begin(), chance.end(), u) - chance.begin() - 1, static_cast<std::size_t>(steps - 1));
        const double part = (u - chance[n]) / (chance[n + 1] - chance[n]);
        light =
          this->Path(eye + (place[n] + part * (place[n + 1] - place[n])) * direction, direction, sun, draw, false);
      }
      sum += total * light;
      squares += total * light * total * light;
    }
    const double mean = sum / paths;
    return { once + mean, std::sqrt(std::max(0.0, squares / paths - mean * mean) / paths) };
  }

private:
  static constexpr double Earth = 6360.0;
  static constexpr double Top = 6460.0;

  struct Coefficients
  {
    double Molecules;
    double Aerosols;
    double Absorption;
    double Scattering() const { return this->Molecules + this->Aerosols; }
    double Total() const { return this->Scattering() + this->Absorption; }
  };

  /// Random numbers of a path, one after the other.
  struct Draws
  {
    RandomStream Stream;
    std::uint64_t Path = 0;
    std::uint64_t Count = 0;
    double Second = 0.0;

    void Begin(std::uint64_t path)
    {
      this->Path = path;
      this->Count = 0;
    }
    double operator()()
    {
      if (this->Count++ % 2 == 1)
      {
        return this->Second;
      }
      const std::array<double, 2> pair = this->Stream.UniformPair(this->Path, this->Count / 2);
      this->Second = pair[1];
      return pair[0];
    }
  };

  Coefficients Between(double lowest, double highest) const
  {
    const double aerosols = this->Aerosols * std::exp(-lowest / 1.2);
    const double ozone = this->Ozone * std::max(0.0, 1.0 - std::abs(std::clamp(25.0, lowest, highest) - 25.0) / 15.0);
    return { this->Molecules * std::exp(-lowest / 8.0), aerosols,
      aerosols * (1.0 / this->AerosolAlbedo - 1.0) + ozone };
  }
  Coefficients At(const Vector3& place) const
  {
    const double altitude = std::max(0.0, glm::length(place) - Earth);
    return this->Between(altitude, altitude);
  }

  static double Rayleigh(double c) { return 3.0 / (16.0 * Pi) * (1.0 + c * c); }
  double Henyey(double c) const
  {
    const double g = this->Asymmetry;
    const double root = std::sqrt(1.0 + g * g - 2.0 * g * c);
    return (1.0 - g * g) / (4.0 * Pi * root * root * root);
  }

  /// Length of a line to the ground or to the top of the air.
  static double Whole(const Vector3& from, const Vector3& direction, bool& meetsGround)
  {
    const double b = glm::dot(from, direction);
    const double c = glm::dot(from, from);
    const double reach = b * b - c + Earth * Earth;
    meetsGround = b < 0.0 && reach >= 0.0;
    return meetsGround ? -b - std::sqrt(reach) : -b + std::sqrt(std::max(0.0, b * b - c + Top * Top));
  }

  /// Thickness of the air along a line upwards, by Simpson's rule in t, s = S t2.
  double ThicknessUp(const Vector3& from, const Vector3& direction, double whole) const
  {
    constexpr int parts = 32;
    double sum = 0.0;
    for (int n = 0; n <= parts; ++n)
    {
      const double t = static_cast<double>(n) / parts;
      const double weight = n == parts ? 1.0 : n % 2 == 1 ? 4.0 : 2.0; // nothing at t = 0
      sum += weight * t * this->At(from + whole * t * t * direction).Total();
    }
    return 2.0 * whole * sum / (3.0 * parts);
  }

  /// Part of the sun's light that comes to a place.
  double SunAt(const Vector3& place, const Vector3& sun) const
  {
    bool meetsGround = false;
    const double whole = Whole(place, sun, meetsGround);
    if (meetsGround)
    {
      return 0.0;
    }
    const double down = -glm::dot(place, sun);
    if (down <= 0.0)
    {
      return std::exp(-this->ThicknessUp(place, sun, whole));
    }
    // From the lowest place both ways
    const Vector3 lowest = place + down * sun;
    return std::exp(-this->ThicknessUp(lowest, -sun, down) - this->ThicknessUp(lowest, sun, whole - down));
  }

  static Vector3 Turned(const Vector3& axis, double cosine, double around)
  {
    const Vector3 other = std::abs(axis.x) < 0.5 ? Vector3(1.0, 0.0, 0.0) : Vector3(0.0, 1.0, 0.0);
    const Vector3 x = glm::normalize(glm::cross(axis, other));
    const Vector3 y = glm::cross(axis, x);
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    return glm::normalize(cosine * axis + sine * std::cos(around) * x + sine * std::sin(around) * y);
  }

  /// Goes on after scattering at a place: light that is scattered there, and at least once before.
  double Path(Vector3 place, Vector3 direction, const Vector3& sun, Draws& draw, bool isGround) const
  {
    double light = 0.0;
    double weight = 1.0;
    while (true)
    {
      // A new direction, backwards along the light
      if (isGround)
      {
        const Vector3 up = glm::normalize(place);
        place = (Earth + 1e-6) * up;
        weight *= this->GroundAlbedo;
        const double cosine = std::sqrt(draw());
        direction = Turned(up, cosine, TwoPi * draw());
      }
      else
      {
        const Coefficients c = this->At(place);
        double cosine = 0.0;
        if (draw() * c.Scattering() < c.Molecules)
        {
          // Rayleigh: a root of c3 + 3 c = 4 (2 u - 1)
          const double q = 2.0 * (2.0 * draw() - 1.0);
          const double a = std::cbrt(q + std::sqrt(q * q + 1.0));
          cosine = a - 1.0 / a;
        }
        else
        {
          const double g = this->Asymmetry;
          const double s = (1.0 - g * g) / (1.0 - g + 2.0 * g * draw());
          cosine = (1.0 + g * g - s * s) / (2.0 * g);
        }
        direction = Turned(direction, std::clamp(cosine, -1.0, 1.0), TwoPi * draw());
      }
      if (!this->NextPlace(place, direction, draw, isGround))
      {
        return light;
      }
      // The sun's light, turned into the direction by this place
      if (isGround)
      {
        light += weight * this->GroundAlbedo / Pi * std::max(0.0, glm::dot(glm::normalize(place), sun)) *
          this->SunAt(place, sun);
      }
      else
      {
        const Coefficients c = this->At(place);
        weight *= c.Scattering() / c.Total();
        const double cosine = glm::dot(direction, sun);
        light += weight * this->SunAt(place, sun) *
          (c.Molecules * Rayleigh(cosine) + c.Aerosols * this->Henyey(cosine)) / c.Scattering();
      }
      if (weight < 0.1)
      {
        if (draw() > 0.5)
        {
          return light;
        }
        weight *= 2.0;
      }
    }
  }

  /// Place of the next scattering or absorption by the air, or by the ground; false if the line leaves the air.
  bool NextPlace(Vector3& place, const Vector3& direction, Draws& draw, bool& isGround) const
  {
    const double whole = Whole(place, direction, isGround);
    double s = 0.0;
    while (s < whole)
    {
      // Chances of a bound of the extinction on a piece, kept by the part that is real (Woodcock)
      const double altitude = std::max(0.0, glm::length(place + s * direction) - Earth);
      const double piece = 0.4 + 0.12 * altitude;
      const double bound = this->Between(std::max(0.0, altitude - piece), altitude + piece).Total();
      const double step = -std::log(draw()) / bound;
      if (step > piece)
      {
        s += piece;
        continue;
      }
      s += step;
      if (s < whole && draw() * bound < this->At(place + s * direction).Total())
      {
        place += s * direction;
        isGround = false;
        return true;
      }
    }
    place += whole * direction;
    return isGround;
  }
};

}

#endif
