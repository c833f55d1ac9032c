// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportPipeline_h
#define LittoralSupportPipeline_h

// What the VTK classes share between the numerics and the pipeline. Private: never installed, never wrapped.

#include "Numerics/Parallel.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVersionMacros.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <cstddef>

namespace littoral
{

/// The numerics' parallel loop on VTK's threads.
inline void SmpFor(std::size_t count, const RangeTask& task)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(count),
    [&](vtkIdType begin, vtkIdType end) { task(static_cast<std::size_t>(begin), static_cast<std::size_t>(end)); });
}

/// Whether the user asked to stop.
inline bool IsAborted(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220816)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

/**
 * Runs pieces 0 ... count-1 on all threads, in a few batches, between which progress is reported from first to last
 * and an abort is noticed. False when aborted.
 */
template <typename Task>
bool RunWithProgress(vtkAlgorithm* algorithm, std::size_t count, double first, double last, const Task& task)
{
  const std::size_t batch = std::max<std::size_t>(8, (count + 15) / 16);
  for (std::size_t done = 0; done < count; done += batch)
  {
    if (IsAborted(algorithm))
    {
      return false;
    }
    algorithm->UpdateProgress(first + (last - first) * done / count);
    const std::size_t end = std::min(count, done + batch);
    vtkSMPTools::For(static_cast<vtkIdType>(done), static_cast<vtkIdType>(end), 1, [&](vtkIdType a, vtkIdType b) {
      for (vtkIdType piece = a; piece < b; ++piece)
      {
        task(static_cast<std::size_t>(piece));
      }
    });
  }
  return true;
}

/// The time that is asked of an output [s]; 0 where none is.
inline double RequestedTime(vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  return output->Has(Pipeline::UPDATE_TIME_STEP()) ? output->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
}

/// Tells players of a range of times [s], any of which can be asked for; none if it is not increasing.
inline void AnnounceTimes(vtkInformation* output, double* range)
{
  output->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  if (range[0] < range[1])
  {
    output->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  }
}

/// When what is upstream of a connection changed last.
inline vtkMTimeType PipelineTime(vtkAlgorithm* algorithm, int port, int connection)
{
  vtkAlgorithm* producer = algorithm->GetInputAlgorithm(port, connection);
  auto* executive = producer ? vtkDemandDrivenPipeline::SafeDownCast(producer->GetExecutive()) : nullptr;
  return executive ? executive->GetPipelineMTime() : 0;
}

/// Asks an input for all of its data, whatever piece is asked of the algorithm. Null (no input) is allowed.
inline void RequestAll(vtkInformation* input)
{
  if (input)
  {
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    int whole[6];
    if (input->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT())) // an image
    {
      input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
      input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
    }
  }
}

/**
 * Keeps an image's request from being joined to the next one if this one is refused: VTK asks for the box around both,
 * which may lie beyond what there is by then. For the beginning of RequestData.
 */
inline void ForgetExtent(vtkInformation* output)
{
  int none[6] = { 0, -1, 0, -1, 0, -1 };
  output->Set(vtkStreamingDemandDrivenPipeline::COMBINED_UPDATE_EXTENT(), none, 6);
}

/// Memory that can be taken without driving others out [bytes].
inline double AvailableMemory()
{
  vtksys::SystemInformation system;
  return 0.9 * 1024.0 * static_cast<double>(system.GetHostMemoryTotal() - system.GetHostMemoryUsed());
}

}

#endif
