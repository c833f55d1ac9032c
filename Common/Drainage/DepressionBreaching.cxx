// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/DepressionBreaching.h"

#include "Drainage/CellLattice.h"
#include "Drainage/FloodQueue.h"
#include "Numerics/PolledMemory.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace littoral
{

namespace
{

/// Fall from cell to cell of a channel that ends at an outlet which is not lower, as part of the relief.
constexpr double MinimumFall = 1e-7;

/// Cuts channels into the ground.
class Breacher
{
public:
  Breacher(GridSamples& heights, const OutletMask& outlets, const Poll& poll)
    : Heights(heights.Values)
    , Outlets(outlets)
    , Lattice(heights)
    , Called(poll)
    , Steps(poll, 1 << 16)
  {
    const auto [low, high] = std::minmax_element(this->Heights.begin(), this->Heights.end());
    this->Fall = MinimumFall * (*high - *low);
  }

  /// Priority-flood: the backlink of each cell, pits in the order in which they are reached.
  void Flood(const std::vector<double>& heights)
  {
    this->Pits.clear();
    this->BeginFlood(heights);
    while (!this->Rim.IsEmpty())
    {
      bool isPit = true;
      const CellIndex cell = this->FloodNext([&](CellIndex lowest, CellIndex neighbour) {
        const double other = heights[neighbour];
        isPit = isPit && other >= heights[lowest] && !(other == heights[lowest] && this->IsPassed(neighbour));
      });
      if (isPit && !this->Outlets[cell])
      {
        this->Pits.push_back(cell);
      }
    }
  }

  void CutInFloodOrder()
  {
    this->Flood(this->Heights);
    for (const CellIndex pit : this->Pits)
    {
      this->Steps.Step();
      this->CutAlongFlood(pit);
    }
  }

  /// Lowest pits first, so that higher ones find their channels.
  void CutAtLeastCost(std::size_t maximumVisits)
  {
    const std::vector<double> uncut = CopyOf(this->Heights, this->Called);
    this->Called();
    if (!this->FindClearPits())
    {
      this->Flood(uncut);
      this->SortPits();
    }
    this->Called();
    Lengthen(this->Visits, this->Heights.size(), this->Called);
    this->Called();
    const std::vector<CellIndex> pits = this->Pits;
    for (const CellIndex pit : pits)
    {
      const CellIndex end = this->CheapestEnd(pit, maximumVisits);
      if (end < 0)
      {
        this->FloodUntil(pit, uncut);
        this->CutAlongFlood(pit);
        continue;
      }
      this->Way.clear();
      for (CellIndex cell = end; cell != pit; cell = this->Visits[cell].From)
      {
        this->Way.push_back(cell);
      }
      std::reverse(this->Way.begin(), this->Way.end());
      this->Cut(pit);
    }
  }

  BreachCount Count() const
  {
    BreachCount count = this->Done;
    count.Pits = this->Pits.size();
    return count;
  }

private:
  static constexpr std::uint8_t Unreached = 0xff;
  static constexpr std::uint8_t Passed = 0x10; ///< the flood has passed the cell

  /// The last search that came to a cell.
  struct Visit
  {
    double Cost = 0.0; ///< of the path from its pit
    CellIndex Pit = -1;
    CellIndex From = -1; ///< the cell before on the path
  };

  /// Finds pits without a flood, the lowest first; whether none lies on a flat or is as high as another, where the
  /// order of the flood decides.
  bool FindClearPits()
  {
    for (CellIndex cell = 0; cell < this->Lattice.Count(); ++cell)
    {
      this->Steps.Step();
      if (this->Outlets[cell])
      {
        continue;
      }
      const double height = this->Heights[cell];
      double lowest = std::numeric_limits<double>::infinity();
      this->Lattice.ForEachNeighbour(
        cell, [&](CellIndex neighbour, int) { lowest = std::min(lowest, this->Heights[neighbour]); });
      if (lowest == height)
      {
        return false;
      }
      if (lowest > height)
      {
        this->Pits.push_back(cell);
      }
    }
    this->SortPits();
    return std::adjacent_find(this->Pits.begin(), this->Pits.end(),
             [&](CellIndex a, CellIndex b) { return this->Heights[a] == this->Heights[b]; }) == this->Pits.end();
  }

  void SortPits()
  {
    std::stable_sort(this->Pits.begin(), this->Pits.end(),
      [&](CellIndex a, CellIndex b) { return this->Heights[a] < this->Heights[b]; });
  }

  /// Starts the flood at the outlets.
  void BeginFlood(const std::vector<double>& heights)
  {
    const CellIndex count = this->Lattice.Count();
    this->FloodedHeights = heights.data();
    this->Reached.assign(count, Unreached);
    const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
    this->Rim = FloodQueue(*lowest, *highest, heights.size());
    for (CellIndex cell = 0; cell < count; ++cell)
    {
      if (this->Outlets[cell])
      {
        this->Reached[cell] = CellLattice::Directions;
        this->Rim.Push(cell, heights[cell]);
      }
    }
  }

  /// Floods the lowest cell of the rim, and calls visit(cell, neighbour) for its neighbours.
  template <typename Visit>
  CellIndex FloodNext(const Visit& visit)
  {
    this->Steps.Step();
    const CellIndex cell = this->Rim.Pop();
    this->Rim.ForNext([&](CellIndex next) {
      this->Lattice.PrefetchAround(this->FloodedHeights, next);
      this->Lattice.PrefetchAround(this->Reached.data(), next);
    });
    this->Reached[cell] = static_cast<std::uint8_t>(this->Reached[cell] | Passed);
    this->Lattice.ForEachNeighbour(cell, [&](CellIndex neighbour, int direction) {
      visit(cell, neighbour);
      if (this->Reached[neighbour] == Unreached)
      {
        this->Reached[neighbour] = static_cast<std::uint8_t>(direction);
        this->Rim.Push(neighbour, this->FloodedHeights[neighbour]);
      }
    });
    return cell;
  }

  /// Continues the flood until it reaches a pit.
  void FloodUntil(CellIndex pit, const std::vector<double>& heights)
  {
    if (this->Reached.empty())
    {
      this->BeginFlood(heights);
    }
    while (this->Reached[pit] == Unreached)
    {
      this->FloodNext([](CellIndex, CellIndex) {});
    }
  }

  /// Whether the channel of a pit can end at a cell.
  bool IsEnd(CellIndex cell, CellIndex pit) const
  {
    return this->Outlets[cell] || this->Heights[cell] < this->Heights[pit];
  }

  bool IsPassed(CellIndex cell) const
  {
    return this->Reached[cell] != Unreached && (this->Reached[cell] & Passed) != 0;
  }

  /// Cuts a channel on the way by which the flood has come to a pit.
  void CutAlongFlood(CellIndex pit)
  {
    this->Way.clear();
    CellIndex cell = pit;
    do
    {
      cell = this->Lattice.Before(cell, this->Reached[cell] & ~Passed);
      this->Way.push_back(cell);
    }
    while (!this->IsEnd(cell, pit));
    this->Cut(pit);
  }

  /// Cuts the channel from a pit to the end of its path; the bed falls evenly.
  void Cut(CellIndex pit)
  {
    const double from = this->Heights[pit];
    const auto length = static_cast<double>(this->Way.size());
    double& last = this->Heights[this->Way.back()];
    if (last >= from)
    {
      this->Lower(this->Way.back(),
        std::min(from - length * this->Fall, std::nextafter(from, -std::numeric_limits<double>::infinity())));
    }
    for (std::size_t n = 0; n + 1 < this->Way.size(); ++n)
    {
      // z = z_pit + (z_end - z_pit) s / s_end
      this->Lower(this->Way[n], from + (last - from) * (static_cast<double>(n + 1) / length));
    }
  }

  void Lower(CellIndex cell, double to)
  {
    double& height = this->Heights[cell];
    if (to < height)
    {
      this->Done.Volume += (height - to) * this->Lattice.CellArea();
      ++this->Done.Lowered;
      height = to;
    }
  }

  /// End of the path of least cost from a pit (Dijkstra 1959), c = sum of max(z - z_pit, 0) d; -1 if it is not among
  /// the first cells.
  CellIndex CheapestEnd(CellIndex pit, std::size_t maximumVisits)
  {
    const double bottom = this->Heights[pit];
    FloodQueue& front = this->Front;
    front.Clear();
    this->Visits[pit] = { 0.0, pit, -1 };
    front.Push(pit, 0.0);
    for (std::size_t visited = 0; !front.IsEmpty() && visited < maximumVisits; ++visited)
    {
      this->Steps.Step();
      ++this->Done.Searched;
      const double reached = front.LowestHeight();
      const CellIndex cell = front.Pop();
      const double before = this->Visits[cell].Cost;
      if (reached > before)
      {
        continue;
      }
      if (cell != pit && this->IsEnd(cell, pit))
      {
        return cell;
      }
      this->Lattice.ForEachNeighbour(cell, [&](CellIndex neighbour, int direction) {
        // c = sum of max(z - z_pit, 0) d
        const double cut = std::max(this->Heights[neighbour] - bottom, 0.0);
        const double cost = before + cut * this->Lattice.Distance(direction);
        Visit& visit = this->Visits[neighbour];
        if (visit.Pit != pit || cost < visit.Cost)
        {
          visit = { cost, pit, cell };
          front.Push(neighbour, cost);
        }
      });
    }
    return -1;
  }

  std::vector<double>& Heights;
  const OutletMask& Outlets;
  CellLattice Lattice;
  const Poll& Called;
  SteppedPoll Steps;
  double Fall;
  const double* FloodedHeights = nullptr;
  FloodQueue Rim;                    ///< cells at which the flood goes on
  std::vector<std::uint8_t> Reached; ///< direction in which the flood came, Directions at outlets, with Passed
  std::vector<CellIndex> Pits;
  std::vector<CellIndex> Way; ///< path from the cell after the pit to the end
  std::vector<Visit> Visits;
  FloodQueue Front; ///< cells at which the search goes on
  BreachCount Done;
};

}

BreachCount BreachDepressions(
  GridSamples& heights, const OutletMask& outlets, BreachPath path, const Poll& poll, std::size_t maximumVisits)
{
  Breacher breacher(heights, outlets, poll);
  if (path == BreachPath::LeastCost)
  {
    breacher.CutAtLeastCost(maximumVisits);
  }
  else
  {
    breacher.CutInFloodOrder();
  }
  return breacher.Count();
}

}
