// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/Geomorphons.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace littoral
{

namespace
{

constexpr int Directions = 8;
constexpr std::array<int, Directions> StepX{ 1, 1, 0, -1, -1, -1, 0, 1 };
constexpr std::array<int, Directions> StepY{ 0, 1, 1, 1, 0, -1, -1, -1 };

/// Forms by the number of lower directions (rows) and of higher ones, figure 4 of Jasiewicz & Stepinski (2013), by
/// their initials: Flat, Peak, Ridge, sHoulder, spUr, Slope, hOllow, fooTslope, Valley, pIt; '.' where they are above
/// eight.
constexpr std::array<std::string_view, 9> FormTable{ { "FFFTTVVVI", "FFTTTVVV.", "FHSSOOV..", "HHSSSO...", "HHUSS....",
  "RRUU.....", "RRR......", "RR.......", "P........" } };
constexpr const char* Initials = ".FPRHUSOTVI";

/// Form of numbers of lower and of higher directions.
Geomorphon FormOf(int lower, int higher)
{
  const std::string_view row = FormTable[lower];
  int form = 0;
  while (Initials[form] != row[higher])
  {
    ++form;
  }
  return static_cast<Geomorphon>(form);
}

/// Steepest lines of sight along a direction [m/m].
struct SightLines
{
  double Up = -std::numeric_limits<double>::infinity();
  double Down = std::numeric_limits<double>::infinity();
  bool HasCells = false;

  void See(double slope)
  {
    this->Up = std::max(this->Up, slope);
    this->Down = std::min(this->Down, slope);
    this->HasCells = true;
  }

  /// 1 for a higher direction, -1 for a lower one, 0 for a level one.
  int Sign(double flatness) const
  {
    const double up = std::atan(this->Up);
    const double down = std::atan(this->Down);
    const bool isLevel = !this->HasCells || std::max(std::abs(up), std::abs(down)) <= flatness;
    // nadir less zenith angle, 90 + d - (90 - b) = b + d
    return isLevel ? 0 : (up + down > 0.0 ? 1 : (up + down < 0.0 ? -1 : 0));
  }
};

SightLines Look(const GridSamples& heights, int i, int j, int direction, double radius)
{
  SightLines lines;
  const double step = std::hypot(StepX[direction] * heights.Spacing[0], StepY[direction] * heights.Spacing[1]);
  const int last = std::max(1, static_cast<int>(std::ceil(radius / step)) - 1);
  const double height = heights.At(i, j);
  for (int n = 1; n <= last; ++n)
  {
    const int x = i + n * StepX[direction];
    const int y = j + n * StepY[direction];
    if (x < 0 || y < 0 || x >= heights.Width || y >= heights.Height)
    {
      break;
    }
    if (!std::isnan(heights.At(x, y)))
    {
      // tan b = (z' - z) / d
      lines.See((heights.At(x, y) - height) / (n * step));
    }
  }
  return lines;
}

Geomorphon FormAt(const GridSamples& heights, int i, int j, double radius, double flatness)
{
  int lower = 0;
  int higher = 0;
  for (int direction = 0; direction < Directions; ++direction)
  {
    const int sign = Look(heights, i, j, direction, radius).Sign(flatness);
    lower += sign < 0 ? 1 : 0;
    higher += sign > 0 ? 1 : 0;
  }
  return FormOf(lower, higher);
}

}

std::string WhyInvalid(const GeomorphonSearch& search)
{
  ParameterCheck check;
  check.Count("SearchRadius", search.Radius, 1, 10000);
  check.Range("Flatness", search.Flatness, 0.0, 45.0, "degrees");
  return check.Reason();
}

std::vector<Geomorphon> GeomorphonsOf(
  const GridSamples& heights, const GeomorphonSearch& search, const ParallelFor& parallel)
{
  std::vector<Geomorphon> forms(heights.Values.size(), Geomorphon::None);
  const double radius = search.Radius * std::max(heights.Spacing[0], heights.Spacing[1]);
  const double flatness = search.Flatness * Pi / 180.0;
  const auto inner = static_cast<std::size_t>(std::max(0, heights.Height - 2));
  parallel(inner, [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin) + 1; j <= static_cast<int>(end); ++j)
    {
      for (int i = 1; i < heights.Width - 1; ++i)
      {
        if (!std::isnan(heights.At(i, j)))
        {
          forms[static_cast<std::size_t>(j) * heights.Width + i] = FormAt(heights, i, j, radius, flatness);
        }
      }
    }
  });
  return forms;
}

std::array<double, GeomorphonForms> SharesOf(const std::vector<Geomorphon>& forms)
{
  std::array<double, GeomorphonForms + 1> counts{};
  for (const Geomorphon form : forms)
  {
    ++counts[static_cast<std::size_t>(form)];
  }
  const double all = static_cast<double>(forms.size()) - counts[0];
  std::array<double, GeomorphonForms> shares{};
  for (int form = 0; form < GeomorphonForms; ++form)
  {
    shares[form] = all > 0.0 ? counts[form + 1] / all : 0.0;
  }
  return shares;
}

std::string NameOf(int form)
{
  constexpr std::array<const char*, GeomorphonForms> names{ "flat", "peak", "ridge", "shoulder", "spur", "slope",
    "hollow", "footslope", "valley", "pit" };
  return names[form - 1];
}

}
