// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Arrays.h"

#include "Numerics/ParameterCheck.h"
#include "Pipeline/Memory.h"

#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <string>

namespace littoral
{

void SetTuples(vtkAbstractArray* array, vtkIdType tuples)
{
  const vtkIdType values = tuples * array->GetNumberOfComponents();
  if (values > array->GetSize()) // to ask for free memory takes longer than to fill small arrays
  {
    const char* name = array->GetName();
    RequireMemory(static_cast<double>(values) * array->GetDataTypeSize(),
      name && *name ? "The array " + std::string(name) : "An array", "take less");
  }
  array->SetNumberOfTuples(tuples);
}

void RequireMemoryOfList(double values, double bytesOfValue)
{
  RequireMemory(values * bytesOfValue, "A list of " + TextOf(values) + " values", "take less");
}

vtkSmartPointer<vtkDataArray> WithType(vtkDataArray* array, int type)
{
  auto copy = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  if (array->IsA(copy->GetClassName()))
  {
    return array;
  }
  copy->SetName(array->GetName());
  copy->SetNumberOfComponents(array->GetNumberOfComponents());
  SetTuples(copy, array->GetNumberOfTuples());
  copy->DeepCopy(array);
  return copy;
}

vtkSmartPointer<vtkPoints> PointsOf(const std::vector<Vector3>& positions)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(ArrayOf<vtkFloatArray>("Points", 3, positions));
  return points;
}

}
