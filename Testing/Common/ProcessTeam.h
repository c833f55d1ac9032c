// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTestProcessTeam_h
#define LittoralTestProcessTeam_h

#include "Numerics/WorkShare.h"

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace littoral::testing
{

/// Processes that share work, as threads that meet at each exchange.
class ProcessTeam
{
public:
  explicit ProcessTeam(std::size_t ranks)
    : Ranks(ranks)
    , Rows(ranks)
    , Dealt(ranks)
  {
  }

  /// Calls a task with the share of each process.
  void Run(const std::function<void(const WorkShare& share)>& task)
  {
    std::vector<std::thread> processes;
    for (std::size_t rank = 0; rank < this->Ranks; ++rank)
    {
      processes.emplace_back([this, rank, &task] {
        task({ rank, this->Ranks, [this, rank](NumberRows& rows) { this->Exchange(rank, rows); },
          [this, rank](const SingleRows& sent, SingleRows& received) { this->Deal(rank, sent, received); },
          [this, rank](NumberRows& rows) { this->Collect(rank, rows); } });
      });
    }
    for (std::thread& process : processes)
    {
      process.join();
    }
  }

private:
  /// Waits for all.
  void Meet()
  {
    std::unique_lock<std::mutex> lock(this->Lock);
    const std::size_t meeting = this->Meetings;
    if (++this->Here == this->Ranks)
    {
      this->Here = 0;
      ++this->Meetings;
      this->AllHere.notify_all();
      return;
    }
    this->AllHere.wait(lock, [&] { return this->Meetings != meeting; });
  }

  void Exchange(std::size_t rank, NumberRows& rows)
  {
    this->Rows[rank] = rows;
    this->Meet();
    for (std::size_t n = 0; n < rows.size(); ++n)
    {
      rows[n] = this->Rows[n % this->Ranks][n];
    }
    this->Meet();
  }

  void Collect(std::size_t rank, NumberRows& rows)
  {
    NumberRows all = rows;
    this->Exchange(rank, all);
    if (rank == 0)
    {
      rows = all;
    }
  }

  void Deal(std::size_t rank, const SingleRows& sent, SingleRows& received)
  {
    this->Dealt[rank] = sent;
    this->Meet();
    received.clear();
    for (const SingleRows& other : this->Dealt)
    {
      received.push_back(other[rank]);
    }
    this->Meet();
  }

  std::size_t Ranks;
  std::vector<NumberRows> Rows;
  std::vector<SingleRows> Dealt;
  std::mutex Lock;
  std::condition_variable AllHere;
  std::size_t Here = 0;
  std::size_t Meetings = 0;
};

}

#endif
