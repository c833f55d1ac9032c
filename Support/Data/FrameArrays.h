// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportFrameArrays_h
#define LittoralSupportFrameArrays_h

// Memory that the frames of an animation take in turn. Private: never installed, never wrapped.

#include "Data/Arrays.h"

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkFloatArray;

namespace littoral
{

/// An array that shares the numbers of another one, which is not filled again as long as this one is there.
template <typename Array>
class SharedArray : public Array
{
public:
  static SharedArray* New() { VTK_STANDARD_NEW_BODY(SharedArray); }

  void Share(Array* other)
  {
    this->ShallowCopy(other);
    this->Other = other;
  }

private:
  vtkSmartPointer<Array> Other;
};

/**
 * Arrays that a filter fills anew for each frame. An array that nobody else holds any more is filled again: new memory
 * costs a page fault for each 4 KiB, which takes as long as to move the points in it. An array that is still held, as
 * that of the picture on the screen, stays as it is.
 */
class FrameArrays
{
public:
  /// A new frame begins: the arrays of the last one may be taken.
  void BeginFrame();

  /// The frame has all its arrays: free ones that it has not taken are given back.
  void EndFrame();

  /// An array with a name and room for tuples, not filled.
  template <typename Array>
  vtkSmartPointer<Array> New(const char* name, int components, vtkIdType tuples)
  {
    vtkSmartPointer<Array> array;
    for (vtkSmartPointer<vtkDataArray>& former : this->Former)
    {
      if (IsFree(former, components, tuples) && Array::SafeDownCast(former))
      {
        array = Array::SafeDownCast(former);
        former = nullptr;
        array->SetNumberOfTuples(tuples);
        array->Modified(); // VTK drops the ranges of its former values
        break;
      }
    }
    if (!array)
    {
      array = NewArray<Array>(name, components, tuples);
    }
    array->SetName(name);
    this->Given.push_back(array);
    return array;
  }

  /// An array of the name and type of another one, with room for tuples, not filled.
  vtkSmartPointer<vtkDataArray> Like(vtkDataArray* other, vtkIdType tuples);

  /// An array of the same name and size, not filled.
  vtkSmartPointer<vtkFloatArray> Like(vtkFloatArray* other);

private:
  std::vector<vtkSmartPointer<vtkDataArray>> Former; ///< of earlier frames; null where one was taken
  std::vector<vtkSmartPointer<vtkDataArray>> Given;  ///< of this frame

  static bool IsFree(vtkDataArray* array, int components, vtkIdType tuples);
};

}

#endif
