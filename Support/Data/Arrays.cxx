// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Arrays.h"

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"

namespace littoral
{

vtkSmartPointer<vtkPoints> PointsOf(const std::vector<Vector3>& positions)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(ArrayOf<vtkFloatArray>("Points", 3, positions));
  return points;
}

vtkSmartPointer<vtkFloatArray> FloatsLike(vtkFloatArray* other)
{
  return NewArray<vtkFloatArray>(other->GetName(), other->GetNumberOfComponents(), other->GetNumberOfTuples());
}

vtkDataArray* FieldArray(vtkDataObject* data, const char* name, int components, vtkIdType tuples)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  const bool fits =
    array && array->GetNumberOfComponents() == components && (tuples < 0 || array->GetNumberOfTuples() == tuples);
  return fits ? array : nullptr;
}

}
