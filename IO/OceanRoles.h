// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralOceanRoles_h
#define LittoralOceanRoles_h

// Roles of the variables of a file of an ocean model, by the conventions for climate and forecast (CF) and UGRID, else
// by the names that models give them.

#include "Currents/OceanLevels.h"
#include "Geometry/EarthGrid.h"
#include "NetcdfFile.h"

#include <array>
#include <string>
#include <vector>

namespace littoral
{

/// Directions of the two horizontal components of velocities.
enum class OceanDirections
{
  Automatic = 0, ///< by standard names, else by the kind of the grid
  EastNorth = 1,
  GridAxes = 2,
};

/// Names and choices of a user; empty names are found.
struct OceanChoices
{
  std::array<std::string, 3> Velocities; ///< variables of u, v and w
  OceanDirections Directions = OceanDirections::Automatic;
};

/// Places of the axes among the dimensions of a variable; -1 for none. That of points of a mesh is X.
struct OceanAxes
{
  int T = -1;
  int Z = -1;
  int Y = -1;
  int X = -1;
};

/// A variable with its axes.
struct OceanVariable
{
  const NetcdfVariable* Variable = nullptr; ///< null: there is none
  OceanAxes Axes;
  double Unit = 1.0; ///< m/s or m of one of its unit

  explicit operator bool() const { return this->Variable != nullptr; }
};

enum class OceanGridKind
{
  Structured,
  Staggered, ///< an Arakawa C grid: u and v at the sides of the cells of the centres
  Nodes,     ///< a mesh with velocities at its nodes
  Faces,     ///< a mesh with velocities in its faces
};

enum class OceanPlaceKind
{
  Degrees,
  RotatedDegrees,
  Projected, ///< lengths on a map
  Metres,    ///< lengths on no map
};

struct OceanRoles
{
  OceanGridKind Kind = OceanGridKind::Structured;
  OceanVariable Velocity[3]; ///< the third may be absent
  bool IsAlongAxes = false;  ///< components along the axes of the grid, else eastwards and northwards

  const NetcdfVariable* Time = nullptr;
  const NetcdfVariable* TimeDays = nullptr;  ///< FVCOM's whole days, with
  const NetcdfVariable* TimeOfDay = nullptr; ///< the milliseconds since midnight

  OceanPlaceKind PlaceKind = OceanPlaceKind::Degrees;
  const NetcdfVariable* PlaceX = nullptr; ///< longitudes or lengths, of one or two dimensions
  const NetcdfVariable* PlaceY = nullptr;
  double MetresPerPlace = 1.0;
  RotatedPole Pole;
  std::string Map; ///< of projected places, see MapOfMapping()

  LevelKind LevelsKind = LevelKind::Heights;
  const NetcdfVariable* S = nullptr; ///< heights, sigma or s; null: there is one level
  bool IsDownwards = false;          ///< heights are depths
  double MetresPerHeight = 1.0;
  const NetcdfVariable* Stretching = nullptr; ///< C(s), or by
  LevelStretching Function;                   ///< this one
  double CriticalDepth = 0.0;
  OceanVariable Surface; ///< height of the surface, which may be absent
  OceanVariable Depth;   ///< of still water, which may be absent
  OceanVariable Mask;    ///< 0 on land, which may be absent
  OceanVariable Angle;   ///< of the grid's x axis from east [rad], which may be absent

  const NetcdfVariable* FaceNodes = nullptr; ///< of a mesh
  bool AreNodesFirst = false;                ///< the first dimension counts the nodes of a face
  double StartIndex = 0.0;
};

/// Finds what the variables of a file are. Throws InvalidInput.
OceanRoles FindOceanRoles(const NetcdfFile& file, const OceanChoices& choices);

/// Whether a file has velocities of the sea.
bool HasOceanVelocities(const NetcdfFile& file);

}

#endif
