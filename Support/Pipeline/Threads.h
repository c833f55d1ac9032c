// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPipelineThreads_h
#define LittoralPipelineThreads_h

#include "Numerics/Parallel.h"

#include <cstddef>

namespace littoral
{

/// Number of threads of vtkSMPTools, at least 1.
std::size_t NumberOfThreads();

/**
 * Runs a task on [begin, end) on as many threads as vtkSMPTools has, in ranges of at least a grain where there is one.
 * The first exception of a range is thrown on. With TBB the threads are those of TBB, which wait for the next loop:
 * vtkSMPTools of VTK 9.1 starts new ones for each loop, which takes some 0.1 ms. A loop within a range is serial.
 */
void OnThreads(std::size_t begin, std::size_t end, std::size_t grain, const RangeTask& task);

/// The numerics' parallel loop on these threads.
void SmpFor(std::size_t count, const RangeTask& task);

}

#endif
