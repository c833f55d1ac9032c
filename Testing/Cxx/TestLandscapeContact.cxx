// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Shade where things meet (vtkLandscapePass, ContactRadius) against the light that a hemisphere of rays finds.
#include "LandscapePicture.h"

#include "vtkSphereSource.h"

#include <cmath>
#include <string>

namespace
{

constexpr double Radius = 0.5;
constexpr double WallHeight = 3.0;

/// A floor at z = 0 before a wall at y = 0, in even light.
struct Corner : Picture
{
  Corner(double floor, double wall)
  {
    this->Pass->SetSkyToEven();
    this->Pass->SetOcclusionRadius(0.0);
    this->Pass->SetContactRadius(Radius);
    this->Pass->SetExposureCompensation(-0.5);
    this->Add(Plane({ -20.0, -20.0, 0.0 }, { 20.0, -20.0, 0.0 }, { -20.0, 0.0, 0.0 }), floor);
    this->Add(Plane({ -20.0, 0.0, 0.0 }, { 20.0, 0.0, 0.0 }, { -20.0, 0.0, WallHeight }), wall);
  }

  /// Light at a place over that of an open one.
  double LightAt(double x, double y, double z, double albedo)
  {
    this->Renderer->SetWorldPoint(x, y, z, 1.0);
    this->Renderer->WorldToDisplay();
    const double* at = this->Renderer->GetDisplayPoint();
    const double lit = this->LinearAt(static_cast<int>(at[0]), static_cast<int>(at[1]))[1];
    return lit / (albedo * std::exp2(-0.5));
  }
};

/// Part of the light on a floor that is not lost to a wall at a distance, by rays over the hemisphere, each of which
/// loses 1 - (s / r)2 to what it meets at a distance s below the radius r.
double OpenBeside(double distance)
{
  constexpr int count = 400;
  double lost = 0.0;
  for (int ring = 0; ring < count; ++ring)
  {
    for (int turn = 0; turn < count; ++turn)
    {
      // Rays of equal weight: sin2 of the angle from the normal is even
      const double across = std::sqrt((ring + 0.5) / count);
      const double toWall = across * std::cos((turn + 0.5) * 2.0 * vtkMath::Pi() / count);
      const double s = toWall > 0.0 ? distance / toWall : 1e9;
      const double height = s * std::sqrt(1.0 - across * across);
      lost += s < Radius && height < WallHeight ? 1.0 - s * s / (Radius * Radius) : 0.0;
    }
  }
  return 1.0 - lost / (count * count);
}

/// What is left where things reflect an albedo of the light that they hide.
double WithReflections(double open, double albedo)
{
  return open / (1.0 - albedo * (1.0 - open));
}

/// Floor beside a wall, from several sides, in both projections and qualities.
bool TestWall()
{
  bool good = true;
  constexpr double albedo = 0.4;
  for (const bool isBest : { false, true })
  {
    for (const bool isParallel : { false, true })
    {
      for (const Color& from : { Color{ 0.0, -6.0, 3.0 }, Color{ 4.0, -3.0, 3.0 }, Color{ -3.0, -4.0, 4.0 } })
      {
        Corner picture(albedo, albedo);
        picture.Look(from, { 0.0, -0.3, 0.0 }, { 0.0, 0.0, 1.0 });
        picture.Pass->SetQuality(isBest ? vtkLandscapePass::Best : vtkLandscapePass::Good);
        vtkCamera* camera = picture.Renderer->GetActiveCamera();
        camera->SetViewAngle(24.0);
        camera->SetParallelProjection(isParallel);
        camera->SetParallelScale(1.2);
        picture.Renderer->ResetCameraClippingRange();
        picture.Draw();
        for (const double distance : { 0.06, 0.12, 0.2, 0.3, 0.42, 0.8 })
        {
          double mean = 0.0;
          for (int k = 0; k < 9; ++k)
          {
            mean += picture.LightAt(0.04 * (k - 4), -distance, 0.0, albedo) / 9.0;
          }
          const double expected = WithReflections(OpenBeside(distance), albedo);
          // Few taps miss some of what is seen at an angle.
          const double bound = distance > Radius ? 0.005 : isBest ? 0.03 : 0.045;
          good &= Check(mean - expected < bound && mean - expected > -0.02,
            "Light at " + std::to_string(distance) + " m from a wall is " + std::to_string(mean) + " for " +
              std::to_string(expected) + " from x = " + std::to_string(from[0]));
        }
      }
    }
  }
  return good;
}

/// An open plane, near and far and at all angles, has the same bytes as without.
bool TestOpenPlane()
{
  Picture picture;
  picture.Pass->SetSkyToEven();
  picture.Pass->SetOcclusionRadius(0.0);
  picture.Add(Level(500.0), 0.3);
  picture.Look({ 0.0, 0.0, 1.5 }, { 1.0, 4.0, 1.2 }, { 0.0, 0.0, 1.0 });
  picture.Pass->SetContactRadius(0.0);
  picture.Draw();
  vtkNew<vtkUnsignedCharArray> without;
  without->DeepCopy(picture.Pixels);
  picture.Pass->SetContactRadius(Radius);
  picture.Draw();
  int others = 0;
  for (vtkIdType k = 0; k < without->GetNumberOfValues(); ++k)
  {
    others += without->GetValue(k) != picture.Pixels->GetValue(k);
  }
  return Check(others == 0, "An open plane has " + std::to_string(others) + " other bytes");
}

/// In even light, white things that hide the sky from each other stay white.
bool TestFurnace()
{
  Corner picture(1.0, 1.0);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.0, -0.4, 0.3);
  ball->SetRadius(0.3);
  ball->SetThetaResolution(60);
  ball->SetPhiResolution(60);
  ball->Update();
  picture.Add(ball->GetOutput(), 1.0);
  picture.Look({ 1.0, -3.0, 2.0 }, { 0.0, -0.3, 0.0 }, { 0.0, 0.0, 1.0 });
  picture.Draw();
  double least = 1.0;
  for (int k = 0; k < Width * Height; ++k)
  {
    least = std::min(least, picture.LinearAt(k % Width, k / Width)[1] / std::exp2(-0.5));
  }
  return Check(least > 0.99, "White in even light is " + std::to_string(least));
}

/// What hides is counted once: where a map of the zenith knows the wall too, half of the light is left at its foot.
bool TestOnce()
{
  constexpr double albedo = 0.02;
  double left[2];
  for (const bool isNear : { false, true })
  {
    Corner picture(albedo, albedo);
    picture.Add(Box({ 0.0, 5.0, 0.5 * WallHeight }, { 40.0, 10.0, WallHeight }), albedo);
    picture.Pass->SetOcclusionRadius(2.0);
    picture.Pass->SetContactRadius(isNear ? Radius : 0.0);
    picture.Look({ 0.0, -4.0, 3.0 }, { 0.0, -0.3, 0.0 }, { 0.0, 0.0, 1.0 });
    picture.Draw();
    left[isNear] = picture.LightAt(0.3, -0.08, 0.0, albedo);
  }
  return Check(std::abs(left[1] - 0.5) < 0.02 && left[1] < left[0],
    "Light at the foot of a wall is " + std::to_string(left[1]) + " with its shade near by, without " +
      std::to_string(left[0]));
}

}

int TestLandscapeContact(int, char*[])
{
  bool good = TestWall();
  good &= TestOpenPlane();
  good &= TestFurnace();
  good &= TestOnce();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
