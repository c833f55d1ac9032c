// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportInputs_h
#define LittoralSupportInputs_h

// Inputs by their types. VTK checks the type of an input that is no composite, and of none of the leaves that it hands
// to a filter one by one; nor does it check that arrays have a tuple for each point. Private: never installed, never
// wrapped.

#include "Numerics/InvalidInput.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <string>
#include <type_traits>
#include <vector>

namespace littoral
{

/// A type of data in words for a user.
template <typename Type>
constexpr const char* WordsForType()
{
  if constexpr (std::is_same_v<Type, vtkImageData>)
  {
    return "an image (vtkImageData)";
  }
  else if constexpr (std::is_same_v<Type, vtkTable>)
  {
    return "a table (vtkTable)";
  }
  else if constexpr (std::is_same_v<Type, vtkPolyData>)
  {
    return "polygonal data (vtkPolyData)";
  }
  else
  {
    static_assert(std::is_same_v<Type, vtkPointSet>, "a type without words");
    return "points (vtkPointSet)";
  }
}

/// Why an input is not of a type, in words for a user: "Terrain is a vtkTable; it must be an image (vtkImageData)."
std::string WhyOtherType(vtkDataObject* data, const char* input, const char* words);

/// Throws InvalidInput if parts of a data set, or of the leaves of a composite, do not fit each other: an array that
/// has not a tuple for each point or cell, two arrays of one name, points that are fewer than the grid has, an image at
/// no place.
void RequireFit(vtkDataObject* data, const char* input);

/// The input of a port, named as in the panel. Throws InvalidInput if it is of another type, if there is none, or if
/// its parts do not fit each other.
template <typename Type>
Type* InputOf(vtkInformationVector* inputs, const char* input)
{
  vtkDataObject* data = vtkDataObject::GetData(inputs);
  auto* typed = Type::SafeDownCast(data);
  Require(typed ? "" : WhyOtherType(data, input, WordsForType<Type>()));
  RequireFit(typed, input);
  return typed;
}

/// The same of a port to which nothing needs to be connected: null if nothing is.
template <typename Type>
Type* OptionalInputOf(vtkInformationVector* inputs, const char* input)
{
  return inputs->GetNumberOfInformationObjects() > 0 ? InputOf<Type>(inputs, input) : nullptr;
}

/// Throws InvalidInput unless an image is a raster: one layer in z of at least `least` points along x and y, with
/// spacings above 0.
void RequireRaster(vtkImageData* image, int least);

/// Throws InvalidInput if an image is turned by its direction matrix, for what takes rows to run along x and columns
/// along y.
void RequireUpright(vtkImageData* image, const char* input);

/// All leaves of a composite that have data; else the data themselves.
std::vector<vtkDataObject*> LeavesOf(vtkDataObject* data);

/// The leaves of an input that is a composite, else the input itself; leaves without data are left out. Throws
/// InvalidInput if one has another type, or parts that do not fit each other.
std::vector<vtkPointSet*> PointSetsOf(vtkDataObject* data, const char* input);

/// Data that PointSetsOf() has let pass, or a copy of them.
inline vtkPointSet* PointsIn(vtkDataObject* data)
{
  return vtkPointSet::SafeDownCast(data);
}

}

#endif
