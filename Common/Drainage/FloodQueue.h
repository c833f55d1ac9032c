// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFloodQueue_h
#define LittoralFloodQueue_h

#include "Drainage/CellLattice.h"
#include "Numerics/Parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace littoral
{

/**
 * Cells by height, the lowest first; of equal ones the one that came first. A heap of four children, which is half as
 * deep as one of two and keeps them side by side. It holds the cells of the present interval of heights alone; those
 * above wait in theirs, unsorted, so that the heap of a long rim stays in the cache.
 */
class FloodQueue
{
public:
  /// Queue of a single interval.
  FloodQueue() = default;

  /// Queue for heights that are known to lie between two.
  FloodQueue(double lowest, double highest, std::size_t cells)
    : Waiting(cells / CellsOfInterval + 1)
    , Lowest(lowest)
    , PerHeight(highest > lowest ? static_cast<double>(this->Waiting.size()) / (highest - lowest) : 0.0)
  {
  }

  bool IsEmpty() const { return this->Size == 0; }

  /// Empties a queue of one interval.
  void Clear()
  {
    this->Heap.clear();
    this->Size = 0;
    this->Next = 0;
  }

  void Push(CellIndex cell, double height)
  {
    const Entry entry{ height, this->Next++, cell };
    ++this->Size;
    const std::size_t interval = this->IntervalOf(height);
    if (interval > this->Present)
    {
      this->Waiting[interval].push_back(entry);
      return;
    }
    this->Raise(entry);
  }

  /// Smallest height of a queue of one interval.
  double LowestHeight() const { return this->Heap.front().Height; }

  /// Calls visit(cell) for cells among which those are that come next, as far as they are known.
  template <typename Visit>
  void ForNext(const Visit& visit) const
  {
    const std::size_t count = std::min(this->Heap.size(), Children + 1);
    for (std::size_t n = 0; n < count; ++n)
    {
      visit(this->Heap[n].Cell);
    }
  }

  /// Takes the lowest cell out.
  CellIndex Pop()
  {
    double height = 0.0;
    return this->Pop(height);
  }

  /// The same with its height, which need not be looked up.
  CellIndex Pop(double& height)
  {
    --this->Size;
    while (this->Heap.empty())
    {
      this->EnterNextInterval();
    }
    height = this->Heap.front().Height;
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
  static constexpr std::size_t CellsOfInterval = 256; ///< mean number of cells in an interval

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

  std::size_t IntervalOf(double height) const
  {
    const double interval = (height - this->Lowest) * this->PerHeight;
    const auto last = static_cast<double>(this->Waiting.size() - 1);
    return interval > 0.0 ? static_cast<std::size_t>(std::min(interval, last)) : 0;
  }

  /// Adds to the heap.
  void Raise(const Entry& entry)
  {
    std::size_t at = this->Heap.size();
    this->Heap.push_back(entry);
    for (; at > 0 && entry < this->Heap[Parent(at)]; at = Parent(at))
    {
      this->Heap[at] = this->Heap[Parent(at)];
    }
    this->Heap[at] = entry;
  }

  void EnterNextInterval()
  {
    ++this->Present;
    const std::vector<Entry> entries = std::move(this->Waiting[this->Present]);
    for (const Entry& entry : entries)
    {
      this->Raise(entry);
    }
  }

  std::vector<Entry> Heap;
  std::vector<std::vector<Entry>> Waiting{ 1 }; ///< cells of the intervals of height that are still to come
  double Lowest = 0.0;
  double PerHeight = 0.0; ///< intervals of height in a metre
  std::size_t Present = 0;
  std::size_t Size = 0;
  std::uint32_t Next = 0;
};

/**
 * Priority-flood from the cells of a rim: sets the level of each cell that is reached, w = max(z, level of the cell
 * before). `reach(cell, neighbour)` is called for each neighbour of a flooded cell, and returns whether that one is
 * reached by it.
 */
template <typename Reach>
void FloodFrom(FloodQueue& rim, const CellLattice& lattice, const std::vector<double>& heights,
  std::vector<double>& levels, const Poll& poll, const Reach& reach)
{
  // Cells below the water are filled at once, in the order in which they are reached: no heap is needed for them.
  std::vector<CellIndex> lake;
  SteppedPoll steps(poll, 1 << 16);
  while (!rim.IsEmpty())
  {
    double level = 0.0;
    lake.assign(1, rim.Pop(level));
    for (std::size_t n = 0; n < lake.size(); ++n)
    {
      steps.Step();
      lattice.ForEachNeighbour(lake[n], [&](CellIndex neighbour, int) {
        if (!reach(lake[n], neighbour))
        {
          return;
        }
        levels[neighbour] = std::max(heights[neighbour], level);
        if (heights[neighbour] > level)
        {
          rim.Push(neighbour, heights[neighbour]);
          return;
        }
        lake.push_back(neighbour);
      });
    }
  }
}

}

#endif
