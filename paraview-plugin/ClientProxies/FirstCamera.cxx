// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstCamera.h"

#include "Daylight.h"

#include "Numerics/Constants.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkPVRenderView.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"

#include <algorithm>
#include <cmath>

namespace littoral
{
namespace
{

/// Azimuth of the eye, from east to north [rad]: from the south-west, so that x goes to the right and y away.
constexpr double EyeAzimuth = -0.62 * Pi;

/// Priority of an observer before those that take the camera.
constexpr float BeforeOthers = 10.0f;

/// Whether a camera, from above, shows just the cube of edge 2 around the origin, which is ParaView's for an empty
/// view.
bool ShowsEmptyView(vtkCamera* camera, double aspectRatio)
{
  constexpr double Radius = 1.7320508075688772; // of the sphere around the cube
  const double* eye = camera->GetPosition();
  const double* focus = camera->GetFocalPoint();
  const double halfAngle = std::atan(std::min(1.0, aspectRatio) * std::tan(0.5 * camera->GetViewAngle() * Pi / 180.0));
  return eye[0] == 0.0 && eye[1] == 0.0 && focus[0] == 0.0 && focus[1] == 0.0 && focus[2] == 0.0 &&
    std::abs(eye[2] * std::sin(halfAngle) - Radius) < 1e-6;
}

/// Position and focal point of a camera.
std::array<double, 6> LineOfSight(vtkCamera* camera)
{
  std::array<double, 6> line{};
  camera->GetPosition(line.data());
  camera->GetFocalPoint(line.data() + 3);
  return line;
}

/// Whether a camera looks along x, y or z, as ParaView looks at flat data.
bool LooksAlongAxis(vtkCamera* camera)
{
  const double* d = camera->GetDirectionOfProjection();
  return std::max({ std::abs(d[0]), std::abs(d[1]), std::abs(d[2]) }) > 0.999;
}

}

//----------------------------------------------------------------------------
bool ShowsData(vtkSMProxy* representation)
{
  return representation && representation->GetProperty("Input") && !IsLandscapeLight(representation) &&
    vtkSMPropertyHelper(representation, "Visibility", true).GetAsInt() != 0;
}

//----------------------------------------------------------------------------
bool IsEmpty(vtkSMProxy* view)
{
  const vtkSMPropertyHelper shown(view, "Representations");
  for (unsigned int k = 0; k < shown.GetNumberOfElements(); ++k)
  {
    if (ShowsData(shown.GetAsProxy(k)))
    {
      return false;
    }
  }
  return true;
}

//----------------------------------------------------------------------------
bool IsFlat(vtkSMProxy* view)
{
  return vtkSMPropertyHelper(view, "InteractionMode").GetAsInt() == vtkPVRenderView::INTERACTION_MODE_2D;
}

//----------------------------------------------------------------------------
bool HasFirstCamera(vtkSMRenderViewProxy* view)
{
  vtkCamera* camera = view->GetActiveCamera();
  int size[2] = { 1, 1 };
  vtkSMPropertyHelper(view, "ViewSize").Get(size, 2);
  if (ShowsEmptyView(camera, static_cast<double>(size[0]) / std::max(1, size[1])))
  {
    return true;
  }
  double position[3];
  double focus[3];
  vtkSMPropertyHelper(view, "CameraPosition").Get(position, 3);
  vtkSMPropertyHelper(view, "CameraFocalPoint").Get(focus, 3);
  return view->GetProperty("CameraPosition")->IsValueDefault() &&
    view->GetProperty("CameraFocalPoint")->IsValueDefault() &&
    std::equal(position, position + 3, camera->GetPosition()) && std::equal(focus, focus + 3, camera->GetFocalPoint());
}

//----------------------------------------------------------------------------
void MoveCamera(vtkCamera* camera, const CameraPlace& place)
{
  camera->SetViewUp(0.0, 0.0, 1.0);
  if (place.IsFixed)
  {
    camera->SetPosition(place.Eye);
    camera->SetFocalPoint(place.Target);
    camera->SetViewAngle(place.Angle > 0.0 ? place.Angle : camera->GetViewAngle());
    return;
  }
  const double elevation = place.Elevation * Pi / 180.0;
  if (place.Elevation >= 90.0)
  {
    camera->SetViewUp(0.0, 1.0, 0.0);
  }
  // What the camera shows of a sphere around the data does not depend on where it looks from.
  const double distance = camera->GetDistance() / std::max(0.1, place.Closer);
  double focus[3];
  camera->GetFocalPoint(focus);
  camera->SetPosition(focus[0] + distance * std::cos(elevation) * std::cos(EyeAzimuth),
    focus[1] + distance * std::cos(elevation) * std::sin(EyeAzimuth), focus[2] + distance * std::sin(elevation));
}

//----------------------------------------------------------------------------
void MoveCamera(vtkCamera* camera, const CameraPlace& place, const double bounds[6])
{
  double squares = 0.0;
  double middle[3];
  for (int c = 0; c < 3; ++c)
  {
    middle[c] = 0.5 * (bounds[2 * c] + bounds[2 * c + 1]);
    squares += (bounds[2 * c + 1] - bounds[2 * c]) * (bounds[2 * c + 1] - bounds[2 * c]);
  }
  const double radius = 0.5 * std::sqrt(squares);
  const double distance = radius / std::sin(0.5 * camera->GetViewAngle() * Pi / 180.0);
  camera->SetFocalPoint(middle);
  camera->SetPosition(middle[0], middle[1] - std::max(distance, 1e-3), middle[2]);
  CameraPlace whole = place;
  whole.Closer = 1.0;
  MoveCamera(camera, whole);
}

//----------------------------------------------------------------------------
void TurnAboutFocus(vtkSMRenderViewProxy* view)
{
  vtkCamera* camera = view->GetActiveCamera();
  if (!IsFlat(view)) // where the scale is all that counts
  {
    camera->SetParallelScale(camera->GetDistance() * std::tan(0.5 * camera->GetViewAngle() * Pi / 180.0));
  }
  vtkSMPropertyHelper(view, "CenterOfRotation").Set(camera->GetFocalPoint(), 3);
  view->UpdateVTKObjects();
}

//----------------------------------------------------------------------------
FirstCamera::~FirstCamera()
{
  this->Stop();
}

//----------------------------------------------------------------------------
void FirstCamera::WaitFor(vtkSMRenderViewProxy* view, const CameraPlace& place)
{
  if (view == this->View || (IsFlat(view) && !place.IsOnMap))
  {
    return;
  }
  this->Stop();
  this->Place = place;
  this->View = view;
  this->WasReset = place.IsOnMap;
  // A script draws once before it resets the camera, the window some times in a new view; see OnStart for flat data.
  this->PicturesToWait = place.IsOfFlatData ? 10 : 2;
  this->Shown = vtkObject::SafeDownCast(view->GetClientSideObject());
  this->ResetObserver = this->Shown->AddObserver(vtkCommand::ResetCameraEvent, this, &FirstCamera::OnResetCamera);
  this->StartObserver = view->AddObserver(vtkCommand::StartEvent, this, &FirstCamera::OnStart, BeforeOthers);
  this->PictureObserver = view->AddObserver(vtkCommand::EndEvent, this, &FirstCamera::OnPicture);
}

//----------------------------------------------------------------------------
void FirstCamera::ShowAll(vtkSMRenderViewProxy* view, double closer)
{
  this->Stop();
  this->Place = {};
  this->Place.Closer = closer;
  this->View = view;
  this->Former = LineOfSight(view->GetActiveCamera());
  this->StartObserver = view->AddObserver(vtkCommand::StartEvent, this, &FirstCamera::OnStartWithData, BeforeOthers);
}

//----------------------------------------------------------------------------
void FirstCamera::OnStartWithData(vtkObject*, unsigned long, void*)
{
  vtkSMRenderViewProxy* view = this->View;
  this->Stop();
  if (LineOfSight(view->GetActiveCamera()) == this->Former)
  {
    view->ResetCamera();
    view->GetActiveCamera()->Dolly(this->Place.Closer);
    TurnAboutFocus(view);
  }
}

//----------------------------------------------------------------------------
void FirstCamera::OnResetCamera(vtkObject*, unsigned long, void*)
{
  if (!this->WasReset && !IsEmpty(this->View))
  {
    this->WasReset = true;
    if (!this->Place.IsOfFlatData || this->Place.IsFixed)
    {
      MoveCamera(this->View->GetActiveCamera(), this->Place);
    }
  }
}

//----------------------------------------------------------------------------
void FirstCamera::OnStart(vtkObject*, unsigned long, void*)
{
  if (this->Place.IsBesideLight && !this->WasReset && !IsEmpty(this->View) && HasFirstCamera(this->View))
  {
    this->View->ResetCamera();
  }
  if (this->WasReset)
  {
    this->LiftFlatData();
    TurnAboutFocus(this->View); // after ParaView has taken the middle of all that it knows to be visible
  }
}

//----------------------------------------------------------------------------
/// The window shows a flat image, as that of a terrain is, or a point in two dimensions, after it has reset the camera.
void FirstCamera::LiftFlatData()
{
  vtkCamera* camera = this->View->GetActiveCamera();
  if (!(this->Place.IsOfFlatData || this->Place.IsOnMap) || !LooksAlongAxis(camera))
  {
    return; // someone has turned it since
  }
  vtkSMPropertyHelper(this->View, "InteractionMode").Set("3D");
  vtkSMPropertyHelper(this->View, "CameraParallelProjection").Set(0);
  this->View->UpdateVTKObjects();
  MoveCamera(camera, this->Place);
  if (!this->Place.IsFixed)
  {
    this->View->ResetCamera(); // to what is drawn of it
    camera->Dolly(this->Place.Closer);
  }
}

//----------------------------------------------------------------------------
void FirstCamera::OnPicture(vtkObject*, unsigned long, void*)
{
  if (!IsEmpty(this->View) && (this->WasReset || --this->PicturesToWait == 0))
  {
    this->Stop();
  }
}

//----------------------------------------------------------------------------
void FirstCamera::Stop()
{
  if (this->View)
  {
    this->View->RemoveObserver(this->StartObserver);
    this->View->RemoveObserver(this->PictureObserver);
  }
  if (this->Shown)
  {
    this->Shown->RemoveObserver(this->ResetObserver);
  }
  this->Shown = nullptr;
  this->View = nullptr;
}

}
