// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/Ranges.h"

#include "Pipeline/SharedKey.h"
#include "Pipeline/Threads.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationIdTypeKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace littoral
{
namespace
{

template <typename T>
TupleRanges RangesOf(const T* values, vtkIdType tuples, int components)
{
  constexpr vtkIdType atOnce = 65536;
  constexpr std::size_t few = 1 << 20; // some 0.1 ms: threads would take as long
  TupleRanges all;
  if (static_cast<std::size_t>(tuples * components) * sizeof(T) <= few)
  {
    all.AddTuples(values, values + tuples * components, components);
    return all;
  }
  std::vector<TupleRanges> parts((tuples + atOnce - 1) / atOnce);
  ForRanges(SmpFor, tuples, atOnce, [&](std::size_t begin, std::size_t end) {
    parts[begin / atOnce].AddTuples(values + begin * components, values + end * components, components);
  });
  for (const TupleRanges& part : parts)
  {
    all.Add(part);
  }
  return all;
}

/// Ranges of an array of numbers in single or double precision.
TupleRanges RangesOfReals(vtkDataArray* array)
{
  const auto find = [array](const auto* values) {
    return RangesOf(values, array->GetNumberOfTuples(), array->GetNumberOfComponents());
  };
  const void* values = array->GetVoidPointer(0);
  return array->GetDataType() == VTK_FLOAT ? find(static_cast<const float*>(values))
                                           : find(static_cast<const double*>(values));
}

/// Keeps the ranges of an array that is not short.
void KeepUnlessFew(vtkDataArray* array)
{
  if (array && array->GetNumberOfTuples() >= FewTuples)
  {
    KeepRanges(array);
  }
}

void SetRange(vtkInformation* info, vtkInformationDoubleVectorKey* key, double low, double high)
{
  const double range[2] = { low, high };
  info->Set(key, range, 2);
}

/// The modification time of an array when ranges of finite values were kept with it: VTK's own may leave some out.
vtkInformationIdTypeKey* FiniteTime()
{
  static auto* key = SharedKey<vtkInformationIdTypeKey>("FINITE_TIME");
  return key;
}

/// Known from the start, as arrays of other ranks may come with it.
[[maybe_unused]] const vtkInformationIdTypeKey* const EarlyKey = FiniteTime();

bool HasFiniteRanges(vtkDataArray* array)
{
  vtkInformation* info = array->HasInformation() ? array->GetInformation() : nullptr;
  return info && info->Has(vtkDataArray::PER_FINITE_COMPONENT()) && info->Has(FiniteTime()) &&
    info->Get(FiniteTime()) == static_cast<vtkIdType>(array->GetMTime());
}

/// Points whose bounds are the ranges of their array.
class RangedPoints : public vtkPoints
{
public:
  static RangedPoints* New() { VTK_STANDARD_NEW_BODY(RangedPoints); }

  /// As SetData(), which would tell the array that it is modified; it would drop its ranges.
  void Take(vtkDataArray* positions)
  {
    positions->Register(this);
    this->Data->UnRegister(this);
    this->Data = positions;
  }

  void ComputeBounds() override
  {
    if (this->GetNumberOfPoints() == 0)
    {
      this->vtkPoints::ComputeBounds();
    }
    else if (this->GetMTime() > this->ComputeTime)
    {
      double* range = this->Bounds;
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Data->GetRange(range, axis);
        range += 2;
      }
      this->ComputeTime.Modified();
    }
  }
};

}

void TupleRanges::Add(const VectorRange& vectors, int components)
{
  for (int c = 0; c < components; ++c)
  {
    this->Components[c].Add(ValueRange{ vectors.Low[c], vectors.High[c] });
  }
  this->SquaredLength.Add(ValueRange{ vectors.MinimumSquare, vectors.MaximumSquare });
  this->AreFinite = this->AreFinite && vectors.IsFinite;
}

void TupleRanges::AddTuples(const float* tuple, const float* end, int components)
{
  if (tuple != end && (components == 2 || components == 3))
  {
    const std::size_t count = static_cast<std::size_t>(end - tuple) / static_cast<std::size_t>(components);
    this->Add(components == 3 ? RangeOf(tuple, count) : RangeOfPairs(tuple, count), components);
    return;
  }
  this->AddTuples<float>(tuple, end, components);
}

void TupleRanges::AddTuples(const unsigned char* tuple, const unsigned char* end, int components)
{
  if (tuple != end && components == 3)
  {
    this->Add(RangeOfBytes(tuple, static_cast<std::size_t>(end - tuple) / 3), 3);
    return;
  }
  this->AddTuples<unsigned char>(tuple, end, components);
}

void TupleRanges::Add(const TupleRanges& other)
{
  for (int c = 0; c < MaximumComponents; ++c)
  {
    this->Components[c].Add(other.Components[c]);
  }
  this->SquaredLength.Add(other.SquaredLength);
  this->AreFinite = this->AreFinite && other.AreFinite;
}

void KeepRanges(vtkDataArray* array, const TupleRanges& ranges)
{
  if (!ranges.AreFinite)
  {
    return;
  }
  const int components = array->GetNumberOfComponents();
  vtkInformation* info = array->GetInformation();
  // Those of all values are those of the finite ones: one list for both, which nobody changes.
  auto all = vtkSmartPointer<vtkInformationVector>::New();
  all->SetNumberOfInformationObjects(components);
  for (int c = 0; c < components; ++c)
  {
    const ValueRange& range = ranges.Components[c];
    SetRange(all->GetInformationObject(c), vtkDataArray::COMPONENT_RANGE(), range.Low, range.High);
  }
  info->Set(vtkDataArray::PER_COMPONENT(), all);
  info->Set(vtkDataArray::PER_FINITE_COMPONENT(), all);
  const ValueRange& squared = ranges.SquaredLength;
  if (components > 1 && squared.Low <= squared.High)
  {
    for (vtkInformationDoubleVectorKey* key : { vtkDataArray::L2_NORM_RANGE(), vtkDataArray::L2_NORM_FINITE_RANGE() })
    {
      SetRange(info, key, std::sqrt(squared.Low), std::sqrt(squared.High));
    }
  }
  info->Set(FiniteTime(), static_cast<vtkIdType>(array->GetMTime()));
}

void KeepRangesOfParts(vtkDataArray* array, const std::vector<TupleRanges>& parts)
{
  if (array->GetNumberOfTuples() >= FewTuples)
  {
    TupleRanges all;
    std::for_each(parts.begin(), parts.end(), [&](const TupleRanges& part) { all.Add(part); });
    KeepRanges(array, all);
  }
}

void ShareRanges(vtkDataArray* from, vtkDataArray* to)
{
  if (!HasFiniteRanges(from))
  {
    return;
  }
  vtkInformation* info = to->GetInformation();
  for (vtkInformationInformationVectorKey* each :
    { vtkDataArray::PER_COMPONENT(), vtkDataArray::PER_FINITE_COMPONENT() })
  {
    info->Set(each, from->GetInformation()->Get(each));
  }
  for (vtkInformationDoubleVectorKey* key : { vtkDataArray::L2_NORM_RANGE(), vtkDataArray::L2_NORM_FINITE_RANGE() })
  {
    info->CopyEntry(from->GetInformation(), key);
  }
  info->Set(FiniteTime(), static_cast<vtkIdType>(to->GetMTime()));
}

TupleRanges ShiftedRanges(const TupleRanges& ranges, const Vector3& way, bool areSingle)
{
  if (way == Vector3(0.0))
  {
    return ranges;
  }
  const auto rounded = [areSingle](double x) { return areSingle ? static_cast<float>(x) : x; };
  TupleRanges shifted;
  shifted.AreFinite = ranges.AreFinite;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double value : { ranges.Components[axis].Low, ranges.Components[axis].High })
    {
      shifted.Components[axis].Add(rounded(value + way[axis]));
      shifted.AreFinite = shifted.AreFinite && std::isfinite(rounded(value + way[axis]));
    }
  }
  return shifted;
}

void KeepShiftedRanges(vtkDataArray* from, const Vector3& way, vtkDataArray* to)
{
  if (to->GetNumberOfTuples() < FewTuples || !KeepFiniteRanges(from))
  {
    return;
  }
  TupleRanges ranges;
  for (int axis = 0; axis < 3; ++axis)
  {
    ranges.Components[axis] = { from->GetRange(axis)[0], from->GetRange(axis)[1] };
  }
  KeepRanges(to, ShiftedRanges(ranges, way, to->GetDataType() == VTK_FLOAT));
}

void KeepRanges(vtkDataArray* array)
{
  const int components = array ? array->GetNumberOfComponents() : 0;
  const vtkIdType tuples = array ? array->GetNumberOfTuples() : 0;
  const bool isKnown =
    array && array->HasInformation() && array->GetInformation()->Has(vtkDataArray::PER_FINITE_COMPONENT());
  if (isKnown || tuples == 0 || components < 1 || components > TupleRanges::MaximumComponents ||
    !array->HasStandardMemoryLayout())
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

bool KeepFiniteRanges(vtkDataArray* array)
{
  if (HasFiniteRanges(array))
  {
    return true;
  }
  const TupleRanges ranges = RangesOfReals(array);
  KeepRanges(array, ranges);
  return ranges.AreFinite;
}

bool AreWithin(vtkDataArray* array, double magnitude)
{
  if (array->GetNumberOfTuples() < FewTuples && !HasFiniteRanges(array))
  {
    const TupleRanges ranges = RangesOfReals(array);
    const auto* end = ranges.Components.data() + array->GetNumberOfComponents();
    return ranges.AreFinite && std::all_of(ranges.Components.data(), end, [=](const ValueRange& range) {
      return range.Low >= -magnitude && range.High <= magnitude;
    });
  }
  bool isWithin = KeepFiniteRanges(array);
  for (int axis = 0; isWithin && axis < array->GetNumberOfComponents(); ++axis)
  {
    const double* range = array->GetRange(axis);
    isWithin = range[0] >= -magnitude && range[1] <= magnitude;
  }
  return isWithin;
}

vtkSmartPointer<vtkPoints> PointsWithRanges(vtkDataArray* positions)
{
  KeepUnlessFew(positions);
  const auto points = vtkSmartPointer<RangedPoints>::New();
  points->Take(positions);
  return points;
}

void KeepRanges(vtkDataObject* data, const Poll& onArray)
{
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    {
      KeepRanges(each->GetCurrentDataObject(), onArray);
    }
    return;
  }
  auto* set = vtkPointSet::SafeDownCast(data);
  if (!set)
  {
    return;
  }
  if (set->GetNumberOfPoints() > 0 && !dynamic_cast<RangedPoints*>(set->GetPoints()))
  {
    set->SetPoints(PointsWithRanges(set->GetPoints()->GetData()));
  }
  for (vtkDataSetAttributes* fields :
    { static_cast<vtkDataSetAttributes*>(set->GetPointData()), static_cast<vtkDataSetAttributes*>(set->GetCellData()) })
  {
    for (int k = 0; k < fields->GetNumberOfArrays(); ++k)
    {
      onArray();
      KeepUnlessFew(fields->GetArray(k));
    }
  }
}

}
