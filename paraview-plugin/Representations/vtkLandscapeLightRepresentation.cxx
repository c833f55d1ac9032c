// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLandscapeLightRepresentation.h"

#include "ViewLightPass.h"
#include "vtkLandscapePass.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOrderedCompositingHelper.h"
#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkRenderWindow.h"
#include "vtkSynchronizedRenderers.h"

namespace
{

/// Members of a view that are for its subclasses.
struct Access : vtkPVRenderView
{
  static vtkPVSynchronizedRenderer* RenderersOf(vtkPVRenderView* view)
  {
    return view->*(&Access::SynchronizedRenderers);
  }

  /// Whether this process draws surfaces, rather than pictures of others.
  static bool DrawsSurfaces(vtkPVRenderView* view, bool isRemote)
  {
    return (view->*(&Access::IsProcessRenderingGeometriesForCompositing))(isRemote);
  }
};

/// Whether a rank is the farthest of those whose pictures are composed in order.
bool IsFarthest(vtkPVRenderView* view, int rank)
{
  auto* data = vtkPVRenderViewDataDeliveryManager::SafeDownCast(view->GetDeliveryManager());
  vtkNew<vtkOrderedCompositingHelper> order;
  order->SetBoundingBoxes(data->GetCuts());
  return order->ComputeSortOrder(view->GetActiveCamera()).back() == rank;
}

/// The ranks that draw pictures together; null if this one draws them alone.
vtkMultiProcessController* RanksOf(vtkPVRenderView* view, bool isRemote)
{
  vtkMultiProcessController* all = vtkMultiProcessController::GetGlobalController();
  const bool areSeveral =
    isRemote && Access::RenderersOf(view)->GetParallelSynchronizer() && all && all->GetNumberOfProcesses() > 1;
  return areSeveral ? all : nullptr;
}

/// Whether a picture is one of a drag, for which a view asks 5 a second of its window, and slow whatever it shows.
bool IsDraggedInSoftware(vtkRenderWindow* window)
{
  return window->GetDesiredUpdateRate() > 1.0 && vtkLandscapePass::IsDrawnBySoftware(window);
}

}

vtkStandardNewMacro(vtkLandscapeLightRepresentation);

//----------------------------------------------------------------------------
vtkLandscapeLightRepresentation::vtkLandscapeLightRepresentation()
  : Light(vtkSmartPointer<littoral::ViewLightPass>::New())
{
}

//----------------------------------------------------------------------------
vtkLandscapeLightRepresentation::~vtkLandscapeLightRepresentation() = default;

//----------------------------------------------------------------------------
void vtkLandscapeLightRepresentation::SetPass(vtkLandscapePass* pass)
{
  if (this->Light->Landscape != pass)
  {
    this->Light->Landscape = pass;
    this->Modified();
  }
}

//----------------------------------------------------------------------------
vtkLandscapePass* vtkLandscapeLightRepresentation::GetPass()
{
  return this->Light->Landscape;
}

//----------------------------------------------------------------------------
void vtkLandscapeLightRepresentation::SetShowSky(bool shows)
{
  if (this->Light->ShowsSky != shows)
  {
    this->Light->ShowsSky = shows;
    this->Modified();
  }
}

//----------------------------------------------------------------------------
bool vtkLandscapeLightRepresentation::GetShowSky()
{
  return this->Light->ShowsSky;
}

//----------------------------------------------------------------------------
int vtkLandscapeLightRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // clients and render servers have none
  return 1;
}

//----------------------------------------------------------------------------
int vtkLandscapeLightRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* in, vtkInformation* out)
{
  const int isVisible = this->Superclass::ProcessViewRequest(request, in, out);
  auto* view = vtkPVRenderView::SafeDownCast(this->GetView());
  if (isVisible && view && request == vtkPVView::REQUEST_RENDER())
  {
    const bool usesLevels = in->Has(vtkPVRenderView::USE_LOD()) != 0;
    if (this->Light->Landscape)
    {
      this->Light->Landscape->SetDraft(usesLevels || IsDraggedInSoftware(view->GetRenderWindow()));
      this->Light->Landscape->SetWaterTime(view->GetViewTime());
    }
    this->Prepare(
      view, usesLevels ? view->GetUseDistributedRenderingForLODRender() : view->GetUseDistributedRenderingForRender());
  }
  return isVisible;
}

//----------------------------------------------------------------------------
void vtkLandscapeLightRepresentation::Prepare(vtkPVRenderView* view, bool isRemote)
{
  vtkPVSynchronizedRenderer* renderers = Access::RenderersOf(view);
  auto* other = littoral::ViewLightPass::SafeDownCast(renderers->GetRenderPass());
  if (!renderers->GetRenderPass() || (other && !other->IsOn))
  {
    renderers->SetRenderPass(this->Light);
  }
  this->Light->IsOn = renderers->GetRenderPass() == this->Light && Access::DrawsSurfaces(view, isRemote);
  vtkMultiProcessController* ranks = this->Light->IsOn ? RanksOf(view, isRemote) : nullptr;
  this->Light->SetRanks(ranks, view->GetRenderer(),
    [view, ranks] { return !view->GetUseOrderedCompositing() || IsFarthest(view, ranks->GetLocalProcessId()); });
}

//----------------------------------------------------------------------------
void vtkLandscapeLightRepresentation::SetVisibility(bool isVisible)
{
  this->Superclass::SetVisibility(isVisible);
  if (!isVisible)
  {
    this->TakeOff(vtkPVRenderView::SafeDownCast(this->GetView()));
  }
}

//----------------------------------------------------------------------------
bool vtkLandscapeLightRepresentation::RemoveFromView(vtkView* view)
{
  auto* shown = vtkPVRenderView::SafeDownCast(view);
  this->TakeOff(shown);
  if (shown)
  {
    this->Light->ReleaseGraphicsResources(shown->GetRenderWindow());
  }
  return this->Superclass::RemoveFromView(view);
}

//----------------------------------------------------------------------------
/// A pass that another one has taken the place of, such as that of a ray tracer, comes back as one that is off.
void vtkLandscapeLightRepresentation::TakeOff(vtkPVRenderView* view)
{
  this->Light->IsOn = false;
  this->Light->SetRanks(nullptr, nullptr, nullptr);
  if (view && Access::RenderersOf(view)->GetRenderPass() == this->Light)
  {
    Access::RenderersOf(view)->SetRenderPass(nullptr);
  }
}

//----------------------------------------------------------------------------
void vtkLandscapeLightRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShowSky: " << this->Light->ShowsSky << "\n";
  os << indent << "Pass: " << this->Light->Landscape.Get() << "\n";
}
