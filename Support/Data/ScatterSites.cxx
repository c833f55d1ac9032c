// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ScatterSites.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Places.h"
#include "Data/TerrainGrid.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

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
  int FirstSite = 0;

  SiteArrays(vtkPointSet* sites, const DimensionArrays& dimensions, int firstSite)
    : FirstSite(firstSite)
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

/// The plant at a site by its arrays alone.
PlantPlace ReadPlace(vtkPointSet* sites, const SiteArrays& arrays, int species, vtkIdType site)
{
  PlantPlace place;
  double position[3];
  sites->GetPoint(site, position);
  place.Foot = { position[0], position[1], position[2] };
  place.Site = arrays.FirstSite + static_cast<int>(site);
  const double drawnBy = arrays.SiteId ? arrays.SiteId->GetComponent(site, 0) : static_cast<double>(place.Site);
  place.SiteId = IsIdentity(drawnBy) ? static_cast<long long>(drawnBy) : 0;
  const double kind = arrays.Species ? arrays.Species->GetComponent(site, 0) : 0.0;
  place.Scale = arrays.Scale ? arrays.Scale->GetComponent(site, 0) : 1.0;
  place.Azimuth = arrays.Azimuth ? arrays.Azimuth->GetComponent(site, 0) : 0.0;
  const bool isSpecies = kind >= 0.0 && kind < species && kind == std::floor(kind);
  if (!IsFinite(place.Foot) || !IsIdentity(drawnBy) || !isSpecies || !ValueInterval::Positive().Contains(place.Scale) ||
    !std::isfinite(place.Azimuth))
  {
    RefuseSite(place, drawnBy, kind, species);
  }
  place.Species = static_cast<int>(kind);
  return place;
}

/// Draws what the arrays do not tell of a plant.
void DrawPlace(const SiteArrays& arrays, const PlantDraws& draws, PlantPlace& place)
{
  place.Species = arrays.Species ? place.Species : draws.Species(place.SiteId);
  place.Scale = arrays.Scale ? place.Scale : draws.Scale(place.SiteId);
  place.Azimuth = arrays.Azimuth ? place.Azimuth : draws.Azimuth(place.SiteId);
  place.Tint = draws.Tint(place.SiteId);
}

/// The dimensions of the tree at a site.
TreeDimensions ReadDimensions(const SiteArrays& arrays, int site)
{
  TreeDimensions tree{ 1.0, 1.0 }; // what is not given is good
  const vtkIdType own = site - arrays.FirstSite;
  tree.Height = arrays.Height ? arrays.Height->GetComponent(own, 0) : tree.Height;
  tree.Diameter = arrays.Diameter ? arrays.Diameter->GetComponent(own, 0) : tree.Diameter;
  Require(WhyInvalid(tree, " of site " + std::to_string(site)));
  return tree;
}

/// Gives the plant at a site the dimensions that it has there.
void FitPlace(const SiteArrays& arrays, const std::vector<StemShape>& stems, PlantPlace& place)
{
  const std::string ofSite = " of site " + std::to_string(place.Site);
  const TreeDimensions tree = ReadDimensions(arrays, place.Site);
  InContext("the plant" + ofSite + " cannot have a DBH: ", [&] {
    Require(
      stems[place.Species].Fit({ arrays.Height ? tree.Height : 0.0, arrays.Diameter ? tree.Diameter : 0.0 }, place));
  });
}

/// Looks at all sites, of which other parts hold some.
void CheckSites(vtkPointSet* sites, const SiteArrays& arrays, vtkImageData* terrain, int species)
{
  const HeightGrid ground = terrain ? MakeGrid(terrain) : HeightGrid();
  GroundGaps gaps(ground);
  for (vtkIdType site = 0; site < sites->GetNumberOfPoints(); ++site)
  {
    const PlantPlace place = ReadPlace(sites, arrays, species, site);
    if (arrays.HasDimensions())
    {
      ReadDimensions(arrays, place.Site);
    }
    if (terrain)
    {
      gaps.Add(place.Foot);
    }
  }
  Require(gaps.Reason());
}

void RequireCount(double sites)
{
  Require(sites > std::numeric_limits<int>::max() ? "more sites than 2147483647 are not placed." : "");
}

void RequirePlaces(double sites, double inAll)
{
  const double bytes = 2.0 * sizeof(int) + sizeof(PlantPlace);
  RequireMemory(sites * bytes, "A forest on " + std::to_string(static_cast<long long>(inAll)) + " sites", "take fewer");
}

/// The cell of each site.
std::vector<int> CellsOf(vtkPointSet* sites, const CellGrid& grid)
{
  std::vector<int> cells;
  SetSize(cells, sites->GetNumberOfPoints());
  for (vtkIdType site = 0; site < sites->GetNumberOfPoints(); ++site)
  {
    double foot[3];
    sites->GetPoint(site, foot);
    cells[static_cast<std::size_t>(site)] = grid.CellAt({ foot[0], foot[1], foot[2] });
  }
  return cells;
}

}

SitePart MakeSitePart(vtkPointSet* sites, double sitesPerCell, int part, int parts)
{
  const vtkIdType count = sites->GetNumberOfPoints();
  RequireCount(static_cast<double>(count));
  SitePart result;
  result.IsFirst = part == 0;
  if (count == 0)
  {
    return result;
  }
  double box[6];
  sites->GetBounds(box);
  result.Grid =
    CellGrid({ { box[0], box[2], box[4] }, { box[1], box[3], box[5] } }, static_cast<double>(count), sitesPerCell);
  RequirePlaces(static_cast<double>(count) / parts, static_cast<double>(count));
  const int cells = result.Grid.GetColumns() * result.Grid.GetRows();
  if (parts == 1)
  {
    result.Cells = { 0, cells };
    result.Indices.resize(count);
    std::iota(result.Indices.begin(), result.Indices.end(), 0);
    return result;
  }
  const std::vector<int> cellsOfSites = CellsOf(sites, result.Grid);
  const std::vector<int> firstCells = FirstCellsOfParts(cellsOfSites, cells, parts);
  const auto [first, end] = result.Cells = { firstCells[std::min(part, parts)], firstCells[std::min(part + 1, parts)] };
  result.Indices.reserve(count / parts + 1);
  for (vtkIdType site = 0; site < count; ++site)
  {
    if (cellsOfSites[site] >= first && cellsOfSites[site] < end)
    {
      result.Indices.push_back(static_cast<int>(site));
    }
  }
  return result;
}

SitePart ShareSites(vtkPointSet* sites, double sitesPerCell, const WorkShare& share)
{
  const vtkIdType own = sites->GetNumberOfPoints();
  double box[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  if (own > 0)
  {
    sites->GetBounds(box);
  }
  const NumberRows all = share.Gather({ static_cast<double>(own), box[0], box[1], box[2], box[3], box[4], box[5] });
  SitePart result;
  Box ground;
  double count = 0.0;
  double before = 0.0;
  for (std::size_t rank = 0; rank < all.size(); ++rank)
  {
    const std::vector<double>& row = all[rank];
    before = rank == share.Rank ? count : before;
    if (row[0] > 0.0)
    {
      const Box part{ { row[1], row[3], row[5] }, { row[2], row[4], row[6] } };
      ground = count > 0.0 ? Box{ glm::min(ground.Low, part.Low), glm::max(ground.High, part.High) } : part;
      count += row[0];
    }
  }
  RequireCount(count);
  if (count == 0.0)
  {
    return result;
  }
  result.FirstSite = static_cast<int>(before);
  result.Grid = CellGrid(ground, count, sitesPerCell);
  result.FirstCells = FirstCellsOfParts(CellsOf(sites, result.Grid), result.Grid.GetColumns() * result.Grid.GetRows(),
    static_cast<int>(share.Ranks), share);
  result.Cells = { result.FirstCells[share.Rank], result.FirstCells[share.Rank + 1] };
  RequirePlaces(static_cast<double>(own), count);
  result.Indices.resize(own);
  std::iota(result.Indices.begin(), result.Indices.end(), 0);
  return result;
}

std::vector<PlantPlace> PlacePlants(vtkPointSet* sites, const SitePart& part, vtkImageData* terrain,
  const ScatterOptions& options, const GroundLimits& limits, const DimensionArrays& dimensions,
  const std::vector<StemShape>& stems, const WorkShare& share)
{
  std::vector<PlantPlace> places;
  // Ranks have room for plants of others, which would else take other memory for all.
  places.reserve(part.Indices.size() + (share.Ranks > 1 ? part.Indices.size() / 8 : 0));
  RequireLengths(sites, "Input", FarForPoints);
  const SiteArrays arrays(sites, dimensions, part.FirstSite);
  const PlantDraws draws(options);
  const int species = static_cast<int>(options.Weights.size());
  if (part.IsFirst && static_cast<vtkIdType>(part.Indices.size()) < sites->GetNumberOfPoints())
  {
    CheckSites(sites, arrays, terrain, species);
  }
  for (const int site : part.Indices)
  {
    places.push_back(ReadPlace(sites, arrays, species, site));
    DrawPlace(arrays, draws, places.back());
    if (arrays.HasDimensions())
    {
      FitPlace(arrays, stems, places.back());
    }
  }
  if (terrain)
  {
    Require(PutOnGround(MakeGrid(terrain), limits, places, share));
  }
  else
  {
    DropOutside(limits, places);
  }
  return places;
}

std::vector<PlantPlace> PlacesInLevel(vtkPointSet* sites, const SitePart& part, const DimensionArrays& dimensions,
  const std::vector<StemShape>& stems, const std::vector<PlantPlace>& places)
{
  RequireLengths(sites, "Input", FarForPoints);
  const SiteArrays arrays(sites, dimensions, part.FirstSite);
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
