// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/RankTeam.h"

#include "Numerics/InvalidInput.h"
#include "Pipeline/Exceptions.h"

#include "vtkExecutive.h"
#include "vtkExtentTranslator.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerRequestKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <exception>
#include <numeric>
#include <vector>

namespace littoral
{

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

constexpr int DealTag = 4401;
constexpr int CollectTag = 4402;
constexpr std::size_t LengthOfReason = 256; ///< with its end
constexpr const char* WordOfAbort = "aborted";

/// Whether an image is asked for the part that VTK's executive makes of its piece, and not for one that a consumer has
/// chosen.
bool AsksForPiece(vtkInformation* output)
{
  if (!output->Has(Pipeline::WHOLE_EXTENT()))
  {
    return true; // no image
  }
  std::array<int, 6> whole{ 0, -1, 0, -1, 0, -1 };
  std::array<int, 6> asked = whole;
  std::array<int, 6> ofPiece = whole;
  output->Get(Pipeline::WHOLE_EXTENT(), whole.data());
  output->Get(Pipeline::UPDATE_EXTENT(), asked.data());
  vtkInformationIntegerKey* key = vtkExtentTranslator::UPDATE_SPLIT_MODE();
  const int mode = output->Has(key) ? output->Get(key) : static_cast<int>(vtkExtentTranslator::BLOCK_MODE);
  vtkNew<vtkExtentTranslator> translator;
  const int hasPart = translator->PieceToExtentThreadSafe(output->Get(Pipeline::UPDATE_PIECE_NUMBER()),
    output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()), output->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()),
    whole.data(), ofPiece.data(), mode, 0);
  return hasPart == 0 ? asked[1] < asked[0] || asked[3] < asked[2] || asked[5] < asked[4] : asked == ofPiece;
}

}

RankTeam::RankTeam()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
  if (this->Controller)
  {
    this->Ranks = static_cast<std::size_t>(this->Controller->GetNumberOfProcesses());
    this->Rank = static_cast<std::size_t>(this->Controller->GetLocalProcessId());
  }
}

RankTeam::RankTeam(vtkInformation* request, vtkInformationVector* outputs, bool hasAnyPart)
  : Controller(vtkMultiProcessController::GetGlobalController())
{
  const int port = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  vtkInformation* output = outputs->GetInformationObject(port);
  const int ranks = this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
  const int rank = this->Controller ? this->Controller->GetLocalProcessId() : 0;
  if (output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) == ranks &&
    output->Get(Pipeline::UPDATE_PIECE_NUMBER()) == rank && (hasAnyPart || AsksForPiece(output)))
  {
    this->Ranks = static_cast<std::size_t>(ranks);
    this->Rank = static_cast<std::size_t>(rank);
  }
}

/// The reason of the first rank that cannot go on, to each of them; empty where all can.
std::string RankTeam::FirstReason(const std::string& own) const
{
  std::array<char, LengthOfReason> sent{};
  std::copy_n(own.begin(), std::min(own.size(), LengthOfReason - 1), sent.begin());
  std::vector<char> all(LengthOfReason * this->Ranks);
  this->Controller->AllGather(sent.data(), all.data(), static_cast<vtkIdType>(LengthOfReason));
  for (std::size_t rank = 0; rank < this->Ranks; ++rank)
  {
    if (all[rank * LengthOfReason] != '\0')
    {
      return &all[rank * LengthOfReason];
    }
  }
  return {};
}

/// Ends the work of all where one cannot go on.
void RankTeam::GoOn()
{
  const std::string reason = this->FirstReason({});
  if (reason.empty())
  {
    return;
  }
  this->IsShared = false;
  this->End(reason);
}

/// Says on the first rank why all end, and nothing on the others.
void RankTeam::End(const std::string& reason) const
{
  if (!this->IsFirst() || reason == WordOfAbort)
  {
    throw Aborted{};
  }
  throw InvalidInput(reason);
}

/// Lets the others know that this rank cannot go on, at the exchange that they are waiting in. The first goes on to say
/// why.
void RankTeam::Leave(const std::string& reason)
{
  if (!this->HasAgreed)
  {
    this->Agree(0);
  }
  else if (this->IsShared)
  {
    this->FirstReason(reason);
  }
  if (!this->IsFirst())
  {
    throw Aborted{};
  }
}

void RankTeam::Run(const std::function<void()>& work)
{
  if (this->IsAlone())
  {
    work();
    return;
  }
  try
  {
    work();
  }
  catch (const Aborted&)
  {
    this->Leave(WordOfAbort);
    throw;
  }
  catch (const std::exception& error)
  {
    this->Leave(error.what());
    throw;
  }
  if (this->IsShared)
  {
    this->GoOn();
  }
}

void RankTeam::RunAll(const std::function<void()>& work)
{
  if (this->IsAlone())
  {
    work();
    return;
  }
  std::string reason;
  try
  {
    work();
  }
  catch (const Aborted&)
  {
    reason = WordOfAbort;
  }
  catch (const std::exception& error)
  {
    reason = error.what();
  }
  if (!this->HasAgreed)
  {
    this->Agree(0);
  }
  if (this->IsShared)
  {
    this->FirstReason(reason); // for those that wait in an exchange
  }
  const std::string first = this->FirstReason(reason);
  if (!first.empty())
  {
    this->End(first);
  }
}

bool RankTeam::HoldsOnAll(bool own) const
{
  const char sent = own ? 1 : 0;
  std::vector<char> all(this->Ranks, sent);
  if (this->Ranks > 1)
  {
    this->Controller->AllGather(&sent, all.data(), 1);
  }
  return std::count(all.begin(), all.end(), 1) == static_cast<std::ptrdiff_t>(this->Ranks);
}

bool RankTeam::Agree(std::uint64_t input)
{
  if (this->IsAlone())
  {
    return true;
  }
  std::vector<unsigned long long> all(this->Ranks);
  const unsigned long long own = input;
  this->Controller->AllGather(&own, all.data(), 1);
  this->HasAgreed = true;
  this->IsShared =
    all[0] != 0 && std::count(all.begin(), all.end(), all[0]) == static_cast<std::ptrdiff_t>(this->Ranks);
  return this->IsShared || this->IsFirst();
}

WorkShare RankTeam::Share()
{
  return this->IsShared ? WorkShare{ this->Rank, this->Ranks, [this](NumberRows& rows) { this->Exchange(rows); },
    [this](const SingleRows& sent, SingleRows& received) { this->Deal(sent, received); },
    [this](NumberRows& rows) { this->Collect(rows); } }
                        : WorkShare{};
}

/// Own rows, each after its length.
std::vector<double> RankTeam::OwnNumbers(const NumberRows& rows) const
{
  const WorkShare share{ this->Rank, this->Ranks, {}, {}, {} };
  std::vector<double> numbers;
  for (std::size_t own = 0; own < share.OwnOf(rows.size()); ++own)
  {
    const std::vector<double>& row = rows[share.RowOf(own)];
    numbers.push_back(static_cast<double>(row.size()));
    numbers.insert(numbers.end(), row.begin(), row.end());
  }
  return numbers;
}

/// The same of a rank, into their places.
void RankTeam::TakeNumbers(const double* next, std::size_t rank, NumberRows& rows) const
{
  const WorkShare share{ rank, this->Ranks, {}, {}, {} };
  for (std::size_t own = 0; own < share.OwnOf(rows.size()); ++own)
  {
    const auto count = static_cast<std::size_t>(*next++);
    rows[share.RowOf(own)].assign(next, next + count);
    next += count;
  }
}

void RankTeam::Exchange(NumberRows& rows)
{
  this->GoOn();
  const std::vector<double> sent = this->OwnNumbers(rows);
  const auto length = static_cast<vtkIdType>(sent.size());
  std::vector<vtkIdType> lengths(this->Ranks);
  this->Controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(this->Ranks, 0);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  std::vector<double> all(static_cast<std::size_t>(offsets.back() + lengths.back()));
  this->Controller->AllGatherV(sent.data(), all.data(), length, lengths.data(), offsets.data());
  for (std::size_t rank = 0; rank < this->Ranks; ++rank)
  {
    this->TakeNumbers(&all[static_cast<std::size_t>(offsets[rank])], rank, rows);
  }
}

/// Rank by rank, so that the first has the numbers of one other at a time.
void RankTeam::Collect(NumberRows& rows)
{
  this->GoOn();
  std::vector<double> numbers;
  if (!this->IsFirst())
  {
    numbers = this->OwnNumbers(rows);
    const auto length = static_cast<vtkIdType>(numbers.size());
    this->Controller->Send(&length, 1, 0, CollectTag);
    if (length > 0)
    {
      this->Controller->Send(numbers.data(), length, 0, CollectTag);
    }
    return;
  }
  for (std::size_t rank = 1; rank < this->Ranks; ++rank)
  {
    vtkIdType length = 0;
    this->Controller->Receive(&length, 1, static_cast<int>(rank), CollectTag);
    numbers.resize(static_cast<std::size_t>(length));
    if (length > 0)
    {
      this->Controller->Receive(numbers.data(), length, static_cast<int>(rank), CollectTag);
    }
    this->TakeNumbers(numbers.data(), rank, rows);
  }
}

/// All ranks deal their rows out, pair by pair: in each round each rank has another partner, or none.
void RankTeam::Deal(const SingleRows& sent, SingleRows& received)
{
  this->GoOn();
  std::vector<vtkIdType> lengths;
  for (const std::vector<float>& row : sent)
  {
    lengths.push_back(static_cast<vtkIdType>(row.size()));
  }
  std::vector<vtkIdType> all(this->Ranks * this->Ranks); // from each rank to each
  this->Controller->AllGather(lengths.data(), all.data(), static_cast<vtkIdType>(this->Ranks));
  received.resize(this->Ranks);
  received[this->Rank] = sent[this->Rank];
  const auto send = [&](std::size_t other) {
    const vtkIdType length = lengths[other];
    if (length > 0)
    {
      this->Controller->Send(sent[other].data(), length, static_cast<int>(other), DealTag);
    }
  };
  for (std::size_t round = 0; round < this->Ranks; ++round)
  {
    const std::size_t other = (round + this->Ranks - this->Rank) % this->Ranks;
    if (other == this->Rank)
    {
      continue;
    }
    // A message that is sent before it is wanted keeps both busy.
    char ready = 1;
    if (this->Rank < other)
    {
      this->Controller->Receive(&ready, 1, static_cast<int>(other), DealTag);
      send(other);
    }
    else
    {
      this->Controller->Send(&ready, 1, static_cast<int>(other), DealTag);
    }
    const vtkIdType length = all[other * this->Ranks + this->Rank];
    received[other].resize(static_cast<std::size_t>(length));
    if (length > 0)
    {
      this->Controller->Receive(received[other].data(), length, static_cast<int>(other), DealTag);
    }
    if (this->Rank > other)
    {
      send(other);
    }
  }
}

}
