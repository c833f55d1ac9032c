// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Blocks.h"

#include "Data/Inputs.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"

#include <cstring>
#include <vector>

namespace littoral
{

namespace
{

/// The name of a data set of a collection; empty if it has none.
std::string DataSetName(vtkPartitionedDataSetCollection* collection, unsigned int index)
{
  const char* name =
    collection->HasMetaData(index) ? collection->GetMetaData(index)->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : "";
}

/// The only partition of a data set that there is; null if there is none.
vtkDataObject* OnlyPartition(vtkPartitionedDataSet* parts, const std::string& name)
{
  vtkDataObject* only = nullptr;
  for (unsigned int part = 0; parts && part < parts->GetNumberOfPartitions(); ++part)
  {
    vtkDataObject* one = parts->GetPartitionAsDataObject(part);
    Require(
      only && one ? "the data set '" + name + "' of the collection is in several partitions; it must be in one." : "");
    only = only ? only : one;
  }
  return only;
}

/// Appends what an assembly has in a node: data sets by their names, and nodes below it as blocks.
void AddNode(vtkPartitionedDataSetCollection* collection, int node, vtkMultiBlockDataSet* blocks)
{
  vtkDataAssembly* assembly = collection->GetDataAssembly();
  for (unsigned int index : assembly->GetDataSetIndices(node, false))
  {
    const std::string name = DataSetName(collection, index);
    AddBlock(blocks, name.c_str(), OnlyPartition(collection->GetPartitionedDataSet(index), name));
  }
  for (int child : assembly->GetChildNodes(node, false))
  {
    const std::string name = assembly->GetAttributeOrDefault(child, "label", assembly->GetNodeName(child));
    const std::vector<unsigned int> own = assembly->GetDataSetIndices(child, false);
    // VTK gives each leaf of a multiblock a node of its own, which has its name.
    if (own.size() == 1 && assembly->GetNumberOfChildren(child) == 0 && DataSetName(collection, own[0]) == name)
    {
      AddBlock(blocks, name.c_str(), OnlyPartition(collection->GetPartitionedDataSet(own[0]), name));
      continue;
    }
    vtkNew<vtkMultiBlockDataSet> below;
    AddNode(collection, child, below);
    AddBlock(blocks, name.c_str(), below);
  }
}

}

void AddBlock(vtkMultiBlockDataSet* blocks, const char* name, vtkDataObject* block)
{
  const unsigned int index = blocks->GetNumberOfBlocks();
  blocks->SetBlock(index, block);
  blocks->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), name);
}

vtkDataObject* FindBlock(vtkMultiBlockDataSet* blocks, const char* name)
{
  for (unsigned int index = 0; blocks && index < blocks->GetNumberOfBlocks(); ++index)
  {
    const char* own =
      blocks->HasMetaData(index) ? blocks->GetMetaData(index)->Get(vtkCompositeDataSet::NAME()) : nullptr;
    if (own && std::strcmp(own, name) == 0)
    {
      return blocks->GetBlock(index);
    }
  }
  return nullptr;
}

void ReplaceBlock(vtkMultiBlockDataSet* blocks, const char* name, vtkDataObject* data)
{
  for (unsigned int block = 0; block < blocks->GetNumberOfBlocks(); ++block)
  {
    const char* own = blocks->HasMetaData(block) ? blocks->GetMetaData(block)->Get(vtkCompositeDataSet::NAME()) : "";
    if (own && std::strcmp(own, name) == 0)
    {
      blocks->SetBlock(block, data);
    }
  }
}

void EmptyBlocks(vtkMultiBlockDataSet* blocks)
{
  for (unsigned int index = 0; index < blocks->GetNumberOfBlocks(); ++index)
  {
    vtkDataObject* block = blocks->GetBlock(index);
    if (auto* below = vtkMultiBlockDataSet::SafeDownCast(block))
    {
      EmptyBlocks(below);
    }
    else if (block)
    {
      blocks->SetBlock(index, vtkSmartPointer<vtkDataObject>::Take(block->NewInstance()));
    }
  }
}

vtkPartitionedDataSet* FindDataSet(vtkPartitionedDataSetCollection* collection, const char* name)
{
  for (unsigned int index = 0; collection && index < collection->GetNumberOfPartitionedDataSets(); ++index)
  {
    if (DataSetName(collection, index) == name)
    {
      return collection->GetPartitionedDataSet(index);
    }
  }
  return nullptr;
}

vtkSmartPointer<vtkMultiBlockDataSet> BlocksOf(vtkDataObject* data, const char* input)
{
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data);
  auto* multiblock = vtkMultiBlockDataSet::SafeDownCast(data);
  Require(collection || multiblock ? "" : WhyOtherType(data, input, "blocks (vtkMultiBlockDataSet)"));
  if (!collection)
  {
    return multiblock;
  }
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->GetFieldData()->ShallowCopy(collection->GetFieldData());
  if (collection->GetDataAssembly())
  {
    AddNode(collection, vtkDataAssembly::GetRootNode(), blocks);
    return blocks;
  }
  for (unsigned int index = 0; index < collection->GetNumberOfPartitionedDataSets(); ++index)
  {
    const std::string name = DataSetName(collection, index);
    AddBlock(blocks, name.c_str(), OnlyPartition(collection->GetPartitionedDataSet(index), name));
  }
  return blocks;
}

}
