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

vtkSmartPointer<vtkDataArray> FrameArrays::Like(vtkDataArray* other, vtkIdType tuples)
{
  const int components = other->GetNumberOfComponents();
  vtkSmartPointer<vtkDataArray> array;
  for (vtkSmartPointer<vtkDataArray>& former : this->Former)
  {
    if (IsFree(former, components, tuples) && former->IsA(other->GetClassName()))
    {
      array = former;
      former = nullptr;
      array->SetNumberOfTuples(tuples);
      array->Modified();
      break;
    }
  }
  if (!array)
  {
    array.TakeReference(other->NewInstance());
    array->SetNumberOfComponents(components);
    SetTuples(array, tuples);
  }
  array->SetName(other->GetName());
  this->Given.push_back(array);
  return array;
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
