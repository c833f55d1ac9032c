// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSeaSurfaceRepresentation.h"

#include "vtkSeaSurfaceFilter.h"

#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"

namespace
{

/// Distance of the near clipping plane as a ratio to the far one, at least. VTK's 0.001 would cut off what is within
/// some 10 m of an eye that sees the horizon.
constexpr double NearToFar = 2e-5;

/// VTK's own choice.
constexpr double Automatic = 0.0;

void SetNearToFar(vtkView* view, double ratio)
{
  if (auto* shown = vtkPVRenderView::SafeDownCast(view))
  {
    // They have one camera, whose clipping planes both set.
    shown->GetRenderer()->SetNearClippingPlaneTolerance(ratio);
    shown->GetNonCompositedRenderer()->SetNearClippingPlaneTolerance(ratio);
  }
}

}

vtkStandardNewMacro(vtkSeaSurfaceRepresentation);

//----------------------------------------------------------------------------
vtkSeaSurfaceRepresentation::vtkSeaSurfaceRepresentation()
{
  vtkNew<vtkSeaSurfaceFilter> filter;
  this->SetFilter(filter);
}

//----------------------------------------------------------------------------
vtkSeaSurfaceRepresentation::~vtkSeaSurfaceRepresentation() = default;

//----------------------------------------------------------------------------
int vtkSeaSurfaceRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // clients and render servers have none
  return 1;
}

//----------------------------------------------------------------------------
bool vtkSeaSurfaceRepresentation::AddToView(vtkView* view)
{
  SetNearToFar(view, NearToFar);
  return this->Superclass::AddToView(view);
}

//----------------------------------------------------------------------------
bool vtkSeaSurfaceRepresentation::RemoveFromView(vtkView* view)
{
  SetNearToFar(view, Automatic);
  return this->Superclass::RemoveFromView(view);
}

//----------------------------------------------------------------------------
void vtkSeaSurfaceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
