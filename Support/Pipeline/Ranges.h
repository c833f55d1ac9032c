// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportRanges_h
#define LittoralSupportRanges_h

#include "Numerics/VectorRange.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

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
  static constexpr int Most = 9; ///< components
  std::array<ValueRange, Most> Components;
  ValueRange SquaredLength;
  bool AreFinite = true;

  void Add(const VectorRange& vectors)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Components[c].Add(vectors.Low[c]);
      this->Components[c].Add(vectors.High[c]);
    }
    this->SquaredLength.Add(vectors.LeastSquare);
    this->SquaredLength.Add(vectors.MostSquare);
    this->AreFinite = this->AreFinite && vectors.IsFinite;
  }

  void AddTuples(const float* tuple, const float* end, int components)
  {
    if (components == 3)
    {
      this->Add(RangeOf(tuple, static_cast<std::size_t>(end - tuple) / 3));
      return;
    }
    this->AddTuples<float>(tuple, end, components);
  }

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

  void Add(const TupleRanges& other)
  {
    for (int c = 0; c < Most; ++c)
    {
      this->Components[c].Add(other.Components[c]);
    }
    this->SquaredLength.Add(other.SquaredLength);
    this->AreFinite = this->AreFinite && other.AreFinite;
  }
};

template <typename T>
TupleRanges RangesOf(const T* values, vtkIdType tuples, int components)
{
  vtkSMPThreadLocal<TupleRanges> local;
  vtkSMPTools::For(0, tuples, 65536, [&](vtkIdType begin, vtkIdType end) {
    local.Local().AddTuples(values + begin * components, values + end * components, components);
  });
  TupleRanges all;
  for (const TupleRanges& part : local)
  {
    all.Add(part);
  }
  return all;
}

inline void SetRange(vtkInformation* info, vtkInformationDoubleVectorKey* key, double low, double high)
{
  const double range[2] = { low, high };
  info->Set(key, range, 2);
}

/// Keeps the ranges of an array that is complete. Those of arrays with values that are not finite are left to VTK.
inline void KeepRanges(vtkDataArray* array, const TupleRanges& ranges)
{
  if (!ranges.AreFinite)
  {
    return;
  }
  const int components = array->GetNumberOfComponents();
  vtkInformation* info = array->GetInformation();
  for (vtkInformationInformationVectorKey* each :
    { vtkDataArray::PER_COMPONENT(), vtkDataArray::PER_FINITE_COMPONENT() })
  {
    auto all = vtkSmartPointer<vtkInformationVector>::New();
    all->SetNumberOfInformationObjects(components);
    for (int c = 0; c < components; ++c)
    {
      const ValueRange& range = ranges.Components[c];
      SetRange(all->GetInformationObject(c), vtkDataArray::COMPONENT_RANGE(), range.Low, range.High);
    }
    info->Set(each, all);
  }
  if (components > 1)
  {
    const ValueRange& squared = ranges.SquaredLength;
    for (vtkInformationDoubleVectorKey* key : { vtkDataArray::L2_NORM_RANGE(), vtkDataArray::L2_NORM_FINITE_RANGE() })
    {
      SetRange(info, key, std::sqrt(squared.Low), std::sqrt(squared.High));
    }
  }
}

/// Finds the ranges of an array that is complete, unless they are there.
inline void KeepRanges(vtkDataArray* array)
{
  const int components = array ? array->GetNumberOfComponents() : 0;
  const vtkIdType tuples = array ? array->GetNumberOfTuples() : 0;
  const bool isKnown =
    array && array->HasInformation() && array->GetInformation()->Has(vtkDataArray::PER_FINITE_COMPONENT());
  if (isKnown || tuples == 0 || components < 1 || components > TupleRanges::Most || !array->HasStandardMemoryLayout())
  {
    return;
  }
  switch (array->GetDataType())
  {
    vtkTemplateMacro(
      KeepRanges(array, RangesOf(static_cast<const VTK_TT*>(array->GetVoidPointer(0)), tuples, components)));
    default:
      return;
  }
}

/// Finds the ranges of all arrays and of the points of data that are complete: points, polygons, blocks of them.
inline void KeepRanges(vtkDataObject* data)
{
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    {
      KeepRanges(each->GetCurrentDataObject());
    }
    return;
  }
  auto* set = vtkPointSet::SafeDownCast(data);
  if (!set)
  {
    return;
  }
  if (set->GetPoints())
  {
    KeepRanges(set->GetPoints()->GetData());
  }
  for (vtkDataSetAttributes* fields :
    { static_cast<vtkDataSetAttributes*>(set->GetPointData()), static_cast<vtkDataSetAttributes*>(set->GetCellData()) })
  {
    for (int k = 0; k < fields->GetNumberOfArrays(); ++k)
    {
      KeepRanges(fields->GetArray(k));
    }
  }
}

}

#endif
