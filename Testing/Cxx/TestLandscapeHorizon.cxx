// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The haze before what is straight below has no side. Beside what is shown the earth below the horizon is lost in haze, within the size of what is shown: it is a meadow
// around a ground, and the sky's earth around other things.
#include "LandscapePicture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

constexpr double Half = 50.0; // of the square that is shown [m]
constexpr double Eye = 20.0;  // height of the eye above it [m]

/// A level square, seen from afar: the middle of the picture is below the horizon by an angle [degrees], beside it.
struct Afar : Picture
{
  double Down;

  Afar(bool isGround, double down)
    : Down(down)
  {
    this->Pass->SetVisibility(1e9);
    this->Pass->SetSunAzimuth(20.0);
    this->Pass->SetExposureCompensation(-1.0);
    vtkActor* square = this->Add(Level(Half), 0.5);
    if (isGround)
    {
      vtkLandscapePass::SetMaterial(square, vtkLandscapePass::Ground);
    }
    const double angle = vtkMath::RadiansFromDegrees(down);
    const double y = -300.0;
    this->Look({ 0.0, y, Eye }, { 0.0, y + std::cos(angle), Eye - std::sin(angle) }, { 0.0, 0.0, 1.0 });
    this->Draw();
  }

  /// What the middle of the picture shows of an earth's luminance through the haze before it.
  Color Expected(const Color& earth)
  {
    const double sine = std::sin(vtkMath::RadiansFromDegrees(this->Down));
    const double radius = std::max(250.0, std::sqrt(2.0) * Half);
    const double through = std::exp(-Eye / sine / (4.0 * radius));
    Color horizon;
    this->Pass->GetSkyLuminance(0.0, 1.0, 1e-3, horizon.data());
    Color expected;
    for (int c = 0; c < 3; ++c)
    {
      expected[c] = this->Pass->GetExposureFactor() * (horizon[c] + through * (earth[c] - horizon[c]));
    }
    return expected;
  }

  Color Meadow()
  {
    Color sun, light, sky, cover;
    this->Pass->GetSunDirection(sun.data());
    this->Pass->GetSunLight(light.data());
    this->Pass->GetSkyLight(0.0, 0.0, 1.0, sky.data());
    this->Pass->GetCoverColor(cover.data());
    Color luminance;
    for (int c = 0; c < 3; ++c)
    {
      luminance[c] = LinearOf(cover[c]) / vtkMath::Pi() * (sky[c] + sun[2] * light[c]);
    }
    return luminance;
  }

  Color SkysEarth()
  {
    const double angle = vtkMath::RadiansFromDegrees(this->Down);
    Color luminance;
    this->Pass->GetSkyLuminance(0.0, std::cos(angle), -std::sin(angle), luminance.data());
    return luminance;
  }
};

/// Largest over least luminance of what is straight below a low sun's haze, a few pixels around the middle.
double ContrastBelow()
{
  Picture picture;
  picture.Pass->SetVisibility(200.0);
  picture.Pass->SetSunElevation(10.0);
  picture.Pass->SetExposureCompensation(-1.0);
  picture.Add(Level(500.0), 0.2);
  picture.Look({ 0.0, 0.0, 150.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
  picture.Draw();
  double least = 1e9;
  double largest = 0.0;
  for (int n = 0; n < 16; ++n)
  {
    const double around = 2.0 * vtkMath::Pi() * n / 16.0;
    const int x = Width / 2 + static_cast<int>(std::lround(4.0 * std::cos(around)));
    const int y = Height / 2 + static_cast<int>(std::lround(4.0 * std::sin(around)));
    const double green = picture.LinearAt(x, y)[1];
    least = std::min(least, green);
    largest = std::max(largest, green);
  }
  return largest / least;
}

}

int TestLandscapeHorizon(int, char*[])
{
  bool good = Check(ContrastBelow() < 1.05, "Haze has a side straight below");
  for (const double down : { 3.0, 12.0, 60.0 })
  {
    const std::string where = ", " + std::to_string(down) + " degrees below the horizon";
    Afar ground(true, down);
    good &= Near(ground.LinearAt(Width / 2, Height / 2), ground.Expected(ground.Meadow()), 0.03, 0.006,
      "A meadow around a ground" + where);
    Afar other(false, down);
    good &= Near(other.LinearAt(Width / 2, Height / 2), other.Expected(other.SkysEarth()), 0.03, 0.006,
      "Earth around a surface" + where);
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
