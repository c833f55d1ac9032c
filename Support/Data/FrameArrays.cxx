// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/FrameArrays.h"

#include "vtkFloatArray.h"

#include <algorithm>

namespace littoral
{

void FrameArrays::BeginFrame()
{
  // What is free now, and was not given to the last frame, was of no use to it.
  const auto useless = [](vtkDataArray* array) { return !array || array->GetReferenceCount() == 1; };
  this->Former.erase(std::remove_if(this->Former.begin(), this->Former.end(), useless), this->Former.end());
  this->Former.insert(this->Former.end(), this->Given.begin(), this->Given.end());
  this->Given.clear();
}

vtkSmartPointer<vtkFloatArray> FrameArrays::Like(vtkFloatArray* other)
{
  return this->New<vtkFloatArray>(other->GetName(), other->GetNumberOfComponents(), other->GetNumberOfTuples());
}

bool FrameArrays::IsFree(vtkDataArray* array, int components, vtkIdType tuples)
{
  return array && array->GetReferenceCount() == 1 && array->GetNumberOfComponents() == components &&
    array->GetNumberOfTuples() == tuples;
}

}
