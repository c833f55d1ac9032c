// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneView.h"

#include "vtkSMProxySelectionModel.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

namespace littoral
{

//----------------------------------------------------------------------------
vtkSMProxy* ViewOfScene(vtkSMSessionProxyManager* manager)
{
  vtkSMProxySelectionModel* selection = manager->GetSelectionModel("ActiveView");
  vtkSMProxy* active = selection ? selection->GetCurrentProxy() : nullptr;
  if (vtkSMRenderViewProxy::SafeDownCast(active))
  {
    return active;
  }
  for (unsigned int k = 0; k < manager->GetNumberOfProxies("views"); ++k)
  {
    vtkSMProxy* view = manager->GetProxy("views", manager->GetProxyName("views", k));
    if (vtkSMRenderViewProxy::SafeDownCast(view))
    {
      return view;
    }
  }
  return nullptr;
}

//----------------------------------------------------------------------------
void ActivateViewOfScene(vtkSMSessionProxyManager* manager)
{
  vtkSMProxySelectionModel* selection = manager->GetSelectionModel("ActiveView");
  vtkSMProxy* view = ViewOfScene(manager);
  if (selection && view && view != selection->GetCurrentProxy())
  {
    selection->SetCurrentProxy(view, vtkSMProxySelectionModel::CLEAR_AND_SELECT);
  }
}

}
