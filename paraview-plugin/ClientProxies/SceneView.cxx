// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneView.h"

#include "Scene.h"

#include "vtkNew.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <algorithm>
#include <vector>

namespace littoral
{
namespace
{

/// All views in three dimensions; two may have one name.
std::vector<vtkSMRenderViewProxy*> RenderViews(vtkSMSessionProxyManager* manager)
{
  std::vector<vtkSMRenderViewProxy*> views;
  vtkNew<vtkSMProxyIterator> next;
  next->SetSessionProxyManager(manager);
  for (next->Begin("views"); !next->IsAtEnd(); next->Next())
  {
    if (auto* view = vtkSMRenderViewProxy::SafeDownCast(next->GetProxy()))
    {
      views.push_back(view);
    }
  }
  return views;
}

}

//----------------------------------------------------------------------------
vtkSMProxy* ViewOfScene(vtkSMSessionProxyManager* manager)
{
  vtkSMProxySelectionModel* selection = manager->GetSelectionModel("ActiveView");
  vtkSMProxy* active = selection ? selection->GetCurrentProxy() : nullptr;
  if (vtkSMRenderViewProxy::SafeDownCast(active))
  {
    return active;
  }
  const std::vector<vtkSMRenderViewProxy*> views = RenderViews(manager);
  return views.empty() ? nullptr : views.front();
}

//----------------------------------------------------------------------------
bool Shows(vtkSMProxy* view, vtkSMProxy* source)
{
  const vtkSMPropertyHelper shown(view, "Representations", true);
  for (unsigned int k = 0; k < shown.GetNumberOfElements(); ++k)
  {
    vtkSMProxy* one = shown.GetAsProxy(k);
    vtkSMProxy* input = one && one->GetProperty("Input") ? vtkSMPropertyHelper(one, "Input").GetAsProxy() : nullptr;
    const bool isVisible = one && vtkSMPropertyHelper(one, "Visibility", true).GetAsInt() != 0;
    if (isVisible && input && (input == source || UpstreamOf(input).count(source) == 1))
    {
      return true;
    }
  }
  return false;
}

//----------------------------------------------------------------------------
std::vector<vtkSMRenderViewProxy*> ViewsThatShow(vtkSMSessionProxyManager* manager, vtkSMProxy* source)
{
  std::vector<vtkSMRenderViewProxy*> views = RenderViews(manager);
  views.erase(
    std::remove_if(views.begin(), views.end(), [=](auto* view) { return !Shows(view, source); }), views.end());
  std::stable_partition(views.begin(), views.end(), [=](auto* view) { return view == ViewOfScene(manager); });
  return views;
}

//----------------------------------------------------------------------------
vtkSMRenderViewProxy* ViewThatShows(vtkSMSessionProxyManager* manager, vtkSMProxy* source)
{
  const std::vector<vtkSMRenderViewProxy*> views = ViewsThatShow(manager, source);
  return views.empty() ? nullptr : views.front();
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
