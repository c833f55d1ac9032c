// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralThreads_h
#define LittoralThreads_h

#include "Numerics/Parallel.h"

#include "vtkSMPTools.h"

namespace littoral
{

/// Work of Common on VTK's threads, as a ParallelFor.
inline void OnThreads(std::size_t count, const RangeTask& work)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(count),
    [&](vtkIdType begin, vtkIdType end) { work(static_cast<std::size_t>(begin), static_cast<std::size_t>(end)); });
}

}

#endif
