// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFullSurfaceRepresentation.h"

#include "BlockSurfaces.h"
#include "Instances.h"
#include "TexturedBlocks.h"
#include "vtkLandscapePass.h"

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVGeometryFilter.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <functional>

vtkStandardNewMacro(vtkFullSurfaceRepresentation);

namespace
{

using LeafFunction = std::function<bool(vtkDataObject*)>;

/// Calls a function with each visible leaf of a tree, or with data that are no tree; ends when it returns false.
/// Without attributes all are visible.
bool EachVisible(vtkDataObject* data, const vtkCompositeDataDisplayAttributes* attributes, const LeafFunction& function,
  bool isVisible = true)
{
  if (attributes && attributes->HasBlockVisibility(data))
  {
    isVisible = attributes->GetBlockVisibility(data);
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return !isVisible || function(data);
  }
  for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::SkipEmptyNodes))
  {
    if (!EachVisible(child, attributes, function, isVisible))
    {
      return false;
    }
  }
  return true;
}

/// Material of a data set, by its first part: polygons with elevations are a terrain, with a stretch the surface of a
/// sea, with a width of channels that of rivers.
int MaterialOf(vtkDataObject* data)
{
  int material = vtkLandscapePass::Surface;
  EachVisible(data, nullptr, [&](vtkDataObject* leaf) {
    auto* surface = vtkPolyData::SafeDownCast(leaf);
    if (surface && surface->GetNumberOfPolys() > 0)
    {
      vtkPointData* arrays = surface->GetPointData();
      material = arrays->HasArray("Jacobian") ? vtkLandscapePass::Water
        : arrays->HasArray("ChannelWidth")    ? vtkLandscapePass::River
        : arrays->HasArray("Elevation")       ? vtkLandscapePass::Ground
                                              : vtkLandscapePass::Surface;
    }
    return false;
  });
  return material;
}

}

//----------------------------------------------------------------------------
vtkFullSurfaceRepresentation::vtkFullSurfaceRepresentation()
  : Textured(std::make_unique<littoral::TexturedBlocks>())
{
  this->GeometryFilter->Delete();
  this->GeometryFilter = littoral::BlockSurfaces::New();
  this->SetupDefaults();
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
  if (request == vtkPVView::REQUEST_UPDATE() && this->GetVisibility())
  {
    this->Update();
    this->TakeBoundsOfPoints();
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
int vtkFullSurfaceRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (auto* surface = vtkPVGeometryFilter::SafeDownCast(this->GeometryFilter))
  {
    const bool isNumbered =
      input[0]->GetNumberOfInformationObjects() != 1 || !littoral::IsItsOwnSurface(vtkDataObject::GetData(input[0]));
    surface->SetPassThroughCellIds(isNumbered);
    surface->SetPassThroughPointIds(isNumbered);
  }
  return this->Superclass::RequestData(request, input, output);
}

//----------------------------------------------------------------------------
/// Sets the bounds of visible blocks, which the superclass would compute next; not where one is no polygonal data.
void vtkFullSurfaceRepresentation::TakeBoundsOfPoints()
{
  if (this->VisibleDataBoundsTime >= this->GetPipelineDataTime())
  {
    return;
  }
  vtkDataObject* data = this->MultiBlockMaker->GetOutputDataObject(0);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  this->PopulateBlockAttributes(attributes, data);
  vtkBoundingBox bounds;
  const littoral::InstancedBlocks instanced = littoral::InstancesIn(data);
  const auto add = [&](vtkDataObject* leaf) {
    auto* surface = vtkPolyData::SafeDownCast(leaf);
    if (surface && surface->GetNumberOfPoints() > 0 && instanced.Blocks.count(leaf) == 0)
    {
      bounds.AddBounds(surface->GetPoints()->GetBounds());
    }
    return surface != nullptr;
  };
  if (EachVisible(data, attributes, add))
  {
    for (const auto& pair : instanced.Pairs) // drawn whether their blocks are visible or not
    {
      bounds.AddBox(littoral::BatchOf(pair)->Bounds);
    }
    bounds.GetBounds(this->VisibleDataBounds);
    this->VisibleDataBoundsTime.Modified();
  }
}

//----------------------------------------------------------------------------
/// Leaves data with textures to their own actors, while this representation is visible.
void vtkFullSurfaceRepresentation::DrawTextures(bool attributesChanged)
{
  vtkMapper* mapper = this->Actor->GetEnableLOD() ? this->LODMapper : this->Mapper;
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  const int material = data ? MaterialOf(data) : vtkLandscapePass::Surface;
  if (this->Material != material)
  {
    this->Material = material;
    vtkLandscapePass::SetMaterial(this->Actor, material);
  }
  const auto take = [this](vtkCompositeDataDisplayAttributes* attributes, vtkDataObject* blocks) {
    this->PopulateBlockAttributes(attributes, blocks);
  };
  const bool isDrawn = data && this->Textured->Draw(data, this->Actor, mapper, attributesChanged, take);
  this->Actor->SetVisibility(!isDrawn);
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
