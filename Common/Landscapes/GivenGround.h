// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGivenGround_h
#define LittoralGivenGround_h

#include "Drainage/CellLattice.h"
#include "Terrain/GridSamples.h"

#include <array>
#include <string>
#include <vector>

namespace littoral
{

/// Line on the ground.
struct GivenLine
{
  std::vector<std::array<double, 2>> Places; ///< from the middle of the terrain's first cell [m]
  std::vector<double> Heights;               ///< one a place, or none [m]
};

/// Height at a place.
struct GivenHeight
{
  std::array<double, 2> Place; ///< from the middle of the terrain's first cell [m]
  double Height;               ///< [m]
};

/// Rivers, ridges and heights of the ground that shall grow.
struct GivenGround
{
  std::vector<GivenLine> Rivers; ///< from their upper to their lower ends
  std::vector<GivenLine> Ridges;
  std::vector<GivenHeight> Heights;

  bool HasLines() const { return !this->Rivers.empty() || !this->Ridges.empty(); }
};

/// Why a terrain cannot have what is given: numbers that are not finite, a place outside of the terrain's cells, a
/// river that crosses a ridge or that would run uphill; empty when it can.
std::string WhyInvalid(const GridSamples& terrain, const GivenGround& given);

/// The same ground with another origin.
GivenGround Shifted(GivenGround given, const std::array<double, 2>& shift);

/// The same ground, where rivers that end in the outermost cells go on straight over the border by so many of them.
GivenGround WithMouths(GivenGround given, const GridSamples& terrain, int cells);

/// All heights that are given, along the lines one in each cell of a grid.
std::vector<GivenHeight> HeightsOf(const GivenGround& given, const GridSamples& grid);

/// Piece of a line in a cell.
struct LineCell
{
  CellIndex Cell;
  GivenHeight Middle; ///< mean of the piece; NaN as height where there is none
};

/// Cells along a line, each a neighbour of the one before, without corners that a diagonal step leaves out. What is
/// outside of the grid is in the cells at its border.
std::vector<LineCell> CellsAlong(const GivenLine& line, int width, int height, const std::array<double, 2>& spacing);

}

#endif
