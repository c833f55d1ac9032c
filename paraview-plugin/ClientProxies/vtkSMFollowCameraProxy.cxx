// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMFollowCameraProxy.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSMFollowCameraProxy);

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
  this->Selection = selection;
  if (selection)
  {
    this->SelectionObserver =
      selection->AddObserver(vtkCommand::CurrentChangedEvent, this, &vtkSMFollowCameraProxy::OnActiveView);
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
  else if (auto* view = vtkSMRenderViewProxy::SafeDownCast(selection->GetCurrentProxy()))
  {
    this->WatchView(view); // a chart that becomes active leaves the last one
  }
}

//----------------------------------------------------------------------------
void vtkSMFollowCameraProxy::OnPicture()
{
  vtkCamera* camera = this->View ? this->View->GetActiveCamera() : nullptr;
  if (!camera || this->IsTaking)
  {
    return;
  }
  this->IsTaking = true;
  const vtkSMPropertyHelper size(this->View, "ViewSize");
  if (size.GetNumberOfElements() == 2 && size.GetAsInt(0) > 0 && size.GetAsInt(1) > 0)
  {
    vtkSMPropertyHelper(this, "AspectRatio").Set(static_cast<double>(size.GetAsInt(0)) / size.GetAsInt(1));
    vtkSMPropertyHelper(this, "ViewHeight").Set(static_cast<double>(size.GetAsInt(1)));
  }
  double point[3];
  camera->GetPosition(point);
  double angle = camera->GetViewAngle();
  if (camera->GetParallelProjection())
  {
    // A perspective that shows as much at the focal point.
    constexpr double Degree = 3.14159265358979323846 / 180.0;
    const double distance = camera->GetParallelScale() / std::tan(0.5 * angle * Degree);
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = camera->GetFocalPoint()[axis] - distance * camera->GetDirectionOfProjection()[axis];
    }
  }
  vtkSMPropertyHelper(this, "ViewPoint").Set(point, 3);
  vtkSMPropertyHelper(this, "ViewDirection").Set(camera->GetDirectionOfProjection(), 3);
  vtkSMPropertyHelper(this, "ViewUp").Set(camera->GetViewUp(), 3);
  vtkSMPropertyHelper(this, "ViewAngle").Set(angle);
  this->UpdateVTKObjects();
  this->IsTaking = false;
}

//----------------------------------------------------------------------------
void vtkSMFollowCameraProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->View << "\n";
}
