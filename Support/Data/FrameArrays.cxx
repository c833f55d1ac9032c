// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/FrameArrays.h"

#include "vtkFloatArray.h"

#include <algorithm>

namespace littoral
{

void FrameArrays::BeginFrame()
{
  this->Former.insert(this->Former.end(), this->Given.begin(), this->Given.end());
  this->Given.clear();
}

void FrameArrays::EndFrame()
{
  const auto isUseless = [](vtkDataArray* array) { return !array || array->GetReferenceCount() == 1; };
  this->Former.erase(std::remove_if(this->Former.begin(), this->Former.end(), isUseless), this->Former.end());
}

vtkSmartPointer<vtkFloatArray> FrameArrays::Like(vtkFloatArray* other)
{
  return this->New<vtkFloatArray>(other->GetName(), other->GetNumberOfComponents(), other->GetNumberOfTuples());
}

bool FrameArrays::IsFree(vtkDataArray* array, int components, vtkIdType tuples)
{
  // One with room for twice as many would waste what it has beyond.
  const vtkIdType values = components * tuples;
  return array && array->GetReferenceCount() == 1 && array->GetNumberOfComponents() == components &&
    array->GetSize() >= values && array->GetSize() <= 2 * values;
}

}
