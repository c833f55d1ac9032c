// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportFrameArrays_h
#define LittoralSupportFrameArrays_h

// Memory that the frames of an animation take in turn. Private: never installed, never wrapped.

#include "Data/Arrays.h"

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
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
 * that of the picture on the screen, stays as it is. An array like another one is taken where that one's frames were,
 * if it can be: what never changes from frame to frame is there already. With SetOverwrites(true) the arrays of the
 * last frame are filled again whoever holds them: half the memory, where nobody needs a frame that has passed.
 */
class FrameArrays
{
public:
  using Pointer = vtkSmartPointer<vtkDataArray>;

  void SetOverwrites(bool overwrites) { this->Overwrites = overwrites; }

  /// A new frame begins: the arrays of the last one may be taken.
  void BeginFrame();

  /// The frame has all its arrays: free ones that it has not taken are given back.
  void EndFrame();

  /// An array with a name and room for tuples, not filled. One of a state other than 0 is taken where an array of the
  /// same state was, if it can be: IsFormer() tells whether it has the values of that one. New memory has room for
  /// spare tuples, too, so that it fits later frames of somewhat more.
  template <typename Array>
  vtkSmartPointer<Array> New(
    const char* name, int components, vtkIdType tuples, std::size_t state = 0, vtkIdType spare = 0)
  {
    const auto fits = [&](const Frame& former) {
      return this->IsFree(former.Array, components, tuples) && Array::SafeDownCast(former.Array);
    };
    const auto isOfState = [&](const Frame& former) { return former.State == state && fits(former); };
    auto array = vtkSmartPointer<Array>(state > 0 ? Array::SafeDownCast(this->Take(isOfState)) : nullptr);
    const bool isFormer = array != nullptr;
    if (!array)
    {
      array = Array::SafeDownCast(this->Take(fits));
    }
    if (!array)
    {
      array = NewArray<Array>(name, components, tuples + spare);
    }
    SetTuples(array, tuples);
    array->SetName(name);
    this->Given.push_back({ array, nullptr, isFormer, state });
    return array;
  }

  /// An array of the name and type of another one, with room for tuples, not filled.
  vtkSmartPointer<vtkDataArray> Like(vtkDataArray* other, vtkIdType tuples);

  /// An array of the same name and size, not filled but for what IsFormer() says.
  vtkSmartPointer<vtkFloatArray> Like(vtkFloatArray* other);

  /// Whether an array of this frame has the values of an earlier one that was like the same other, or of one state.
  bool IsFormer(vtkDataArray* array) const;

  /// The number that was noted with the values that an array of this frame has from an earlier one; 0: none.
  long long NotedWith(vtkDataArray* array) const;

  /// Notes a number with the values that an array of this frame gets.
  void Note(vtkDataArray* array, long long number);

private:
  /// An array, and the one that it is like.
  struct Frame
  {
    Pointer Array; ///< null where it was taken
    const vtkDataArray* Model = nullptr;
    bool IsFormer = false;
    std::size_t State = 0;
    long long Number = 0; ///< that was noted
  };
  std::vector<Frame> Former; ///< of earlier frames
  std::vector<Frame> Given;  ///< of this frame
  bool Overwrites = false;

  bool IsFree(vtkDataArray* array, int components, vtkIdType tuples) const;

  /// A former array of a kind, which VTK takes for modified: it drops the ranges of the former values. Null: none is.
  template <typename Kind>
  Pointer Take(const Kind& isOfKind)
  {
    for (Frame& former : this->Former)
    {
      if (isOfKind(former))
      {
        const Pointer array = former.Array;
        former.Array = nullptr;
        array->Modified();
        return array;
      }
    }
    return nullptr;
  }
};

/// Memory of a filter from frame to frame: its arrays, and an entry of each leaf of its input, by their order.
template <typename Entry>
class LeafFrames
{
public:
  FrameArrays Arrays;

  void BeginFrame()
  {
    this->Arrays.BeginFrame();
    this->Leaf = 0;
  }

  void EndFrame()
  {
    this->Arrays.EndFrame();
    this->Entries.resize(this->Leaf);
  }

protected:
  /// Entry of the next leaf.
  Entry& NextEntry()
  {
    this->Entries.resize(std::max(this->Entries.size(), this->Leaf + 1));
    return this->Entries[this->Leaf++];
  }

private:
  std::vector<Entry> Entries;
  std::size_t Leaf = 0; ///< that comes next
};

}

#endif
