// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralOceanProjection_h
#define LittoralOceanProjection_h

// Maps on which files of ocean models have their axes, by the grid mappings of CF.

#include "Geometry/EarthGrid.h"
#include "NetcdfFile.h"

#include <array>
#include <memory>
#include <string>

namespace littoral
{

/// The map of a grid mapping, as WKT (attribute crs_wkt) or as a PROJ string in metres. Its false origin is in units of
/// so many metres. Throws InvalidInput for a mapping that is not known.
std::string MapOfMapping(const NetcdfFile& file, const NetcdfVariable& mapping, double metres);

/// The way from a map to the earth, by PROJ. Longitudes and latitudes are those of the map's own ellipsoid.
class OceanProjection
{
public:
  /// A map as MapOfMapping() gives it. Throws InvalidInput if PROJ does not know it.
  explicit OceanProjection(const std::string& map);
  ~OceanProjection();

  /// The place on earth of one on the map [m]. Throws InvalidInput where there is none.
  EarthPlace ToEarth(const std::array<double, 2>& place) const;

private:
  class Internals;
  std::unique_ptr<Internals> Own;
};

}

#endif
