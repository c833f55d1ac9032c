// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NaturalDisplay.h"

#include "Numerics/Constants.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#if __has_include("vtkSMColorMapEditorHelper.h") // ParaView 5.13 and later
#include "vtkSMColorMapEditorHelper.h"
#else
#include "vtkSMPVRepresentationProxy.h"
#endif
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>

namespace littoral
{
namespace
{

#if __has_include("vtkSMColorMapEditorHelper.h")
using ColorHelper = vtkSMColorMapEditorHelper;
#else
using ColorHelper = vtkSMPVRepresentationProxy;
#endif

/// Azimuth of the eye, from east to north [rad]: from the south-west, so that x goes to the right and y away.
constexpr double EyeAzimuth = -0.62 * Pi;

/// Whether nothing is shown in a view.
bool IsEmpty(vtkSMProxy* view)
{
  const vtkSMPropertyHelper shown(view, "Representations");
  for (unsigned int k = 0; k < shown.GetNumberOfElements(); ++k)
  {
    vtkSMProxy* one = shown.GetAsProxy(k);
    if (one && one->GetProperty("Input") && vtkSMPropertyHelper(one, "Visibility", true).GetAsInt() != 0)
    {
      return false;
    }
  }
  return true;
}

}

//----------------------------------------------------------------------------
NaturalDisplay::~NaturalDisplay()
{
  this->StopWaiting();
  this->StopWaitingForLegend();
  if (this->Manager)
  {
    this->Manager->RemoveObserver(this->RegisterObserver);
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::Watch()
{
  if (!this->Manager && this->Owner->GetSession())
  {
    this->Manager = this->Owner->GetSessionProxyManager();
    this->RegisterObserver = this->Manager->AddObserver(vtkCommand::RegisterEvent, this, &NaturalDisplay::OnRegister);
  }
}

//----------------------------------------------------------------------------
const char* NaturalDisplay::Hint(const char* name)
{
  vtkPVXMLElement* hints = this->Owner->GetHints();
  vtkPVXMLElement* hint = hints ? hints->FindNestedElementByName("NaturalDisplay") : nullptr;
  return hint ? hint->GetAttribute(name) : nullptr;
}

//----------------------------------------------------------------------------
void NaturalDisplay::OnRegister(vtkObject*, unsigned long, void* information)
{
  const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(information);
  if (registered->Type != vtkSMProxyManager::RegisteredProxyInformation::PROXY || !registered->GroupName ||
    std::strcmp(registered->GroupName, "representations") != 0 || this->Manager->GetInLoadXMLState())
  {
    return;
  }
  vtkSMProxy* representation = registered->Proxy;
  if (!representation->GetProperty("Input") || !representation->GetProperty("MapScalars"))
  {
    return;
  }
  const vtkSMPropertyHelper input(representation, "Input");
  if (input.GetAsProxy() == this->Owner)
  {
    this->TakeColors(representation, input.GetOutputPort());
    this->WaitForCamera();
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::TakeColors(vtkSMProxy* representation, int port)
{
  this->Owner->UpdatePipeline();
  vtkPVDataInformation* data = this->Owner->GetDataInformation(port);
  if (!data || data->GetNumberOfPoints() == 0)
  {
    this->WaitForData(representation, port);
  }
  if (data && data->GetArrayInformation("RGB", vtkDataObject::POINT))
  {
    vtkSMPropertyHelper(representation, "MapScalars").Set(0);
    this->WaitForLegend(representation);
  }
  const bool isForest = data && data->GetArrayInformation("SiteId", vtkDataObject::FIELD);
  const char* blocks = isForest ? this->Hint("forest-blocks") : nullptr;
  blocks = port != 0 ? nullptr : blocks ? blocks : this->Hint("blocks");
  if (blocks && representation->GetProperty("BlockSelectors"))
  {
    vtkSMPropertyHelper selectors(representation, "BlockSelectors");
    std::istringstream names(blocks);
    std::string name;
    for (unsigned int k = 0; names >> name; ++k)
    {
      selectors.Set(k, name.c_str());
    }
  }
  const char* array = this->Hint("color");
  if (array && data && data->GetArrayInformation(array, vtkDataObject::POINT))
  {
    ColorHelper::SetScalarColoring(representation, array, vtkDataObject::POINT);
    ColorHelper::RescaleTransferFunctionToDataRange(representation, array, vtkDataObject::POINT);
  }
  if (this->Hint("own-levels"))
  {
    vtkSMPropertyHelper(representation, "Representation").Set("Full Surface");
  }
  representation->UpdateVTKObjects();
}

//----------------------------------------------------------------------------
/// Inputs that are missing at first leave nothing to take colors from.
void NaturalDisplay::WaitForData(vtkSMProxy* representation, int port)
{
  this->Empty = representation;
  this->EmptyPort = port;
  if (this->DataObserver == 0)
  {
    this->DataObserver = this->Owner->AddObserver(vtkCommand::UpdateDataEvent, this, &NaturalDisplay::OnData);
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::OnData(vtkObject*, unsigned long, void*)
{
  vtkPVDataInformation* data = this->Owner->GetDataInformation(this->EmptyPort);
  if (this->Empty && (!data || data->GetNumberOfPoints() == 0))
  {
    return;
  }
  this->Owner->RemoveObserver(this->DataObserver);
  this->DataObserver = 0;
  vtkSMProxy* representation = this->Empty;
  this->Empty = nullptr;
  if (!representation)
  {
    return;
  }
  if (data->GetArrayInformation("RGB", vtkDataObject::POINT))
  {
    ColorHelper::SetScalarColoring(representation, "RGB", vtkDataObject::POINT);
  }
  this->TakeColors(representation, this->EmptyPort);
}

//----------------------------------------------------------------------------
vtkSMRenderViewProxy* NaturalDisplay::ActiveView()
{
  vtkSMProxySelectionModel* active = this->Manager->GetSelectionModel("ActiveView");
  return active ? vtkSMRenderViewProxy::SafeDownCast(active->GetCurrentProxy()) : nullptr;
}

//----------------------------------------------------------------------------
void NaturalDisplay::WaitForLegend(vtkSMProxy* representation)
{
  this->StopWaitingForLegend();
  this->Colored = representation;
  this->LegendView = this->ActiveView();
  if (this->LegendView)
  {
    this->LegendObserver =
      this->LegendView->AddObserver(vtkCommand::StartEvent, this, &NaturalDisplay::OnStartOfPicture);
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::OnStartOfPicture(vtkObject*, unsigned long, void*)
{
  if (this->Colored)
  {
    ColorHelper::SetScalarBarVisibility(this->Colored, this->LegendView, false);
  }
  this->StopWaitingForLegend();
}

//----------------------------------------------------------------------------
void NaturalDisplay::StopWaitingForLegend()
{
  if (this->LegendView)
  {
    this->LegendView->RemoveObserver(this->LegendObserver);
  }
  this->LegendView = nullptr;
}

//----------------------------------------------------------------------------
void NaturalDisplay::WaitForCamera()
{
  vtkSMRenderViewProxy* view = this->ActiveView();
  if (!this->Hint("elevation") || !view || view == this->View || !IsEmpty(view))
  {
    return;
  }
  this->StopWaiting();
  this->View = view;
  this->PicturesToWait = 2; // a script draws once before it resets the camera
  this->Shown = vtkObject::SafeDownCast(view->GetClientSideObject());
  this->ResetObserver = this->Shown->AddObserver(vtkCommand::ResetCameraEvent, this, &NaturalDisplay::OnResetCamera);
  this->PictureObserver = view->AddObserver(vtkCommand::EndEvent, this, &NaturalDisplay::OnPicture);
}

//----------------------------------------------------------------------------
void NaturalDisplay::OnResetCamera(vtkObject*, unsigned long, void*)
{
  vtkCamera* camera = this->View ? this->View->GetActiveCamera() : nullptr;
  this->StopWaiting();
  if (!camera) // what the view showed on may outlive it
  {
    return;
  }
  const double elevation = std::atof(this->Hint("elevation")) * Pi / 180.0;
  const char* closer = this->Hint("closer");
  // What the camera shows of a sphere around the data does not depend on where it looks from.
  const double distance = camera->GetDistance() / std::max(0.1, closer ? std::atof(closer) : 1.0);
  double focus[3];
  camera->GetFocalPoint(focus);
  camera->SetPosition(focus[0] + distance * std::cos(elevation) * std::cos(EyeAzimuth),
    focus[1] + distance * std::cos(elevation) * std::sin(EyeAzimuth), focus[2] + distance * std::sin(elevation));
  camera->SetViewUp(0.0, 0.0, 1.0);
}

//----------------------------------------------------------------------------
void NaturalDisplay::OnPicture(vtkObject*, unsigned long, void*)
{
  if (--this->PicturesToWait == 0)
  {
    this->StopWaiting(); // shown with a camera that someone has chosen
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::StopWaiting()
{
  if (this->View)
  {
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
