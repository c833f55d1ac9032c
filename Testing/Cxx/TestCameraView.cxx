// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The view that is taken from a camera shows what the camera shows, with vertical and with horizontal view angles.
#include "CameraPicture.h"
#include "Check.h"
#include "Geometry/ViewFrustum.h"
#include "Pipeline/CameraView.h"
#include "vtkTerrainLevelOfDetailFilter.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

namespace
{

constexpr std::array<int, 2> Windows[] = { { 900, 200 }, { 200, 900 } };
constexpr double About[3] = { 3.0, -5.0, 2.0 };
constexpr double Distance = 40.0;

/// Left, right, bottom and top planes, as the camera has them: they point inwards.
bool HasPlanesOf(vtkCamera* camera, const littoral::View& view)
{
  double planes[24];
  camera->GetFrustumPlanes(view.AspectRatio, planes);
  const littoral::ViewFrustum frustum(view);
  bool good = true;
  for (int side = 0; side < 4; ++side)
  {
    const double* theirs = planes + 4 * side;
    const double length = vtkMath::Norm(theirs);
    const littoral::ViewFrustum::Plane& ours = frustum.GetPlanes()[static_cast<std::size_t>(side)];
    for (int axis = 0; axis < 3; ++axis)
    {
      good &= std::abs(theirs[axis] / length - ours.Normal[axis]) < 1e-6;
    }
    good &= std::abs(theirs[3] / length - ours.Offset) < 1e-6 * Distance;
  }
  return good;
}

/// Whether a place is between the sides of a view and before its eye; those on its edge are of no interest.
enum class Seen
{
  No,
  Yes,
  Edge
};

Seen IsSeen(const littoral::View& view, const littoral::Vector3& place)
{
  const littoral::ViewFrustum frustum(view);
  double nearest = Distance;
  for (const littoral::ViewFrustum::Plane& plane : frustum.GetPlanes())
  {
    nearest = std::min(nearest, glm::dot(plane.Normal, place) + plane.Offset);
  }
  return std::abs(nearest) < 1e-6 * Distance ? Seen::Edge : nearest > 0.0 ? Seen::Yes : Seen::No;
}

/// Cameras anywhere: their planes, and places on their pictures by their matrices.
bool Views(bool isHorizontal)
{
  std::mt19937 random(isHorizontal ? 5 : 6);
  std::uniform_real_distribution<double> uniform(-Distance, Distance);
  bool planes = true;
  int count[2] = { 0, 0 }; // unseen, seen
  int wrong = 0;
  int otherwise = 0; // places that the same angle along the other side would misjudge
  for (int round = 0; round < 100; ++round)
  {
    vtkNew<vtkCamera> camera;
    LookFromAnywhere(camera, random, About, Distance);
    camera->SetUseHorizontalViewAngle(isHorizontal);
    camera->SetClippingRange(1e-3, 1e3);
    const std::array<int, 2>& size = Windows[round % 2];
    const littoral::View view = littoral::ViewOfCamera(camera, size[0], size[1], littoral::View());
    planes &= HasPlanesOf(camera, view);
    littoral::View other = view;
    other.Angle = vtkMath::RadiansFromDegrees(camera->GetViewAngle());
    const CameraPicture picture(camera, size[0], size[1]);
    for (int n = 0; n < 100; ++n)
    {
      const littoral::Vector3 place(About[0] + uniform(random), About[1] + uniform(random), About[2] + uniform(random));
      const Seen seen = IsSeen(view, place);
      const bool isShown = picture.Shows(&place.x);
      if (seen != Seen::Edge)
      {
        ++count[isShown];
        wrong += (seen == Seen::Yes) != isShown;
        otherwise += (IsSeen(other, place) == Seen::Yes) != isShown;
      }
    }
  }
  const std::string angle = isHorizontal ? "horizontal" : "vertical";
  bool good = Check(planes, "planes are not those of the camera, " + angle + " angle");
  good &= Check(wrong == 0, std::to_string(wrong) + " places are misjudged, " + angle + " angle");
  good &= Check(count[0] > 1000 && count[1] > 1000, "too few places are seen or unseen, " + angle + " angle");
  good &=
    Check((otherwise > 300) == isHorizontal, std::to_string(otherwise) + " places depend on the side of the angle");
  return good;
}

/// A filter that follows a renderer has the vertical angle of its picture.
bool Follows(const std::array<int, 2>& size)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetSize(size[0], size[1]);
  window->AddRenderer(renderer);
  vtkNew<vtkTerrainLevelOfDetailFilter> filter;
  filter->Follow(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetViewAngle(50.0);
  camera->UseHorizontalViewAngleOn();
  renderer->InvokeEvent(vtkCommand::StartEvent);
  const double aspect = static_cast<double>(size[0]) / size[1];
  const double half = std::tan(vtkMath::RadiansFromDegrees(25.0)) / aspect;
  bool good = std::abs(filter->GetViewAngle() - 2.0 * vtkMath::DegreesFromRadians(std::atan(half))) < 1e-9;
  good &= filter->GetAspectRatio() == aspect && filter->GetViewHeight() == size[1];
  const vtkMTimeType before = filter->GetMTime();
  renderer->InvokeEvent(vtkCommand::StartEvent);
  good &= filter->GetMTime() == before;
  camera->UseHorizontalViewAngleOff();
  renderer->InvokeEvent(vtkCommand::StartEvent);
  good &= std::abs(filter->GetViewAngle() - 50.0) < 1e-9 && filter->GetMTime() > before;
  return Check(good, "a filter does not follow a window of " + std::to_string(size[0]) + " columns");
}

}

int TestCameraView(int, char*[])
{
  bool good = Views(true);
  good &= Views(false);
  good &= Follows(Windows[0]);
  good &= Follows(Windows[1]);
  return good ? 0 : 1;
}
