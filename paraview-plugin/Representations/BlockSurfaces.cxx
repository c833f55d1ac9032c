// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockSurfaces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>

namespace littoral
{
namespace
{

bool IsOwnSurface(vtkDataObject* leaf)
{
  auto* surface = vtkPolyData::SafeDownCast(leaf);
  return surface && surface->GetNumberOfStrips() == 0 && !surface->HasAnyGhostCells();
}

/// Whether all branches of a tree are multiblock data, whose parts ParaView does not merge.
bool HasOnlyBlocks(vtkDataObjectTree* tree)
{
  const auto node = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  node->VisitOnlyLeavesOff();
  bool areBlocks = vtkMultiBlockDataSet::SafeDownCast(tree) != nullptr;
  for (node->InitTraversal(); areBlocks && !node->IsDoneWithTraversal(); node->GoToNextItem())
  {
    vtkDataObject* data = node->GetCurrentDataObject();
    areBlocks = !vtkDataObjectTree::SafeDownCast(data) || vtkMultiBlockDataSet::SafeDownCast(data);
  }
  return areBlocks;
}

/// Keeps the range of an array of one number where VTK, which would read all of it, looks first.
void KeepRange(double number, vtkDataArray* array)
{
  const double range[2] = { number, number };
  vtkNew<vtkInformationVector> ranges;
  ranges->SetNumberOfInformationObjects(1);
  ranges->GetInformationObject(0)->Set(vtkDataArray::COMPONENT_RANGE(), range, 2);
  array->GetInformation()->Set(vtkDataArray::PER_COMPONENT(), ranges);
  array->GetInformation()->Set(vtkDataArray::PER_FINITE_COMPONENT(), ranges);
}

/// An array of one number, as it was before if it had as many; in bytes where they can tell it.
vtkDataArray* Filled(vtkSmartPointer<vtkDataArray>& kept, const char* name, unsigned int number, vtkIdType size)
{
  if (!kept || kept->GetNumberOfTuples() != size)
  {
    kept = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(number <= VTK_UNSIGNED_CHAR_MAX ? VTK_UNSIGNED_CHAR : VTK_UNSIGNED_INT));
    kept->SetName(name);
    kept->SetNumberOfTuples(size);
    kept->Fill(number);
    KeepRange(number, kept);
  }
  return kept;
}

/// Adds the number that colors a block by its place among the leaves.
void AddColor(vtkPolyData* block, unsigned int number)
{
  vtkNew<vtkFieldData> fields;
  fields->PassData(block->GetFieldData());
  vtkNew<vtkUnsignedIntArray> color;
  color->SetName("vtkBlockColors");
  color->InsertNextValue(number);
  fields->AddArray(color);
  block->SetFieldData(fields);
}

}

vtkStandardNewMacro(BlockSurfaces);

//----------------------------------------------------------------------------
bool IsItsOwnSurface(vtkDataObject* data)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return data && IsOwnSurface(data);
  }
  const auto leaf = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  bool isOwn = true;
  for (leaf->InitTraversal(); isOwn && !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    isOwn = IsOwnSurface(leaf->GetCurrentDataObject());
  }
  return isOwn;
}

//----------------------------------------------------------------------------
int BlockSurfaces::RequestDataObjectTree(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* input = vtkDataObjectTree::GetData(inputVector[0], 0);
  auto* output = vtkDataObjectTree::GetData(outputVector, 0);
  const bool isAlone = !this->Controller || this->Controller->GetNumberOfProcesses() == 1;
  const bool isPlain = isAlone && !this->UseOutline && !this->GenerateFeatureEdges && !this->GenerateCellNormals &&
    !this->Triangulate && !this->GenerateProcessIds && !this->PassThroughCellIds && !this->PassThroughPointIds;
  if (!isPlain || !input || !output || !HasOnlyBlocks(input) || !IsItsOwnSurface(input))
  {
    this->Kept.clear();
    return this->Superclass::RequestDataObjectTree(request, inputVector, outputVector);
  }
  this->OutlineFlag = 0;
  output->CopyStructure(input);
  std::map<unsigned int, Numbers> kept;
  unsigned int place = 0; // among all leaves, with those that are empty
  const auto leaf = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(input->NewTreeIterator());
  leaf->SkipEmptyNodesOff();
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem(), ++place)
  {
    auto* block = vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject());
    if (!block || block->GetNumberOfPoints() == 0)
    {
      continue;
    }
    if (block->CheckAttributes())
    {
      return 0;
    }
    const unsigned int index = leaf->GetCurrentFlatIndex();
    Numbers& numbers = kept[index] = this->Kept[index];
    vtkNew<vtkPolyData> surface;
    surface->ShallowCopy(block);
    surface->GetPointData()->AddArray(Filled(numbers.OfPoints, "vtkCompositeIndex", index, block->GetNumberOfPoints()));
    surface->GetCellData()->AddArray(Filled(numbers.OfCells, "vtkCompositeIndex", index, block->GetNumberOfCells()));
    AddColor(surface, place % static_cast<unsigned int>(std::max(1, this->BlockColorsDistinctValues)));
    output->SetDataSet(leaf, surface);
  }
  this->Kept = kept;
  return 1;
}

}
