// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Arrays.h"

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

}
