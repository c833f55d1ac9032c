// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WriterRanks.h"

#include "Numerics/InvalidInput.h"
#include "Pipeline/FailedInput.h"
#include "Pipeline/Pipeline.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace littoral
{

namespace
{

constexpr int ReasonTag = 78130;

void AskForPiece(vtkInformation* input, int piece, int pieces)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

}

//----------------------------------------------------------------------------
WriterRanks::WriterRanks(vtkMultiProcessController* controller)
  : Controller(controller)
{
}

//----------------------------------------------------------------------------
bool WriterRanks::IsAlone() const
{
  return this->GetNumberOfRanks() < 2;
}

//----------------------------------------------------------------------------
int WriterRanks::GetRank() const
{
  return this->Controller ? this->Controller->GetLocalProcessId() : 0;
}

//----------------------------------------------------------------------------
int WriterRanks::GetNumberOfRanks() const
{
  return this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
}

//----------------------------------------------------------------------------
std::vector<int> WriterRanks::AllOf(int number) const
{
  std::vector<int> all(this->GetNumberOfRanks(), number);
  if (!this->IsAlone())
  {
    this->Controller->AllGather(&number, all.data(), 1);
  }
  return all;
}

//----------------------------------------------------------------------------
int WriterRanks::FirstWith(bool isSo) const
{
  const std::vector<int> all = this->AllOf(isSo ? 1 : 0);
  const auto first = std::find(all.begin(), all.end(), 1);
  return first == all.end() ? -1 : static_cast<int>(first - all.begin());
}

//----------------------------------------------------------------------------
int WriterRanks::Largest(int number) const
{
  const std::vector<int> all = this->AllOf(number);
  return *std::max_element(all.begin(), all.end());
}

//----------------------------------------------------------------------------
int WriterRanks::Shared(int number) const
{
  if (!this->IsAlone())
  {
    this->Controller->Broadcast(&number, 1, 0);
  }
  return number;
}

//----------------------------------------------------------------------------
void WriterRanks::Agree(const std::string& reason) const
{
  const int first = this->FirstWith(!reason.empty());
  if (first < 0)
  {
    return;
  }
  if (first > 0 && first == this->GetRank())
  {
    vtkMultiProcessStream words;
    words << reason;
    this->Controller->Send(words, 0, ReasonTag);
  }
  if (!this->IsFirst())
  {
    throw Aborted();
  }
  std::string said = reason;
  if (first > 0)
  {
    vtkMultiProcessStream words;
    this->Controller->Receive(words, first, ReasonTag);
    words >> said;
  }
  throw InvalidInput(said);
}

//----------------------------------------------------------------------------
void WriterRanks::AskForPart(vtkInformation* input) const
{
  AskForPiece(input, this->GetRank(), this->GetNumberOfRanks());
}

//----------------------------------------------------------------------------
vtkDataObject* WriterRanks::PartOfInput(vtkAlgorithm* writer) const
{
  int port = 0;
  vtkAlgorithm* producer = writer->GetNumberOfInputConnections(0) > 0 ? writer->GetInputAlgorithm(0, 0, port) : nullptr;
  const std::vector<int> haveInput = this->AllOf(producer ? 1 : 0);
  const auto before = haveInput.begin() + this->GetRank();
  const int piece = std::accumulate(haveInput.begin(), before, 0);
  const int pieces = std::accumulate(before, haveInput.end(), piece);
  this->Agree(pieces == 0 ? "there is no input" : "");
  bool isGood = true;
  if (producer)
  {
    vtkNew<vtkInformationVector> requests;
    for (int output = 0; output < producer->GetNumberOfOutputPorts(); ++output)
    {
      vtkNew<vtkInformation> request;
      AskForPiece(request, piece, pieces);
      requests->Append(request);
    }
    isGood = producer->Update(port, requests) != 0 && !HasFailedInput(writer);
  }
  const bool isAborted = producer && IsAborted(producer);
  if (this->FirstWith(!isGood) == 0 || this->FirstWith(isAborted) >= 0)
  {
    throw Aborted(); // the first rank has told why
  }
  this->Agree(isGood ? std::string() : "the input has failed on rank " + std::to_string(this->GetRank()));
  return producer ? producer->GetOutputDataObject(port) : nullptr;
}

}
