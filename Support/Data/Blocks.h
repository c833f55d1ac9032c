// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportBlocks_h
#define LittoralSupportBlocks_h

// Named blocks. Private: never installed, never wrapped.

#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkPartitionedDataSet;

namespace littoral
{

/// Appends a named block.
void AddBlock(vtkMultiBlockDataSet* blocks, const char* name, vtkDataObject* block);

/// The block of a name; null where there is none.
vtkDataObject* FindBlock(vtkMultiBlockDataSet* blocks, const char* name);

/// Puts a block in the place of that of the same name.
void ReplaceBlock(vtkMultiBlockDataSet* blocks, const char* name, vtkDataObject* data);

/// Takes the data out of all blocks. The blocks stay: ranks that draw data together must have the same ones.
void EmptyBlocks(vtkMultiBlockDataSet* blocks);

/// The partitions of a name in a collection; null where there are none.
vtkPartitionedDataSet* FindDataSet(vtkPartitionedDataSetCollection* collection, const char* name);

/// Input in blocks: a multiblock as it is, a collection as its assembly orders it, or in a row if it has none. Throws
/// InvalidInput, which names the input as in the panel, of anything else and of a data set in several partitions.
vtkSmartPointer<vtkMultiBlockDataSet> BlocksOf(vtkDataObject* data, const char* input);

}

#endif
