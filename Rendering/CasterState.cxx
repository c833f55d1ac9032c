// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CasterState.h"
#include "CompositeMapper.h"
#include "vtkImpostorMapper.h"
#include "vtkLandscapePass.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationIdTypeKey.h"
#include "vtkMapper.h"
#include "vtkSmartPointer.h"

namespace littoral
{

namespace
{

/// Hash of numbers, FNV-1a.
struct Hash
{
  std::uint64_t Value = 14695981039346656037ULL;

  void Add(std::uint64_t number) { this->Value = (this->Value ^ number) * 1099511628211ULL; }
};

/// Whether a prop casts other shadows in coarse maps.
bool HasCoarseShape(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(vtkLandscapePass::COARSE_SHAPE());
}

/// Blocks that are hidden or translucent.
void AddBlocks(CompositeMapper* mapper, vtkDataObjectTree* tree, Hash& hash)
{
  vtkCompositeDataDisplayAttributes* attributes = mapper->GetCompositeDataDisplayAttributes();
  if (!tree || !attributes || !(attributes->HasBlockVisibilities() || attributes->HasBlockOpacities()))
  {
    return;
  }
  auto next = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  next->VisitOnlyLeavesOff();
  for (next->InitTraversal(); !next->IsDoneWithTraversal(); next->GoToNextItem())
  {
    vtkDataObject* block = next->GetCurrentDataObject();
    hash.Add(!attributes->HasBlockVisibility(block) || attributes->GetBlockVisibility(block));
    hash.Add(!attributes->HasBlockOpacity(block) || attributes->GetBlockOpacity(block) >= 1.0);
  }
}

/// Time of a mapper without that of its lookup table, and of what it draws.
void AddMapper(vtkMapper* mapper, Hash& hash)
{
  if (vtkAlgorithm* source = mapper->GetInputAlgorithm())
  {
    source->Update();
  }
  vtkDataObject* input = mapper->GetNumberOfInputConnections(0) > 0 ? mapper->GetInputDataObject(0, 0) : nullptr;
  hash.Add(mapper->vtkAbstractMapper::GetMTime());
  hash.Add(input ? input->GetMTime() : 0);
  if (auto* impostors = vtkImpostorMapper::SafeDownCast(mapper))
  {
    std::vector<vtkProp*> parts;
    for (int part = 0; part < impostors->GetNumberOfParts(); ++part)
    {
      parts.push_back(impostors->GetPart(part));
    }
    hash.Add(StateOf(parts));
  }
  if (auto* blocks = CompositeMapper::SafeDownCast(mapper))
  {
    AddBlocks(blocks, vtkDataObjectTree::SafeDownCast(input), hash);
  }
}

}

//----------------------------------------------------------------------------
bool CastsNothing(vtkProp* prop)
{
  return HasCoarseShape(prop) && prop->GetPropertyKeys()->Get(vtkLandscapePass::COARSE_SHAPE()) == 0;
}

//----------------------------------------------------------------------------
std::uint64_t StateOf(const std::vector<vtkProp*>& casters, bool isCoarse)
{
  Hash hash;
  for (vtkProp* prop : casters)
  {
    const double* bounds = prop->GetBounds();
    const bool isOther = isCoarse && HasCoarseShape(prop);
    if (!bounds || !vtkBoundingBox::IsValid(bounds) || (isOther && CastsNothing(prop)))
    {
      continue;
    }
    hash.Add(reinterpret_cast<std::uintptr_t>(prop));
    auto* actor = vtkActor::SafeDownCast(prop);
    hash.Add(actor ? prop->GetMTime() : prop->GetRedrawMTime());
    if (isOther)
    {
      hash.Add(prop->GetPropertyKeys()->Get(vtkLandscapePass::COARSE_SHAPE()));
    }
    else if (actor && actor->GetMapper())
    {
      AddMapper(actor->GetMapper(), hash);
    }
  }
  return hash.Value;
}

}
