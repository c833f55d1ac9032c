// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/DrainageOutlets.h"

#include "Drainage/CellLattice.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace littoral
{

namespace
{

std::string WhyBadSize(const GridSamples& heights)
{
  if (heights.Width < 3 || heights.Height < 3)
  {
    return "The terrain has " + std::to_string(heights.Width) + " by " + std::to_string(heights.Height) +
      " heights; water needs at least 3 by 3 to flow.";
  }
  const auto count = static_cast<std::size_t>(heights.Width) * static_cast<std::size_t>(heights.Height);
  if (count > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
  {
    return "The terrain has " + std::to_string(count) + " heights; water can be routed over at most 2147483647.";
  }
  return heights.Values.size() == count ? "" : "The terrain does not have one height for each point of its grid.";
}

std::string WhyBadHeights(const GridSamples& heights)
{
  const auto isBad = [](double height) { return !std::isnan(height) && !IsSensible(height); };
  const auto isThere = [](double height) { return !std::isnan(height); };
  const auto bad = std::count_if(heights.Values.begin(), heights.Values.end(), isBad);
  if (bad > 0)
  {
    return "The terrain has " + std::to_string(bad) + " of " + std::to_string(heights.Values.size()) +
      " heights beyond all numbers of metres.";
  }
  return std::any_of(heights.Values.begin(), heights.Values.end(), isThere) ? "" : "The terrain has no heights.";
}

/// Visits cells of a terrain, each connected part from its first cell on: visit(cell, isFirst).
template <typename Visit>
void ForEachPart(const GridSamples& heights, const Visit& visit, const Poll& poll = NoPoll)
{
  SteppedPoll steps(poll, 1 << 16);
  const CellLattice lattice(heights);
  OutletMask isSeen = OutsideOf(heights);
  std::vector<CellIndex> open;
  for (CellIndex first = 0; first < lattice.Count(); ++first)
  {
    if (isSeen[first])
    {
      continue;
    }
    isSeen[first] = 1;
    open.assign(1, first);
    while (!open.empty())
    {
      steps.Step();
      const CellIndex cell = open.back();
      open.pop_back();
      visit(cell, cell == first);
      lattice.ForEachNeighbour(cell, [&](CellIndex neighbour, int) {
        if (!isSeen[neighbour])
        {
          isSeen[neighbour] = 1;
          open.push_back(neighbour);
        }
      });
    }
  }
}

/// Why some part of a terrain has no outlet; empty if all have one.
std::string WhyClosed(const GridSamples& heights, const OutletMask& outlets, const Poll& poll)
{
  std::vector<bool> hasOutlet;
  const auto visit = [&](CellIndex cell, bool isFirst) {
    if (isFirst)
    {
      hasOutlet.push_back(false);
    }
    hasOutlet.back() = hasOutlet.back() || outlets[cell];
  };
  ForEachPart(heights, visit, poll);
  const auto closed = std::count(hasOutlet.begin(), hasOutlet.end(), false);
  if (closed == 0)
  {
    return {};
  }
  return hasOutlet.size() == 1 ? "No cell is an outlet; water must be able to leave somewhere."
                               : "No cell is an outlet in " + std::to_string(closed) + " of " +
      std::to_string(hasOutlet.size()) + " parts of the terrain; water must be able to leave each.";
}

/// Adds cells that are outside, and those beside them.
void AddRim(const GridSamples& heights, const OutletMask& outside, OutletMask& mask)
{
  const CellLattice lattice(heights);
  for (CellIndex cell = 0; cell < lattice.Count(); ++cell)
  {
    if (outside[cell])
    {
      mask[cell] = 1;
      lattice.ForEachNeighbour(cell, [&](CellIndex neighbour, int) { mask[neighbour] = 1; });
    }
  }
}

}

OutletMask BorderOutlets(int width, int height)
{
  OutletMask mask(static_cast<std::size_t>(width) * height, 0);
  for (int i = 0; i < width; ++i)
  {
    mask[i] = 1;
    mask[mask.size() - 1 - i] = 1;
  }
  for (int j = 0; j < height; ++j)
  {
    mask[static_cast<std::size_t>(j) * width] = 1;
    mask[static_cast<std::size_t>(j) * width + width - 1] = 1;
  }
  return mask;
}

OutletMask OutsideOf(const GridSamples& heights)
{
  OutletMask outside;
  outside.reserve(heights.Values.size());
  for (const double height : heights.Values)
  {
    outside.push_back(std::isnan(height) ? 1 : 0);
  }
  return outside;
}

OutletMask RimOutlets(const GridSamples& heights)
{
  OutletMask mask = BorderOutlets(heights.Width, heights.Height);
  AddRim(heights, OutsideOf(heights), mask);
  return mask;
}

OutletMask SeaOutlets(const GridSamples& heights, double seaLevel)
{
  OutletMask mask = RimOutlets(heights);
  for (std::size_t cell = 0; cell < mask.size(); ++cell)
  {
    mask[cell] = mask[cell] || heights.Values[cell] <= seaLevel;
  }
  return mask;
}

OutletMask SeaOutletsAlone(const GridSamples& heights, double seaLevel)
{
  OutletMask mask = OutsideOf(heights);
  for (std::size_t cell = 0; cell < mask.size(); ++cell)
  {
    mask[cell] = mask[cell] || heights.Values[cell] <= seaLevel;
  }
  return mask;
}

OutletMask LowestRimOutlets(const GridSamples& heights)
{
  const OutletMask rim = RimOutlets(heights);
  OutletMask mask = OutsideOf(heights);
  std::vector<CellIndex> lowest; // of each part
  ForEachPart(heights, [&](CellIndex cell, bool isFirst) {
    if (isFirst)
    {
      lowest.push_back(-1);
    }
    CellIndex& best = lowest.back();
    const double height = heights.Values[cell];
    const bool isLower = best < 0 || height < heights.Values[best] || (height == heights.Values[best] && cell < best);
    best = rim[cell] && isLower ? cell : best;
  });
  for (const CellIndex cell : lowest)
  {
    mask[cell] = 1;
  }
  return mask;
}

OutletMask DrainageOutlets::Of(const GridSamples& heights) const
{
  OutletMask mask = this->Choice == OutletChoice::SeaLevel ? SeaOutlets(heights, this->SeaLevel)
    : this->Choice == OutletChoice::Chosen                 ? this->Cells
                                                           : RimOutlets(heights);
  if (!this->Outside.empty() && this->Choice != OutletChoice::Chosen)
  {
    AddRim(heights, this->Outside, mask);
  }
  for (std::size_t cell = 0; cell < mask.size(); ++cell)
  {
    mask[cell] = mask[cell] || std::isnan(heights.Values[cell]) || (!this->Outside.empty() && this->Outside[cell]);
  }
  return mask;
}

std::string WhyUndrainable(const GridSamples& heights, const OutletMask& outlets, const Poll& poll)
{
  ParameterCheck check;
  check.Require(WhyBadSize(heights));
  for (int axis = 0; axis < 2; ++axis)
  {
    check.Positive(axis == 0 ? "Spacing along x" : "Spacing along y", heights.Spacing[axis], "m");
  }
  if (check.IsGood())
  {
    check.Require(WhyBadHeights(heights));
    check.Require(outlets.size() == heights.Values.size(), "Outlets must have one value for each height.");
  }
  if (check.IsGood())
  {
    check.Require(WhyClosed(heights, outlets, poll));
  }
  return check.Reason();
}

}
