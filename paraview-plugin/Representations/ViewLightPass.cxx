// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewLightPass.h"

#include "vtkLandscapePass.h"

#include "vtkCallbackCommand.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPVDefaultPass.h"
#include "vtkProp.h"
#include "vtkRenderState.h"

namespace littoral
{

vtkStandardNewMacro(ViewLightPass);

/// A prop of which nothing is seen, with bounds around all that is near or far while it is on.
class ViewLightPass::Everywhere : public vtkProp
{
public:
  static Everywhere* New();
  vtkTypeMacro(Everywhere, vtkProp);
  double* GetBounds() override { return this->IsOn ? this->Bounds : nullptr; }

  bool IsOn = false;

private:
  double Bounds[6] = { -1e9, 1e9, -1e9, 1e9, -1e9, 1e9 };
};
vtkStandardNewMacro(ViewLightPass::Everywhere);

//----------------------------------------------------------------------------
ViewLightPass::ViewLightPass()
  : Whole(vtkSmartPointer<Everywhere>::New())
{
  this->Start->SetClientData(this);
  this->Start->SetCallback(
    [](vtkObject*, unsigned long, void* pass, void*) { static_cast<ViewLightPass*>(pass)->BeforePicture(); });
}

//----------------------------------------------------------------------------
ViewLightPass::~ViewLightPass()
{
  this->SetRanks(nullptr, nullptr, nullptr);
}

//----------------------------------------------------------------------------
void ViewLightPass::SetRanks(
  vtkMultiProcessController* ranks, vtkRenderer* renderer, const std::function<bool()>& hasBackground)
{
  if (this->Landscape)
  {
    this->Landscape->SetController(ranks);
    this->Landscape->SetBackground(this->ShowsSky);
  }
  this->HasBackground = hasBackground;
  vtkRenderer* wanted = ranks ? renderer : nullptr;
  if (this->Renderer == wanted)
  {
    return;
  }
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this->Start);
    this->Renderer->RemoveViewProp(this->Whole);
  }
  this->Renderer = wanted;
  if (wanted)
  {
    // After that of ParaView, by which all ranks have the camera of the first
    constexpr float late = -1.0F;
    wanted->AddObserver(vtkCommand::StartEvent, this->Start, late);
    wanted->AddViewProp(this->Whole);
  }
}

//----------------------------------------------------------------------------
void ViewLightPass::BeforePicture()
{
  if (this->IsOn && this->Landscape && !this->Renderer->GetSelector())
  {
    this->Landscape->SetBackground(this->ShowsSky && this->HasBackground());
    this->Landscape->DrawMaps(this->Renderer);
    this->Whole->IsOn = true;
  }
}

//----------------------------------------------------------------------------
void ViewLightPass::Render(const vtkRenderState* state)
{
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(state->GetRenderer());
  const bool isLit = this->IsOn && this->Landscape && renderer && !renderer->GetSelector();
  vtkRenderPass* pass = isLit ? static_cast<vtkRenderPass*>(this->Landscape) : this->Plain.Get();
  this->Whole->IsOn = false;
  pass->Render(state);
  this->NumberOfRenderedProps = pass->GetNumberOfRenderedProps();
  // Where pixels are larger, edges are soft already.
  if (isLit && renderer->GetUseFXAA() && this->Landscape->GetPixelSize() <= 1.0)
  {
    this->Smoothing->UpdateConfiguration(renderer->GetFXAAOptions());
    this->Smoothing->Execute(renderer);
  }
}

//----------------------------------------------------------------------------
void ViewLightPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Landscape)
  {
    this->Landscape->ReleaseGraphicsResources(window);
  }
  this->Smoothing->ReleaseGraphicsResources();
  this->Superclass::ReleaseGraphicsResources(window);
}

}
