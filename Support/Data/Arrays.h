// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportArrays_h
#define LittoralSupportArrays_h

// Arrays that are about to be filled. Private: never installed, never wrapped.

#include "vtkSmartPointer.h"
#include "vtkType.h"

namespace littoral
{

/// An array with a name and room for tuples, not filled.
template <typename Array>
vtkSmartPointer<Array> NewArray(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

}

#endif
