// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlaceUnits_h
#define LittoralPlaceUnits_h

#include <string>
#include <vector>

namespace littoral
{

/// Coordinates of places along an axis, as far as they are known.
struct PlaceAxis
{
  std::string Name; ///< as a file calls it, `lon`; empty: none
  std::string Unit; ///< as a file says it, `degrees_east`; empty: none
  double Low = 0.0;
  double High = 0.0;
};

enum class PlaceKind
{
  Lengths,
  Degrees,       ///< longitude and latitude
  TurnedDegrees, ///< on a sphere whose pole lies elsewhere
};

/// Measure of coordinates.
struct PlaceUnit
{
  PlaceKind Kind = PlaceKind::Lengths;
  double Metres = 1.0; ///< of a length
  bool IsSaid = false; ///< by units or names, else guessed from the numbers
};

/// Distance of a map from the origin over its size, beyond which numbers without a unit are taken for degrees: those of
/// a file, of a grid, and of points, which may be some of a plot around the origin.
inline constexpr double FarForFile = 1.0;
inline constexpr double FarForGrid = 1.5;
inline constexpr double FarForPoints = 8.0;

/**
 * Measure of coordinates by their units, else by their names, else by their numbers. Numbers are degrees if they fit
 * longitudes from -360 to 540 and latitudes, and lie `far` times their own diagonal from the origin, where plots begin,
 * or around the whole earth. Throws InvalidInput for a unit that is none of lengths or angles.
 */
PlaceUnit UnitOfPlaces(const PlaceAxis& x, const PlaceAxis& y, double far);

/// A unit of length as files call it.
struct UnitOfLength
{
  double Metres;
  const char* Words; ///< for a user, "US survey feet"
  std::vector<const char*> Names;
};

/// The unit of a name in any case, `km` or `US survey foot`; null if it is none.
const UnitOfLength* FindUnitOfLength(const std::string& name);

/// The same for heights, which weather models also give as a geopotential, `m^2/s^2`, or in geopotential metres.
const UnitOfLength* FindUnitOfHeight(const std::string& name);

}

#endif
