// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/DataStamp.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataAssembly.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

namespace littoral
{

namespace
{

/// Adds what a data object is made of to a stamp.
class Stamper
{
public:
  explicit Stamper(DataStamp& stamp)
    : Stamp(stamp)
  {
  }

  void Add(vtkDataObject* data)
  {
    this->Add(data ? data->GetDataObjectType() : -1);
    if (!data)
    {
      return;
    }
    this->AddArrays(data->GetFieldData());
    if (auto* table = vtkTable::SafeDownCast(data))
    {
      this->AddAttributes(table->GetRowData());
    }
    else if (auto* set = vtkDataSet::SafeDownCast(data))
    {
      this->AddAttributes(set->GetPointData());
      this->AddAttributes(set->GetCellData());
      this->AddGeometry(set);
    }
    else if (!this->AddBlocks(data))
    {
      this->Add(static_cast<double>(data->GetMTime()));
    }
  }

private:
  DataStamp& Stamp;

  void Add(double number) { this->Stamp.Numbers.push_back(number); }
  void Add(vtkAbstractArray* array) { this->Stamp.Arrays.push_back(littoral::StampOf(array)); }

  void AddArrays(vtkFieldData* fields)
  {
    const int count = fields ? fields->GetNumberOfArrays() : 0;
    this->Add(count);
    for (int index = 0; index < count; ++index)
    {
      this->Add(fields->GetAbstractArray(index));
    }
  }

  void AddAttributes(vtkDataSetAttributes* attributes)
  {
    this->AddArrays(attributes);
    int indices[vtkDataSetAttributes::NUM_ATTRIBUTES];
    attributes->GetAttributeIndices(indices);
    std::copy(std::begin(indices), std::end(indices), std::back_inserter(this->Stamp.Numbers));
  }

  void AddCells(vtkCellArray* cells)
  {
    this->Add(cells->GetConnectivityArray());
    this->Add(cells->GetOffsetsArray());
  }

  void AddGeometry(vtkDataSet* set)
  {
    if (auto* image = vtkImageData::SafeDownCast(set))
    {
      std::copy_n(image->GetExtent(), 6, std::back_inserter(this->Stamp.Numbers));
      std::copy_n(image->GetOrigin(), 3, std::back_inserter(this->Stamp.Numbers));
      std::copy_n(image->GetSpacing(), 3, std::back_inserter(this->Stamp.Numbers));
      std::copy_n(image->GetDirectionMatrix()->GetData(), 9, std::back_inserter(this->Stamp.Numbers));
    }
    else if (auto* mesh = vtkPolyData::SafeDownCast(set))
    {
      this->Add(mesh->GetPoints() ? mesh->GetPoints()->GetData() : nullptr);
      for (vtkCellArray* cells : { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
      {
        this->AddCells(cells);
      }
    }
    else
    {
      this->Add(static_cast<double>(set->GetMTime()));
    }
  }

  void AddName(vtkInformation* info)
  {
    const char* name = info ? info->Get(vtkCompositeDataSet::NAME()) : nullptr;
    this->Stamp.Names.emplace_back(name ? name : "");
  }

  /// Adds blocks or partitions; false if data have none.
  bool AddBlocks(vtkDataObject* data)
  {
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
    {
      this->Add(blocks->GetNumberOfBlocks());
      for (unsigned int index = 0; index < blocks->GetNumberOfBlocks(); ++index)
      {
        this->AddName(blocks->HasMetaData(index) ? blocks->GetMetaData(index) : nullptr);
        this->Add(blocks->GetBlock(index));
      }
      return true;
    }
    if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
    {
      vtkDataAssembly* assembly = collection->GetDataAssembly();
      this->Add(assembly ? static_cast<double>(assembly->GetMTime()) : 0.0);
      this->Add(collection->GetNumberOfPartitionedDataSets());
      for (unsigned int index = 0; index < collection->GetNumberOfPartitionedDataSets(); ++index)
      {
        this->AddName(collection->HasMetaData(index) ? collection->GetMetaData(index) : nullptr);
        this->Add(collection->GetPartitionedDataSet(index));
      }
      return true;
    }
    auto* parts = vtkPartitionedDataSet::SafeDownCast(data);
    for (unsigned int index = 0; parts && index < parts->GetNumberOfPartitions(); ++index)
    {
      this->Add(parts->GetPartitionAsDataObject(index));
    }
    return parts != nullptr;
  }
};

}

DataStamp StampOf(vtkDataObject* data)
{
  DataStamp stamp;
  Stamper(stamp).Add(data);
  return stamp;
}

}
