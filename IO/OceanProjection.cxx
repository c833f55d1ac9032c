// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OceanProjection.h"

#include "CoordinateSystem.h"
#include "GdalMessages.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"

#include <cstdio>
#include <vector>

#include <ogr_spatialref.h>

namespace littoral
{

namespace
{

/// An attribute of CF, and the parameter of PROJ that it is.
struct MapParameter
{
  const char* Attribute;
  const char* Proj;
};

/// A grid mapping of CF, and the projection of PROJ that it is.
struct Mapping
{
  const char* Name;
  const char* Proj;
  std::vector<MapParameter> Parameters;
};

const std::vector<Mapping>& Mappings()
{
  static constexpr const char* latitude = "latitude_of_projection_origin";
  static constexpr const char* longitude = "longitude_of_projection_origin";
  static constexpr const char* meridian = "longitude_of_central_meridian";
  static constexpr const char* scale = "scale_factor_at_projection_origin";
  static const std::vector<Mapping> all = {
    { "polar_stereographic", "stere",
      { { latitude, "lat_0" }, { "straight_vertical_longitude_from_pole", "lon_0" }, { longitude, "lon_0" },
        { scale, "k_0" } } },
    { "stereographic", "stere", { { latitude, "lat_0" }, { longitude, "lon_0" }, { scale, "k_0" } } },
    { "mercator", "merc", { { longitude, "lon_0" }, { scale, "k_0" } } },
    { "transverse_mercator", "tmerc",
      { { latitude, "lat_0" }, { meridian, "lon_0" }, { "scale_factor_at_central_meridian", "k_0" } } },
    { "lambert_conformal_conic", "lcc", { { latitude, "lat_0" }, { meridian, "lon_0" } } },
    { "albers_conical_equal_area", "aea", { { latitude, "lat_0" }, { meridian, "lon_0" } } },
    { "lambert_azimuthal_equal_area", "laea", { { latitude, "lat_0" }, { longitude, "lon_0" } } },
    { "azimuthal_equidistant", "aeqd", { { latitude, "lat_0" }, { longitude, "lon_0" } } },
  };
  return all;
}

std::string Term(const char* name, double value)
{
  char text[80];
  std::snprintf(text, sizeof(text), " +%s=%.17g", name, value);
  return text;
}

/// Terms of the standard parallels: those of cones, and the latitude of true scale of the others.
std::string ParallelsOf(const NetcdfFile& file, const NetcdfVariable& mapping, const std::string& proj)
{
  const std::vector<double> parallels = file.NumbersOf(mapping, "standard_parallel");
  if (parallels.empty())
  {
    return {};
  }
  const bool isCone = proj == "lcc" || proj == "aea";
  return isCone ? Term("lat_1", parallels.front()) + Term("lat_2", parallels.back())
                : Term("lat_ts", parallels.front());
}

/// Terms of the figure of the earth, WGS 84 where none is given.
std::string FigureOf(const NetcdfFile& file, const NetcdfVariable& mapping)
{
  const auto radius = file.NumberOf(mapping, "earth_radius");
  const auto major = file.NumberOf(mapping, "semi_major_axis");
  const auto minor = file.NumberOf(mapping, "semi_minor_axis");
  const auto flattening = file.NumberOf(mapping, "inverse_flattening");
  if (radius)
  {
    return Term("R", *radius);
  }
  if (major && (minor || flattening))
  {
    const bool isSphere = !minor && *flattening == 0.0;
    return Term("a", *major) + (minor ? Term("b", *minor) : isSphere ? Term("b", *major) : Term("rf", *flattening));
  }
  return " +datum=WGS84";
}

}

//----------------------------------------------------------------------------
std::string MapOfMapping(const NetcdfFile& file, const NetcdfVariable& mapping, double metres)
{
  for (const char* attribute : { "crs_wkt", "spatial_ref" })
  {
    const std::string wkt = file.TextOf(mapping, attribute);
    if (!wkt.empty())
    {
      return wkt;
    }
  }
  const std::string name = file.TextOf(mapping, "grid_mapping_name");
  for (const Mapping& known : Mappings())
  {
    if (name == known.Name)
    {
      std::string map = std::string("+proj=") + known.Proj;
      for (const MapParameter& parameter : known.Parameters)
      {
        const auto value = file.NumberOf(mapping, parameter.Attribute);
        map += value ? Term(parameter.Proj, *value) : "";
      }
      map += ParallelsOf(file, mapping, known.Proj);
      map += Term("x_0", metres * file.NumberOf(mapping, "false_easting").value_or(0.0));
      map += Term("y_0", metres * file.NumberOf(mapping, "false_northing").value_or(0.0));
      return map + FigureOf(file, mapping) + " +units=m +no_defs";
    }
  }
  Refuse("its coordinates are those of a map (grid_mapping ", mapping.Name, ") of a kind that is not read, '", name,
    "', and longitudes and latitudes beside them are missing");
}

//----------------------------------------------------------------------------
class OceanProjection::Internals
{
public:
  std::unique_ptr<OGRCoordinateTransformation> Way;
  double MetresPerUnit = 1.0;
};

//----------------------------------------------------------------------------
OceanProjection::OceanProjection(const std::string& map)
  : Own(std::make_unique<Internals>())
{
  const GdalMessages messages;
  OGRSpatialReference plane;
  const bool isMap = ReadCoordinateSystem(map, plane) && plane.IsProjected();
  Require(isMap ? "" : "PROJ does not know the map of its coordinates: " + messages.ErrorOr(map));
  const std::unique_ptr<OGRSpatialReference> earth(plane.CloneGeogCS());
  plane.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  this->Own->MetresPerUnit = plane.GetLinearUnits();
  if (earth)
  {
    earth->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    this->Own->Way.reset(OGRCreateCoordinateTransformation(&plane, earth.get()));
  }
  Require(this->Own->Way ? "" : "PROJ has no way from the map of its coordinates: " + messages.ErrorOr(map));
}

//----------------------------------------------------------------------------
OceanProjection::~OceanProjection() = default;

//----------------------------------------------------------------------------
EarthPlace OceanProjection::ToEarth(const std::array<double, 2>& place) const
{
  const GdalMessages messages;
  double x = place[0] / this->Own->MetresPerUnit;
  double y = place[1] / this->Own->MetresPerUnit;
  if (!this->Own->Way->Transform(1, &x, &y))
  {
    Refuse("its point ", TextOf(place[0]), ", ", TextOf(place[1]), " m is not on its map");
  }
  return { x, y };
}

}
