// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralOceanGrid_h
#define LittoralOceanGrid_h

#include "Currents/FacesToNodes.h"
#include "Numerics/CalendarTime.h"
#include "Numerics/Vector3.h"
#include "OceanMap.h"
#include "OceanRoles.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace littoral
{

/// Wishes about the place and the time of a grid.
struct OceanPlacing
{
  std::optional<EarthPlace> Origin;            ///< none: the middle
  std::optional<std::array<double, 4>> Region; ///< west, east, south and north [degrees]; none: all
  std::string StartDate;                       ///< of time 0; empty: the first one of the file
};

/**
 * The grid of a file: columns of points, x fastest, from the bed upwards, in local metres, and its times. Rows are
 * turned round where that makes the grid right-handed.
 */
struct OceanGrid
{
  bool IsMesh = false;
  std::array<int, 3> Count{ 1, 1, 1 }; ///< of points along x, y and z; of a mesh its nodes, 1 and its levels

  // The part of the file's grid of columns: those along x follow around the end.
  std::size_t FirstX = 0;
  std::size_t FirstY = 0;
  std::size_t LengthX = 1;
  bool TurnsY = false;
  bool TurnsZ = false;

  std::vector<std::array<double, 2>> Places; ///< of columns [m]
  std::vector<MapAxes> Axes;                 ///< velocities of 1 m/s of each component, of columns or of faces
  std::vector<double> Depth;                 ///< of the still water of columns [m], NaN for unknown; empty: unknown
  std::vector<unsigned char> Water;          ///< 0 for land; empty: nothing says so
  std::vector<FaceCorners> Faces;            ///< of a mesh, counterclockwise
  FacesToNodes ToNodes;                      ///< of a mesh with velocities in faces

  OceanLevels Levels;           ///< in the order of the file; those of each column one after the other in
  std::vector<double> OwnSigma; ///< this list, where they differ [level][column]

  std::vector<double> Times; ///< [s]
  std::string FirstDate;     ///< of the first time; empty: unknown
  std::string System;        ///< of the map, WKT; empty: none
  std::optional<EarthPlace> Origin;

  std::size_t Columns() const { return this->Places.size(); }
};

/// The columns in a window of a grid: first and last along x and y.
using OceanWindow = std::array<int, 4>;

/// Makes the grid of a file. Throws InvalidInput.
OceanGrid MakeOceanGrid(const NetcdfFile& file, const OceanRoles& roles, const OceanPlacing& placing);

/// Reads layers of a grid from its file.
class OceanLayers
{
public:
  OceanLayers(const NetcdfFile& file, const OceanRoles& roles, const OceanGrid& grid)
    : File(file)
    , Roles(roles)
    , Grid(grid)
  {
  }

  /// Heights of the surface in a window at a time [m], 0 where there is none.
  std::vector<double> Surface(int time, const OceanWindow& window) const;

  /// Heights of a layer in a window, for the surface there [m].
  void Heights(int layer, const OceanWindow& window, const std::vector<double>& surface, double* heights) const;

  /// Velocities of a layer in a window at a time [m/s], three a column; NaN on land.
  void Velocities(int time, int layer, const OceanWindow& window, float* velocities) const;

private:
  std::vector<double> Centers(
    const OceanVariable& variable, int time, int level, const OceanWindow& window, int shift, int axis) const;
  /// Velocities on the map of columns or faces in a window, whose axes begin at a number; NaN on land.
  std::vector<Vector3> OnMap(int time, int level, const OceanWindow& window, std::size_t firstAxes) const;
  std::vector<double> Up(int time, int level, const OceanWindow& window) const;
  std::size_t LevelOf(int layer) const;

  const NetcdfFile& File;
  const OceanRoles& Roles;
  const OceanGrid& Grid;
};

}

#endif
