// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportStandFoliage_h
#define LittoralSupportStandFoliage_h

// The leaves of a stand, whatever form it has: plants as blocks, instances of plants, or trees by their dimensions.
// Private: never installed, never wrapped.

#include "Numerics/Parallel.h"
#include "Numerics/WorkShare.h"
#include "Plants/CanopyDensity.h"
#include "Plants/LeafInclination.h"
#include "Plants/LeafTraits.h"
#include "Plants/PlantFoliage.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataObject;

namespace littoral
{

/// Ways to count the leaves of instances.
enum class FoliageDetail
{
  Automatic = 0, ///< leaves, where all plants together have at most 20 million triangles
  Leaves = 1,
  Parcels = 2,
};

/// Numbers and names that a stand does not tell.
struct StandOptions
{
  std::string SpeciesNames;                        ///< separated by semicolons
  double MassPerArea = 0.0;                        ///< of leaves [kg/m2]; 0: by species
  FoliageDetail Detail = FoliageDetail::Automatic; ///< of instances
  double LeafAreaIndex = 0.0;                      ///< of crowns of trees without leaves; 0: by diameter
  double MaximumHeight = 0.7;                      ///< z_m / h of trees without leaves
  bool HeightsAboveGround = false;                 ///< z of each plant is that above its own foot
};

/// A species, or a kind of plants.
struct StandKind
{
  std::string Name;
  LeafTraits Traits = HardwoodTraits();
};

/// A plant as one cylinder.
struct StandCrown
{
  Vector3 Foot;
  int Plant; ///< its number in the stand
  int Kind;
  double Height;        ///< [m]
  double Diameter;      ///< of the crown [m]
  double LeafArea;      ///< [m2]
  double MaximumHeight; ///< z_m / h of the profile with the mean height of its leaves
};

/// A stand of any form. Processes that share one have a part of the plants each.
class StandFoliage
{
public:
  virtual ~StandFoliage() = default;

  const std::vector<StandKind>& Kinds() const { return this->KindList; }

  /// One-sided leaf area of all plants, of all processes [m2].
  virtual double LeafArea() const = 0;

  /// Half the surface of the wood of all plants, of all processes [m2].
  virtual double WoodArea() const = 0;

  /// The own plants as cylinders.
  virtual std::vector<StandCrown> Crowns() const = 0;

  /// Adds all plants to the cells, and the angles of their leaves. Called by all processes.
  virtual void AddTo(CanopyDensity& density, LeafInclination& inclination, const ParallelFor& parallel) const = 0;

protected:
  std::vector<StandKind> KindList;
};

/// Reads a stand, checking all of it. Throws InvalidInput, which names the input as in the panel. Only instances can be
/// shared; the share must live as long as they are used.
std::unique_ptr<StandFoliage> ReadStand(
  vtkDataObject* data, const char* input, const StandOptions& options, const WorkShare& share = {});

}

#endif
