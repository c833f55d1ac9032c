// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OceanMap.h"

#include "CoordinateSystem.h"
#include "GdalMessages.h"
#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>

#include <ogr_spatialref.h>

namespace littoral
{

namespace
{

constexpr double Degrees = 180.0 / Pi;
constexpr double Step = 1e-4;           ///< of differences [rad]
constexpr double NearestToPole = 89.99; ///< latitude of the axes of places beyond [degrees]

}

class OceanMap::Internals
{
public:
  std::string Wkt;
  std::unique_ptr<OGRCoordinateTransformation> Way;
};

OceanMap::OceanMap(const EarthPlace& origin)
  : Own(std::make_unique<Internals>())
{
  const GdalMessages messages;
  char text[160];
  std::snprintf(text, sizeof(text), "+proj=stere +lat_0=%.10f +lon_0=%.10f +k=1 +datum=WGS84 +units=m +no_defs",
    origin[1], origin[0]);
  OGRSpatialReference earth, map;
  const bool isMade = earth.SetWellKnownGeogCS("WGS84") == OGRERR_NONE && map.importFromProj4(text) == OGRERR_NONE;
  earth.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  map.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  this->Own->Way.reset(isMade ? OGRCreateCoordinateTransformation(&earth, &map) : nullptr);
  Require(this->Own->Way ? "" : "PROJ has no map about its middle: " + messages.ErrorOr("no reason is given"));
  this->Own->Wkt = WktOf(map);
}

OceanMap::~OceanMap() = default;
OceanMap::OceanMap(OceanMap&&) noexcept = default;

std::vector<std::array<double, 2>> OceanMap::Places(const std::vector<EarthPlace>& places) const
{
  const GdalMessages messages;
  std::vector<double> x(places.size()), y(places.size());
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    x[n] = places[n][0];
    y[n] = places[n][1];
  }
  const bool isDone = places.empty() || this->Own->Way->Transform(static_cast<int>(places.size()), x.data(), y.data());
  Require(isDone ? "" : "PROJ cannot place its points on the map: " + messages.ErrorOr("no reason is given"));
  std::vector<std::array<double, 2>> found(places.size());
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    found[n] = { x[n], y[n] };
  }
  return found;
}

std::vector<MapAxes> OceanMap::Axes(const std::vector<EarthPlace>& places) const
{
  std::vector<MapAxes> axes(places.size());
  for (const int axis : { 0, 1 })
  {
    std::vector<EarthPlace> ahead = places, behind = places;
    for (std::size_t n = 0; n < places.size(); ++n)
    {
      ahead[n][1] = behind[n][1] = std::clamp(places[n][1], -NearestToPole, NearestToPole);
      ahead[n][axis] += Step * Degrees;
      behind[n][axis] -= Step * Degrees;
    }
    const auto to = this->Places(ahead);
    const auto from = this->Places(behind);
    for (std::size_t n = 0; n < places.size(); ++n)
    {
      const double metres = 2.0 * Step * MetresPerRadian(std::clamp(places[n][1], -NearestToPole, NearestToPole))[axis];
      std::array<double, 2>& along = axis == 0 ? axes[n].East : axes[n].North;
      // dx/ds and dy/ds by central differences
      along = { (to[n][0] - from[n][0]) / metres, (to[n][1] - from[n][1]) / metres };
    }
  }
  return axes;
}

const std::string& OceanMap::System() const
{
  return this->Own->Wkt;
}

}
