// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralBlocks_h
#define LittoralBlocks_h

// Named blocks. Private: never installed, never wrapped.

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"

#include <cstring>

namespace littoral
{

/// Appends a named block.
inline void AddBlock(vtkMultiBlockDataSet* blocks, const char* name, vtkDataObject* block)
{
  const unsigned int index = blocks->GetNumberOfBlocks();
  blocks->SetBlock(index, block);
  blocks->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), name);
}

/// The block of a name; null where there is none.
inline vtkDataObject* FindBlock(vtkMultiBlockDataSet* blocks, const char* name)
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

}

#endif
