// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantScatter_h
#define LittoralPlantScatter_h

#include "Geometry/HeightGrid.h"
#include "Geometry/SceneCells.h"
#include "Geometry/ViewFrustum.h"
#include "Numerics/WorkShare.h"
#include "Plants/PlantImpostor.h"
#include "Plants/Skeleton.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

/// Variation of plants of several species from site to site.
struct ScatterOptions
{
  int Seed = 1;
  std::vector<double> Weights;  ///< of the species, not negative, not all zero
  double ScaleVariation = 0.15; ///< standard deviation of the size, 0 to 0.45
  double TintVariation = 0.08;  ///< standard deviation of the brightness of a plant's colors, 0 to 0.45
};

/// Why plants cannot be drawn so, with the name of the property; empty when they can.
std::string WhyInvalid(const ScatterOptions& options);

/// Species, size, azimuth and colors of the plant at a site, as functions of the seed and of the site's identity
/// alone. The options must be valid.
class PlantDraws
{
public:
  explicit PlantDraws(const ScatterOptions& options);

  int Species(long long site) const;
  double Scale(long long site) const;
  double Azimuth(long long site) const; ///< [radians], 0 to 2 pi
  /// Factors of red, green and blue: a brightness, and a shift from blue to red.
  std::array<float, 3> Tint(long long site) const;

private:
  ScatterOptions Options;
  std::vector<double> Shares; ///< cumulative, the last is 1
};

/// A plant at its site.
struct PlantPlace
{
  int Site = 0; ///< index of the site
  int Species = 0;
  long long SiteId = 0;          ///< the site's identity
  double Scale = 1.0;            ///< of heights
  double WidthScale = 1.0;       ///< of widths, beside Scale: a plant is Scale WidthScale times as thick and wide
  double Azimuth = 0.0;          ///< turn about the vertical [radians]
  Vector3 Foot{ 0.0, 0.0, 0.0 }; ///< [m]
  std::array<float, 3> Tint{ 1.0f, 1.0f, 1.0f };
};

/// The skeleton of a prototype at a plant's site: scaled, turned about the vertical and moved to the foot. Radii scale
/// as what is level.
Skeleton Placed(const Skeleton& prototype, const PlantPlace& place);

/// The box that holds a plant, however it is turned.
Box BoxOf(const PlantPlace& place, const PlantExtent& extent);

/// The card of a plant that faces the eye of a view, at the plant's site.
ImpostorCard FacingCard(const ImpostorShape& shape, const PlantPlace& place, const View& view);

/// The ground on which plants stand.
struct GroundLimits
{
  double Slope = 1.5707963267948966; ///< steepest [radians], 0 to pi / 2
  double LowestHeight = -1e30;       ///< [m]
  double HighestHeight = 1e30;       ///< [m]
};

/// Counts sites under which a terrain has no ground.
class GroundGaps
{
public:
  explicit GroundGaps(const HeightGrid& terrain)
    : Terrain(terrain)
  {
  }
  /// The ground under a site.
  GroundPoint Add(const Vector3& foot);
  bool AreThere() const { return this->Outside + this->Holes > 0; }
  /// Takes in what the others find of processes that share sites, of which the first has the first sites.
  void Complete(const WorkShare& share);
  /// Why there is no ground at a site, in words for a user; empty if all have one.
  std::string Reason() const;

private:
  const HeightGrid& Terrain;
  std::size_t Sites = 0;
  std::size_t Outside = 0;
  std::size_t Holes = 0;
  Vector3 First{ 0.0, 0.0, 0.0 };
};

/// Sets plants on a terrain and drops those whose ground is beyond the limits. Why there is no ground at a site, in
/// words for a user; empty if all have one.
std::string PutOnGround(
  const HeightGrid& terrain, const GroundLimits& limits, std::vector<PlantPlace>& places, const WorkShare& share = {});

/// Deals plants out to processes that share sites, of which the first has the first sites: each gets those in its own
/// cells, in the order of their sites. The cells are those of FirstCellsOfParts().
void DealPlaces(
  const CellGrid& grid, const std::vector<int>& firstCells, const WorkShare& share, std::vector<PlantPlace>& places);

/// Drops plants that stand above or below the limits of height.
void DropOutside(const GroundLimits& limits, std::vector<PlantPlace>& places);

/// The levels of detail of a plant.
enum class PlantLevel
{
  High = 0,
  Medium = 1,
  Low = 2,
};

/// Levels of detail and culling of the plants of a view.
struct PlantViewOptions
{
  bool UseLevels = true;        ///< else all is High
  bool UseCulling = true;       ///< else all is shown
  double NearDistance = 30.0;   ///< of levels, up to which a plant is High [m]
  double FarDistance = 130.0;   ///< up to which it is Medium [m]
  double VisibleDistance = 0.0; ///< of sight, up to which it is shown [m]; 0: no limit
};

/// A plant that a view shows.
struct ShownPlant
{
  int Place = 0; ///< index into the places
  PlantLevel Level = PlantLevel::High;
};

/// Plants that a view shows, in the order of the places. `cellsShown` are the marks of the cells for this view.
std::vector<ShownPlant> ShownPlants(const std::vector<PlantPlace>& places, const SceneCells& cells,
  const std::vector<char>& cellsShown, const View& view, const PlantViewOptions& options);

/// Takes vertices from a prototype to a plant.
class PlantPlacement
{
public:
  explicit PlantPlacement(const PlantPlace& place);

  void Points(const float* from, std::size_t count, float* to) const;
  /// Normals, and other directions at right angles to a surface.
  void Directions(const float* from, std::size_t count, float* to) const;
  /// Lengths across branches, as radii.
  void Lengths(const float* from, std::size_t count, float* to) const;
  void Colors(const unsigned char* from, std::size_t count, unsigned char* to) const;

private:
  const PlantPlace& Place;
  double Cosine;
  double Sine;
};

}

#endif
