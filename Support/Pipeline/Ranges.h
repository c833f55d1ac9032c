// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportRanges_h
#define LittoralSupportRanges_h

#include "Numerics/Parallel.h"
#include "Numerics/Vector3.h"
#include "Numerics/VectorRange.h"

#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

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
  void AddTuples(const unsigned char* tuple, const unsigned char* end, int components);

  template <typename T>
  void AddTuples(const T* tuple, const T* end, int components)
  {
    if (components == 1)
    {
      this->AddNumbers(tuple, end);
      return;
    }
    if (components == 3)
    {
      this->AddTriples(tuple, end);
      return;
    }
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

  /// Numbers side by side, which the compiler makes vectors of.
  template <typename T>
  void AddNumbers(const T* number, const T* end)
  {
    constexpr int lanes = 16;
    if (end - number < 4 * lanes)
    {
      this->AddFewNumbers(number, end);
      return;
    }
    std::array<T, lanes> low;
    std::array<T, lanes> high;
    std::array<T, lanes> checks{}; // no number as soon as one of them is not finite
    low.fill(*number);
    high.fill(*number);
    const auto add = [&](int lane, T value) {
      low[lane] = value < low[lane] ? value : low[lane];
      high[lane] = value > high[lane] ? value : high[lane];
      checks[lane] = static_cast<T>(checks[lane] + (value - value)); // NOLINT(misc-redundant-expression)
    };
    for (; end - number >= lanes; number += lanes)
    {
      for (int lane = 0; lane < lanes; ++lane)
      {
        add(lane, number[lane]);
      }
    }
    for (; number != end; ++number)
    {
      add(0, *number);
    }
    for (int lane = 0; lane < lanes; ++lane)
    {
      this->Components[0].Add(static_cast<double>(low[lane]));
      this->Components[0].Add(static_cast<double>(high[lane]));
      this->AreFinite = this->AreFinite && checks[lane] == T{};
    }
  }

  /// The same one by one.
  template <typename T>
  void AddFewNumbers(const T* number, const T* end)
  {
    if (number == end)
    {
      return;
    }
    T low = *number;
    T high = *number;
    T check{}; // no number as soon as one of them is not finite
    for (; number != end; ++number)
    {
      low = *number < low ? *number : low;
      high = *number > high ? *number : high;
      check = static_cast<T>(check + (*number - *number)); // NOLINT(misc-redundant-expression)
    }
    this->Components[0].Add(static_cast<double>(low));
    this->Components[0].Add(static_cast<double>(high));
    this->AreFinite = this->AreFinite && check == T{};
  }

  template <typename T>
  void AddTriples(const T* triple, const T* end)
  {
    ValueRange x;
    ValueRange y;
    ValueRange z;
    ValueRange squared;
    double check = 0.0; // no number as soon as one of them is not finite
    for (; triple != end; triple += 3)
    {
      const double a = static_cast<double>(triple[0]);
      const double b = static_cast<double>(triple[1]);
      const double c = static_cast<double>(triple[2]);
      const double squares = a * a + b * b + c * c;
      x.Add(a);
      y.Add(b);
      z.Add(c);
      squared.Add(squares);
      check += squares - squares; // NOLINT(misc-redundant-expression)
    }
    this->Components[0].Add(x);
    this->Components[1].Add(y);
    this->Components[2].Add(z);
    this->SquaredLength.Add(squared);
    this->AreFinite = this->AreFinite && check == 0.0;
  }

  void Add(const TupleRanges& other);
};

/// Arrays of fewer tuples keep no ranges where nobody asks for them: to keep them takes longer than to find them.
constexpr long long FewTuples = 4096;

/// Keeps the ranges of an array that is complete. Those of arrays with values that are not finite are left to VTK.
void KeepRanges(vtkDataArray* array, const TupleRanges& ranges);

/// Keeps the ranges of an array that is complete and not short, from those of its parts.
void KeepRangesOfParts(vtkDataArray* array, const std::vector<TupleRanges>& parts);

/// Lets an array have the ranges that were kept with another one of the same values.
void ShareRanges(vtkDataArray* from, vtkDataArray* to);

/// The ranges of triples that are moved by a way as ShiftTriples() does it, which never changes their order. That of
/// the lengths is not known where they move.
TupleRanges ShiftedRanges(const TupleRanges& ranges, const Vector3& way, bool areSingle);

/// Keeps the ranges of triples, unless they are few, that are those of another array moved by a way. That of the
/// lengths is left to VTK.
void KeepShiftedRanges(vtkDataArray* from, const Vector3& way, vtkDataArray* to);

/// Finds the ranges of an array that is complete, unless they are there.
void KeepRanges(vtkDataArray* array);

/// Finds and keeps the ranges of an array of numbers in single or double precision, unless they are there; whether all
/// of them are finite.
bool KeepFiniteRanges(vtkDataArray* array);

/// Whether the ranges of an array of numbers in single or double precision, which it finds and keeps, are within a
/// magnitude.
bool AreWithin(vtkDataArray* array, double magnitude);

/// Points with these positions, whose ranges it finds unless they are there, or few. They are the bounds of the points,
/// for which VTK would look through them again.
vtkSmartPointer<vtkPoints> PointsWithRanges(vtkDataArray* positions);

/// Finds the ranges of all arrays, but short ones, and of the points of data that are complete: points, polygons,
/// blocks of them.
void KeepRanges(vtkDataObject* data, const Poll& onArray = NoPoll);

}

#endif
