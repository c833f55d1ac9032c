// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Shafts of light in water by vtkLandscapePass, beside a fine integral along each line of sight.
#include "LandscapePicture.h"

#include "Sea/Ripples.h"
#include "Sea/ScatteredPattern.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <iostream>
#include <numeric>
#include <vector>

namespace
{

constexpr double Side = 6.4; // of the square of waves [m]
constexpr int Places = 128;
constexpr double Absorption = 0.5;
constexpr double Scattering = 0.2;
constexpr double Variance = 0.008; // of slopes
constexpr double MeshVariance = 0.012;
constexpr double Depth = 4.0;
constexpr double Pitch = 0.3; // of the line of sight
constexpr std::array<double, 4> Depths = { 0.75, 2.25, 6.75, 20.25 };

/// The light of waves below them, over that below level water.
class Gathered
{
public:
  explicit Gathered(const glm::dvec3& sun)
    : Sun(sun)
  {
    const std::vector<littoral::SurfaceSlope> slopes = littoral::Ripples(Side, 2 * Places, 1).SlopesAt(0.0);
    for (std::size_t k = 0; k < Depths.size(); ++k)
    {
      this->Light[k] = littoral::ScatteredPattern(
        littoral::GatheredLight(slopes, 2 * Places, Side, 0.25 * Depths[k] * std::sqrt(Variance + MeshVariance)),
        Places, Side, { Depths[k] / sun.z, Scattering });
    }
  }

  /// At a place below the surface, between channels by the logarithm of the depth.
  double At(const glm::dvec3& place) const
  {
    const double depth = -place.z;
    const glm::dvec3 above = place + depth / this->Sun.z * this->Sun;
    if (depth < Depths[0])
    {
      return 1.0 + depth / Depths[0] * (this->In(0, above) - 1.0);
    }
    const int k = depth < Depths[1] ? 0 : depth < Depths[2] ? 1 : 2;
    const double part = std::min(std::log(depth / Depths[k]) / std::log(3.0), 1.0);
    return (1.0 - part) * this->In(k, above) + part * this->In(k + 1, above);
  }

private:
  double In(int channel, const glm::dvec3& place) const
  {
    const double x = place.x / Side * Places - 0.5;
    const double y = place.y / Side * Places - 0.5;
    const int i = static_cast<int>(std::floor(x));
    const int j = static_cast<int>(std::floor(y));
    const auto at = [&](int column, int row) {
      return this->Light[channel][((row % Places + Places) % Places) * Places + (column % Places + Places) % Places];
    };
    const double u = x - i;
    const double v = y - j;
    return (1.0 - v) * ((1.0 - u) * at(i, j) + u * at(i + 1, j)) +
      v * ((1.0 - u) * at(i, j + 1) + u * at(i + 1, j + 1));
  }

  glm::dvec3 Sun;
  std::array<std::vector<double>, 4> Light;
};

struct Deep : Water
{
  Deep()
    : Water({ Absorption, Absorption, Absorption }, { Scattering, Scattering, Scattering })
  {
    this->Pass->SetSunElevation(50.0);
    this->Pass->SetSunAzimuth(0.0);
    this->Pass->ShadowsOff();
    this->Pass->SetWaterSlopeVariance(Variance);
    this->Pass->SetWaterMeshVariance(MeshVariance);
    this->Pass->SetExposureCompensation(1.0);
    this->Look({ 0.0, 0.0, -Depth }, { 0.0, std::cos(Pitch), std::sin(Pitch) - Depth }, { 0.0, 0.0, 1.0 });
    this->Renderer->GetActiveCamera()->SetClippingRange(0.1, 3000.0);
  }

  std::vector<double> Greens(bool hasRipples)
  {
    this->Pass->SetWaterRipples(hasRipples);
    this->Draw();
    std::vector<double> greens;
    for (int pixel = 0; pixel < Width * Height; ++pixel)
    {
      greens.push_back(this->LinearAt(pixel % Width, pixel / Width)[1]);
    }
    return greens;
  }

  /// Direction through the middle of a pixel.
  glm::dvec3 Sight(int pixel)
  {
    const double side = 2.0 * std::tan(vtkMath::RadiansFromDegrees(15.0)) / Height;
    const double right = side * (pixel % Width + 0.5 - 0.5 * Width);
    const double up = side * (pixel / Width + 0.5 - 0.5 * Height);
    return glm::normalize(
      glm::dvec3(right, std::cos(Pitch) - up * std::sin(Pitch), std::sin(Pitch) + up * std::cos(Pitch)));
  }
};

/// Light of the sun along a line of sight, over that in level water, of which the sun sends a part: steps of 2 cm of
/// the light exp(-K z - c l).
double Expected(const Gathered& light, const glm::dvec3& sight, double sunPart)
{
  const double length = std::min(Depth / sight.z, 20.0);
  double sum = 0.0;
  double level = 0.0;
  for (double l = 0.01; l < length; l += 0.02)
  {
    const glm::dvec3 place = glm::dvec3(0.0, 0.0, -Depth) + l * sight;
    const double weight = std::exp((Absorption + 0.02 * Scattering) * place.z - (Absorption + Scattering) * l);
    sum += weight * light.At(place);
    level += weight;
  }
  return 1.0 + sunPart * (sum / level - 1.0);
}

/// Part of the sun in the light that water scatters into a line of sight: p(d) E of the sun against the sky's.
double SunPart(Water& picture, const glm::dvec3& sun, const glm::dvec3& sight)
{
  const double above = picture.Sun()[2];
  const double cosine = sun.z;
  const double across = (above - 1.333 * cosine) / (above + 1.333 * cosine);
  const double along = (1.333 * above - cosine) / (1.333 * above + cosine);
  const double through = 1.0 - 0.5 * (across * across + along * along);
  const double direct = 0.19 / (4.0 * vtkMath::Pi() * std::pow(1.81 - 1.8 * glm::dot(sun, sight), 1.5)) *
    picture.SunLight()[1] * through * above / cosine;
  const double sky = (0.5 + 0.48 * sight.z) / (2.0 * vtkMath::Pi()) * 0.934 * picture.SkyLight()[1];
  return direct / (direct + sky);
}

}

//----------------------------------------------------------------------------
int TestLandscapeShafts(int, char*[])
{
  Deep water;
  const std::vector<double> level = water.Greens(false);
  const std::vector<double> found = water.Greens(true);
  const Color above = water.Sun();
  glm::dvec3 sun(above[0] / 1.333, above[1] / 1.333, 0.0);
  sun.z = std::sqrt(1.0 - glm::dot(sun, sun));
  const Gathered light(sun);
  // What eyes see of them: means of squares of 2 x 2 pixels
  std::vector<double> expected(Width * Height / 4);
  std::vector<double> here(expected.size());
  for (int pixel = 0; pixel < Width * Height; ++pixel)
  {
    const std::size_t square = pixel / Width / 2 * (Width / 2) + pixel % Width / 2;
    const glm::dvec3 sight = water.Sight(pixel);
    expected[square] += (Expected(light, sight, SunPart(water, sun, sight)) - 1.0) / 4.0;
    here[square] += (found[pixel] / level[pixel] - 1.0) / 4.0;
  }
  const double both = std::inner_product(expected.begin(), expected.end(), here.begin(), 0.0);
  const double expectedSquares = std::inner_product(expected.begin(), expected.end(), expected.begin(), 0.0);
  const double foundSquares = std::inner_product(here.begin(), here.end(), here.begin(), 0.0);
  const double slope = both / expectedSquares;
  const double correlation = both / std::sqrt(expectedSquares * foundSquares);
  const double contrast = std::sqrt(expectedSquares / static_cast<double>(expected.size()));
  std::cout << "Contrast " << contrast << ", found " << slope << " of it, correlation " << correlation << ", brightest "
            << *std::max_element(found.begin(), found.end()) << "\n";
  return Check(contrast > 0.015 && std::abs(slope - 1.0) < 0.1, "Shafts are too faint or too bright.") &&
      Check(correlation > 0.95, "Shafts are elsewhere.")
    ? 0
    : 1;
}
