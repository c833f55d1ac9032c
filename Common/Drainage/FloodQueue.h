// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFloodQueue_h
#define LittoralFloodQueue_h

#include "Drainage/CellLattice.h"

#include <cstdint>
#include <queue>
#include <tuple>
#include <vector>

namespace littoral
{

/// Cells by height, the lowest first; of equal ones the one that came first.
class FloodQueue
{
public:
  bool IsEmpty() const { return this->Heap.empty(); }

  void Push(CellIndex cell, double height) { this->Heap.push({ height, this->Next++, cell }); }

  double LowestHeight() const { return this->Heap.top().Height; }

  /// Takes the lowest cell out.
  CellIndex Pop()
  {
    const CellIndex cell = this->Heap.top().Cell;
    this->Heap.pop();
    return cell;
  }

private:
  struct Entry
  {
    double Height;
    std::uint32_t Turn;
    CellIndex Cell;

    bool operator<(const Entry& other) const // std::priority_queue gives the largest first
    {
      return std::tie(other.Height, other.Turn) < std::tie(this->Height, this->Turn);
    }
  };

  std::priority_queue<Entry> Heap;
  std::uint32_t Next = 0;
};

}

#endif
