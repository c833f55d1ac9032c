// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Pixels of vtkLandscapePass against closed forms: light of planes, shadows, air, leaves, and where it must not matter
// how a scene is placed.
#include "LandscapePicture.h"

#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTestErrorObserver.h"
#include "vtkTexture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

/// A white plane of any direction has the light of the sun and of the sky by its normal.
bool TestLightOfPlanes()
{
  bool good = true;
  for (const Color& angles : { Color{ 60.0, 120.0, 2.0 }, Color{ 15.0, 300.0, 5.0 } })
  {
    for (const Color& n :
      { Color{ 0.0, 0.0, 1.0 }, Color{ 0.6, 0.0, 0.8 }, Color{ 0.0, -1.0, 0.0 }, Color{ -0.8, 0.6, 0.0 } })
    {
      Picture picture;
      picture.Pass->SetSunElevation(angles[0]);
      picture.Pass->SetSunAzimuth(angles[1]);
      picture.Pass->SetTurbidity(angles[2]);
      picture.Pass->SetVisibility(1e9);
      picture.Pass->SetExposureCompensation(-2.5);
      Color a;
      Color b;
      vtkMath::Perpendiculars(n.data(), a.data(), b.data(), 0.3);
      picture.Add(Plane({ 0.0, 0.0, 0.0 }, a, b), 1.0);
      const Color middle{ 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) };
      picture.Look({ middle[0] + 2.0 * n[0], middle[1] + 2.0 * n[1], middle[2] + 2.0 * n[2] }, middle, a);
      picture.Draw();
      Color sun;
      Color sunLight;
      Color skyLight;
      picture.Pass->GetSunDirection(sun.data());
      picture.Pass->GetSunLight(sunLight.data());
      picture.Pass->GetSkyLight(n[0], n[1], n[2], skyLight.data());
      Color expected;
      for (int c = 0; c < 3; ++c)
      {
        const double light = skyLight[c] + std::max(0.0, vtkMath::Dot(sun.data(), n.data())) * sunLight[c];
        expected[c] = picture.Pass->GetExposureFactor() * light / vtkMath::Pi();
      }
      good &= Near(picture.LinearAt(Width / 2, Height / 2), expected, 0.015, 0.002, "Light of a white plane");
    }
  }
  return good;
}

/// In a light that is equal from everywhere each surface is as bright as its albedo, however it is turned.
bool TestFurnace()
{
  Picture picture;
  picture.Pass->SetSkyToEven();
  picture.Pass->SetOcclusionRadius(0.0);
  picture.Pass->SetExposureCompensation(-0.5);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(40);
  sphere->Update();
  picture.Add(sphere->GetOutput(), 0.8);
  picture.Look({ 1.0, -2.0, 0.7 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  picture.Draw();
  bool good = true;
  int counted = 0;
  const double sky = std::exp2(-0.5);
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const bool isSphere = picture.LinearAt(x, y)[0] < 0.9 * sky;
      counted += isSphere;
      good &= std::abs(picture.LinearAt(x, y)[1] / sky - (isSphere ? 0.8 : 1.0)) < 0.01;
    }
  }
  return Check(good && counted > 4000, "Even light is not even on " + std::to_string(counted) + " pixels of a sphere.");
}

/// A pole's shadow ends at h / tan(elevation), away from the sun.
bool TestShadowOfPole()
{
  bool good = true;
  constexpr double height = 10.0;
  for (const Color& hour : { Color{ 50.0, 180.0, 0.0 }, Color{ 35.0, 97.0, 0.0 }, Color{ 25.0, 250.0, 0.0 } })
  {
    Picture picture;
    picture.Pass->SetSunElevation(hour[0]);
    picture.Pass->SetSunAzimuth(hour[1]);
    picture.Pass->SetOcclusionRadius(0.0);
    picture.Pass->SetMapSize(4096);
    picture.Add(Level(40.0), 0.5);
    picture.Add(Box({ 0.0, 0.0, 0.5 * height }, { 0.4, 0.4, height }), 0.5);
    picture.Look({ 0.0, 0.0, 100.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
    vtkCamera* camera = picture.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(24.0);
    picture.Renderer->ResetCameraClippingRange();
    picture.Draw();
    // Along the shadow from the pole, the last dark pixel
    const double metres = 48.0 / Height;
    const double azimuth = vtkMath::RadiansFromDegrees(hour[1]);
    const Color away{ -std::sin(azimuth), -std::cos(azimuth), 0.0 };
    const double bright = picture.LinearAt(5, 5)[1];
    double end = 0.0;
    for (double s = 1.0; s < 24.0; s += 0.25 * metres)
    {
      const int x = static_cast<int>(std::floor(0.5 * Width + s * away[0] / metres));
      const int y = static_cast<int>(std::floor(0.5 * Height + s * away[1] / metres));
      if (x >= 0 && x < Width && y >= 0 && y < Height && picture.LinearAt(x, y)[1] < 0.6 * bright)
      {
        end = s;
      }
    }
    const double expected = height / std::tan(vtkMath::RadiansFromDegrees(hour[0]));
    // The near edge of the top's shadow
    good &= Check(std::abs(end - expected) <= metres + 0.2,
      "Shadow of a pole ends at " + std::to_string(end) + " m for " + std::to_string(expected) + " m.");
  }
  return good;
}

/// Boards at distances: L exp(-k d) + L_h (1 - exp(-k d)), k = ln 50 / visibility.
bool TestAir()
{
  bool good = true;
  for (const double distance : { 500.0, 2000.0, 8000.0 })
  {
    for (const double albedo : { 0.0, 1.0 })
    {
      Picture picture;
      picture.Pass->SetVisibility(10000.0);
      picture.Pass->ShadowsOff();
      picture.Pass->SetOcclusionRadius(0.0);
      picture.Pass->SetExposureCompensation(-1.0);
      const double side = 0.6 * distance;
      picture.Add(Plane({ -side, distance, -side }, { side, distance, -side }, { -side, distance, side }), albedo);
      picture.Look({ 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 });
      picture.Renderer->GetActiveCamera()->SetViewAngle(50.0);
      picture.Draw();
      Color sun;
      Color sunLight;
      Color skyLight;
      picture.Pass->GetSunDirection(sun.data());
      picture.Pass->GetSunLight(sunLight.data());
      picture.Pass->GetSkyLight(0.0, -1.0, 0.0, skyLight.data());
      for (const int column : { Width / 2, 30 })
      {
        // Line of sight of a pixel in the middle row
        const double x = (column + 0.5 - 0.5 * Width) / (0.5 * Height) * std::tan(vtkMath::RadiansFromDegrees(25.0));
        const double through = std::pow(50.0, -distance * std::hypot(1.0, x) / 10000.0);
        Color horizon;
        picture.Pass->GetSkyLuminance(x, 1.0, 1e-3 * std::hypot(1.0, x), horizon.data());
        Color expected;
        for (int c = 0; c < 3; ++c)
        {
          const double own = albedo / vtkMath::Pi() * (skyLight[c] + std::max(0.0, -sun[1]) * sunLight[c]);
          expected[c] = CodeOf(picture.Pass->GetExposureFactor() * (own * through + horizon[c] * (1.0 - through)));
        }
        good &= Near(picture.At(column, Height / 2), expected, 0.0, 1.01 / 255.0,
          "Board behind " + std::to_string(distance) + " m of air");
      }
    }
  }
  return good;
}

/// Length of dense fog along a line of sight [m]: its density, 1 up to the level 0 and exp(-z / 8 m) above, by
/// Simpson's rule.
double LengthOfFog(double z, double rise, double way)
{
  constexpr int parts = 20000;
  double sum = 0.0;
  for (int k = 0; k <= parts; ++k)
  {
    const double density = std::exp(-std::max(z + rise * k / parts, 0.0) / 8.0);
    sum += (k == 0 || k == parts ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) * density;
  }
  return sum * way / (3.0 * parts);
}

/// A black board in fog, from an eye in it, at its level and above, and the sky behind it: L_h (1 - T) + L T,
/// T = exp(-k length of fog). In parallel projection each line of sight begins at its own height.
bool TestFog(bool isParallel)
{
  bool good = true;
  constexpr double level = 300.0;
  for (const double eye : { -12.0, 0.0, 30.0 })
  {
    Picture picture;
    picture.Pass->SetVisibility(1e9);
    picture.Pass->SetFogLevel(level);
    picture.Pass->SetFogScaleHeight(8.0);
    picture.Pass->SetCloudCover(0.0);
    picture.Pass->ShadowsOff();
    picture.Pass->SetOcclusionRadius(0.0);
    picture.Pass->SetExposureCompensation(-1.0);
    const double z = level + eye;
    picture.Add(Plane({ -300.0, 200.0, z - 300.0 }, { 300.0, 200.0, z - 300.0 }, { -300.0, 200.0, z + 20.0 }), 0.0);
    picture.Look({ 0.0, 0.0, z }, { 0.0, 1.0, z }, { 0.0, 0.0, 1.0 });
    vtkCamera* camera = picture.Renderer->GetActiveCamera();
    camera->SetViewAngle(50.0);
    camera->SetParallelProjection(isParallel);
    camera->SetParallelScale(40.0);
    picture.Draw();
    const std::array<Color, 2> clear{ picture.LinearAt(Width / 2, Height - 5),
      picture.LinearAt(Width / 2, Height - 40) };
    picture.Pass->SetFogVisibility(400.0);
    picture.Draw();
    Color horizon;
    picture.Pass->GetSkyLuminance(0.0, 1.0, 1e-3, horizon.data());
    const auto through = [](double length) { return std::pow(50.0, -length / 400.0); };
    const auto check = [&](int row, double left, const Color& behind, const char* what) {
      Color expected;
      for (int c = 0; c < 3; ++c)
      {
        expected[c] = CodeOf(behind[c] * left + picture.Pass->GetExposureFactor() * horizon[c] * (1.0 - left));
      }
      return Near(picture.At(Width / 2, row), expected, 0.0, 1.01 / 255.0, std::string(what) + std::to_string(eye));
    };
    for (const int row : { 4, Height / 4, Height / 2 + 3 })
    {
      const double up = (row + 0.5 - 0.5 * Height) / (0.5 * Height);
      const double slope = up * std::tan(vtkMath::RadiansFromDegrees(25.0));
      const double length = isParallel ? LengthOfFog(eye + 40.0 * up, 0.0, 200.0)
                                       : LengthOfFog(eye, 200.0 * slope, 200.0 * std::hypot(1.0, slope));
      good &= check(row, through(length), { 0.0, 0.0, 0.0 }, "Board in fog, from an eye at ");
    }
    if (isParallel)
    {
      continue;
    }
    for (const int k : { 0, 1 })
    {
      const int row = k == 0 ? Height - 5 : Height - 40;
      const double slope = (row + 0.5 - 0.5 * Height) / (0.5 * Height) * std::tan(vtkMath::RadiansFromDegrees(25.0));
      const double rise = 400.0; // 50 scale heights above the level
      const double length = LengthOfFog(eye, rise, rise / slope * std::hypot(1.0, slope));
      good &= check(row, through(length), clear[static_cast<std::size_t>(k)], "Sky behind fog, from an eye at ");
    }
  }
  return good;
}

/// A card that its texture cuts out on one side casts the shadow of the other.
bool TestCutOut()
{
  Picture picture;
  picture.Pass->SetSunElevation(90.0);
  picture.Pass->SetOcclusionRadius(0.0);
  picture.Add(Level(6.0), 0.5);
  vtkActor* card = picture.Add(Level(1.0, 2.0), 1.0);
  vtkNew<vtkImageData> texels;
  texels->SetDimensions(2, 1, 1);
  texels->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int part = 0; part < 8; ++part)
  {
    static_cast<unsigned char*>(texels->GetScalarPointer())[part] = part < 4 ? 64 : 255; // a quarter, then all
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(texels);
  texture->InterpolateOff();
  card->SetTexture(texture);
  card->ForceOpaqueOn();
  picture.Look({ 0.0, -9.0, 1.0 }, { 0.0, 0.0, 0.4 }, { 0.0, 0.0, 1.0 });
  picture.Draw();
  // Below the middles of both halves of the card
  const auto shade = [&](double x) {
    picture.Renderer->SetWorldPoint(x, 0.0, 0.0, 1.0);
    picture.Renderer->WorldToDisplay();
    const double* at = picture.Renderer->GetDisplayPoint();
    return picture.LinearAt(static_cast<int>(at[0]), static_cast<int>(at[1]))[1];
  };
  return Check(shade(0.5) < 0.4 * shade(3.0) && shade(-0.5) > 0.9 * shade(3.0),
    "Shadows of a cut card: " + std::to_string(shade(-0.5)) + " " + std::to_string(shade(0.5)) + " in " +
      std::to_string(shade(3.0)));
}

/// A leaf with the sun behind it has the light of its far side by its transmittance.
bool TestLeaf()
{
  bool good = true;
  Color lit[2];
  Color sun;
  Color sunLight;
  Color near;
  Color far;
  double factor = 0.0;
  for (const double transmittance : { 0.0, 0.35 })
  {
    Picture picture;
    picture.Pass->SetSunElevation(30.0);
    picture.Pass->SetSunAzimuth(0.0);
    picture.Pass->SetOcclusionRadius(0.0);
    picture.Pass->SetVisibility(1e9);
    picture.Pass->SetExposureCompensation(-0.5);
    vtkActor* leaf = picture.Add(Plane({ -1.0, 0.0, -1.0 }, { 1.0, 0.0, -1.0 }, { -1.0, 0.0, 1.0 }), 0.5);
    vtkLandscapePass::SetTransmittance(leaf, transmittance);
    picture.Look({ 0.0, -3.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
    picture.Draw();
    lit[transmittance > 0.0] = picture.LinearAt(Width / 2, Height / 2);
    factor = picture.Pass->GetExposureFactor();
    picture.Pass->GetSunDirection(sun.data());
    picture.Pass->GetSunLight(sunLight.data());
    picture.Pass->GetSkyLight(0.0, -1.0, 0.0, near.data());
    picture.Pass->GetSkyLight(0.0, 1.0, 0.0, far.data());
  }
  for (int c = 0; c < 3; ++c)
  {
    const double own = factor * 0.5 / vtkMath::Pi() * near[c];
    const double through = factor * 0.5 / vtkMath::Pi() * 0.35 * (far[c] + sun[1] * sunLight[c]);
    good &= Check(std::abs(lit[0][c] - own) < 0.02 * own + 0.002, "A leaf without transmittance is lit from behind.");
    good &= Check(std::abs(lit[1][c] - lit[0][c] - through) < 0.02 * through + 0.003, "Light through a leaf is wrong.");
  }
  return good;
}

/// Where a roof hides all of the sky within the occlusion's radius there is no light of it; beside the roof there is
/// all.
bool TestRoof()
{
  Picture picture;
  picture.Pass->SetSkyToEven();
  picture.Pass->SetOcclusionRadius(4.0);
  picture.Add(Level(40.0), 0.5);
  picture.Add(Box({ -20.0, 0.0, 1.0 }, { 40.0, 80.0, 0.1 }), 0.5);
  picture.Look({ 0.0, -30.0, 0.5 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  picture.Renderer->GetActiveCamera()->SetViewAngle(60.0);
  picture.Draw();
  const Color hidden = picture.LinearAt(Width / 8, Height / 2 - 6);
  const Color open = picture.LinearAt(7 * Width / 8, Height / 2 - 6);
  return Check(hidden[1] < 0.01, "Light under a roof is " + std::to_string(hidden[1])) &&
    Near(open, { 0.5, 0.5, 0.5 }, 0.02, 0.0, "Light beside a roof");
}

/// A surface with a color map has the renderer's lights, as without the pass, beside maps of shadows; lit if asked for.
bool TestColorMap()
{
  Picture picture;
  vtkActor* board = picture.Add(Level(20.0), 0.5);
  vtkPolyData* data = vtkPolyData::SafeDownCast(board->GetMapper()->GetInputDataObject(0, 0));
  vtkNew<vtkFloatArray> heights;
  heights->SetNumberOfTuples(data->GetNumberOfPoints());
  heights->Fill(0.3);
  data->GetPointData()->SetScalars(heights);
  board->GetMapper()->SetColorModeToMapScalars();
  board->GetMapper()->ScalarVisibilityOn();
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(0.8, 0.3, 1.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  picture.Renderer->AddLight(light);
  picture.Add(Box({ 4.0, 0.0, 6.0 }, { 2.0, 2.0, 2.0 }), 0.5);
  picture.Look({ 0.0, -20.0, 20.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  std::array<Color, 3> colors;
  for (std::size_t k = 0; k < colors.size(); ++k)
  {
    picture.Renderer->SetPass(k == 0 ? nullptr : picture.Pass.Get());
    picture.Pass->SetLightsColorMaps(k == 2);
    picture.Draw();
    colors[k] = picture.At(Width / 4, Height / 2);
  }
  return Near(colors[1], colors[0], 0.0, 0.01 / 255.0, "Surface with a color map") &&
    Check(std::abs(colors[2][0] - colors[0][0]) > 0.1, "A color map that is to be lit is not.");
}

/// In haste as without it, and in a fast picture, shadows are those of what is there.
bool TestHaste()
{
  Picture picture;
  picture.Pass->SetSunElevation(45.0);
  picture.Pass->SetSunAzimuth(90.0);
  picture.Pass->SetOcclusionRadius(0.0);
  picture.Add(Level(20.0), 0.5);
  vtkActor* box = picture.Add(Box({ 4.0, 0.0, 6.0 }, { 2.0, 2.0, 2.0 }), 0.5);
  picture.Look({ 0.0, 0.0, 30.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
  picture.Draw();
  // The shadow falls 6 m to the west.
  const auto shadowAt = [&](double y) {
    const int row = Height / 2 + static_cast<int>(y / 30.0 / std::tan(vtkMath::RadiansFromDegrees(15.0)) * Height / 2);
    const int column =
      Width / 2 - static_cast<int>(2.0 / 30.0 / std::tan(vtkMath::RadiansFromDegrees(15.0)) * Height / 2);
    return picture.LinearAt(column, row)[1] < 0.5 * picture.LinearAt(5, 5)[1];
  };
  bool good = Check(shadowAt(0.0) && !shadowAt(5.0), "A box has no shadow.");
  box->SetPosition(0.0, 5.0, 0.0);
  picture.Pass->DraftOn();
  picture.Draw();
  good &= Check(!shadowAt(0.0) && shadowAt(5.0), "In haste, a shadow stays.");
  picture.Pass->DraftOff();
  picture.Draw();
  good &= Check(!shadowAt(0.0) && shadowAt(5.0), "After haste, a shadow stays.");
  picture.Add(Box({ -40.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }), 0.5); // the last that changed
  picture.Draw();
  box->VisibilityOff();
  picture.Draw();
  good &= Check(!shadowAt(5.0), "What is hidden casts a shadow.");
  box->VisibilityOn();
  picture.Draw();
  picture.Pass->SetQualityToFast();
  box->SetPosition(0.0, 0.0, 0.0);
  picture.Draw();
  return good & Check(shadowAt(0.0) && !shadowAt(5.0), "A fast picture has an old shadow.");
}

/// Red, green and blue of a window by rows [1/255].
std::vector<unsigned char> PixelsOf(Picture& picture, int width, int height)
{
  picture.Window->SetSize(width, height);
  picture.Window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  picture.Window->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels);
  return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
}

/// A wood of boxes on a ground much wider than the distance of sharp shadows.
void AddWideWood(Picture& picture)
{
  picture.Pass->SetShadowDistance(20.0);
  picture.Pass->SetMapSize(128);
  picture.Pass->SetSunElevation(30.0);
  picture.Add(Level(100.0), 0.5);
  for (int k = 0; k < 25; ++k)
  {
    picture.Add(Box({ -20.0 + 10.0 * (k % 5), -20.0 + 10.0 * (k / 5), 2.0 }, { 1.0, 1.0, 4.0 }), 0.3);
  }
}

/// Pictures of a drag are functions of where the camera is, not of where it was, and leave no trace behind it.
bool TestDrag()
{
  Picture dragged;
  AddWideWood(dragged);
  const auto lookFrom = [](Picture& picture, double x) {
    picture.Look({ x, -30.0, 12.0 }, { x, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
    picture.Window->Render();
    return PixelsOf(picture, Width, Height);
  };
  const std::vector<unsigned char> before = lookFrom(dragged, 0.0);
  dragged.Pass->DraftOn();
  for (double x : { 1.0, 9.0, 40.0, 12.0 })
  {
    lookFrom(dragged, x);
  }
  const std::vector<unsigned char> last = lookFrom(dragged, 15.0);
  Picture fresh;
  AddWideWood(fresh);
  fresh.Pass->DraftOn();
  bool good = Check(lookFrom(fresh, 15.0) == last, "A picture in haste is another one after a drag.");
  dragged.Pass->DraftOff();
  good &= Check(lookFrom(dragged, 0.0) == before, "A picture is another one after a drag.");
  fresh.Pass->ShadowsOff();
  return good & Check(lookFrom(fresh, 15.0) != last, "A picture in haste has no shadow.");
}

/// Whether a picture is one that is less wide, enlarged by a linear filter between the middles of its pixels.
bool IsEnlarged(
  const std::vector<unsigned char>& large, const std::vector<unsigned char>& small, int narrow, int width, int height)
{
  const double ratio = static_cast<double>(width) / narrow;
  const int low = static_cast<int>(std::lround(height / ratio));
  double largest = 0.0;
  for (int pixel = 0; pixel < width * height; ++pixel)
  {
    const double x = (pixel % width + 0.5) / ratio - 0.5;
    const double y = (pixel / width + 0.5) / ratio - 0.5;
    double mean = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double column = std::floor(x) + corner % 2;
      const double row = std::floor(y) + corner / 2;
      const double weight = (1.0 - std::abs(x - column)) * (1.0 - std::abs(y - row));
      const int at = static_cast<int>(std::clamp(row, 0.0, low - 1.0)) * narrow +
        static_cast<int>(std::clamp(column, 0.0, narrow - 1.0));
      mean += weight * small[4 * at];
    }
    largest = std::max(largest, std::abs(mean - large[4 * pixel]));
  }
  return largest <= 2.0;
}

/// A picture in haste is one of half the size, and a fast one of two thirds of it, enlarged by a linear filter.
bool TestPixelsInHaste()
{
  Picture picture;
  picture.Add(Box({ 0.0, 0.0, -1.0 }, { 40.0, 40.0, 2.0 }), 0.5);
  picture.Add(Box({ 0.0, 0.0, 2.0 }, { 2.0, 2.0, 4.0 }), 0.8);
  picture.Look({ 0.0, -20.0, 8.0 }, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 });
  picture.Pass->DraftOn();
  const std::vector<unsigned char> large = PixelsOf(picture, Width, Height);
  picture.Pass->SetDraftPixelSize(1);
  const std::vector<unsigned char> sharp = PixelsOf(picture, Width, Height);
  const std::vector<unsigned char> small = PixelsOf(picture, Width / 2, Height / 2);
  bool good = Check(IsEnlarged(large, small, Width / 2, Width, Height), "A picture in haste is not enlarged.");
  good &= Check(sharp != large, "A picture in haste with pixels of 1 is no other.");
  // The sides are multiples of 3.
  const std::vector<unsigned char> part = PixelsOf(picture, 160, 100);
  picture.Pass->DraftOff();
  picture.Pass->SetQualityToFast();
  return good & Check(IsEnlarged(PixelsOf(picture, 240, 150), part, 160, 240, 150), "A fast picture is not enlarged.");
}

/// Largest and mean difference of two pictures [1/255].
std::array<double, 2> Differences(const Picture& a, const Picture& b)
{
  double largest = 0.0;
  double sum = 0.0;
  for (vtkIdType k = 0; k < a.Pixels->GetNumberOfValues(); ++k)
  {
    const double off = std::abs(double(a.Pixels->GetValue(k)) - double(b.Pixels->GetValue(k)));
    largest = std::max(largest, off);
    sum += off;
  }
  return { largest, sum / static_cast<double>(a.Pixels->GetNumberOfValues()) };
}

/// Some boxes and balls on a plane, all at an offset, in an order, the boxes as glyphs or as actors.
void AddTown(Picture& picture, const Color& off, bool isBackwards, bool hasGlyphs)
{
  std::vector<Color> places;
  for (int k = 0; k < 9; ++k)
  {
    places.push_back({ off[0] + 9.0 * (k % 3) - 9.0, off[1] + 8.0 * (k / 3) - 8.0, off[2] + 2.0 });
  }
  std::vector<std::function<void()>> steps;
  steps.emplace_back([&picture, off] {
    picture.Add(Plane({ off[0] - 60.0, off[1] - 60.0, off[2] }, { off[0] + 60.0, off[1] - 60.0, off[2] },
                  { off[0] - 60.0, off[1] + 60.0, off[2] }),
      0.4);
  });
  if (hasGlyphs)
  {
    steps.emplace_back([&picture, places] {
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      for (const Color& place : places)
      {
        points->InsertNextPoint(place.data());
      }
      vtkNew<vtkPolyData> data;
      data->SetPoints(points);
      vtkNew<vtkGlyph3DMapper> mapper;
      mapper->SetInputData(data);
      mapper->SetSourceData(Box({ 0.0, 0.0, 0.0 }, { 3.0, 2.0, 4.0 }));
      mapper->ScalingOff();
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->GetProperty()->SetColor(CodeOf(0.7), CodeOf(0.7), CodeOf(0.7));
      picture.Renderer->AddActor(actor);
    });
  }
  for (const Color& place : places)
  {
    if (!hasGlyphs)
    {
      steps.emplace_back([&picture, place] { picture.Add(Box(place, { 3.0, 2.0, 4.0 }), 0.7); });
    }
  }
  if (isBackwards)
  {
    std::reverse(steps.begin(), steps.end());
  }
  for (const auto& step : steps)
  {
    step();
  }
  picture.Look({ off[0] - 12.0, off[1] - 30.0, off[2] + 14.0 }, off, { 0.0, 0.0, 1.0 });
  picture.Draw();
}

/// The same scene: in another order of props, as instances, in the coordinates of a zone of UTM.
bool TestPlacement()
{
  const Color origin{ 0.0, 0.0, 0.0 };
  Picture first;
  AddTown(first, origin, false, false);
  Picture backwards;
  AddTown(backwards, origin, true, false);
  Picture glyphs;
  AddTown(glyphs, origin, false, true);
  Picture far;
  AddTown(far, { 500000.0, 6000000.0, 100.0 }, false, false);
  Picture smooth;
  smooth.Pass->SetQualityToBest();
  AddTown(smooth, origin, false, false);
  const auto samples = Differences(first, smooth);
  const auto order = Differences(first, backwards);
  const auto instances = Differences(first, glyphs);
  const auto utm = Differences(first, far);
  // Four samples a pixel change what is on edges.
  bool good = Check(samples[0] > 30.0 && samples[1] < 2.0, "Four samples differ by " + std::to_string(samples[1]));
  good &= Check(order[0] <= 1.0, "The order of props makes a difference of " + std::to_string(order[0]));
  good &= Check(instances[0] <= 1.0, "Instances make a difference of " + std::to_string(instances[0]));
  // Points of these coordinates have single precision in VTK's buffers unless they are shifted.
  good &= Check(utm[1] < 0.3, "Coordinates of UTM make a mean difference of " + std::to_string(utm[1]));
  return good;
}

/// What is drawn where something is wrong or there is nothing.
bool TestBadInput()
{
  bool good = true;
  Picture picture;
  picture.Draw(); // nothing at all
  good &= Check(picture.At(Width / 2, Height - 2)[2] > 0.1, "There is no sky.");
  vtkNew<vtkPolyData> empty;
  picture.Add(empty, 0.5);
  auto broken = vtkSmartPointer<vtkPolyData>::New();
  broken->DeepCopy(Level(3.0));
  broken->GetPoints()->SetPoint(0, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  picture.Add(broken, 0.5);
  picture.Add(Level(1.0, 0.5), 0.5);
  picture.Look({ 0.0, -5.0, 3.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  picture.Draw();
  const double lit = picture.LinearAt(Width / 2, Height / 2)[1];
  good &= Check(lit > 0.05 && lit < 1.0, "A surface beside a broken one is lit by " + std::to_string(lit));
  // Night is dark, not black.
  picture.Pass->SetSunElevation(-40.0);
  picture.Draw();
  const double night = picture.At(Width / 2, Height / 2)[1];
  good &= Check(night > 1.0 / 255.0 && night < 0.3, "Night is " + std::to_string(night));
  // Parameters out of range: one sentence, and a picture as without the pass.
  vtkNew<vtkTest::ErrorObserver> errors;
  picture.Pass->AddObserver(vtkCommand::ErrorEvent, errors);
  picture.Pass->SetTurbidity(0.5);
  picture.Draw();
  good &= Check(errors->GetError() &&
      errors->GetErrorMessage().find("Turbidity is 0.5; it must be from 1 to 10.") != std::string::npos,
    "A turbidity of 0.5 is told as: " + errors->GetErrorMessage());
  // Once, also while one drags
  errors->Clear();
  picture.Pass->SetDraft(true);
  picture.Draw();
  good &= Check(!errors->GetError(), "A mistake is told with each picture.");
  return good;
}

}

int TestLandscapePass(int, char*[])
{
  bool good = TestLightOfPlanes();
  good &= TestFurnace();
  good &= TestShadowOfPole();
  good &= TestAir();
  good &= TestFog(false);
  good &= TestFog(true);
  good &= TestCutOut();
  good &= TestLeaf();
  good &= TestRoof();
  good &= TestHaste();
  good &= TestDrag();
  good &= TestPixelsInHaste();
  good &= TestColorMap();
  good &= TestPlacement();
  good &= TestBadInput();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
