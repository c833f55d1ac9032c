// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGeomorphons_h
#define LittoralGeomorphons_h

#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <array>
#include <string>
#include <vector>

namespace littoral
{

/// The ten common forms of ground, with the numbers that r.geomorphon of GRASS gives them; 0 where there is none.
enum class Geomorphon : unsigned char
{
  None = 0,
  Flat = 1,
  Peak = 2,
  Ridge = 3,
  Shoulder = 4,
  Spur = 5,
  Slope = 6,
  Hollow = 7,
  Footslope = 8,
  Valley = 9,
  Pit = 10
};
constexpr int GeomorphonForms = 10;

/// Lines of sight of geomorphons.
struct GeomorphonSearch
{
  int Radius = 10;       ///< length of the lines [cells of the longer spacing], 1 to 10 000
  double Flatness = 1.0; ///< difference of zenith and nadir angle up to which a direction is level [degrees], 0 to 45
};

/// Why a search is invalid, with the name of the parameter; empty when it is not.
std::string WhyInvalid(const GeomorphonSearch& search);

/**
 * Forms of the inner cells by what they see (Jasiewicz & Stepinski 2013): along each of the eight directions the
 * steepest lines of sight upwards and downwards, of the angles b and d above the horizon, make a direction higher where
 * b + d > t, lower where b + d < -t, and level between, t the flatness: b + d is the nadir angle less the zenith angle.
 * The numbers of lower and of higher directions tell the form. A line ends with the first cell at the radius or beyond,
 * and at the border; cells of the border and missing ones have none, and missing ones are not seen.
 */
std::vector<Geomorphon> GeomorphonsOf(
  const GridSamples& heights, const GeomorphonSearch& search, const ParallelFor& parallel = SerialFor);

/// Shares of the ten forms in the cells that have one.
std::array<double, GeomorphonForms> SharesOf(const std::vector<Geomorphon>& forms);

/// Name of form 1 to 10.
const char* NameOf(int form);

}

#endif
