// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMLandscapeProxy.h"

#include "NaturalDisplay.h"

#include "vtkObjectFactory.h"
#include "vtkSMProxyProperty.h"
#include "vtkSMSessionProxyManager.h"

vtkStandardNewMacro(vtkSMLandscapeProxy);

//----------------------------------------------------------------------------
vtkSMLandscapeProxy::vtkSMLandscapeProxy()
  : Display(new littoral::NaturalDisplay(this))
{
}

//----------------------------------------------------------------------------
vtkSMLandscapeProxy::~vtkSMLandscapeProxy() = default;

//----------------------------------------------------------------------------
void vtkSMLandscapeProxy::UpdateVTKObjects()
{
  this->Superclass::UpdateVTKObjects();
  this->Display->Watch();
}

//----------------------------------------------------------------------------
void vtkSMLandscapeProxy::UpdatePipelineInformation()
{
  this->Superclass::UpdatePipelineInformation();
  vtkSMSessionProxyManager* manager = this->GetSession() ? this->GetSessionProxyManager() : nullptr;
  const char* name = manager ? manager->GetProxyName("timekeeper", 0u) : nullptr;
  vtkSMProxy* keeper = name ? manager->GetProxy("timekeeper", name) : nullptr;
  auto* left = keeper ? vtkSMProxyProperty::SafeDownCast(keeper->GetProperty("SuppressedTimeSources")) : nullptr;
  if (left && left->IsProxyAdded(this))
  {
    left->RemoveProxy(this);
    keeper->UpdateVTKObjects();
  }
}

//----------------------------------------------------------------------------
void vtkSMLandscapeProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
