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
  int Radius = 10;       ///< what lines of sight end before [cells of the longer spacing], 1 to 10 000
  double Flatness = 1.0; ///< angle up to which lines of sight are level [degrees], 0 to 45
};

/// Why a search is invalid, with the name of the parameter; empty when it is not.
std::string WhyInvalid(const GeomorphonSearch& search);

/**
 * Forms of the inner cells by what they see (Jasiewicz & Stepinski 2013), along the eight directions: with the angles b
 * and d above the horizon of the steepest lines of sight upwards and downwards, a direction is level where neither is
 * above the flatness in size, else higher where b + d > 0, and lower where it is below: b + d is the nadir angle less
 * the zenith angle. The numbers of lower and of higher directions tell the form, as in r.geomorphon of GRASS. A line
 * has the cells nearer than the radius, at least one, as far as the border; cells of the border and missing ones have
 * no form, and missing ones are not seen. Unlike there a line of one slope all along is not level if it is steep.
 */
std::vector<Geomorphon> GeomorphonsOf(
  const GridSamples& heights, const GeomorphonSearch& search, const ParallelFor& parallel = SerialFor);

/// Shares of the ten forms in the cells that have one.
std::array<double, GeomorphonForms> SharesOf(const std::vector<Geomorphon>& forms);

/// Name of form 1 to 10.
std::string NameOf(int form);

}

#endif
