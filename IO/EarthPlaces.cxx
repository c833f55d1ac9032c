// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EarthPlaces.h"

#include "CoordinateSystem.h"
#include "GdalMessages.h"
#include "Numerics/InvalidInput.h"

#include <cmath>
#include <vector>

#include <ogr_spatialref.h>

namespace littoral
{

//----------------------------------------------------------------------------
class EarthPlaces::Projection
{
public:
  OGRSpatialReference Map;
  OGRSpatialReference Earth;
  std::unique_ptr<OGRCoordinateTransformation> To;
  std::unique_ptr<OGRCoordinateTransformation> Back;
};

//----------------------------------------------------------------------------
EarthPlaces::EarthPlaces(const Georeference& place, double heightOffset)
  : Way(std::make_unique<Projection>())
  , Own(place)
  , HeightOffset(heightOffset)
{
  const GdalMessages quiet;
  Require(place.System.empty() ? "there is no coordinate system: set CoordinateSystem, as EPSG:32632" : "");
  OGRSpatialReference& map = this->Way->Map;
  Require(ReadCoordinateSystem(place.System, map) ? ""
                                                  : "CoordinateSystem is '" + place.System.substr(0, 60) +
        "', which is no coordinate system; it must be a code as EPSG:32632, or WKT");
  DropHeights(map);
  Require(map.IsProjected()
      ? ""
      : "CoordinateSystem is " + NameOf(map) + "; that of sites in metres must be a projection, as UTM");
  this->Way->Earth.importFromEPSG(4326);
  this->Way->Earth.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  this->Way->To.reset(OGRCreateCoordinateTransformation(&map, &this->Way->Earth));
  this->Way->Back.reset(OGRCreateCoordinateTransformation(&this->Way->Earth, &map));
  Require(this->Way->To && this->Way->Back ? "" : "PROJ knows no way from " + NameOf(map) + " to WGS 84");
  this->Own.MetresPerUnit = map.GetLinearUnits();
}

//----------------------------------------------------------------------------
EarthPlaces::~EarthPlaces() = default;

//----------------------------------------------------------------------------
void EarthPlaces::Place(Vector3* places, std::size_t count, std::size_t first) const
{
  const GdalMessages quiet;
  constexpr double mostUnits = 1e-3; // that a way there and back is off
  std::vector<double> map[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    for (std::size_t site = 0; site < count; ++site)
    {
      map[axis].push_back((places[site][axis] + this->Own.Offset[axis]) / this->Own.MetresPerUnit);
    }
  }
  std::vector<double> x = map[0];
  std::vector<double> y = map[1];
  std::vector<int> isGood(count, 0);
  const int number = static_cast<int>(count);
  this->Way->To->Transform(number, x.data(), y.data(), nullptr, isGood.data());
  const std::vector<double> longitudes = x;
  const std::vector<double> latitudes = y;
  std::vector<int> isBack(count, 0);
  this->Way->Back->Transform(number, x.data(), y.data(), nullptr, isBack.data());
  for (std::size_t site = 0; site < count; ++site)
  {
    const bool isThere = isGood[site] && isBack[site] && std::isfinite(longitudes[site]) &&
      std::abs(x[site] - map[0][site]) <= mostUnits && std::abs(y[site] - map[1][site]) <= mostUnits;
    if (!isThere)
    {
      Refuse("tree ", first + site, " at (", map[0][site], ", ", map[1][site], ") lies outside of ",
        NameOf(this->Way->Map), "; CoordinateOffset or CoordinateSystem may be another's");
    }
    places[site] = EarthCentred({ longitudes[site], latitudes[site] }, places[site].z + this->HeightOffset);
  }
}

//----------------------------------------------------------------------------
EarthPlace EarthPlaces::OnEarth(const Vector3& place) const
{
  double x = (place.x + this->Own.Offset[0]) / this->Own.MetresPerUnit;
  double y = (place.y + this->Own.Offset[1]) / this->Own.MetresPerUnit;
  this->Way->To->Transform(1, &x, &y);
  return { x, y };
}

//----------------------------------------------------------------------------
EarthFrame EarthPlaces::FrameAt(const Vector3& place) const
{
  const GdalMessages quiet;
  constexpr double step = 1.0; // [m]
  const EarthPlace here = this->OnEarth(place);
  const double height = place.z + this->HeightOffset;
  const Vector3 ahead = EarthCentred(this->OnEarth(place + Vector3(step, 0.0, 0.0)), height);
  return { EarthCentred(here, height), UpAt(here), ahead };
}

}
