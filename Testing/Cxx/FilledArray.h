// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilledArray_h
#define FilledArray_h

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

/// Adds a point array with the same value everywhere.
template <typename Array>
void AddFilled(vtkPointSet* set, const char* name, typename Array::ValueType value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(set->GetNumberOfPoints());
  array->FillValue(value);
  set->GetPointData()->AddArray(array);
}

#endif
