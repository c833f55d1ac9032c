// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/DrainageOutlets.h"

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
  const auto isBad = [](double height) { return !IsSensible(height); };
  const auto bad = std::count_if(heights.Values.begin(), heights.Values.end(), isBad);
  return bad == 0 ? ""
                  : "The terrain has " + std::to_string(bad) + " of " + std::to_string(heights.Values.size()) +
      " heights missing or not finite; fill these holes first.";
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

OutletMask SeaOutlets(const GridSamples& heights, double seaLevel)
{
  OutletMask mask = BorderOutlets(heights.Width, heights.Height);
  for (std::size_t cell = 0; cell < mask.size(); ++cell)
  {
    mask[cell] = mask[cell] || heights.Values[cell] <= seaLevel;
  }
  return mask;
}

OutletMask DrainageOutlets::Of(const GridSamples& heights) const
{
  switch (this->Choice)
  {
    case OutletChoice::SeaLevel:
      return SeaOutlets(heights, this->SeaLevel);
    case OutletChoice::Chosen:
      return this->Cells;
    default:
      return BorderOutlets(heights.Width, heights.Height);
  }
}

std::string WhyUndrainable(const GridSamples& heights, const OutletMask& outlets)
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
    check.Require(std::any_of(outlets.begin(), outlets.end(), [](std::uint8_t is) { return is != 0; }),
      "No cell is an outlet; water must be able to leave somewhere.");
  }
  return check.Reason();
}

}
