// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoordinateSystem.h"

#include "Terrain/UtmZone.h"

#include <cmath>
#include <memory>

#include <cpl_conv.h>
#include <ogr_spatialref.h>

namespace littoral
{

namespace
{

constexpr double RadiansPerDegree = 0.017453292519943295;

/// Transformation from a system to longitude and latitude on its own datum, both with x first; null if PROJ knows no
/// way.
class ToEarth
{
public:
  explicit ToEarth(const OGRSpatialReference& system)
    : From(system)
  {
    this->From.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    this->Earth.reset(this->From.CloneGeogCS());
    if (this->Earth)
    {
      this->Earth->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
      this->Way.reset(OGRCreateCoordinateTransformation(&this->From, this->Earth.get()));
    }
  }

  std::optional<std::array<double, 2>> At(double x, double y) const
  {
    const bool isFound = this->Way && this->Way->Transform(1, &x, &y);
    return isFound && std::isfinite(x) && std::isfinite(y) ? std::optional<std::array<double, 2>>({ x, y })
                                                           : std::nullopt;
  }

  const OGRSpatialReference* System() const { return this->Earth.get(); }

private:
  OGRSpatialReference From;
  std::unique_ptr<OGRSpatialReference> Earth;
  std::unique_ptr<OGRCoordinateTransformation> Way;
};

/// Length [m] between two near places on the ellipsoid.
double LengthOnEarth(
  const OGRSpatialReference& earth, const std::array<double, 2>& from, const std::array<double, 2>& to)
{
  const double a = earth.GetSemiMajor();
  const double b = earth.GetSemiMinor();
  const double e2 = 1.0 - b * b / (a * a);
  const double phi = 0.5 * (from[1] + to[1]) * RadiansPerDegree;
  const double w2 = 1.0 - e2 * std::sin(phi) * std::sin(phi);
  // N cos(phi) dlambda and M dphi, N = a/w, M = a (1 - e^2)/w^3
  const double east = a * std::cos(phi) / std::sqrt(w2) * RadiansPerDegree * std::remainder(to[0] - from[0], 360.0);
  const double north = a * (1.0 - e2) / (w2 * std::sqrt(w2)) * RadiansPerDegree * (to[1] - from[1]);
  return std::hypot(east, north);
}

/// Sets the projection of a UTM zone. PROJ has none for a sphere, as that of weather models: there it is the transverse
/// Mercator projection of the same meridian without the zone's scale of 0.9996.
bool SetZone(const UtmZone& zone, OGRSpatialReference& system)
{
  if (system.GetInvFlattening() != 0.0)
  {
    return system.SetUTM(zone.Number, zone.IsNorth) == OGRERR_NONE;
  }
  const std::string name = "Transverse Mercator of zone " + std::to_string(zone.Number) + (zone.IsNorth ? "N" : "S");
  return system.SetProjCS(name.c_str()) == OGRERR_NONE &&
    system.SetTM(0.0, 6.0 * zone.Number - 183.0, 1.0, 5e5, zone.IsNorth ? 0.0 : 1e7) == OGRERR_NONE;
}

}

bool ReadCoordinateSystem(const std::string& text, OGRSpatialReference& system)
{
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return !text.empty() && system.SetFromUserInput(text.c_str()) == OGRERR_NONE && !system.IsEmpty();
}

void DropHeights(OGRSpatialReference& system)
{
  if (system.IsCompound())
  {
    system.StripVertical();
  }
  system.DemoteTo2D(nullptr);
}

std::string WktOf(const OGRSpatialReference& system)
{
  if (system.IsEmpty())
  {
    return {};
  }
  const char* const options[] = { "FORMAT=WKT2_2019", nullptr };
  char* text = nullptr;
  const bool isWritten = system.exportToWkt(&text, options) == OGRERR_NONE && text;
  const std::string wkt = isWritten ? text : "";
  CPLFree(text);
  return wkt;
}

std::string NameOf(const OGRSpatialReference& system)
{
  const char* name = system.GetName();
  const char* authority = system.GetAuthorityName(nullptr);
  const char* code = system.GetAuthorityCode(nullptr);
  const std::string number = authority && code ? std::string(authority) + ":" + code : "";
  if (!name || !*name)
  {
    return number;
  }
  return name + (number.empty() ? "" : " (" + number + ")");
}

std::optional<std::array<double, 2>> MapScale(const OGRSpatialReference& system, double x, double y)
{
  const ToEarth earth(system);
  const double step = 100.0; // [m]; the differences of degrees keep some nine digits
  const double inUnits = step / system.GetLinearUnits();
  const auto here = earth.At(x, y);
  const auto east = earth.At(x + inUnits, y);
  const auto north = earth.At(x, y + inUnits);
  if (!here || !east || !north)
  {
    return {};
  }
  return std::array<double, 2>{ step / LengthOnEarth(*earth.System(), *here, *east),
    step / LengthOnEarth(*earth.System(), *here, *north) };
}

bool SetUtmZone(const OGRSpatialReference& system, double x, double y, OGRSpatialReference& utm)
{
  const ToEarth earth(system);
  const auto place = earth.At(x, y);
  const UtmZone zone = place ? UtmZoneOf((*place)[0], (*place)[1]) : UtmZone();
  if (zone.Number == 0)
  {
    return false;
  }
  utm.Clear();
  utm.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (utm.CopyGeogCSFrom(earth.System()) != OGRERR_NONE || !SetZone(zone, utm))
  {
    return false;
  }
  utm.AutoIdentifyEPSG(); // WGS 84, NAD 83 and NAD 27; others stay without a code
  // With the code comes the whole definition, with its name.
  const char* code = utm.GetAuthorityCode(nullptr);
  OGRSpatialReference whole;
  if (code && whole.importFromEPSG(std::atoi(code)) == OGRERR_NONE)
  {
    whole.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    utm = whole;
  }
  return true;
}

}
