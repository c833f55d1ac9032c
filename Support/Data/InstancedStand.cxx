// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/StandForms.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Data/FoliageTriangles.h"
#include "Data/Inputs.h"
#include "Data/PlantBlocks.h"
#include "Data/PlantForm.h"
#include "Plants/FoliageParcels.h"

#include "vtkIntArray.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double MostTriangles = 2e7;    ///< of all plants, which are counted one by one
constexpr double ParcelsOfCell = 1.5;    ///< along a side
constexpr std::size_t PlantsAtOnce = 64; ///< by a thread
constexpr int LevelsOfPlant = 3;

/// Instances of plants, as vtkPlantScatterFilter makes them.
class InstancedStand : public StandFoliage
{
public:
  InstancedStand(
    vtkMultiBlockDataSet* blocks, vtkPolyData* instances, const StandOptions& options, const WorkShare& share)
    : Detail(options.Detail)
    , Share(share)
  {
    RequireWhole(blocks, share);
    this->ReadKinds(blocks, options);
    this->ReadPlaces(instances, options.HeightsAboveGround);
    std::vector<double> triangles;
    for (const PlantFoliage& kind : this->Plants)
    {
      triangles.push_back(static_cast<double>(kind.Leaves.size() + kind.Wood.size()));
      this->Own.push_back({ { kind.Leaves, Unparcelled }, { kind.Wood, Unparcelled } });
      CrownMeasure& measure = this->Measures.emplace_back();
      for (const FoliageTriangle& leaf : kind.Leaves)
      {
        measure.Add(leaf, Vector3(0.0), true);
      }
      for (const FoliageTriangle& bark : kind.Wood)
      {
        measure.Add(bark, Vector3(0.0), false);
      }
    }
    std::vector<double> sums(3, 0.0); // triangles, leaves and wood
    for (const FoliagePlace& place : this->Places)
    {
      const double leaf = this->AreaOf(place, &ParcelledPlant::Leaves);
      sums[0] += triangles[place.Kind];
      sums[1] += leaf;
      sums[2] += this->AreaOf(place, &ParcelledPlant::Wood);
      this->LeafAreas.push_back(leaf);
    }
    share.AddUp(sums);
    this->IsParcelled =
      this->Detail == FoliageDetail::Parcels || (this->Detail == FoliageDetail::Automatic && sums[0] > MostTriangles);
    this->AreaOfLeaves = sums[1];
    this->AreaOfWood = sums[2];
  }

  double LeafArea() const override { return this->AreaOfLeaves; }
  double WoodArea() const override { return this->AreaOfWood; }

  std::vector<StandCrown> Crowns() const override
  {
    std::vector<StandCrown> ofKind;
    for (const CrownMeasure& measure : this->Measures)
    {
      ofKind.push_back(measure.Crown(Vector3(0.0), 0, 0));
    }
    std::vector<StandCrown> crowns;
    for (std::size_t plant = 0; plant < this->Places.size(); ++plant)
    {
      const FoliagePlace& place = this->Places[plant];
      const StandCrown& own = ofKind[place.Kind];
      const double width = std::sqrt(place.Scale.x * place.Scale.y);
      crowns.push_back({ place.Foot, this->Ids.empty() ? static_cast<int>(plant) : this->Ids[plant], place.Kind,
        place.Scale.z * own.Height, width * own.Diameter, this->LeafAreas[plant], own.MaximumHeight });
    }
    return crowns;
  }

  void AddTo(CanopyDensity& density, LeafInclination& inclination, const ParallelFor& parallel) const override
  {
    std::vector<ParcelledPlant> parcels;
    const Vector3& spacing = density.GetGrid().Spacing;
    const double side = std::min({ spacing.x, spacing.y, spacing.z }) / ParcelsOfCell;
    for (const PlantFoliage& kind : this->Plants)
    {
      if (this->IsParcelled)
      {
        parcels.push_back({ { kind.Leaves, side }, { kind.Wood, side } });
      }
    }
    const std::vector<std::size_t> order = OrderOfNeighbors(density.GetGrid(), this->Places);
    ForRanges(parallel, order.size(), PlantsAtOnce, [&](std::size_t begin, std::size_t end) {
      PlantCells cells;
      for (std::size_t n = begin; n < end; ++n)
      {
        const FoliagePlace& place = this->Places[order[n]];
        this->IsParcelled ? AddPlant(parcels[place.Kind], place, cells, density)
                          : AddPlant(this->Plants[place.Kind], place, density);
      }
    });
    density.AddUp(this->Share);
    this->AddAngles(inclination);
  }

private:
  static constexpr double Unparcelled = 1e6; ///< one parcel a plant: only areas are asked of it

  void ReadKinds(vtkMultiBlockDataSet* blocks, const StandOptions& options)
  {
    const unsigned int count = (blocks->GetNumberOfBlocks() - 1) / LevelsOfPlant;
    for (unsigned int kind = 0; kind < count; ++kind)
    {
      auto* high = vtkMultiBlockDataSet::SafeDownCast(blocks->GetBlock(1 + LevelsOfPlant * kind));
      PlantFoliage& plant = this->Plants.emplace_back();
      if (auto* leaves = this->PartOf(high, plant::Leaves, kind))
      {
        RequireTexture(leaves, "Leaves of species " + std::to_string(kind));
        const TextureImage picture = ReadTexture(leaves);
        plant.Leaves = TrianglesOf(leaves, &picture);
      }
      plant.Wood = TrianglesOf(this->PartOf(high, plant::Skin, kind), nullptr);
    }
    Require(count > 0 ? "" : "its instances have no plants.");
    this->KindList = KindsOf(blocks, count, options);
  }

  static vtkPolyData* PartOf(vtkMultiBlockDataSet* level, const char* name, unsigned int kind)
  {
    auto* part = vtkPolyData::SafeDownCast(FindBlock(level, name));
    if (part)
    {
      RequireDrawing(part, std::string(name) + " of species " + std::to_string(kind));
    }
    return part;
  }

  void ReadPlaces(vtkPolyData* instances, bool aboveGround)
  {
    RequireFit(instances, "Instances of the stand");
    const ArrayReader points = ArrayReader::OfPoints(instances, "Instances of the stand");
    vtkDataArray* species = points.Need("Species", 1);
    vtkDataArray* rotations = points.Need("Rotation", 4);
    vtkDataArray* widths = points.Seek("Scale", 3);
    vtkDataArray* scales = widths ? widths : points.Need("Scale", 1);
    points.NeedIds(species, static_cast<vtkIdType>(this->Plants.size()), "species");
    points.NeedFinite(rotations);
    points.NeedFinite(scales);
    points.NeedFinite(instances->GetPoints() ? instances->GetPoints()->GetData() : nullptr);
    SetSize(this->Places, instances->GetNumberOfPoints());
    if (auto* ids = vtkIntArray::SafeDownCast(points.Seek(plant::PlantId, 1)))
    {
      SetSize(this->Ids, ids->GetNumberOfTuples());
      std::copy_n(ids->GetPointer(0), this->Ids.size(), this->Ids.begin());
    }
    for (vtkIdType point = 0; point < instances->GetNumberOfPoints(); ++point)
    {
      FoliagePlace& place = this->Places[static_cast<std::size_t>(point)];
      place.Kind = static_cast<int>(species->GetComponent(point, 0));
      instances->GetPoint(point, &place.Foot.x);
      place.Foot.z = aboveGround ? 0.0 : place.Foot.z;
      place.Rotation = glm::dquat(rotations->GetComponent(point, 0), rotations->GetComponent(point, 1),
        rotations->GetComponent(point, 2), rotations->GetComponent(point, 3));
      for (int axis = 0; axis < 3; ++axis)
      {
        place.Scale[axis] = scales->GetComponent(point, widths ? axis : 0);
      }
      const double length = glm::length(place.Rotation);
      const double least = std::min({ place.Scale.x, place.Scale.y, place.Scale.z });
      if (!(least > 0.0) || !(std::abs(length - 1.0) < 1e-3))
      {
        Refuse("instance ", point, " has the scale ", least, " and a rotation of length ", length,
          "; scales must be positive and rotations of unit length.");
      }
      place.Rotation = place.Rotation * (1.0 / length);
    }
  }

  /// Area of the leaves or of the wood of a plant.
  double AreaOf(const FoliagePlace& place, FoliageParcels ParcelledPlant::*parcels) const
  {
    const FoliageParcels& own = this->Own[place.Kind].*parcels;
    const double width = std::sqrt(place.Scale.x * place.Scale.y);
    return width * width * own.AreaFactor(place.Scale.z / width) * own.Area();
  }

  void AddAngles(LeafInclination& inclination) const
  {
    OrderFreeSums ofKind(this->Plants.size());
    for (std::size_t plant = 0; plant < this->Places.size(); ++plant)
    {
      ofKind.Add(static_cast<std::size_t>(this->Places[plant].Kind), this->LeafAreas[plant]);
    }
    ofKind.AddUp(this->Share);
    for (std::size_t kind = 0; kind < this->Plants.size(); ++kind)
    {
      LeafInclination own;
      AddInclination(this->Plants[kind].Leaves, own);
      const double area = CountedArea(this->Plants[kind].Leaves);
      inclination.Add(own, area > 0.0 ? ofKind.At(kind) / area : 0.0);
    }
  }

  FoliageDetail Detail;
  WorkShare Share;
  bool IsParcelled = false;
  std::vector<PlantFoliage> Plants;
  std::vector<ParcelledPlant> Own;
  std::vector<CrownMeasure> Measures;
  std::vector<FoliagePlace> Places;
  std::vector<int> Ids; ///< empty: by their order
  std::vector<double> LeafAreas;
  double AreaOfLeaves = 0.0; ///< of all processes, as the next
  double AreaOfWood = 0.0;
};

}

//----------------------------------------------------------------------------
std::unique_ptr<StandFoliage> InstancedFoliage(
  vtkMultiBlockDataSet* blocks, vtkPolyData* instances, const StandOptions& options, const WorkShare& share)
{
  return std::make_unique<InstancedStand>(blocks, instances, options, share);
}

}
