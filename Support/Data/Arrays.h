// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportArrays_h
#define LittoralSupportArrays_h

// Arrays from numbers, and arrays and vectors that are about to be filled. Private: never installed, never wrapped.

#include "Numerics/Vector3.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkTypeTraits.h"

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

class vtkPoints;

namespace littoral
{

/// Sets the number of tuples of an array. Throws InvalidInput where there is no memory for them: VTK itself ends the
/// program, as distributions compile it.
void SetTuples(vtkAbstractArray* array, vtkIdType tuples);

/// Throws InvalidInput where there is no memory for so many values of a list.
void RequireMemoryOfList(double values, double bytesOfValue);

/// Sets the size of a vector by that of an input. Throws InvalidInput where there is no memory for it.
template <typename Value>
void SetSize(std::vector<Value>& values, vtkIdType size)
{
  RequireMemoryOfList(static_cast<double>(size), sizeof(Value));
  values.resize(static_cast<std::size_t>(size));
}

/// The numbers of an array, tuple by tuple. Throws InvalidInput where there is no memory for them.
template <typename Array>
std::vector<typename Array::ValueType> ListOf(Array* array)
{
  std::vector<typename Array::ValueType> values;
  SetSize(values, array->GetNumberOfValues());
  std::copy_n(array->GetPointer(0), values.size(), values.begin());
  return values;
}

/// The array itself if it lies in memory as numbers of the type, else a copy that does. Throws InvalidInput where there
/// is no memory for it.
vtkSmartPointer<vtkDataArray> WithType(vtkDataArray* array, int type);

template <typename Array>
vtkSmartPointer<Array> WithType(vtkDataArray* array)
{
  // VTK makes arrays of fixed width by type, of which a plain one is none.
  auto* same = Array::SafeDownCast(array);
  return same ? same : Array::SafeDownCast(WithType(array, vtkTypeTraits<typename Array::ValueType>::VTK_TYPE_ID));
}

/// An array with a name and room for tuples, not filled.
template <typename Array>
vtkSmartPointer<Array> NewArray(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  SetTuples(array, tuples);
  return array;
}

/// A point or cell array from tuples of numbers, each converted to the array's type.
template <typename Array, typename Tuples>
vtkSmartPointer<Array> ArrayOf(const char* name, int components, const Tuples& tuples)
{
  auto array = NewArray<Array>(name, components, static_cast<vtkIdType>(tuples.size()));
  auto* value = array->GetPointer(0);
  for (const auto& tuple : tuples)
  {
    for (int component = 0; component < components; ++component)
    {
      *value++ = static_cast<std::decay_t<decltype(*value)>>(tuple[component]);
    }
  }
  return array;
}

/// Single precision points [m].
vtkSmartPointer<vtkPoints> PointsOf(const std::vector<Vector3>& positions);

}

#endif
