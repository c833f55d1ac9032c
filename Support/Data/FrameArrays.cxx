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
  const auto isUseless = [](const Frame& frame) { return !frame.Array || frame.Array->GetReferenceCount() == 1; };
  this->Former.erase(std::remove_if(this->Former.begin(), this->Former.end(), isUseless), this->Former.end());
}

vtkSmartPointer<vtkDataArray> FrameArrays::Like(vtkDataArray* other, vtkIdType tuples)
{
  const int components = other->GetNumberOfComponents();
  Pointer array = this->Take([&](const Frame& former) {
    return this->IsFree(former.Array, components, tuples) && former.Array->IsA(other->GetClassName());
  });
  if (!array)
  {
    array.TakeReference(other->NewInstance());
    array->SetNumberOfComponents(components);
  }
  SetTuples(array, tuples);
  array->SetName(other->GetName());
  this->Given.push_back({ array, nullptr, false, 0 });
  return array;
}

vtkSmartPointer<vtkFloatArray> FrameArrays::Like(vtkFloatArray* other)
{
  const int components = other->GetNumberOfComponents();
  const vtkIdType tuples = other->GetNumberOfTuples();
  long long number = 0;
  const Pointer own = this->Take([&](const Frame& former) {
    number = former.Number;
    return former.Model == other && this->IsFree(former.Array, components, tuples) &&
      former.Array->GetNumberOfTuples() == tuples && vtkFloatArray::SafeDownCast(former.Array);
  });
  if (own)
  {
    this->Given.push_back({ own, other, true, 0, number });
    return vtkFloatArray::SafeDownCast(own);
  }
  auto array = this->New<vtkFloatArray>(other->GetName(), components, tuples);
  this->Given.back().Model = other;
  return array;
}

bool FrameArrays::IsFormer(vtkDataArray* array) const
{
  return std::any_of(this->Given.begin(), this->Given.end(),
    [array](const Frame& given) { return given.IsFormer && given.Array == array; });
}

long long FrameArrays::NotedWith(vtkDataArray* array) const
{
  const auto given = std::find_if(
    this->Given.begin(), this->Given.end(), [array](const Frame& one) { return one.IsFormer && one.Array == array; });
  return given != this->Given.end() ? given->Number : 0;
}

void FrameArrays::Note(vtkDataArray* array, long long number)
{
  for (Frame& given : this->Given)
  {
    given.Number = given.Array == array ? number : given.Number;
  }
}

bool FrameArrays::IsFree(vtkDataArray* array, int components, vtkIdType tuples) const
{
  if (this->Overwrites && array && array->GetReferenceCount() > 1)
  {
    // Whoever holds it counts on its size.
    return array->GetNumberOfComponents() == components && array->GetNumberOfTuples() == tuples;
  }
  // One with room for twice as many would waste what it has beyond.
  const vtkIdType values = components * tuples;
  return array && array->GetReferenceCount() == 1 && array->GetNumberOfComponents() == components &&
    array->GetSize() >= values && array->GetSize() <= 2 * values;
}

}
