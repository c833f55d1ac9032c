// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCoordinateSystem_h
#define LittoralCoordinateSystem_h

// Coordinate systems of maps, by PROJ behind GDAL.

#include <array>
#include <optional>
#include <string>

class OGRSpatialReference;

namespace littoral
{

/// Reads an EPSG code, WKT, a PROJ string or the name of a file with one; false if it is none.
bool ReadCoordinateSystem(const std::string& text, OGRSpatialReference& system);

/// Leaves only what is horizontal.
void DropHeights(OGRSpatialReference& system);

/// WKT of the year 2019; empty for none.
std::string WktOf(const OGRSpatialReference& system);

/// Name and code, as "WGS 84 / UTM zone 16N (EPSG:32616)".
std::string NameOf(const OGRSpatialReference& system);

/**
 * Lengths on the map over those on the ground at a place, along x and y, for a projected system: 1 where it keeps
 * them. None where that cannot be told.
 */
std::optional<std::array<double, 2>> MapScale(const OGRSpatialReference& system, double x, double y);

/// Sets the UTM zone of a place on the datum of a system. False near the poles.
bool SetUtmZone(const OGRSpatialReference& system, double x, double y, OGRSpatialReference& utm);

}

#endif
