// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/PlaceUnits.h"

#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/Words.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace littoral
{

namespace
{

bool IsAmong(const std::string& word, std::initializer_list<const char*> words)
{
  return std::any_of(words.begin(), words.end(), [&](const char* one) { return word == one; });
}

bool IsAngle(const std::string& unit)
{
  return unit.rfind("degree", 0) == 0 || IsAmong(unit, { "deg", "°", "rad", "radian", "radians" });
}

bool IsTurned(const std::string& name)
{
  return IsAmong(name, { "rlon", "rlat", "grid_longitude", "grid_latitude" });
}

bool IsOnEarth(const std::string& name)
{
  return IsAmong(name, { "lon", "lat", "long", "longitude", "latitude", "lng", "nav_lon", "nav_lat" });
}

/// Whether numbers are such as longitudes and latitudes have, and plots have not.
bool LookLikeDegrees(const PlaceAxis& x, const PlaceAxis& y, double far)
{
  constexpr double slack = 1e-6;
  const bool fits = x.Low >= -360.0 && x.High <= 540.0 && std::max(-y.Low, y.High) <= 90.0 + slack;
  const double width = x.High - x.Low;
  const double height = y.High - y.Low;
  const double distance = 0.5 * std::hypot(x.Low + x.High, y.Low + y.High);
  const bool isAround = width > 350.0 && width < 361.0 && height > 100.0;
  return fits && (isAround || distance > far * std::hypot(width, height));
}

}

const UnitOfLength* FindUnitOfLength(const std::string& name)
{
  static const std::vector<UnitOfLength> units = {
    { 1.0, "metres", { "m", "metre", "meter", "metres", "meters", "metre(s)" } },
    { 0.3048, "feet", { "ft", "foot", "feet", "international foot", "international feet" } },
    { 1200.0 / 3937.0, "US survey feet",
      { "us survey foot", "us survey feet", "us-ft", "ftus", "foot_us", "sft", "us_survey_foot" } },
    { 0.001, "millimetres", { "mm", "millimetre", "millimeter", "millimetres", "millimeters" } },
    { 0.01, "centimetres", { "cm", "centimetre", "centimeter", "centimetres", "centimeters" } },
    { 0.1, "decimetres", { "dm", "decimetre", "decimeter", "decimetres", "decimeters" } },
    { 1000.0, "kilometres", { "km", "kilometre", "kilometer", "kilometres", "kilometers" } },
  };
  const std::string word = Lower(name);
  const auto has = [&](const UnitOfLength& unit) {
    return std::any_of(unit.Names.begin(), unit.Names.end(), [&](const char* known) { return word == known; });
  };
  const auto found = std::find_if(units.begin(), units.end(), has);
  return found == units.end() ? nullptr : &*found;
}

const UnitOfLength* FindUnitOfHeight(const std::string& name)
{
  // z = Phi / g0, for the geopotential Phi of weather models
  static const UnitOfLength geopotential{ 1.0 / Gravity, "geopotential over 9.80665 m/s2",
    { "m^2/s^2", "m2/s2", "m2 s-2", "m**2 s**-2", "m^2 s^-2", "m^2 s-2" } };
  static const UnitOfLength geopotentialMetres{ 1.0, "geopotential metres", { "gpm" } };
  const std::string word = Lower(name);
  for (const UnitOfLength* unit : { &geopotential, &geopotentialMetres })
  {
    if (std::find(unit->Names.begin(), unit->Names.end(), word) != unit->Names.end())
    {
      return unit;
    }
  }
  return FindUnitOfLength(name);
}

PlaceUnit UnitOfPlaces(const PlaceAxis& x, const PlaceAxis& y, double far)
{
  const std::string unit = Lower(x.Unit.empty() ? y.Unit : x.Unit);
  const std::string names[2] = { Lower(x.Name), Lower(y.Name) };
  const bool isTurned = IsTurned(names[0]) && IsTurned(names[1]);
  if (IsAngle(unit) || (unit.empty() && (isTurned || (IsOnEarth(names[0]) && IsOnEarth(names[1])))))
  {
    return { isTurned ? PlaceKind::TurnedDegrees : PlaceKind::Degrees, 1.0, true };
  }
  // Numbers without a dimension, as indices of pixels, are taken for metres.
  if (!unit.empty() && unit != "1")
  {
    const UnitOfLength* length = FindUnitOfLength(unit);
    if (!length)
    {
      Refuse("its coordinates are in '", unit, "', which is no unit of lengths or angles");
    }
    return { PlaceKind::Lengths, length->Metres, true };
  }
  return { LookLikeDegrees(x, y, far) ? PlaceKind::Degrees : PlaceKind::Lengths, 1.0, false };
}

}
