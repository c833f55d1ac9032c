// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFullSurfaceRepresentation.h"

#include "TexturedBlocks.h"

#include "vtkAlgorithm.h"
#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkProperty.h"

vtkStandardNewMacro(vtkFullSurfaceRepresentation);

//----------------------------------------------------------------------------
vtkFullSurfaceRepresentation::vtkFullSurfaceRepresentation()
  : Textured(std::make_unique<littoral::TexturedBlocks>())
{
}

//----------------------------------------------------------------------------
vtkFullSurfaceRepresentation::~vtkFullSurfaceRepresentation() = default;

//----------------------------------------------------------------------------
int vtkFullSurfaceRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* in, vtkInformation* out)
{
  if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    if (this->GetVisibility())
    {
      vtkPVView::SetPieceLOD(in, this, this->MultiBlockMaker->GetOutputDataObject(0));
    }
    return this->GetVisibility();
  }
  const bool attributesChanged = this->BlockAttrChanged;
  const int isVisible = this->Superclass::ProcessViewRequest(request, in, out);
  if (request == vtkPVView::REQUEST_RENDER() && isVisible)
  {
    this->DrawTextures(attributesChanged);
  }
  return isVisible;
}

//----------------------------------------------------------------------------
/// Leaves data with textures to their own actors.
void vtkFullSurfaceRepresentation::DrawTextures(bool attributesChanged)
{
  vtkMapper* mapper = this->Actor->GetEnableLOD() ? this->LODMapper : this->Mapper;
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  const auto take = [this](vtkCompositeDataDisplayAttributes* attributes, vtkDataObject* blocks) {
    this->PopulateBlockAttributes(attributes, blocks);
  };
  if (data && this->Textured->Draw(data, this->Actor, mapper, attributesChanged, take))
  {
    const auto nothing = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
    mapper->SetInputDataObject(nothing);
  }
}

//----------------------------------------------------------------------------
void vtkFullSurfaceRepresentation::SetVisibility(bool isVisible)
{
  this->Superclass::SetVisibility(isVisible);
  if (!isVisible)
  {
    this->Textured->Hide();
  }
}

//----------------------------------------------------------------------------
bool vtkFullSurfaceRepresentation::AddToView(vtkView* view)
{
  this->Textured->SetView(vtkPVRenderView::SafeDownCast(view), this);
  return this->Superclass::AddToView(view);
}

//----------------------------------------------------------------------------
bool vtkFullSurfaceRepresentation::RemoveFromView(vtkView* view)
{
  this->Textured->SetView(nullptr, this);
  return this->Superclass::RemoveFromView(view);
}

//----------------------------------------------------------------------------
bool vtkFullSurfaceRepresentation::NeedsOrderedCompositing()
{
  return this->Property->GetOpacity() < 1.0 || !this->BlockOpacities.empty();
}

//----------------------------------------------------------------------------
void vtkFullSurfaceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
