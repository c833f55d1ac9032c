// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMLandscapeProxy.h"

#include "NaturalDisplay.h"

#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyProperty.h"
#include "vtkSMSessionProxyManager.h"

vtkStandardNewMacro(vtkSMLandscapeProxy);

namespace
{

constexpr int DefaultFrames = 10;        // of ParaView
constexpr double FramesPerSecond = 12.0; // of a film instead

/// The first proxy of a group; null if there is none.
vtkSMProxy* FirstOf(vtkSMSessionProxyManager* manager, const char* group)
{
  const char* name = manager ? manager->GetProxyName(group, 0u) : nullptr;
  return name ? manager->GetProxy(group, name) : nullptr;
}

/// Gives a range of times without time steps the frames of a film, unless someone has chosen their number.
void SetFrames(vtkSMProxy* animation, vtkSMProxy* source)
{
  vtkSMProperty* range = source->GetProperty("TimeRange");
  if (!animation || !range || !animation->GetProperty("NumberOfFrames"))
  {
    return;
  }
  vtkSMPropertyHelper frames(animation, "NumberOfFrames");
  const vtkSMPropertyHelper times(range);
  if (frames.GetAsInt() == DefaultFrames)
  {
    frames.Set(static_cast<int>(FramesPerSecond * (times.GetAsDouble(1) - times.GetAsDouble(0))) + 1);
    animation->UpdateVTKObjects();
  }
}

}

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
  vtkSMProxy* keeper = FirstOf(manager, "timekeeper");
  auto* left = keeper ? vtkSMProxyProperty::SafeDownCast(keeper->GetProperty("SuppressedTimeSources")) : nullptr;
  if (left && left->IsProxyAdded(this))
  {
    left->RemoveProxy(this);
    keeper->UpdateVTKObjects();
    SetFrames(FirstOf(manager, "animation"), this);
  }
}

//----------------------------------------------------------------------------
void vtkSMLandscapeProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
