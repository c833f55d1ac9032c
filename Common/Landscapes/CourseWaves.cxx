// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/CourseWaves.h"

#include "Drainage/ValleySpreading.h"
#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace littoral
{

namespace
{

constexpr double RadiusFactor = 1.5; ///< of the ground about a line over the deviation
constexpr int Rounds = 2;

/// Lowest and highest of the waves within a radius [cells] about a cell.
std::array<double, 2> RangeAbout(const GridSamples& waves, CellIndex cell, int radius)
{
  std::array<double, 2> range{ waves.Values[cell], waves.Values[cell] };
  const int column = cell % waves.Width;
  const int row = cell / waves.Width;
  for (int j = std::max(row - radius, 0); j <= std::min(row + radius, waves.Height - 1); ++j)
  {
    for (int i = std::max(column - radius, 0); i <= std::min(column + radius, waves.Width - 1); ++i)
    {
      if ((i - column) * (i - column) + (j - row) * (j - row) <= radius * radius)
      {
        range = { std::min(range[0], waves.At(i, j)), std::max(range[1], waves.At(i, j)) };
      }
    }
  }
  return range;
}

/// Changes that are asked for, and the number of pieces that ask, in each cell.
struct Changes
{
  std::vector<double> Sum;
  std::vector<double> Count;

  void Add(CellIndex cell, double change)
  {
    this->Sum[cell] += change;
    this->Count[cell] += 1.0;
  }
};

Changes ChangesAlong(const GridSamples& waves, const GivenGround& given, int radius)
{
  Changes changes{ std::vector<double>(waves.Values.size(), 0.0), std::vector<double>(waves.Values.size(), 0.0) };
  for (const GivenLine& river : given.Rivers)
  {
    double most = std::numeric_limits<double>::infinity();
    for (const LineCell& piece : CellsAlong(river, waves.Width, waves.Height, waves.Spacing))
    {
      most = std::min(most, RangeAbout(waves, piece.Cell, radius)[0]);
      changes.Add(piece.Cell, most - waves.Values[piece.Cell]);
    }
  }
  for (const GivenLine& ridge : given.Ridges)
  {
    for (const LineCell& piece : CellsAlong(ridge, waves.Width, waves.Height, waves.Spacing))
    {
      changes.Add(piece.Cell, RangeAbout(waves, piece.Cell, radius)[1] - waves.Values[piece.Cell]);
    }
  }
  return changes;
}

}

void LeadWaves(GridSamples& waves, const GivenGround& given, double deviation, const ParallelFor& parallel)
{
  // as the ground is now: a second round that looked about again would deepen its own valleys
  const int radius = static_cast<int>(RadiusFactor * deviation);
  for (int round = 0; round < Rounds && given.HasLines(); ++round)
  {
    Changes changes = ChangesAlong(waves, given, round == 0 ? radius : 0);
    SmoothGrid(changes.Sum, waves.Width, waves.Height, deviation, parallel);
    SmoothGrid(changes.Count, waves.Width, waves.Height, deviation, parallel);
    const double least = 1.0 / (std::sqrt(2.0 * Pi) * deviation);
    for (std::size_t n = 0; n < waves.Values.size(); ++n)
    {
      waves.Values[n] += changes.Sum[n] / std::max(changes.Count[n], least);
    }
  }
}

}
