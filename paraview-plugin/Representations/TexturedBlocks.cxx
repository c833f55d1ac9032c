// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TexturedBlocks.h"

#include "BlockMapper.h"
#include "vtkLandscapeLightRepresentation.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProp.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace littoral
{
namespace
{

/// Surfaces without a texture that have an actor each.
constexpr std::size_t MostAlone = 16;

/// The branches of a tree, without its leaves.
PartOfTree Branches(vtkDataObjectTree* tree)
{
  const auto branches = vtkSmartPointer<vtkDataObjectTree>::Take(tree->NewInstance());
  branches->CopyStructure(tree);
  PartOfTree part;
  part.Tree = branches;
  part.Attributes = vtkSmartPointer<vtkCompositeDataDisplayAttributes>::New();
  return part;
}

/// Part of the light on the far side of a block of leaves that comes through, by the name of the block, as `Leaves` or
/// `0 High/Leaves`: all others let none through.
double TransmittanceOf(const std::string& name)
{
  constexpr double leaves = 0.4;
  const std::string last = name.substr(name.rfind('/') + 1); // all, if there is none
  return last == "Leaves" || last == "Crown" || last == "Low" ? leaves : 0.0;
}

/// Whether a block is the wood of a tree, by its name.
bool IsBark(const std::string& name)
{
  const std::string last = name.substr(name.rfind('/') + 1);
  return last == "Skin" || last == "Trunk";
}

/// Whether a light is on, or VTK will make one.
bool HasLights(vtkRenderer* renderer)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator next;
  lights->InitTraversal(next);
  while (vtkLight* light = lights->GetNextLight(next))
  {
    if (light->GetSwitch())
    {
      return true;
    }
  }
  return lights->GetNumberOfItems() == 0 && renderer->GetAutomaticLightCreation();
}

/// Whether a view has the light of sun and sky.
bool HasSun(vtkPVRenderView* view)
{
  for (int index = 0; index < view->GetNumberOfRepresentations(); ++index)
  {
    auto* light = vtkLandscapeLightRepresentation::SafeDownCast(view->GetRepresentation(index));
    if (light && light->GetVisibility())
    {
      return true;
    }
  }
  return false;
}

/// A block with its texture coordinates active: ParaView passes them on by their name alone.
vtkSmartPointer<vtkDataObject> WithCoordinates(vtkDataObject* block)
{
  auto copy = vtkSmartPointer<vtkDataObject>::Take(block->NewInstance());
  copy->ShallowCopy(block);
  vtkDataSetAttributes* points = copy->GetAttributes(vtkDataObject::POINT);
  if (points && !points->GetTCoords())
  {
    points->SetActiveTCoords("TCoords");
  }
  return copy;
}

}

//----------------------------------------------------------------------------
void TexturedBlocks::SetView(vtkPVRenderView* view, vtkPVDataRepresentation* representation)
{
  for (const auto& actor : this->Actors)
  {
    if (this->View)
    {
      this->View->GetRenderer()->RemoveViewProp(actor->GetProp());
      this->View->UnRegisterPropForHardwareSelection(representation, actor->GetProp());
    }
  }
  this->Actors.clear();
  this->Parts.clear();
  this->Data = nullptr;
  this->View = view;
  this->Representation = representation;
}

//----------------------------------------------------------------------------
bool TexturedBlocks::Draw(
  vtkDataObject* data, vtkActor* like, vtkMapper* mapper, bool attributesChanged, const TakeAttributes& take)
{
  const bool isDraped = like->GetTexture() || like->GetProperty()->GetNumberOfTextures() > 0;
  const bool dataChanged = this->Data != data || this->DataTime != data->GetMTime() || this->IsDraped != isDraped;
  if (dataChanged)
  {
    this->Split(data, isDraped);
  }
  while (this->View && this->Actors.size() < this->Parts.size())
  {
    this->AddActor();
  }
  const bool hasLights = this->View && HasLights(this->View->GetRenderer());
  const bool hasSun = this->View && HasSun(this->View);
  for (std::size_t index = 0; index < this->Actors.size(); ++index)
  {
    if (index >= this->Parts.size())
    {
      this->Actors[index]->Hide();
      continue;
    }
    PartOfTree part = this->Parts[index];
    if (!hasSun)
    {
      part.Plant.clear(); // without it the far level as it is
      part.FadeRange = { 0.0, 0.0 };
      part.InCoarseMaps = nullptr;
    }
    if (dataChanged || attributesChanged)
    {
      take(part.Attributes, part.Tree);
    }
    this->Actors[index]->Draw(part, like, mapper, hasLights);
  }
  return this->View && !this->Parts.empty();
}

//----------------------------------------------------------------------------
void TexturedBlocks::Hide()
{
  for (const auto& actor : this->Actors)
  {
    actor->Hide();
  }
}

//----------------------------------------------------------------------------
/// Each textured block, each prototype that has instances, each sea that has foam and each large surface without a
/// picture of the user's becomes a part of its own, and without any there are no parts. A few other surfaces are parts
/// of their own too; the rest is the first. Points of instances are not drawn.
void TexturedBlocks::Split(vtkDataObject* data, bool isDraped)
{
  this->IsDraped = isDraped;
  this->Data = data;
  this->DataTime = data->GetMTime();
  this->Parts.clear();
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return;
  }
  this->Parts.push_back(Branches(tree));
  std::size_t others = 0;
  const auto leaf = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  const InstancedBlocks instanced = InstancesIn(tree);
  std::map<vtkDataObject*, double> transmittances;
  std::set<vtkDataObject*> barks;
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    vtkSmartPointer<vtkDataObject> block = leaf->GetCurrentDataObject();
    vtkInformation* about = leaf->HasCurrentMetaData() ? leaf->GetCurrentMetaData() : nullptr;
    const char* name = about ? about->Get(vtkCompositeDataSet::NAME()) : nullptr;
    const double transmittance = TransmittanceOf(name ? name : "");
    if (instanced.Blocks.count(block) > 0)
    {
      transmittances[block] = transmittance;
      if (IsBark(name ? name : ""))
      {
        barks.insert(block);
      }
      continue;
    }
    const bool isTextured = BlockActor::IsTextured(block);
    const bool isAlone = isTextured || (vtkPolyData::SafeDownCast(block) && others++ < MostAlone);
    if (isTextured)
    {
      block = WithCoordinates(block);
    }
    if (isAlone)
    {
      this->Parts.push_back(Branches(tree));
      this->Parts.back().Textured = isTextured ? block : nullptr;
      this->Parts.back().Block = vtkPolyData::SafeDownCast(block);
      this->Parts.back().BlockIndex = leaf->GetCurrentFlatIndex();
      this->Parts.back().Transmittance = transmittance;
      this->Parts.back().IsBark = IsBark(name ? name : "");
    }
    PartOfTree& part = isAlone ? this->Parts.back() : this->Parts.front();
    vtkDataObjectTree::SafeDownCast(part.Tree)->SetDataSetFrom(leaf, block);
  }
  for (const InstancedBlocks::Pair& pair : instanced.Pairs)
  {
    PartOfTree part = Branches(tree);
    const auto block = WithCoordinates(pair.Prototype);
    part.Textured = BlockActor::IsTextured(block) ? block : nullptr;
    part.Prototype = vtkPolyData::SafeDownCast(block);
    part.Instances = BatchOf(pair);
    part.InCoarseMaps = CoarseBatchOf(pair);
    part.Transmittance = transmittances[pair.Prototype];
    part.IsBark = barks.count(pair.Prototype) > 0;
    for (vtkPolyData* near : MediumPlantOf(instanced, pair))
    {
      part.Plant.push_back({ vtkPolyData::SafeDownCast(WithCoordinates(near)), transmittances[near] });
    }
    part.FadeRange = FadeRangeOf(pair);
    part.Places = part.Plant.empty() ? nullptr : PlacesOf(pair);
    this->Parts.push_back(part);
  }
  const auto isSpecial = [isDraped](const PartOfTree& part) {
    vtkPointData* arrays = part.Block ? part.Block->GetPointData() : nullptr;
    const bool isLarge = part.Block && !isDraped && BlockMapper::HasManyCells(part.Block);
    return isLarge || part.Textured || part.Prototype ||
      (arrays && (arrays->HasArray("Jacobian") || arrays->HasArray("Bank")));
  };
  if (std::none_of(this->Parts.begin(), this->Parts.end(), isSpecial))
  {
    this->Parts.clear();
  }
}

//----------------------------------------------------------------------------
void TexturedBlocks::AddActor()
{
  this->Actors.push_back(std::make_unique<BlockActor>());
  this->View->GetRenderer()->AddViewProp(this->Actors.back()->GetProp());
  this->View->RegisterPropForHardwareSelection(this->Representation, this->Actors.back()->GetProp());
}

}
