// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportPipeline_h
#define LittoralSupportPipeline_h

// Functions that the VTK classes share between the numerics and the pipeline. Private: never installed, never wrapped.

#include "Numerics/Parallel.h"
#include "Pipeline/Exceptions.h"
#include "Pipeline/Memory.h"
#include "Pipeline/Threads.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>

class vtkInformationVector;

namespace littoral
{

/// Whether the user asked to stop.
bool IsAborted(vtkAlgorithm* algorithm);

/**
 * Runs a task on 0 ... count-1 on all threads, in batches that take about 0.05 s each, for a user is to be heard ten
 * times a second. `proceeds(done)` is asked before each batch and stops the work by false; so does this function then.
 */
bool ForBatches(std::size_t count, const std::function<bool(std::size_t done)>& proceeds, const RangeTask& task);

/// SmpFor() that stops by Aborted when the user asks for it: for what takes long, not for the short steps of many.
ParallelFor AbortableFor(vtkAlgorithm* algorithm);

/// The same for a part of the work, with progress from first to last; a second loop does not take it back.
ParallelFor AbortableFor(vtkAlgorithm* algorithm, double first, double last);

/// Hears the user a hundred times a second, and ends the work by Aborted. Must be called by the thread of the request.
Poll PollOf(vtkAlgorithm* algorithm);

/// Runs pieces 0 ... count-1 in batches, between which progress is reported from first to last and an abort is noticed.
/// False when aborted.
template <typename Task>
bool RunWithProgress(vtkAlgorithm* algorithm, std::size_t count, double first, double last, const Task& task)
{
  const auto proceeds = [&](std::size_t done) {
    algorithm->UpdateProgress(first + (last - first) * static_cast<double>(done) / static_cast<double>(count));
    return !IsAborted(algorithm);
  };
  return ForBatches(count, proceeds, [&](std::size_t begin, std::size_t end) {
    for (std::size_t piece = begin; piece < end; ++piece)
    {
      task(piece);
    }
  });
}

/**
 * Asks the inputs at a port again, for what their informations ask for by now, while the algorithm executes: for times
 * or parts that it takes one after the other. VTK's own loop, CONTINUE_EXECUTING, never ends where an input fails.
 * False where one does. For within RequestData.
 */
bool UpdateInputs(vtkAlgorithm* algorithm, int port);

/// The time that is asked of an output [s]; 0 where none is.
double RequestedTime(vtkInformation* output);

/// Tells players of a range of times [s], any of which can be asked for; none if it is not increasing.
void AnnounceTimes(vtkInformation* output, double* range);

/// Tells the times of all inputs, at any port, as those of an output; VTK tells those of the first port alone, and does
/// not execute a filter for a time of the others.
void AnnounceTimesOf(vtkAlgorithm* algorithm, vtkInformationVector** inputs, vtkInformation* output);

/// Whether the name of a chosen array is an empty one: "" or "NULL", which ParaView passes until the input has data.
bool NamesNoArray(vtkInformation* choice);

/// Whether the active scalars stand in for a chosen elevation array that is absent: the name is empty or Elevation, the
/// default.
bool NamesDefaultElevation(vtkInformation* choice);

/// Time of the last change upstream of a connection.
vtkMTimeType PipelineTime(vtkAlgorithm* algorithm, int port, int connection);

/// Some of a row of things: from Begin up to End, which does not belong to it.
struct PieceRange
{
  long long Begin;
  long long End;
};

/// The part of `count` things that is asked of an output; none beyond the last piece.
PieceRange RequestedPart(vtkInformation* output, long long count);

/// Asks an input for all of its data, whatever piece is asked of the algorithm. Null (no input) is allowed.
void RequestAll(vtkInformation* input);

/// Announces that an output can be made in parts if it has an extent: VTK divides any output of which this is said.
void AnnounceParts(vtkInformation* output);

/**
 * Keeps an image's request from being joined to the next one if this one is refused: VTK asks for the box around both,
 * which may lie beyond what there is by then. For the beginning of RequestData.
 */
void ForgetExtent(vtkInformation* output);

/// The extent that is asked of an image, within the whole one: a request that failed at an input may have left VTK a
/// box beyond it. All that have no points are the same empty one: of others VTK computes numbers of points below 0.
std::array<int, 6> RequestedExtent(vtkInformation* output);

}

#endif
