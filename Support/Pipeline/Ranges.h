// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportRanges_h
#define LittoralSupportRanges_h

#include "Numerics/Parallel.h"
#include "Numerics/VectorRange.h"

#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

class vtkDataArray;
class vtkDataObject;
class vtkPoints;

// ParaView asks each array of each update for its ranges, by component and of its length. VTK finds them once and keeps
// them with the array, but slowly: for a forest that follows the camera it is most of the time. Here they are found in
// one pass over memory and kept where VTK looks for them. VTK drops them when an array is modified, as it drops its
// own.

namespace littoral
{

/// Smallest and largest values.
struct ValueRange
{
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();

  void Add(double value)
  {
    this->Low = std::min(this->Low, value);
    this->High = std::max(this->High, value);
  }
  void Add(const ValueRange& other)
  {
    this->Low = std::min(this->Low, other.Low);
    this->High = std::max(this->High, other.High);
  }
};

/// Ranges of the components of an array, and of the squared length of its tuples.
struct TupleRanges
{
  static constexpr int MaximumComponents = 9; ///< components
  std::array<ValueRange, MaximumComponents> Components;
  ValueRange SquaredLength;
  bool AreFinite = true;

  void Add(const VectorRange& vectors, int components);

  void AddTuples(const float* tuple, const float* end, int components);

  template <typename T>
  void AddTuples(const T* tuple, const T* end, int components)
  {
    for (; tuple != end; tuple += components)
    {
      double squares = 0.0;
      for (int c = 0; c < components; ++c)
      {
        const double value = static_cast<double>(tuple[c]);
        this->Components[c].Add(value);
        squares += value * value;
      }
      this->SquaredLength.Add(squares);
      this->AreFinite = this->AreFinite && std::isfinite(squares);
    }
  }

  void Add(const TupleRanges& other);
};

/// Keeps the ranges of an array that is complete. Those of arrays with values that are not finite are left to VTK.
void KeepRanges(vtkDataArray* array, const TupleRanges& ranges);

/// Finds the ranges of an array that is complete, unless they are there.
void KeepRanges(vtkDataArray* array);

/// Finds and keeps the ranges of an array of numbers in single or double precision; whether all of them are finite.
bool KeepFiniteRanges(vtkDataArray* array);

/// Points with these positions, whose ranges it finds unless they are there. They are the bounds of the points, for
/// which VTK would look through them again.
vtkSmartPointer<vtkPoints> PointsWithRanges(vtkDataArray* positions);

/// Finds the ranges of all arrays and of the points of data that are complete: points, polygons, blocks of them.
void KeepRanges(vtkDataObject* data, const Poll& onArray = NoPoll);

}

#endif
