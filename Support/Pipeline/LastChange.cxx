// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/LastChange.h"

#include "vtkDataAssembly.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <algorithm>

namespace littoral
{

vtkMTimeType LastChange(vtkDataObject* data)
{
  vtkMTimeType last = std::max(data->GetMTime(), data->GetFieldData()->GetMTime());
  const auto add = [&](vtkDataObject* part) { last = std::max(last, part ? LastChange(part) : 0); };
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    for (unsigned int index = 0; index < blocks->GetNumberOfBlocks(); ++index)
    {
      add(blocks->GetBlock(index));
    }
  }
  else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    last = std::max(last, collection->GetDataAssembly() ? collection->GetDataAssembly()->GetMTime() : 0);
    for (unsigned int index = 0; index < collection->GetNumberOfPartitionedDataSets(); ++index)
    {
      add(collection->GetPartitionedDataSet(index));
    }
  }
  else if (auto* parts = vtkPartitionedDataSet::SafeDownCast(data))
  {
    for (unsigned int index = 0; index < parts->GetNumberOfPartitions(); ++index)
    {
      add(parts->GetPartitionAsDataObject(index));
    }
  }
  return last;
}

DataStamp StampOf(vtkDataObject* data)
{
  return { data, data ? LastChange(data) : 0 };
}

}
