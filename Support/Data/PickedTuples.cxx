// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/PickedTuples.h"

#include "Data/Arrays.h"
#include "Pipeline/Pipeline.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"

#include <cstring>

namespace littoral
{

namespace
{

/// Tuples that one thread copies at a time.
constexpr std::size_t TuplesAtOnce = 1 << 14;

/// Bytes of a tuple where they lie side by side; 0 for strings, bits and arrays of another layout.
std::size_t TupleBytes(vtkAbstractArray* array)
{
  const bool isPlain = vtkDataArray::SafeDownCast(array) && array->HasStandardMemoryLayout();
  return isPlain ? static_cast<std::size_t>(array->GetNumberOfComponents()) * array->GetDataTypeSize() : 0;
}

}

void PickTuples(vtkDataSetAttributes* from, const std::vector<vtkIdType>& places, vtkDataSetAttributes* to)
{
  const auto count = static_cast<vtkIdType>(places.size());
  to->CopyAllOn();
  to->CopyAllocate(from, 1); // of their types; SetTuples makes the room
  for (int index = 0; index < from->GetNumberOfArrays(); ++index)
  {
    vtkAbstractArray* whole = from->GetAbstractArray(index);
    vtkAbstractArray* picked = to->GetAbstractArray(index);
    SetTuples(picked, count);
    const std::size_t bytes = TupleBytes(whole);
    if (bytes == 0)
    {
      for (vtkIdType n = 0; n < count; ++n)
      {
        picked->SetTuple(n, places[n], whole);
      }
      continue;
    }
    const auto* source = static_cast<const unsigned char*>(whole->GetVoidPointer(0));
    auto* target = static_cast<unsigned char*>(picked->GetVoidPointer(0));
    ForRanges(SmpFor, places.size(), TuplesAtOnce, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        std::memcpy(target + n * bytes, source + static_cast<std::size_t>(places[n]) * bytes, bytes);
      }
    });
  }
}

}
