// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRasterAxes_h
#define LittoralRasterAxes_h

// Coordinate variables of rasters in netCDF files, which name their units and need not be any that GDAL places.

#include "Geometry/PlaceUnits.h"

#include <optional>
#include <string>

namespace littoral
{

struct RasterAxes
{
  PlaceAxis X;
  PlaceAxis Y;
  bool AreEven = true; ///< the same step all along
};

/// The coordinates of a variable along its last two dimensions; none where the file has no such variables.
std::optional<RasterAxes> AxesOf(const std::string& path, const std::string& variable);

/// The variable as a dataset that has its place from its coordinates, as GDAL opens it; null for none.
void* PlacedByAxes(const std::string& path, const std::string& variable);

}

#endif
