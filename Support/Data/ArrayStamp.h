// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportArrayStamp_h
#define LittoralSupportArrayStamp_h

// Whether an array is that of the last execution. Private: never installed, never wrapped.

#include "vtkAbstractArray.h"

namespace littoral
{

/// An array as it was; modification times never repeat.
struct ArrayStamp
{
  vtkAbstractArray* Array = nullptr; ///< compared, never used
  vtkMTimeType Time = 0;
};

inline bool operator==(const ArrayStamp& a, const ArrayStamp& b)
{
  return a.Array == b.Array && a.Time == b.Time;
}

inline bool operator!=(const ArrayStamp& a, const ArrayStamp& b)
{
  return !(a == b);
}

/// The stamp of an array; null is allowed.
inline ArrayStamp StampOf(vtkAbstractArray* array)
{
  return { array, array ? array->GetMTime() : 0 };
}

}

#endif
