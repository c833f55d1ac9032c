// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Blur of what is not in focus (vtkLandscapePass, Aperture) against the geometry of a lens.
#include "LandscapePicture.h"

#include <cmath>
#include <string>

namespace
{

constexpr double Angle = 30.0;

/// A look to the north along the level axis, in even light.
struct Camera : Picture
{
  Camera()
  {
    this->Pass->SetSkyToEven();
    this->Pass->SetOcclusionRadius(0.0);
    this->Pass->SetContactRadius(0.0);
    this->Look({ 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 });
    this->Renderer->GetActiveCamera()->SetViewAngle(Angle);
  }

  /// An upright board across the axis at a distance, around a place, with sides of some pixels.
  vtkActor* AddBoard(double distance, double column, double row, double width, double height, double grey)
  {
    const double metres = distance / Focal();
    const double x = metres * (column - 0.5 * Width);
    const double z = metres * (row - 0.5 * Height);
    const double a = 0.5 * metres * width;
    const double b = 0.5 * metres * height;
    return this->Add(Plane({ x - a, distance, z - b }, { x + a, distance, z - b }, { x - a, distance, z + b }), grey);
  }

  /// Distance in pixels at which the picture has its angle of view.
  static double Focal() { return 0.5 * Height / std::tan(vtkMath::RadiansFromDegrees(0.5 * Angle)); }

  void DrawAll()
  {
    this->Renderer->ResetCameraClippingRange();
    this->Draw();
  }
};

/// A point at a distance s becomes a disk of the diameter A |s - f| / s on the plane in focus, at f; of a uniform disk
/// of the diameter c the variance along an axis is c2 / 16.
bool TestDiameters()
{
  bool good = true;
  constexpr double focus = 10.0;
  constexpr double side = 3.0;
  for (const double aperture : { 0.15, 0.25 })
  {
    for (const double distance : { 5.0, 40.0 })
    {
      for (const bool isBest : { false, true })
      {
        Camera camera;
        camera.Pass->SetQuality(isBest ? vtkLandscapePass::Best : vtkLandscapePass::Good);
        camera.Pass->SetAperture(aperture);
        camera.Pass->SetFocusDistance(focus);
        const double exposure = aperture > 0.2 ? 1.5 : 0.0; // brighter than white before the blur, not after
        camera.Pass->SetExposureCompensation(exposure);
        camera.AddBoard(1.001 * distance, 120.0, 80.0, 400.0, 400.0, 0.0);
        camera.AddBoard(distance, 120.0, 80.0, side, side, 0.9);
        camera.DrawAll();
        double sum = 0.0;
        double variance = 0.0;
        for (int y = 60; y < 100; ++y)
        {
          for (int x = 100; x < 140; ++x)
          {
            const double light = camera.LinearAt(x, y)[1];
            sum += light;
            variance += light * (x + 0.5 - 120.0) * (x + 0.5 - 120.0);
          }
        }
        variance = variance / sum - side * side / 12.0;
        const double diameter = 4.0 * std::sqrt(std::max(variance, 0.0));
        const double expected = aperture * std::abs(distance - focus) / distance * Camera::Focal() / focus;
        const double flux = sum / (0.9 * std::exp2(exposure) * side * side);
        good &= Check(std::abs(diameter - expected) < 0.05 * expected + 0.4,
          "A point at " + std::to_string(distance) + " m is " + std::to_string(diameter) + " pixels wide for " +
            std::to_string(expected));
        good &= Check(std::abs(flux - 1.0) < 0.1, "Blur has " + std::to_string(flux) + " of its light");
      }
    }
  }
  return good;
}

/// Largest difference of bytes.
int Apart(const Camera& a, vtkUnsignedCharArray* b)
{
  int apart = 0;
  for (vtkIdType k = 0; k < b->GetNumberOfValues(); ++k)
  {
    apart = std::max(apart, std::abs(a.Pixels->GetValue(k) - b->GetValue(k)));
  }
  return apart;
}

/// Bytes with a lens: in focus, with paint and a film's curve, those without within 1; where there is none, the same.
bool TestUnchanged()
{
  bool good = true;
  for (const bool isBest : { false, true })
  {
    Camera camera;
    camera.Pass->FilmCurveOn();
    camera.Pass->SetQuality(isBest ? vtkLandscapePass::Best : vtkLandscapePass::Good);
    camera.AddBoard(10.0, 120.0, 80.0, 400.0, 400.0, 0.2);
    camera.AddBoard(9.999, 90.0, 70.0, 21.3, 30.7, 0.7);
    camera.AddBoard(9.999, 150.0, 80.0, 30.3, 30.7, 0.5)->GetProperty()->LightingOff();
    camera.DrawAll();
    vtkNew<vtkUnsignedCharArray> sharp;
    sharp->DeepCopy(camera.Pixels);
    camera.Pass->SetAperture(0.2);
    camera.DrawAll();
    const int inFocus = Apart(camera, sharp);
    good &= Check(inFocus <= 1, "In focus bytes are others by " + std::to_string(inFocus));
    camera.Pass->SetFocusDistance(5.0);
    camera.DrawAll();
    good &= Check(Apart(camera, sharp) > 20, "There is no blur");
    camera.Pass->SetAperture(0.0);
    camera.DrawAll();
    good &= Check(Apart(camera, sharp) == 0, "Without a lens there are other bytes");
    camera.Pass->SetAperture(0.2);
    camera.Renderer->GetActiveCamera()->ParallelProjectionOn();
    camera.DrawAll();
    sharp->DeepCopy(camera.Pixels);
    camera.Pass->SetAperture(0.0);
    camera.DrawAll();
    good &= Check(Apart(camera, sharp) == 0, "In parallel projection a lens makes other bytes");
  }
  return good;
}

/// A bright board on the left side before a dark one: in focus, its edge stays where it is, and no light of it is on
/// what is blurred behind; blurred before a sharp one, it covers the half at its edge, and nothing beyond its circle.
bool TestEdges()
{
  bool good = true;
  for (const bool isBefore : { false, true })
  {
    Camera camera;
    camera.Pass->SetExposureCompensation(0.0);
    camera.Pass->SetAperture(0.2);
    camera.Pass->SetFocusDistance(isBefore ? 40.0 : 8.0);
    camera.AddBoard(40.0, 120.0, 80.0, 400.0, 400.0, 0.02);
    camera.AddBoard(8.0, 0.0, 80.0, 240.0, 400.0, 0.9);
    camera.DrawAll();
    const double diameter = 0.2 * 32.0 / 8.0 / 40.0 * Camera::Focal();
    const auto at = [&](double column) {
      double mean = 0.0;
      for (int y = 70; y < 90; ++y)
      {
        mean += camera.LinearAt(static_cast<int>(column), y)[1] / 20.0;
      }
      return mean;
    };
    const double out = isBefore ? 0.5 * diameter + 2.0 : 1.0;
    const double half = 0.5 * (at(119.5) + at(120.5));
    good &= Check(std::abs(at(119.5 - out) - 0.9) < 0.02 && std::abs(at(120.5 + out) - 0.02) < 0.01,
      "Beside an edge there are " + std::to_string(at(119.5 - out)) + " and " + std::to_string(at(120.5 + out)));
    good &= Check(std::abs(half - 0.46) < 0.06, "At an edge there is " + std::to_string(half));
  }
  return good;
}

}

int TestLandscapeLens(int, char*[])
{
  bool good = TestDiameters();
  good &= TestUnchanged();
  good &= TestEdges();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
