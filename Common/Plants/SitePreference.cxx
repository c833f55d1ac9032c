// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/SitePreference.h"

#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace littoral
{

namespace
{

constexpr double Degrees = 180.0 / Pi;
constexpr double SlopeOfAspect = 5.0; // from which on aspect counts in full [degrees]
constexpr const char* FactorNames[] = { "elevation", "relative_elevation", "slope", "aspect", "wetness" };
static_assert(std::size(FactorNames) == NumberOfGroundFactors, "a name a factor");

constexpr int IndexOf(GroundFactor factor)
{
  return static_cast<int>(factor);
}

double Uniform(const PreferenceOptions& options, long long site)
{
  return RandomStream(options.Seed, RandomPurpose::SitePreferences).UniformPair(static_cast<std::uint64_t>(site), 0)[0];
}

/// A cell of a table as a number; `otherwise` where there is none.
double NumberIn(const TextTable& table, const std::string& name, std::size_t row, double otherwise)
{
  const int column = table.ColumnOf(name);
  if (column < 0)
  {
    return otherwise;
  }
  double number = otherwise;
  const std::string& word = table.Columns[column][row];
  if (!ReadNumber(word, number))
  {
    Refuse(name, " of row ", row + 1, " is '", word, "', which is no number.");
  }
  return number == number ? number : otherwise;
}

/// A species of the usual preferences, by optimum and tolerance of each factor.
SpeciesPreference Usual(const char* name, double abundance, const FactorResponse& height, const FactorResponse& slope)
{
  SpeciesPreference species;
  species.Name = name;
  species.Abundance = abundance;
  species.Responses[IndexOf(GroundFactor::RelativeElevation)] = height;
  species.Responses[IndexOf(GroundFactor::Slope)] = slope;
  return species;
}

}

double AspectOf(const GroundPoint& ground)
{
  // Down the slope: (-dz/dx, -dz/dy)
  const double azimuth = Degrees * std::atan2(-ground.Gradient[0], -ground.Gradient[1]);
  const bool isLevel = ground.Gradient[0] == 0.0 && ground.Gradient[1] == 0.0;
  return isLevel ? 0.0 : azimuth < 0.0 ? azimuth + 360.0 : azimuth;
}

double PreferenceFor(const SpeciesPreference& species, const GroundFactors& ground)
{
  double preference = 1.0;
  for (int factor = 0; factor < NumberOfGroundFactors; ++factor)
  {
    const FactorResponse& response = species.Responses[factor];
    if (!response.Counts())
    {
      continue;
    }
    const bool isAspect = factor == IndexOf(GroundFactor::Aspect);
    const double apart = ground[factor] - response.Optimum;
    const double deviation = (isAspect ? std::remainder(apart, 360.0) : apart) / response.Tolerance;
    const double own = std::exp(-0.5 * deviation * deviation);
    const double part = isAspect ? std::min(1.0, ground[IndexOf(GroundFactor::Slope)] / SlopeOfAspect) : 1.0;
    preference *= 1.0 - part * (1.0 - own);
  }
  return preference;
}

std::vector<SpeciesPreference> ReadPreferences(const TextTable& table)
{
  std::vector<SpeciesPreference> all;
  const int names = table.ColumnOf("species");
  if (names < 0 || table.NumberOfRows() == 0)
  {
    Refuse("the table of preferences needs the column species, and a row.");
  }
  for (std::size_t row = 0; row < table.NumberOfRows(); ++row)
  {
    SpeciesPreference species;
    species.Name = table.Columns[names][row];
    species.Abundance = NumberIn(table, "abundance", row, 1.0);
    ParameterCheck check;
    check.NotNegative("abundance of " + species.Name, species.Abundance);
    for (int factor = 0; factor < NumberOfGroundFactors; ++factor)
    {
      const std::string name = FactorNames[factor];
      FactorResponse& response = species.Responses[factor];
      response.Optimum = NumberIn(table, name, row, response.Optimum);
      response.Tolerance = NumberIn(table, name + "_tolerance", row, std::numeric_limits<double>::quiet_NaN());
      if (response.Counts())
      {
        check.Positive(name + "_tolerance of " + species.Name, response.Tolerance);
      }
    }
    Require(check.Reason());
    all.push_back(species);
  }
  const bool isAny = std::any_of(all.begin(), all.end(), [](const auto& species) { return species.Abundance > 0.0; });
  Require(isAny ? "" : "the abundance of all species is 0; at least one must be positive.");
  return all;
}

std::vector<SpeciesPreference> DefaultPreferences(bool knowsDrainage)
{
  std::vector<SpeciesPreference> species = { Usual("Pine", 1.0, { 0.85, 0.25 }, { 15.0, 15.0 }),
    Usual("Oak", 1.0, { 0.2, 0.25 }, { 0.0, 15.0 }), Usual("Birch", 0.6, { 0.45, 0.3 }, { 0.0, 10.0 }),
    Usual("Shrub", 0.6, {}, { 25.0, 10.0 }) };
  if (knowsDrainage)
  {
    // Valley floors of 2 m cells have an index of 8 or more, slopes of 4 to 6.
    species[2].Responses[IndexOf(GroundFactor::RelativeElevation)] = {};
    species[2].Responses[IndexOf(GroundFactor::Wetness)] = { 9.0, 2.0 };
  }
  return species;
}

bool AnyResponds(const std::vector<SpeciesPreference>& species, GroundFactor factor)
{
  return std::any_of(species.begin(), species.end(),
    [factor](const SpeciesPreference& each) { return each.Responses[IndexOf(factor)].Counts(); });
}

int SpeciesAt(const std::vector<SpeciesPreference>& species, const GroundFactors& ground,
  const PreferenceOptions& options, long long site)
{
  std::vector<double> sums;
  double sum = 0.0;
  double all = 0.0;
  for (const SpeciesPreference& each : species)
  {
    sum += each.Abundance * PreferenceFor(each, ground);
    all += each.Abundance;
    sums.push_back(sum);
  }
  const double drawn = Uniform(options, site) * (options.Thinning ? all : sum);
  const auto found = std::upper_bound(sums.begin(), sums.end(), drawn);
  return found == sums.end() ? -1 : static_cast<int>(found - sums.begin());
}

bool StaysAt(
  const SpeciesPreference& species, const GroundFactors& ground, const PreferenceOptions& options, long long site)
{
  return !options.Thinning || Uniform(options, site) < PreferenceFor(species, ground);
}

}
