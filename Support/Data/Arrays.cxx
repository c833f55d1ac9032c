// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Arrays.h"

#include "Pipeline/Memory.h"

#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <new>

namespace littoral
{

namespace
{

/// Sizes that need no look at the limits, and what is left for all else [bytes].
constexpr double Small = 0x1p20;

}

void SetTuples(vtkAbstractArray* array, vtkIdType tuples)
{
  const double bytes = static_cast<double>(tuples) * array->GetNumberOfComponents() * array->GetDataTypeSize();
  if (bytes > Small && bytes + Small > LimitedMemory())
  {
    throw std::bad_alloc();
  }
  array->SetNumberOfTuples(tuples);
}

vtkSmartPointer<vtkPoints> PointsOf(const std::vector<Vector3>& positions)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(ArrayOf<vtkFloatArray>("Points", 3, positions));
  return points;
}

}
