// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Pixels of what water wets by vtkLandscapePass, shores and surfaces below a film, against closed forms.
#include "LandscapePicture.h"

#include <numeric>
#include <vector>

namespace
{

constexpr double Index = 1.333;

/// Part of light that is reflected by its cosine in air  (Fresnel)
double ReflectedPart(double cosine)
{
  const double below = std::sqrt(1.0 - (1.0 - cosine * cosine) / (Index * Index));
  const double across = (cosine - Index * below) / (cosine + Index * below);
  const double along = (below - Index * cosine) / (below + Index * cosine);
  return 0.5 * (across * across + along * along);
}

/// Albedo of ground below a film of water from which 6.6 % of diffuse light is kept out  (Angstrom 1925)
double Soaked(double albedo)
{
  const double leaves = (1.0 - 0.066) / (Index * Index);
  return leaves * albedo / (1.0 - (1.0 - leaves) * albedo);
}

/// Level ground or another surface below a sky, seen to the north at an angle from the zenith, too far for its relief.
struct Plain : Water
{
  double Cosine;
  Color Dry; ///< exposed luminances of the middle, dry and wet
  Color Wet;

  Plain(bool isGround, double grey, int sky, double angle, double wetness, double exposure)
    : Water({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 })
    , Cosine(std::cos(vtkMath::RadiansFromDegrees(angle)))
  {
    this->Renderer->RemoveAllViewProps();
    vtkActor* plain = this->Add(Level(4000.0), grey);
    vtkLandscapePass::SetMaterial(plain, isGround ? vtkLandscapePass::Ground : vtkLandscapePass::Surface);
    this->Pass->SetSky(sky);
    this->Pass->SetSunElevation(30.0);
    this->Pass->SetCoverRadius(0.0);
    this->Pass->ShadowsOff();
    this->Pass->SetExposureCompensation(exposure);
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->Renderer->GetActiveCamera()->SetParallelScale(400.0);
    const double sine = std::sqrt(1.0 - this->Cosine * this->Cosine);
    this->Look({ 0.0, -9e3 * sine, 9e3 * this->Cosine }, { 0.0, 0.0, 0.0 }, { 0.0, this->Cosine, sine });
    this->Draw();
    this->Dry = this->LinearAt(Width / 2, Height / 2);
    this->Pass->SetWetness(wetness);
    this->Draw();
    this->Wet = this->LinearAt(Width / 2, Height / 2);
  }

  /// Luminance of the sky that the surface mirrors to the eye [kcd/m2].
  Color MirroredSky()
  {
    Color luminance;
    this->Pass->GetSkyLuminance(0.0, std::sqrt(1.0 - this->Cosine * this->Cosine), this->Cosine, luminance.data());
    return luminance;
  }
};

/// Dark wet ground mirrors the sky by Fresnel's part of it.
bool TestMirroredSky()
{
  bool good = true;
  for (const int sky : { vtkLandscapePass::Even, vtkLandscapePass::Clear })
  {
    for (const double angle : { 60.0, 80.0 })
    {
      Plain plain(
        true, 0.01, sky, angle, 1.0, (angle < 70.0 ? 2.0 : 0.0) + (sky == vtkLandscapePass::Clear ? 2.5 : 0.0));
      const double exposure = plain.Pass->GetExposureFactor();
      const double back = ReflectedPart(plain.Cosine);
      const Color sun = plain.SunLight();
      Color found;
      Color expected;
      for (int c = 0; c < 3; ++c)
      {
        const double onGround = sky == vtkLandscapePass::Even ? 0.0 : 0.5 * sun[c]; // of a sun of 30 degrees
        const double albedo = vtkMath::Pi() * plain.Dry[c] / exposure / (plain.SkyLight()[c] + onGround);
        const double enters = (1.0 - ReflectedPart(0.5)) / (1.0 - 0.066);
        const double below = (1.0 - back) * Soaked(albedo) * (plain.SkyLight()[c] + enters * onGround) / vtkMath::Pi();
        found[c] = plain.Wet[c] / exposure - below;
        expected[c] = back * plain.MirroredSky()[c];
      }
      good &= Near(found, expected, 0.02, 0.0, "Sky mirrored at " + std::to_string(angle) + " degrees");
    }
  }
  return good;
}

/// What is half wet is between dry and wet.
bool TestHalfWet()
{
  const Plain plain(true, 0.1, vtkLandscapePass::Even, 60.0, 0.5, 1.0);
  const double back = ReflectedPart(0.5);
  Color expected;
  for (int c = 0; c < 3; ++c)
  {
    const double albedo = 0.5 * plain.Dry[c];
    expected[c] = (1.0 - 0.5 * back) * (albedo + Soaked(albedo)) + back;
  }
  return Near(plain.Wet, expected, 0.0, 0.004, "Ground that is half wet");
}

/// A white surface in a white furnace stays white when it is wet.
bool TestFurnace()
{
  bool good = true;
  for (const double angle : { 0.0, 60.0, 80.0 })
  {
    const Plain plain(false, 1.0, vtkLandscapePass::Even, angle, 1.0, -0.3);
    good &= Near(plain.Wet, plain.Dry, 0.01, 0.0, "A furnace at " + std::to_string(angle) + " degrees");
  }
  return good;
}

/// The sun that a film mirrors to the eye: F E / (4 pi v cos), for slopes of the variance v.
bool TestMirroredSun()
{
  Plain plain(false, 0.0, vtkLandscapePass::Clear, 60.0, 1.0, -5.0);
  plain.Pass->SetSunAzimuth(0.0);
  plain.Draw();
  const double back = ReflectedPart(0.5);
  Color expected;
  for (int c = 0; c < 3; ++c)
  {
    const double sun = plain.SunLight()[c] / (4.0 * vtkMath::Pi() * 0.01 * plain.Cosine);
    expected[c] = plain.Pass->GetExposureFactor() * back * (plain.MirroredSky()[c] + sun);
  }
  return Near(plain.LinearAt(Width / 2, Height / 2), expected, 0.03, 0.0, "The sun in a film");
}

/// A beach that falls by 1/50 to the south into black water, from above, at 0.5 m a pixel.
struct Beach : Water
{
  static constexpr double RunUp = 0.14;

  Beach(double runUp, double time)
    : Water({ 100.0, 100.0, 100.0 }, { 0.0, 0.0, 0.0 })
  {
    this->Pass->SetSkyToEven();
    this->Pass->SetCoverRadius(0.0);
    this->Pass->SetShoreRunUp(runUp);
    this->Pass->SetWaterTime(time);
    vtkActor* ground = this->Add(Plane({ -80.0, -80.0, -1.6 }, { 80.0, -80.0, -1.6 }, { -80.0, 80.0, 1.6 }), 0.3);
    vtkLandscapePass::SetMaterial(ground, vtkLandscapePass::Ground);
    this->Look({ 0.0, 0.0, 50.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->Renderer->GetActiveCamera()->SetParallelScale(0.25 * Height);
    this->Renderer->ResetCameraClippingRange();
    this->Draw();
  }

  /// Height of a row of pixels over the water, in runs of the waves.
  static double HeightOf(int row) { return 0.01 * (row + 0.5 - 0.5 * Height) / RunUp; }
};

/// Pixels of a shore over a period of its waves.
struct Swash
{
  std::vector<double> Mean = std::vector<double>(Width * Height, 0.0);
  std::vector<double> Least = std::vector<double>(Width * Height, 1.0);

  Swash()
  {
    constexpr int times = 8;
    for (int time = 0; time < times; ++time)
    {
      const Beach picture(Beach::RunUp, 5.0 * time / times);
      for (int pixel = 0; pixel < Width * Height; ++pixel)
      {
        const double found = picture.LinearAt(pixel % Width, pixel / Width)[1];
        this->Mean[pixel] += found / times;
        this->Least[pixel] = std::min(this->Least[pixel], found);
      }
    }
  }
};

double MeanOfRow(const std::vector<double>& pixels, int row)
{
  return std::accumulate(pixels.begin() + row * Width, pixels.begin() + (row + 1) * Width, 0.0) / Width;
}

/// Foam of the albedo 0.6 covers 0.8 (1 - exp(-3)) / 3 of shallow water on the mean over a period, and none of deep
/// water.
bool TestFoamOfShore(const Swash& swash)
{
  bool good = true;
  for (int row = 0; row < Height; ++row)
  {
    const double depth = -Beach::HeightOf(row);
    if (depth < 0.32 || depth > 1.4)
    {
      continue;
    }
    const double t = std::clamp((depth - 0.4) / 0.6, 0.0, 1.0);
    const double expected = 0.8 * (1.0 - std::exp(-3.0)) / 3.0 * (1.0 - t * t * (3.0 - 2.0 * t));
    const double found = (MeanOfRow(swash.Mean, row) - 0.0204) / (0.6 - 0.0204);
    good &= Check(std::abs(found - expected) < 0.02,
      "Foam at the depth " + std::to_string(depth) + ": " + std::to_string(found) + " for " + std::to_string(expected));
  }
  return good;
}

/// Ground that waves reach is wet, also where no foam is; what they do not reach is as without them.
bool TestWetShore(const Swash& swash)
{
  const Beach dry(0.0, 0.0);
  bool good = true;
  for (int row = 0; row < Height; ++row)
  {
    const double height = Beach::HeightOf(row);
    double expected = 0.0;
    double change = 0.0;
    for (int x = 0; x < Width; ++x)
    {
      const double albedo = dry.LinearAt(x, row)[1];
      expected += (0.0204 + 0.9796 * Soaked(albedo)) / Width;
      change = std::max(change, std::abs(swash.Mean[row * Width + x] - albedo));
    }
    const double found = MeanOfRow(swash.Least, row);
    good &= Check(std::abs(height - 0.6) > 0.1 || (found > expected - 0.003 && found < expected + 0.02),
      "Wet ground is " + std::to_string(found) + " for " + std::to_string(expected));
    good &= Check(std::abs(height) < 1.41 || change < 1e-9, "Changed at the height " + std::to_string(height));
  }
  return good;
}

}

//----------------------------------------------------------------------------
int TestLandscapeWetness(int, char*[])
{
  bool good = TestMirroredSky();
  good &= TestHalfWet();
  good &= TestFurnace();
  good &= TestMirroredSun();
  const Swash swash;
  good &= TestFoamOfShore(swash);
  good &= TestWetShore(swash);
  return good ? 0 : 1;
}
