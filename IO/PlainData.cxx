// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlainData.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

namespace littoral
{

namespace
{

constexpr int KeepsMemory = 1;

vtkSmartPointer<vtkDataArray> PlainNumbers(vtkDataArray* array)
{
  auto plain = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType()));
  plain->SetNumberOfComponents(array->GetNumberOfComponents());
  plain->SetName(array->GetName());
  plain->SetVoidArray(array->GetVoidPointer(0), array->GetNumberOfValues(), KeepsMemory);
  return plain;
}

/// Numbers or texts; null for an array of other things.
vtkSmartPointer<vtkAbstractArray> PlainArray(vtkAbstractArray* array)
{
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    return PlainNumbers(numbers);
  }
  auto* texts = vtkStringArray::SafeDownCast(array);
  if (!texts)
  {
    return nullptr;
  }
  auto plain = vtkSmartPointer<vtkStringArray>::New();
  plain->SetName(texts->GetName());
  for (vtkIdType index = 0; index < texts->GetNumberOfValues(); ++index)
  {
    plain->InsertNextValue(texts->GetValue(index));
  }
  return plain;
}

void AddPlain(vtkFieldData* from, vtkFieldData* to)
{
  for (int index = 0; index < from->GetNumberOfArrays(); ++index)
  {
    if (const auto plain = PlainArray(from->GetAbstractArray(index)))
    {
      to->AddArray(plain);
    }
  }
}

}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> PlainFields(vtkFieldData* fields)
{
  auto plain = vtkSmartPointer<vtkPolyData>::New();
  AddPlain(fields, plain->GetFieldData());
  return plain;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> PlainData(vtkPolyData* data)
{
  const vtkSmartPointer<vtkPolyData> plain = PlainFields(data->GetFieldData());
  plain->CopyStructure(data);
  if (data->GetPoints())
  {
    vtkNew<vtkPoints> points;
    points->SetData(PlainNumbers(data->GetPoints()->GetData()));
    plain->SetPoints(points);
  }
  AddPlain(data->GetPointData(), plain->GetPointData());
  AddPlain(data->GetCellData(), plain->GetCellData());
  return plain;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkMultiBlockDataSet> PlainData(vtkMultiBlockDataSet* blocks)
{
  auto plain = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  plain->CopyStructure(blocks);
  for (unsigned int index = 0; index < blocks->GetNumberOfBlocks(); ++index)
  {
    vtkDataObject* block = blocks->GetBlock(index);
    if (auto* inner = vtkMultiBlockDataSet::SafeDownCast(block))
    {
      plain->SetBlock(index, PlainData(inner));
    }
    else if (auto* data = vtkPolyData::SafeDownCast(block))
    {
      plain->SetBlock(index, PlainData(data));
    }
  }
  return plain;
}

}
