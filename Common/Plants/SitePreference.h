// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSitePreference_h
#define LittoralSitePreference_h

#include "Geometry/HeightGrid.h"
#include "Plants/StandSpecies.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace littoral
{

/// Environmental factors of the ground that a species may prefer.
enum class GroundFactor
{
  Elevation = 0,         ///< [m]
  RelativeElevation = 1, ///< 0 at the lowest point of the terrain, 1 at the highest
  Slope = 2,             ///< steepest [degrees]
  Aspect = 3,            ///< direction that the slope faces, clockwise from north (y) [degrees]
  Wetness = 4,           ///< topographic wetness index, ln(a / tan(slope)) with a in metres
};

inline constexpr int NumberOfGroundFactors = 5;

/// The ground at a site, by factors; NaN where a factor is not known.
using GroundFactors = std::array<double, NumberOfGroundFactors>;

/// The direction that a slope faces, clockwise from north [degrees], 0 to 360; 0 where it is level.
double AspectOf(const GroundPoint& ground);

/// Response of a species to a factor: the Gaussian response curve exp(-(v - o)^2 / (2 t^2)) (ter Braak and Looman
/// 1986).
struct FactorResponse
{
  double Optimum = std::numeric_limits<double>::quiet_NaN(); ///< optimum o; NaN: no response
  double Tolerance = 1.0;                                    ///< tolerance t, positive

  bool Counts() const { return this->Optimum == this->Optimum; }
};

/// Habitat preference of a species.
struct SpeciesPreference
{
  std::string Name;
  double Abundance = 1.0; ///< relative abundance at the optimum, not negative
  std::array<FactorResponse, NumberOfGroundFactors> Responses;
};

/// Habitat suitability p, the product of the responses of a species, 0 to 1. Aspect counts in proportion to the slope
/// below 5 degrees.
double PreferenceFor(const SpeciesPreference& species, const GroundFactors& ground);

/// Species of a table: columns `species`, `abundance` (default 1), and for each factor its optimum and its tolerance,
/// as `elevation` and `elevation_tolerance`, `relative_elevation`, `slope`, `aspect`, `wetness`; an empty optimum: the
/// species does not mind. Throws InvalidInput if the table is none of these.
std::vector<SpeciesPreference> ReadPreferences(const TextTable& table);

/// Preferences of pine, oak, birch and shrub on any terrain: pines high, oaks low, birches between on level
/// ground, shrubs on slopes.
std::vector<SpeciesPreference> DefaultPreferences(bool knowsDrainage = false);

/// Whether one of the species responds to a factor.
bool AnyResponds(const std::vector<SpeciesPreference>& species, GroundFactor factor);

/// Options of the choice of species for sites.
struct PreferenceOptions
{
  bool Thinning = true; ///< thins sites by suitability; else each site gets a species, unless all its preferences are 0
  int Seed = 1;
};

/**
 * Species of a site, by a number that depends on the seed and the site alone; -1: none grows there. With thinning a
 * site has species s with probability a_s p_s / sum of a, else a_s p_s / sum of a p.
 */
int SpeciesAt(const std::vector<SpeciesPreference>& species, const GroundFactors& ground,
  const PreferenceOptions& options, long long site);

/// Whether a plant of a species stays at its site: with probability p.
bool StaysAt(
  const SpeciesPreference& species, const GroundFactors& ground, const PreferenceOptions& options, long long site);

}

#endif
