// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Shadows of vtkLandscapePass in the quality Best: as soft as the sun's disk is wide.
#include "LandscapePicture.h"

#include <cmath>
#include <string>
#include <vector>

namespace
{

/// The sun's light on a level ground across the shadow's edge of a level board, seen from above.
struct Board : Picture
{
  double Metres; ///< of a pixel

  Board(double height, double elevation, double acrossView)
    : Metres(acrossView / Height)
  {
    this->Pass->SetQualityToBest();
    this->Pass->SetSunElevation(elevation);
    this->Pass->SetSunAzimuth(180.0);
    this->Pass->SetOcclusionRadius(0.0);
    this->Pass->SetContactRadius(0.0);
    this->Pass->SetVisibility(1e9);
    this->Pass->SetShadowDistance(10.0);
    this->Pass->SetMapSize(2048);
    this->Pass->SetExposureCompensation(-1.0);
    // The sun is in the south: the edge's shadow is at y = 0.
    const double edge = -height / std::tan(vtkMath::RadiansFromDegrees(elevation));
    this->Add(Level(12.0), 0.8);
    this->Add(Plane({ -12.0, edge - 20.0, height }, { 12.0, edge - 20.0, height }, { -12.0, edge, height }), 0.5);
    this->Look({ 0.0, 0.0, 1.2 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->Renderer->GetActiveCamera()->SetParallelScale(0.5 * acrossView);
    this->Renderer->ResetCameraClippingRange();
    this->Draw();
  }

  /// Sun's light of the rows, from that in the shadow's middle to that outside, each a mean over columns.
  std::vector<double> Rows() const
  {
    std::vector<double> rows(Height, 0.0);
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 40; x < Width - 40; ++x)
      {
        rows[y] += this->LinearAt(x, y)[1] / (Width - 80);
      }
    }
    return rows;
  }
};

/// Row at which light passes a part of that of the last row, from the first, with parts of rows.
double Passes(const std::vector<double>& rows, double part)
{
  const double level = rows.front() + part * (rows.back() - rows.front());
  for (int y = 1; y < Height; ++y)
  {
    if (rows[y] >= level)
    {
      return y - (rows[y] - level) / std::max(rows[y] - rows[y - 1], 1e-12);
    }
  }
  return Height;
}

/// Width of the edge of a disk's light from 10 % to 90 %, over its radius: the part of a disk beyond a chord at t is
/// 1/2 + (t sqrt(1 - t2) + asin t) / pi.
double WidthOfDisk()
{
  double low = 0.0;
  double high = 1.0;
  while (high - low > 1e-9)
  {
    const double t = 0.5 * (low + high);
    const double part = 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / vtkMath::Pi();
    (part < 0.9 ? low : high) = t;
  }
  return 2.0 * low;
}

/// Green light of a white level ground, with a part of the sun.
double GroundUnder(Picture& picture, double part)
{
  Color sun;
  Color sunLight;
  Color skyLight;
  picture.Pass->GetSunDirection(sun.data());
  picture.Pass->GetSunLight(sunLight.data());
  picture.Pass->GetSkyLight(0.0, 0.0, 1.0, skyLight.data());
  return picture.Pass->GetExposureFactor() * (skyLight[1] + part * sun[2] * sunLight[1]) / vtkMath::Pi();
}

bool TestWidths()
{
  bool good = true;
  for (const double elevation : { 30.0, 60.0 })
  {
    for (const double height : { 2.0, 8.0, 20.0 })
    {
      // Across the light at the distance h / sin(e), on the ground longer by 1 / sin(e)
      const double sine = std::sin(vtkMath::RadiansFromDegrees(elevation));
      const double radius = std::tan(vtkMath::RadiansFromDegrees(0.2666)) * height / sine;
      const double expected = WidthOfDisk() * radius / sine;
      Board board(height, elevation, 4.0 * expected);
      const std::vector<double> rows = board.Rows();
      const double width = board.Metres * (Passes(rows, 0.9) - Passes(rows, 0.1));
      const double middle = board.Metres * (Passes(rows, 0.5) - 0.5 * Height);
      const double texel = 2.0 * 1.25 * 1.0 / 2048.0 / sine;
      good &= Check(std::abs(rows.front() / GroundUnder(board, 0.0) - 0.8) < 0.01 &&
          std::abs(rows.back() / GroundUnder(board, 1.0) - 0.8) < 0.01,
        "Light beside a penumbra is " + std::to_string(rows.front()) + " and " + std::to_string(rows.back()));
      good &= Check(std::abs(width - expected) < std::max(0.15 * expected, texel),
        "Penumbra below " + std::to_string(height) + " m is " + std::to_string(width) + " m wide for " +
          std::to_string(expected));
      good &= Check(std::abs(middle) < std::max(0.1 * expected, 2.0 * texel),
        "Penumbra's middle is off by " + std::to_string(middle) + " m");
    }
  }
  return good;
}

/// Slopes in the open do not shade themselves, also with large texels.
bool TestOpenSlopes()
{
  bool good = true;
  for (const double slope : { -1.0, -0.3, 0.0, 0.3, 1.0 })
  {
    Picture soft;
    soft.Pass->SetSunElevation(50.0);
    soft.Pass->SetSunAzimuth(180.0);
    soft.Pass->SetOcclusionRadius(0.0);
    soft.Pass->SetContactRadius(0.0);
    soft.Pass->SetMapSize(512);
    soft.Add(
      Plane({ -30.0, -30.0, -30.0 * slope }, { 30.0, -30.0, -30.0 * slope }, { -30.0, 30.0, 30.0 * slope }), 0.5);
    soft.Look({ 5.0, -20.0, 30.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
    soft.Pass->SetQualityToBest();
    soft.Draw();
    vtkNew<vtkUnsignedCharArray> pixels;
    pixels->DeepCopy(soft.Pixels);
    soft.Pass->ShadowsOff();
    soft.Draw();
    int darkest = 0;
    for (vtkIdType k = 0; k < pixels->GetNumberOfValues(); ++k)
    {
      darkest = std::max(darkest, soft.Pixels->GetValue(k) - pixels->GetValue(k));
    }
    good &= Check(darkest <= 1, "A slope of " + std::to_string(slope) + " shades itself by " + std::to_string(darkest));
  }
  return good;
}

}

int TestLandscapePenumbra(int, char*[])
{
  return TestWidths() && TestOpenSlopes() ? EXIT_SUCCESS : EXIT_FAILURE;
}
