// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMFollowCameraProxy.h"

#include "FirstCamera.h"
#include "Geometry/ViewFrustum.h"
#include "Numerics/Constants.h"
#include "Pipeline/CameraView.h"
#include "SceneView.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <algorithm>

vtkStandardNewMacro(vtkSMFollowCameraProxy);

namespace
{
constexpr double Degree = littoral::Pi / 180.0;

littoral::Vector3 GetVector(vtkSMProxy* proxy, const char* name)
{
  double a[3] = { 0.0, 0.0, 0.0 };
  vtkSMPropertyHelper(proxy, name).Get(a, 3);
  return { a[0], a[1], a[2] };
}

void SetVector(vtkSMProxy* proxy, const char* name, const littoral::Vector3& a)
{
  vtkSMPropertyHelper(proxy, name).Set(&a.x, 3);
}

/// The view that a filter was told of last.
littoral::View ViewOf(vtkSMProxy* filter)
{
  littoral::View view;
  view.Point = GetVector(filter, "ViewPoint");
  view.Direction = GetVector(filter, "ViewDirection");
  view.Up = GetVector(filter, "ViewUp");
  view.Angle = vtkSMPropertyHelper(filter, "ViewAngle").GetAsDouble() * Degree;
  view.IsParallel = vtkSMPropertyHelper(filter, "ParallelProjection").GetAsInt() != 0;
  view.ParallelScale = vtkSMPropertyHelper(filter, "ParallelScale").GetAsDouble();
  view.AspectRatio = vtkSMPropertyHelper(filter, "AspectRatio").GetAsDouble();
  view.Height = vtkSMPropertyHelper(filter, "ViewHeight").GetAsDouble();
  view.DetailFactor = vtkSMPropertyHelper(filter, "DetailFactor").GetAsDouble();
  return view;
}

/// Whether what a filter shows depends on where the camera looks (vtkPlantScatterFilter::DependsOnDirection()).
bool DependsOnDirection(vtkSMProxy* filter, const littoral::View& view)
{
  const auto is = [filter](const char* name, int value) {
    return filter->GetProperty(name) && vtkSMPropertyHelper(filter, name).GetAsInt() == value;
  };
  const bool showsAllAround = is("UseCulling", 0) && (is("OutputForm", 1) || is("FaceCamera", 0));
  return !showsAllAround || view.IsParallel;
}

/// View of the camera of a render view; one that has no size yet leaves that of another. A screenshot larger than the
/// view is drawn in tiles, each with a camera of its own: all of them leave the other view, at the height of the whole.
littoral::View ViewOf(vtkSMRenderViewProxy* shown, const littoral::View& other)
{
  int size[2] = { 0, 0 };
  vtkSMPropertyHelper(shown, "ViewSize").Get(size, 2);
  int tiles[2] = { 1, 1 };
  if (vtkRenderWindow* window = shown->GetRenderWindow())
  {
    window->GetTileScale(tiles);
  }
  if (tiles[0] <= 1 && tiles[1] <= 1)
  {
    return littoral::ViewOfCamera(shown->GetActiveCamera(), size[0], size[1], other);
  }
  littoral::View view = other;
  view.Height = static_cast<double>(size[1]) * tiles[1];
  return view;
}
}

//----------------------------------------------------------------------------
vtkSMFollowCameraProxy::vtkSMFollowCameraProxy() = default;

//----------------------------------------------------------------------------
vtkSMFollowCameraProxy::~vtkSMFollowCameraProxy()
{
  this->WatchView(nullptr);
  this->WatchSelection(nullptr);
}

//----------------------------------------------------------------------------
void vtkSMFollowCameraProxy::UpdateVTKObjects()
{
  this->Superclass::UpdateVTKObjects();
  if (this->IsTaking || !this->GetSession() || !this->GetProperty("FollowCamera"))
  {
    return;
  }
  const bool follows = vtkSMPropertyHelper(this, "FollowCamera").GetAsInt() != 0;
  this->WatchSelection(follows ? this->GetSessionProxyManager()->GetSelectionModel("ActiveView") : nullptr);
  this->OnActiveView();
}

//----------------------------------------------------------------------------
void vtkSMFollowCameraProxy::WatchSelection(vtkObject* selection)
{
  if (this->Selection == selection)
  {
    return;
  }
  if (this->Selection)
  {
    this->Selection->RemoveObserver(this->SelectionObserver);
  }
  if (this->Manager)
  {
    this->Manager->RemoveObserver(this->StateObserver);
    this->Manager = nullptr;
  }
  this->Selection = selection;
  if (selection)
  {
    this->SelectionObserver =
      selection->AddObserver(vtkCommand::CurrentChangedEvent, this, &vtkSMFollowCameraProxy::OnActiveView);
    this->Manager = this->GetSessionProxyManager();
    this->StateObserver =
      this->Manager->AddObserver(vtkCommand::LoadStateEvent, this, &vtkSMFollowCameraProxy::OnActiveView);
  }
}

//----------------------------------------------------------------------------
void vtkSMFollowCameraProxy::WatchView(vtkSMRenderViewProxy* view)
{
  if (this->View == view)
  {
    return;
  }
  if (this->View)
  {
    this->View->RemoveObserver(this->ViewObserver);
  }
  this->View = view;
  if (view)
  {
    // A view says so at the start of a picture, before it updates its data.
    this->ViewObserver = view->AddObserver(vtkCommand::StartEvent, this, &vtkSMFollowCameraProxy::OnPicture);
  }
}

//----------------------------------------------------------------------------
void vtkSMFollowCameraProxy::OnActiveView()
{
  auto* selection = vtkSMProxySelectionModel::SafeDownCast(this->Selection);
  if (!selection)
  {
    this->WatchView(nullptr);
  }
  else if (auto* view = littoral::ViewThatShows(this->GetSessionProxyManager(), this))
  {
    this->WatchView(view);
  }
  else if (auto* active = vtkSMRenderViewProxy::SafeDownCast(selection->GetCurrentProxy()))
  {
    this->WatchView(active); // a chart that becomes active leaves the last one
  }
}

//----------------------------------------------------------------------------
void vtkSMFollowCameraProxy::OnPicture(vtkObject*, unsigned long, void* isInteractive)
{
  vtkSMRenderViewProxy* drawn = this->View;
  this->OnActiveView(); // since then something may be shown elsewhere, as in a state
  if (this->View != drawn)
  {
    return;
  }
  // Before its first camera a level of detail would show nothing: ParaView draws once, and places the camera by that.
  if (!this->View || !this->View->GetActiveCamera() || this->IsTaking || littoral::HasFirstCamera(this->View))
  {
    return;
  }
  littoral::View view = ViewOf(this->View, ViewOf(this));
  const bool isDragged = isInteractive && *static_cast<int*>(isInteractive) != 0;
  view.DetailFactor = isDragged ? vtkSMPropertyHelper(this, "InteractiveDetail").GetAsDouble() : 1.0;
  if (!this->Shows(view))
  {
    this->Take(view);
  }
}

//----------------------------------------------------------------------------
bool vtkSMFollowCameraProxy::Shows(const littoral::View& view)
{
  const littoral::View before = ViewOf(this);
  if (!littoral::WhyInvalid(before).empty() || !littoral::WhyInvalid(view).empty())
  {
    return false; // the filter says why
  }
  littoral::View now = view;
  if (!DependsOnDirection(this, view))
  {
    now.Direction = before.Direction;
    now.Up = before.Up;
    now.AspectRatio = before.AspectRatio;
  }
  const double length = std::max(0.0, vtkSMPropertyHelper(this, "MoveTolerance").GetAsDouble());
  const double angle = std::max(0.0, vtkSMPropertyHelper(this, "TurnTolerance").GetAsDouble()) * Degree;
  return littoral::AreTheSame(littoral::Rounded(now, length, angle), littoral::Rounded(before, length, angle));
}

//----------------------------------------------------------------------------
void vtkSMFollowCameraProxy::Take(const littoral::View& view)
{
  this->IsTaking = true;
  SetVector(this, "ViewPoint", view.Point);
  SetVector(this, "ViewDirection", view.Direction);
  SetVector(this, "ViewUp", view.Up);
  vtkSMPropertyHelper(this, "ViewAngle").Set(view.Angle / Degree);
  vtkSMPropertyHelper(this, "ParallelProjection").Set(view.IsParallel ? 1 : 0);
  vtkSMPropertyHelper(this, "ParallelScale").Set(view.ParallelScale);
  vtkSMPropertyHelper(this, "AspectRatio").Set(view.AspectRatio);
  vtkSMPropertyHelper(this, "ViewHeight").Set(view.Height);
  vtkSMPropertyHelper(this, "DetailFactor").Set(view.DetailFactor);
  this->UpdateVTKObjects();
  this->IsTaking = false;
}

//----------------------------------------------------------------------------
void vtkSMFollowCameraProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->View << "\n";
}
