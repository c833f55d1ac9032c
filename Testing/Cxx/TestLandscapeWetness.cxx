// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Pixels of what water wets by vtkLandscapePass, shores and surfaces below a film, against closed forms.
#include "LandscapePicture.h"

#include <numeric>
#include <vector>

namespace
{

constexpr double Index = 1.333;

/// Albedo of ground below a film of water from which 6.6 % of diffuse light is kept out  (Angstrom 1925)
double Soaked(double albedo)
{
  const double leaves = (1.0 - 0.066) / (Index * Index);
  return leaves * albedo / (1.0 - (1.0 - leaves) * albedo);
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
  const Swash swash;
  bool good = TestFoamOfShore(swash);
  good &= TestWetShore(swash);
  return good ? 0 : 1;
}
