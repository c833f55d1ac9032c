// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ScatterSites.h"

#include "Data/ArrayReader.h"
#include "Data/Places.h"
#include "Data/TerrainGrid.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

constexpr double LargestIdentity = 9007199254740992.0; // 2^53: whole numbers up to there are told apart

/// The optional arrays of the sites.
struct SiteArrays
{
  vtkDataArray* SiteId = nullptr;
  vtkDataArray* Species = nullptr;
  vtkDataArray* Scale = nullptr;
  vtkDataArray* Azimuth = nullptr;
  vtkDataArray* Height = nullptr;
  vtkDataArray* Diameter = nullptr;

  SiteArrays(vtkPointSet* sites, const DimensionArrays& dimensions)
  {
    const ArrayReader points = ArrayReader::OfPoints(sites, "a set of sites");
    this->SiteId = points.Find("SiteId", 1);
    this->Species = points.Find("Species", 1);
    this->Scale = points.Find("Scale", 1);
    this->Azimuth = points.Find("Azimuth", 1);
    this->Height = dimensions.Height.empty() ? nullptr : points.Find(dimensions.Height.c_str(), 1);
    this->Diameter = dimensions.Diameter.empty() ? nullptr : points.Find(dimensions.Diameter.c_str(), 1);
  }

  bool HasDimensions() const { return this->Height || this->Diameter; }
};

/// Whether a number identifies a site. Its fraction does not count.
bool IsIdentity(double siteId)
{
  return std::abs(siteId) <= LargestIdentity;
}

/// Says why a site holds no plant.
[[noreturn]] void RefuseSite(const PlantPlace& place, double siteId, double kind, int species)
{
  const std::string ofSite = " of site " + std::to_string(place.Site);
  ParameterCheck check;
  if (!IsFinite(place.Foot))
  {
    Refuse("site ", place.Site, " lies at (", place.Foot.x, ", ", place.Foot.y, ", ", place.Foot.z,
      "); positions must be finite.");
  }
  check.Range("SiteId" + ofSite, siteId, -LargestIdentity, LargestIdentity);
  check.Require(kind >= 0.0 && kind < species && kind == std::floor(kind), "Species" + ofSite, kind, "",
    "a whole number from 0 to " + std::to_string(species - 1));
  check.Positive("Scale" + ofSite, place.Scale);
  check.Finite("Azimuth" + ofSite, place.Azimuth);
  throw InvalidInput(check.Reason());
}

/// The plant at a site, on no terrain yet.
PlantPlace MakePlace(vtkPointSet* sites, const SiteArrays& arrays, const PlantDraws& draws, int species, vtkIdType site)
{
  PlantPlace place;
  double position[3];
  sites->GetPoint(site, position);
  place.Foot = { position[0], position[1], position[2] };
  place.Site = static_cast<int>(site);
  const double drawnBy = arrays.SiteId ? arrays.SiteId->GetComponent(site, 0) : static_cast<double>(site);
  place.SiteId = IsIdentity(drawnBy) ? static_cast<long long>(drawnBy) : 0;
  const double kind = arrays.Species ? arrays.Species->GetComponent(site, 0) : draws.Species(place.SiteId);
  place.Scale = arrays.Scale ? arrays.Scale->GetComponent(site, 0) : draws.Scale(place.SiteId);
  place.Azimuth = arrays.Azimuth ? arrays.Azimuth->GetComponent(site, 0) : draws.Azimuth(place.SiteId);
  const bool isSpecies = kind >= 0.0 && kind < species && kind == std::floor(kind);
  if (!IsFinite(place.Foot) || !IsIdentity(drawnBy) || !isSpecies || !ValueInterval::Positive().Contains(place.Scale) ||
    !std::isfinite(place.Azimuth))
  {
    RefuseSite(place, drawnBy, kind, species);
  }
  place.Species = static_cast<int>(kind);
  place.Tint = draws.Tint(place.SiteId);
  return place;
}

/// Gives the plant at a site the dimensions that it has there.
void FitPlace(const SiteArrays& arrays, const std::vector<StemShape>& stems, PlantPlace& place)
{
  const std::string ofSite = " of site " + std::to_string(place.Site);
  TreeDimensions tree{ 1.0, 1.0 }; // what is not given is good
  tree.Height = arrays.Height ? arrays.Height->GetComponent(place.Site, 0) : tree.Height;
  tree.Diameter = arrays.Diameter ? arrays.Diameter->GetComponent(place.Site, 0) : tree.Diameter;
  Require(WhyInvalid(tree, ofSite));
  InContext("the plant" + ofSite + " cannot have a DBH: ", [&] {
    Require(
      stems[place.Species].Fit({ arrays.Height ? tree.Height : 0.0, arrays.Diameter ? tree.Diameter : 0.0 }, place));
  });
}

}

std::vector<PlantPlace> PlacePlants(vtkPointSet* sites, vtkImageData* terrain, const ScatterOptions& options,
  const GroundLimits& limits, const DimensionArrays& dimensions, const std::vector<StemShape>& stems)
{
  const vtkIdType count = sites->GetNumberOfPoints();
  const double bytes = sizeof(PlantPlace) + 2.0 * sizeof(Box);
  Require(count > std::numeric_limits<int>::max() ? "more sites than 2147483647 are not placed." : "");
  RequireMemory(static_cast<double>(count) * bytes, "A forest on " + std::to_string(count) + " sites", "take fewer");
  std::vector<PlantPlace> places;
  places.reserve(static_cast<std::size_t>(count));
  RequireLengths(sites, "Input", FarForPoints);
  const SiteArrays arrays(sites, dimensions);
  const PlantDraws draws(options);
  const int species = static_cast<int>(options.Weights.size());
  for (vtkIdType site = 0; site < count; ++site)
  {
    places.push_back(MakePlace(sites, arrays, draws, species, site));
    if (arrays.HasDimensions())
    {
      FitPlace(arrays, stems, places.back());
    }
  }
  if (terrain)
  {
    Require(PutOnGround(MakeGrid(terrain), limits, places));
  }
  else
  {
    DropOutside(limits, places);
  }
  return places;
}

std::vector<PlantPlace> PlacesInLevel(vtkPointSet* sites, const DimensionArrays& dimensions,
  const std::vector<StemShape>& stems, const std::vector<PlantPlace>& places)
{
  RequireLengths(sites, "Input", FarForPoints);
  const SiteArrays arrays(sites, dimensions);
  std::vector<PlantPlace> level;
  for (const PlantPlace& place : arrays.HasDimensions() ? places : std::vector<PlantPlace>())
  {
    PlantPlace own = place;
    const bool fits = WhyRefused([&] { FitPlace(arrays, stems, own); }).empty();
    level.push_back(fits ? own : place);
  }
  return level;
}

}
