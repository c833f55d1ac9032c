// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/GivenGround.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace littoral
{

namespace
{

using Place = std::array<double, 2>;

/// Samples of a line along the side of a cell.
constexpr double SamplesACell = 8.0;

std::string TextAt(const Place& place)
{
  std::ostringstream text;
  text << place[0] << ", " << place[1];
  return text.str();
}

bool IsInside(const GridSamples& terrain, const Place& place)
{
  const auto isWithin = [](double cells, int count) { return cells >= -0.5 && cells <= count - 0.5; };
  return isWithin(place[0] / terrain.Spacing[0], terrain.Width) &&
    isWithin(place[1] / terrain.Spacing[1], terrain.Height);
}

/// Why a place or its height cannot be used.
std::string WhyUnusable(const GridSamples& terrain, const Place& place, double height)
{
  if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(height))
  {
    return "A place or height that is given is not finite.";
  }
  return IsInside(terrain, place)
    ? ""
    : "A place that is given is outside of the terrain, at " + TextAt(place) + " m from its first point.";
}

std::string WhyUnusable(const GridSamples& terrain, const GivenLine& line)
{
  std::string why = line.Places.size() < 2 ? "A line that is given has fewer than two points." : "";
  if (!line.Heights.empty() && line.Heights.size() != line.Places.size())
  {
    why = "A line has another number of heights than of points.";
  }
  for (std::size_t n = 0; n < line.Places.size() && why.empty(); ++n)
  {
    why = WhyUnusable(terrain, line.Places[n], line.Heights.empty() ? 0.0 : line.Heights[n]);
  }
  return why;
}

std::string WhyUphill(const GivenLine& river)
{
  for (std::size_t n = 1; n < river.Heights.size(); ++n)
  {
    if (river.Heights[n] > river.Heights[n - 1])
    {
      std::ostringstream text;
      text << "A river runs uphill, from " << river.Heights[n - 1] << " m to " << river.Heights[n] << " m at "
           << TextAt(river.Places[n]) << " m from the first point; rivers go from their upper to their lower ends.";
      return text.str();
    }
  }
  return "";
}

/// Twice the area of a triangle, above 0 where it turns to the left.
double TurnOf(const Place& a, const Place& b, const Place& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Whether two segments cross; to touch is not to cross.
bool Cross(const Place& a, const Place& b, const Place& c, const Place& d)
{
  const bool isApart = std::max(a[0], b[0]) < std::min(c[0], d[0]) || std::max(c[0], d[0]) < std::min(a[0], b[0]) ||
    std::max(a[1], b[1]) < std::min(c[1], d[1]) || std::max(c[1], d[1]) < std::min(a[1], b[1]);
  return !isApart && TurnOf(a, b, c) * TurnOf(a, b, d) < 0.0 && TurnOf(c, d, a) * TurnOf(c, d, b) < 0.0;
}

std::string WhyCrossing(const GivenLine& river, const GivenLine& ridge)
{
  for (std::size_t n = 1; n < river.Places.size(); ++n)
  {
    for (std::size_t k = 1; k < ridge.Places.size(); ++k)
    {
      if (Cross(river.Places[n - 1], river.Places[n], ridge.Places[k - 1], ridge.Places[k]))
      {
        return "A river crosses a ridge, between " + TextAt(river.Places[n - 1]) + " and " + TextAt(river.Places[n]) +
          " m from the first point.";
      }
    }
  }
  return "";
}

/// Sums of the samples in a cell.
struct CellSum
{
  CellIndex Cell;
  std::array<double, 3> Sum;
  double Count;
};

bool AreNeighbours(CellIndex one, CellIndex other, int width)
{
  return std::abs(one % width - other % width) <= 1 && std::abs(one / width - other / width) <= 1;
}

/// Adds a sample to its cell; a corner that is now left out is dropped.
void AddSample(std::vector<CellSum>& sums, const CellSum& sample, int width)
{
  while (
    sums.size() > 1 && sums.back().Cell != sample.Cell && AreNeighbours(sums[sums.size() - 2].Cell, sample.Cell, width))
  {
    sums.pop_back();
  }
  if (sums.empty() || sums.back().Cell != sample.Cell)
  {
    sums.push_back(sample);
    return;
  }
  for (int k = 0; k < 3; ++k)
  {
    sums.back().Sum[k] += sample.Sum[k];
  }
  sums.back().Count += 1.0;
}

void AddHeights(const GivenLine& line, const GridSamples& grid, std::vector<GivenHeight>& heights)
{
  if (!line.Heights.empty())
  {
    for (const LineCell& piece : CellsAlong(line, grid.Width, grid.Height, grid.Spacing))
    {
      heights.push_back(piece.Middle);
    }
  }
}

}

std::string WhyInvalid(const GridSamples& terrain, const GivenGround& given)
{
  std::string why;
  for (const GivenHeight& height : given.Heights)
  {
    why = why.empty() ? WhyUnusable(terrain, height.Place, height.Height) : why;
  }
  for (const std::vector<GivenLine>* lines : { &given.Rivers, &given.Ridges })
  {
    for (const GivenLine& line : *lines)
    {
      why = why.empty() ? WhyUnusable(terrain, line) : why;
    }
  }
  for (const GivenLine& river : given.Rivers)
  {
    why = why.empty() ? WhyUphill(river) : why;
    for (const GivenLine& ridge : given.Ridges)
    {
      why = why.empty() ? WhyCrossing(river, ridge) : why;
    }
  }
  return why;
}

GivenGround Shifted(GivenGround given, const std::array<double, 2>& shift)
{
  const auto move = [&](Place& place) { place = { place[0] + shift[0], place[1] + shift[1] }; };
  for (std::vector<GivenLine>* lines : { &given.Rivers, &given.Ridges })
  {
    for (GivenLine& line : *lines)
    {
      std::for_each(line.Places.begin(), line.Places.end(), move);
    }
  }
  for (GivenHeight& height : given.Heights)
  {
    move(height.Place);
  }
  return given;
}

GivenGround WithMouths(GivenGround given, const GridSamples& terrain, int cells)
{
  const std::array<int, 2> size{ terrain.Width, terrain.Height };
  for (GivenLine& river : given.Rivers)
  {
    const Place end = river.Places.back();
    for (int axis = 0; axis < 2; ++axis)
    {
      const double cell = end[axis] / terrain.Spacing[axis];
      if (cell < 0.5 || cell > size[axis] - 1.5)
      {
        Place mouth = end;
        mouth[axis] += (cell < 0.5 ? -cells : cells) * terrain.Spacing[axis];
        river.Places.push_back(mouth);
        break;
      }
    }
    // no height is known beyond the border
    river.Heights.resize(river.Heights.empty() ? 0 : river.Places.size(), std::numeric_limits<double>::quiet_NaN());
  }
  return given;
}

std::vector<GivenHeight> HeightsOf(const GivenGround& given, const GridSamples& grid)
{
  std::vector<GivenHeight> heights = given.Heights;
  for (const std::vector<GivenLine>* lines : { &given.Rivers, &given.Ridges })
  {
    for (const GivenLine& line : *lines)
    {
      AddHeights(line, grid, heights);
    }
  }
  return heights;
}

std::vector<LineCell> CellsAlong(const GivenLine& line, int width, int height, const std::array<double, 2>& spacing)
{
  std::vector<CellSum> sums;
  const auto cellOf = [&](const Place& place) {
    const double i = std::clamp(std::floor(place[0] / spacing[0] + 0.5), 0.0, width - 1.0);
    const double j = std::clamp(std::floor(place[1] / spacing[1] + 0.5), 0.0, height - 1.0);
    return static_cast<CellIndex>(j) * width + static_cast<CellIndex>(i);
  };
  for (std::size_t n = 1; n < line.Places.size(); ++n)
  {
    const Place& from = line.Places[n - 1];
    const Place& to = line.Places[n];
    const bool hasHeights = !line.Heights.empty();
    const double low = hasHeights ? line.Heights[n - 1] : std::numeric_limits<double>::quiet_NaN();
    const double high = hasHeights ? line.Heights[n] : low;
    const double cells = std::max(std::abs(to[0] - from[0]) / spacing[0], std::abs(to[1] - from[1]) / spacing[1]);
    const int samples = std::max(1, static_cast<int>(std::ceil(SamplesACell * cells)));
    for (int k = n > 1 ? 1 : 0; k <= samples; ++k)
    {
      const double t = static_cast<double>(k) / samples;
      const Place place{ from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]) };
      AddSample(sums, { cellOf(place), { place[0], place[1], low + t * (high - low) }, 1.0 }, width);
    }
  }
  std::vector<LineCell> pieces;
  for (const CellSum& sum : sums)
  {
    pieces.push_back({ sum.Cell, { { sum.Sum[0] / sum.Count, sum.Sum[1] / sum.Count }, sum.Sum[2] / sum.Count } });
  }
  return pieces;
}

}
