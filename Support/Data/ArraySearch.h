// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportArraySearch_h
#define LittoralSupportArraySearch_h

// Looks through arrays of any type. Private: never installed, never wrapped.

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <cstddef>

namespace littoral
{

/// Whether a number is at least `Low` and below `High`.
struct IsWithin
{
  double Low;
  double High;

  template <typename Number>
  bool operator()(Number number) const
  {
    return static_cast<double>(number) >= this->Low && static_cast<double>(number) < this->High;
  }
};

/// The first of some values that is not good; `count` if all are. Many are looked at without a branch between them.
template <typename Value, typename IsGood>
std::size_t FirstOutside(const Value* values, std::size_t count, const IsGood& isGood)
{
  constexpr std::size_t Run = 512;
  for (std::size_t begin = 0; begin < count; begin += Run)
  {
    const std::size_t end = std::min(begin + Run, count);
    int bad = 0;
    for (std::size_t n = begin; n < end; ++n)
    {
      bad += !isGood(values[n]);
    }
    if (bad > 0)
    {
      return static_cast<std::size_t>(std::find_if_not(values + begin, values + end, isGood) - values);
    }
  }
  return count;
}

/// The first number of an array that is not good; negative if all are, or for null.
template <typename IsGood>
vtkIdType FirstOutside(vtkDataArray* array, const IsGood& isGood)
{
  const vtkIdType count = array ? array->GetNumberOfValues() : 0;
  vtkIdType first = count;
  const auto look = [&](auto* typed) {
    if (typed)
    {
      first = static_cast<vtkIdType>(FirstOutside(typed->GetPointer(0), static_cast<std::size_t>(count), isGood));
    }
    return typed != nullptr;
  };
  if (!array || look(vtkAOSDataArrayTemplate<float>::FastDownCast(array)) ||
    look(vtkAOSDataArrayTemplate<double>::FastDownCast(array)) ||
    look(vtkAOSDataArrayTemplate<int>::FastDownCast(array)) ||
    look(vtkAOSDataArrayTemplate<long>::FastDownCast(array)) ||
    look(vtkAOSDataArrayTemplate<long long>::FastDownCast(array)))
  {
    return first < count ? first : -1;
  }
  const int components = array->GetNumberOfComponents();
  for (vtkIdType value = 0; value < count; ++value)
  {
    if (!isGood(array->GetComponent(value / components, static_cast<int>(value % components))))
    {
      return value;
    }
  }
  return -1;
}

}

#endif
