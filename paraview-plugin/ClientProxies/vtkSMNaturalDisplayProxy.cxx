// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMNaturalDisplayProxy.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMOutputPort.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"

#include <cstring>

vtkStandardNewMacro(vtkSMNaturalDisplayProxy);

//----------------------------------------------------------------------------
vtkSMNaturalDisplayProxy::vtkSMNaturalDisplayProxy() = default;

//----------------------------------------------------------------------------
vtkSMNaturalDisplayProxy::~vtkSMNaturalDisplayProxy()
{
  if (this->Manager)
  {
    this->Manager->RemoveObserver(this->Observer);
  }
}

//----------------------------------------------------------------------------
void vtkSMNaturalDisplayProxy::UpdateVTKObjects()
{
  this->Superclass::UpdateVTKObjects();
  if (!this->Manager && this->GetSession())
  {
    this->Manager = this->GetSessionProxyManager();
    this->Observer = this->Manager->AddObserver(vtkCommand::RegisterEvent, this, &vtkSMNaturalDisplayProxy::OnRegister);
  }
}

//----------------------------------------------------------------------------
void vtkSMNaturalDisplayProxy::OnRegister(vtkObject* manager, unsigned long, void* information)
{
  const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(information);
  if (registered->Type != vtkSMProxyManager::RegisteredProxyInformation::PROXY || !registered->GroupName ||
    std::strcmp(registered->GroupName, "representations") != 0 ||
    static_cast<vtkSMSessionProxyManager*>(manager)->GetInLoadXMLState())
  {
    return;
  }
  vtkSMProxy* representation = registered->Proxy;
  if (!representation->GetProperty("Input") || !representation->GetProperty("MapScalars"))
  {
    return;
  }
  // Asked of the port, since the input may be a compound proxy that has this one in it.
  const vtkSMPropertyHelper input(representation, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  vtkSMOutputPort* port = source ? source->GetOutputPort(input.GetOutputPort()) : nullptr;
  if (!port || port->GetSourceProxy() != this || port->GetPortIndex() != 0)
  {
    return;
  }
  source->UpdatePipeline();
  if (port->GetDataInformation()->GetArrayInformation("RGB", vtkDataObject::POINT))
  {
    vtkSMPropertyHelper(representation, "MapScalars").Set(0);
  }
  const vtkPVXMLElement* hint =
    this->GetHints() ? this->GetHints()->FindNestedElementByName("NaturalDisplay") : nullptr;
  const char* block = hint ? const_cast<vtkPVXMLElement*>(hint)->GetAttribute("block") : nullptr;
  if (block && representation->GetProperty("BlockSelectors"))
  {
    vtkSMPropertyHelper(representation, "BlockSelectors").Set(block);
  }
  representation->UpdateVTKObjects();
}

//----------------------------------------------------------------------------
void vtkSMNaturalDisplayProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
