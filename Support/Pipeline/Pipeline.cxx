// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/Pipeline.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformationVector.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace littoral
{

bool IsAborted(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220816)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

bool UpdateInputs(vtkAlgorithm* algorithm, int port)
{
  for (int connection = 0; connection < algorithm->GetNumberOfInputConnections(port); ++connection)
  {
    vtkAlgorithmOutput* input = algorithm->GetInputConnection(port, connection);
    auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(input->GetProducer()->GetExecutive());
    if (!pipeline || !pipeline->Update(input->GetIndex()))
    {
      return false;
    }
  }
  return true;
}

bool ForBatches(std::size_t count, const std::function<bool(std::size_t done)>& proceeds, const RangeTask& task)
{
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::duration<double> longest(0.05);
  const std::size_t smallest = NumberOfThreads();
  constexpr std::chrono::duration<double> shortest(1e-4); // of a part, which a call of a thread is small beside
  std::size_t batch = smallest;
  std::size_t shortPart = 1;
  for (std::size_t done = 0; done < count;)
  {
    if (!proceeds(done))
    {
      return false;
    }
    EndIfShortOfMemory();
    const std::size_t end = done + std::min(batch, count - done);
    // Small parts, for pieces of the same batch can take unlike times, and all threads wait for the last.
    const std::size_t grain = std::min(shortPart, std::max<std::size_t>(1, (end - done) / (8 * smallest)));
    const Clock::time_point begin = Clock::now();
    OnThreads(done, end, grain, task);
    const auto elapsed = Clock::now() - begin;
    // Short batches grow fast: each takes a call of the threads.
    const std::size_t growth = elapsed < longest / 24 ? 8 : elapsed < longest / 3 ? 2 : 1;
    const std::chrono::duration<double> piece = elapsed * smallest / static_cast<double>(end - done);
    shortPart = static_cast<std::size_t>(std::max(1.0, shortest / std::max(piece, shortest * 1e-6)));
    batch = elapsed > longest ? std::max(smallest, batch / 2) : growth * batch;
    done = end;
  }
  return true;
}

namespace
{

void EndIfAborted(vtkAlgorithm* algorithm, double progress)
{
  algorithm->UpdateProgress(progress); // lets the user ask
  if (IsAborted(algorithm))
  {
    throw Aborted();
  }
}

}

ParallelFor AbortableFor(vtkAlgorithm* algorithm)
{
  return AbortableFor(algorithm, 0.0, 0.0); // leaves progress as it is
}

ParallelFor AbortableFor(vtkAlgorithm* algorithm, double first, double last)
{
  return [=](std::size_t count, const RangeTask& task) {
    const auto proceeds = [=](std::size_t done) {
      const double reached = first + (last - first) * static_cast<double>(done) / static_cast<double>(count);
      EndIfAborted(algorithm, std::max(reached, algorithm->GetProgress()));
      return true;
    };
    ForBatches(count, proceeds, task);
  };
}

Poll PollOf(vtkAlgorithm* algorithm)
{
  using Clock = std::chrono::steady_clock;
  return [algorithm, last = Clock::now()]() mutable {
    const Clock::time_point now = Clock::now();
    if (algorithm->GetAbortExecute() || now - last > std::chrono::milliseconds(10))
    {
      last = now;
      EndIfShortOfMemory();
      EndIfAborted(algorithm, algorithm->GetProgress());
    }
  };
}

double RequestedTime(vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  return output->Has(Pipeline::UPDATE_TIME_STEP()) ? output->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
}

void AnnounceTimes(vtkInformation* output, double* range)
{
  output->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  output->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  if (range[0] < range[1])
  {
    output->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  }
}

void AnnounceTimesOf(vtkAlgorithm* algorithm, vtkInformationVector** inputs, vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  std::set<double> steps;
  double range[2] = { std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int index = 0; index < inputs[port]->GetNumberOfInformationObjects(); ++index)
    {
      vtkInformation* input = inputs[port]->GetInformationObject(index);
      if (input->Has(Pipeline::TIME_STEPS()))
      {
        const double* own = input->Get(Pipeline::TIME_STEPS());
        steps.insert(own, own + input->Length(Pipeline::TIME_STEPS()));
      }
      if (input->Has(Pipeline::TIME_RANGE()))
      {
        range[0] = std::min(range[0], input->Get(Pipeline::TIME_RANGE())[0]);
        range[1] = std::max(range[1], input->Get(Pipeline::TIME_RANGE())[1]);
      }
    }
  }
  AnnounceTimes(output, range);
  if (!steps.empty())
  {
    const std::vector<double> all(steps.begin(), steps.end());
    output->Set(Pipeline::TIME_STEPS(), all.data(), static_cast<int>(all.size()));
  }
}

bool NamesNoArray(vtkInformation* choice)
{
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  return name && (std::string(name).empty() || std::string(name) == "NULL");
}

bool NamesDefaultElevation(vtkInformation* choice)
{
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  return NamesNoArray(choice) || (name && std::string(name) == "Elevation");
}

vtkMTimeType PipelineTime(vtkAlgorithm* algorithm, int port, int connection)
{
  vtkAlgorithm* producer = algorithm->GetInputAlgorithm(port, connection);
  auto* executive = producer ? vtkDemandDrivenPipeline::SafeDownCast(producer->GetExecutive()) : nullptr;
  return executive ? executive->GetPipelineMTime() : 0;
}

PieceRange RequestedPart(vtkInformation* output, long long count)
{
  const int piece = output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  const int pieces = std::max(1, output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()));
  const auto bound = [&](long long part) {
    const long long within = std::clamp<long long>(part, 0, pieces);
    // count * within / pieces, without overflow
    return count / pieces * within + count % pieces * within / pieces;
  };
  // VTK asks for piece -1 where it knows of none.
  return { bound(std::max(0, piece)), bound(std::max(0, piece) + 1ll) };
}

void AnnounceParts(vtkInformation* output)
{
  output->Remove(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT());
  if (output->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    output->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  }
}

void RequestAll(vtkInformation* input)
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

void ForgetExtent(vtkInformation* output)
{
  int none[6] = { 0, -1, 0, -1, 0, -1 };
  output->Set(vtkStreamingDemandDrivenPipeline::COMBINED_UPDATE_EXTENT(), none, 6);
}

std::array<int, 6> RequestedExtent(vtkInformation* output)
{
  std::array<int, 6> extent;
  std::array<int, 6> whole;
  output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
  output->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole.data());
  for (int side = 0; side < 6; side += 2)
  {
    extent[side] = std::max(extent[side], whole[side]);
    extent[side + 1] = std::min(extent[side + 1], whole[side + 1]);
  }
  const bool isEmpty = extent[1] < extent[0] || extent[3] < extent[2] || extent[5] < extent[4];
  return isEmpty ? std::array<int, 6>{ 0, -1, 0, -1, 0, -1 } : extent;
}

}
