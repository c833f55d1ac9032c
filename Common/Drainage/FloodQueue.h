// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFloodQueue_h
#define LittoralFloodQueue_h

#include "Drainage/CellLattice.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace littoral
{

/// Cells by height, the lowest first; of equal ones the one that came first. A heap of four children, which is half as
/// deep as one of two and keeps them side by side.
class FloodQueue
{
public:
  bool IsEmpty() const { return this->Heap.empty(); }

  void Clear()
  {
    this->Heap.clear();
    this->Next = 0;
  }

  void Push(CellIndex cell, double height)
  {
    const Entry entry{ height, this->Next++, cell };
    std::size_t at = this->Heap.size();
    this->Heap.push_back(entry);
    for (; at > 0 && entry < this->Heap[Parent(at)]; at = Parent(at))
    {
      this->Heap[at] = this->Heap[Parent(at)];
    }
    this->Heap[at] = entry;
  }

  double LowestHeight() const { return this->Heap.front().Height; }

  /// Takes the lowest cell out.
  CellIndex Pop()
  {
    const CellIndex cell = this->Heap.front().Cell;
    const Entry last = this->Heap.back();
    this->Heap.pop_back();
    const std::size_t size = this->Heap.size();
    if (size == 0)
    {
      return cell;
    }
    std::size_t at = 0;
    for (std::size_t first = 1; first < size; first = Children * at + 1)
    {
      const std::size_t end = std::min(first + Children, size);
      std::size_t lowest = first;
      for (std::size_t child = first + 1; child < end; ++child)
      {
        lowest = this->Heap[child] < this->Heap[lowest] ? child : lowest;
      }
      if (last < this->Heap[lowest])
      {
        break;
      }
      this->Heap[at] = this->Heap[lowest];
      at = lowest;
    }
    this->Heap[at] = last;
    return cell;
  }

private:
  static constexpr std::size_t Children = 4;

  struct Entry
  {
    double Height;
    std::uint32_t Turn;
    CellIndex Cell;

    bool operator<(const Entry& other) const
    {
      return this->Height < other.Height || (this->Height == other.Height && this->Turn < other.Turn);
    }
  };

  static std::size_t Parent(std::size_t child) { return (child - 1) / Children; }

  std::vector<Entry> Heap;
  std::uint32_t Next = 0;
};

}

#endif
