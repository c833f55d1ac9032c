// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Arrays.h"

#include "Pipeline/Memory.h"

#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <cstdint>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace littoral
{

namespace
{

/// Sizes that need no look at the limits, and what is left for all else [bytes].
constexpr double Small = 0x1p20;

}

void SetTuples(vtkAbstractArray* array, vtkIdType tuples)
{
  const double bytes = static_cast<double>(tuples) * array->GetNumberOfComponents() * array->GetDataTypeSize();
  if (bytes > Small && bytes + Small > LimitedMemory())
  {
    throw std::bad_alloc();
  }
  array->SetNumberOfTuples(tuples);
}

void PreferLargePages(vtkAbstractArray* array)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  const std::uintptr_t bytes = static_cast<std::uintptr_t>(array->GetSize()) * array->GetDataTypeSize();
  if (static_cast<double>(bytes) < Small)
  {
    return;
  }
  // Whole pages within the array; an error means that there are no large ones.
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto first = reinterpret_cast<std::uintptr_t>(array->GetVoidPointer(0));
  const std::uintptr_t begin = (first + page - 1) / page * page;
  const std::uintptr_t end = (first + bytes) / page * page;
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#else
  static_cast<void>(array);
#endif
}

vtkSmartPointer<vtkPoints> PointsOf(const std::vector<Vector3>& positions)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(ArrayOf<vtkFloatArray>("Points", 3, positions));
  return points;
}

vtkSmartPointer<vtkFloatArray> FloatsLike(vtkFloatArray* other)
{
  return NewArray<vtkFloatArray>(other->GetName(), other->GetNumberOfComponents(), other->GetNumberOfTuples());
}

}
