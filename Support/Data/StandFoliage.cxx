// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/StandFoliage.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Data/FoliageTriangles.h"
#include "Data/Inputs.h"
#include "Data/PlantBlocks.h"
#include "Data/PlantForm.h"
#include "Numerics/Constants.h"
#include "Plants/CanopyProfile.h"
#include "Plants/CrownCylinder.h"
#include "Plants/FoliageParcels.h"
#include "Plants/StandAllometry.h"

#include "vtkPointSet.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

namespace littoral
{

namespace
{

constexpr double MostTriangles = 2e7;    ///< of all plants, which are counted one by one
constexpr double ParcelsOfCell = 1.5;    ///< along a side
constexpr std::size_t PlantsAtOnce = 64; ///< by a thread
constexpr std::size_t PolygonsAtOnce = 4096;
constexpr std::size_t TreesAtOnce = 256;
constexpr int MostKinds = 1000; ///< species of a stand
constexpr double TallestTree = 150.0;
constexpr int LevelsOfPlant = 3;

/// Words between semicolons, without the blanks around them.
std::vector<std::string> WordsIn(const std::string& text)
{
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ';');)
  {
    const std::size_t first = word.find_first_not_of(" \t");
    const std::size_t last = word.find_last_not_of(" \t");
    words.push_back(first == std::string::npos ? "" : word.substr(first, last - first + 1));
  }
  return words;
}

/// Kinds by the names of the options, else by those of the data, else by numbers.
std::vector<StandKind> KindsOf(vtkDataObject* data, std::size_t count, const StandOptions& options)
{
  const std::vector<std::string> names = WordsIn(options.SpeciesNames);
  vtkStringArray* own = ArrayReader::OfFields(data, "The stand").FindTexts("Kinds");
  std::vector<StandKind> kinds;
  for (std::size_t n = 0; n < count; ++n)
  {
    StandKind& kind = kinds.emplace_back();
    const auto row = static_cast<vtkIdType>(n);
    kind.Name = n < names.size() ? names[n] : own && row < own->GetNumberOfValues() ? own->GetValue(row) : "";
    kind.Name = kind.Name.empty() ? "Species " + std::to_string(n) : kind.Name;
    const LeafTraits* listed = FindLeafTraits(kind.Name);
    kind.Traits = listed ? *listed : HardwoodTraits();
    kind.Traits.MassPerArea = options.MassPerArea > 0.0 ? options.MassPerArea : kind.Traits.MassPerArea;
  }
  return kinds;
}

/// A number of the field data; another one where there is none.
double FieldOf(vtkDataObject* data, const char* name, double otherwise)
{
  vtkDataArray* field = ArrayReader::OfFields(data, "The stand", 1).Seek(name, 1);
  return field ? field->GetComponent(0, 0) : otherwise;
}

/// All plants must be there.
void RequireWhole(vtkDataObject* data)
{
  const double all = FieldOf(data, "PlantsInAll", 0.0);
  const double shown = FieldOf(data, "PlantsShown", all);
  if (shown < all)
  {
    Refuse("only ", shown, " of ", all, " plants are in view; switch UseCulling of the scattered plants off.");
  }
}

/// Height, reach and mean height of the leaves of a plant from its foot.
struct CrownMeasure
{
  double Top = 0.0;
  double Reach = 0.0;
  double Moment = 0.0; ///< area times height
  double Area = 0.0;

  void Add(const FoliageTriangle& triangle, const Vector3& foot, bool isLeaf)
  {
    Vector3 mean(0.0);
    for (const Vector3& corner : triangle.Corners)
    {
      const Vector3 place = corner - foot;
      this->Top = std::max(this->Top, place.z);
      this->Reach = isLeaf ? std::max(this->Reach, std::hypot(place.x, place.y)) : this->Reach;
      mean += place / 3.0;
    }
    const double area = isLeaf ? CountedArea(triangle) : 0.0;
    this->Area += area;
    this->Moment += area * mean.z;
  }

  StandCrown Crown(const Vector3& foot, int kind) const
  {
    const double mean = this->Area > 0.0 && this->Top > 0.0 ? this->Moment / this->Area / this->Top : 0.5;
    return { foot, kind, this->Top, 2.0 * this->Reach, this->Area, MaximumOfMean(mean) };
  }
};

//----------------------------------------------------------------------------
/// Instances of plants, as vtkPlantScatterFilter makes them.
class InstancedStand : public StandFoliage
{
public:
  InstancedStand(vtkMultiBlockDataSet* blocks, vtkPolyData* instances, const StandOptions& options)
    : Detail(options.Detail)
  {
    RequireWhole(blocks);
    this->ReadKinds(blocks, options);
    this->ReadPlaces(instances);
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
    double all = 0.0;
    for (const FoliagePlace& place : this->Places)
    {
      all += triangles[place.Kind];
      const double leaf = this->AreaOf(place, &ParcelledPlant::Leaves);
      this->AreaOfLeaves += leaf;
      this->AreaOfWood += this->AreaOf(place, &ParcelledPlant::Wood);
      this->LeafAreas.push_back(leaf);
    }
    this->IsParcelled =
      this->Detail == FoliageDetail::Parcels || (this->Detail == FoliageDetail::Automatic && all > MostTriangles);
  }

  double LeafArea() const override { return this->AreaOfLeaves; }
  double WoodArea() const override { return this->AreaOfWood; }

  std::vector<StandCrown> Crowns() const override
  {
    std::vector<StandCrown> ofKind;
    for (const CrownMeasure& measure : this->Measures)
    {
      ofKind.push_back(measure.Crown(Vector3(0.0), 0));
    }
    std::vector<StandCrown> crowns;
    for (std::size_t plant = 0; plant < this->Places.size(); ++plant)
    {
      const FoliagePlace& place = this->Places[plant];
      const StandCrown& own = ofKind[place.Kind];
      const double width = std::sqrt(place.Scale.x * place.Scale.y);
      crowns.push_back({ place.Foot, place.Kind, place.Scale.z * own.Height, width * own.Diameter,
        this->LeafAreas[plant], own.MaximumHeight });
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

  void ReadPlaces(vtkPolyData* instances)
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
    for (vtkIdType point = 0; point < instances->GetNumberOfPoints(); ++point)
    {
      FoliagePlace& place = this->Places[static_cast<std::size_t>(point)];
      place.Kind = static_cast<int>(species->GetComponent(point, 0));
      instances->GetPoint(point, &place.Foot.x);
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
    std::vector<double> ofKind(this->Plants.size(), 0.0);
    for (std::size_t plant = 0; plant < this->Places.size(); ++plant)
    {
      ofKind[this->Places[plant].Kind] += this->LeafAreas[plant];
    }
    for (std::size_t kind = 0; kind < this->Plants.size(); ++kind)
    {
      LeafInclination own;
      AddInclination(this->Plants[kind].Leaves, own);
      const double area = CountedArea(this->Plants[kind].Leaves);
      inclination.Add(own, area > 0.0 ? ofKind[kind] / area : 0.0);
    }
  }

  FoliageDetail Detail;
  bool IsParcelled = false;
  std::vector<PlantFoliage> Plants;
  std::vector<ParcelledPlant> Own;
  std::vector<CrownMeasure> Measures;
  std::vector<FoliagePlace> Places;
  std::vector<double> LeafAreas;
  double AreaOfLeaves = 0.0;
  double AreaOfWood = 0.0;
};

//----------------------------------------------------------------------------
/// One plant, or many merged, with all their leaves.
class MergedStand : public StandFoliage
{
public:
  MergedStand(vtkMultiBlockDataSet* blocks, const StandOptions& options)
    : Leaves(PlantPartOf(blocks, plant::High, plant::Leaves))
    , Skin(PlantPartOf(blocks, plant::High, plant::Skin))
  {
    RequirePlants(blocks);
    RequireWhole(blocks);
    const double far = FieldOf(blocks, "PlantsMedium", 0.0) + FieldOf(blocks, "PlantsLow", 0.0);
    if (far > 0.0)
    {
      Refuse(far, " of ", FieldOf(blocks, "PlantsShown", far),
        " plants are far ones without leaves; set OutputForm of the scattered plants to Instances, or switch UseLevels "
        "off.");
    }
    Require(this->Leaves || this->Skin ? "" : "it has no block High/Leaves or High/Skin.");
    this->Picture = ReadTexture(this->Leaves);
    this->ReadTable(blocks, options);
    this->Measure();
  }

  double LeafArea() const override { return this->AreaOfLeaves; }
  double WoodArea() const override { return this->AreaOfWood; }

  std::vector<StandCrown> Crowns() const override
  {
    std::vector<StandCrown> crowns;
    for (std::size_t plant = 0; plant < this->Feet.size(); ++plant)
    {
      crowns.push_back(this->Measures[plant].Crown(this->Feet[plant], this->KindOfPlant[plant]));
    }
    return crowns;
  }

  void AddTo(CanopyDensity& density, LeafInclination& inclination, const ParallelFor& parallel) const override
  {
    const auto forAll = [&](vtkPolyData* block, const TextureImage* picture, const auto& add) {
      const auto count = static_cast<std::size_t>(block ? block->GetNumberOfPolys() : 0);
      if (count == 0)
      {
        return; // there may be no block either
      }
      ForRanges(parallel, count, PolygonsAtOnce, [&](std::size_t begin, std::size_t end) {
        FoliageTriangles triangles(block, picture);
        for (std::size_t polygon = begin; polygon < end; ++polygon)
        {
          add(triangles.Of(static_cast<vtkIdType>(polygon)), triangles);
        }
      });
    };
    forAll(this->Leaves, &this->Picture, [&](const std::vector<FoliageTriangle>& leaf, FoliageTriangles& triangles) {
      const int kind = this->KindOfPlant[this->PlantOf(this->PlantOfLeaf, triangles)];
      for (const FoliageTriangle& triangle : leaf)
      {
        AddLeaf(triangle, kind, density);
      }
      AddInclination(leaf, inclination);
    });
    forAll(this->Skin, nullptr, [&](const std::vector<FoliageTriangle>& bark, FoliageTriangles&) {
      for (const FoliageTriangle& triangle : bark)
      {
        AddWood(triangle, density);
      }
    });
  }

private:
  /// Row of the table of plants for a polygon.
  std::size_t PlantOf(vtkIntArray* ids, const FoliageTriangles& triangles) const
  {
    if (!ids || this->RowOfPlant.empty())
    {
      return 0;
    }
    const auto row = this->RowOfPlant.find(ids->GetValue(triangles.FirstPoint()));
    return row == this->RowOfPlant.end() ? 0 : row->second;
  }

  void ReadTable(vtkMultiBlockDataSet* blocks, const StandOptions& options)
  {
    this->PlantOfLeaf = this->Leaves ? FindPlantIds(this->Leaves) : nullptr;
    this->PlantOfBark = this->Skin ? FindPlantIds(this->Skin) : nullptr;
    const ArrayReader fields = ArrayReader::OfFields(blocks, "The stand");
    vtkDataArray* ids = fields.Seek(plant::PlantId, 1);
    const ArrayReader rows = ArrayReader::OfFields(blocks, "The stand", ids ? ids->GetNumberOfTuples() : vtkIdType(-1));
    vtkDataArray* species = ids ? rows.Find("Species", 1) : nullptr;
    vtkDataArray* feet = ids ? rows.Find("Position", 3) : nullptr;
    rows.NeedIds(species, VTK_INT_MAX, "species");
    rows.NeedFinite(feet);
    std::size_t kinds = 1;
    for (vtkIdType row = 0; species && row < species->GetNumberOfTuples(); ++row)
    {
      this->RowOfPlant[static_cast<int>(ids->GetComponent(row, 0))] = static_cast<std::size_t>(row);
      const int kind = static_cast<int>(species->GetComponent(row, 0));
      this->KindOfPlant.push_back(kind);
      kinds = std::max(kinds, static_cast<std::size_t>(kind) + 1);
      Vector3& foot = this->Feet.emplace_back(0.0);
      for (int axis = 0; feet && axis < 3; ++axis)
      {
        foot[axis] = feet->GetComponent(row, axis);
      }
    }
    Require(kinds <= std::size_t{ MostKinds } ? "" : "its Species are more than " + std::to_string(MostKinds) + ".");
    if (this->KindOfPlant.empty())
    {
      this->KindOfPlant.push_back(0);
      this->Feet.emplace_back(0.0);
    }
    this->KindList = KindsOf(blocks, kinds, options);
  }

  void Measure()
  {
    this->Measures.resize(this->Feet.size());
    const auto measure = [&](vtkPolyData* block, const TextureImage* picture, vtkIntArray* ids, double& area) {
      const vtkIdType count = block ? block->GetNumberOfPolys() : 0;
      if (count == 0)
      {
        return;
      }
      FoliageTriangles triangles(block, picture);
      for (vtkIdType polygon = 0; polygon < count; ++polygon)
      {
        for (const FoliageTriangle& triangle : triangles.Of(polygon))
        {
          const std::size_t plant = this->PlantOf(ids, triangles);
          this->Measures[plant].Add(triangle, this->Feet[plant], picture != nullptr);
          area += CountedArea(triangle);
        }
      }
    };
    measure(this->Leaves, &this->Picture, this->PlantOfLeaf, this->AreaOfLeaves);
    measure(this->Skin, nullptr, this->PlantOfBark, this->AreaOfWood);
  }

  vtkPolyData* Leaves;
  vtkPolyData* Skin;
  vtkIntArray* PlantOfLeaf = nullptr;
  vtkIntArray* PlantOfBark = nullptr;
  TextureImage Picture;
  std::map<int, std::size_t> RowOfPlant;
  std::vector<int> KindOfPlant;
  std::vector<Vector3> Feet;
  std::vector<CrownMeasure> Measures;
  double AreaOfLeaves = 0.0;
  double AreaOfWood = 0.0;
};

//----------------------------------------------------------------------------
/// Trees by their dimensions, as vtkStandInventoryFilter makes them.
class TreeStand : public StandFoliage
{
public:
  TreeStand(vtkPointSet* trees, const StandOptions& options)
    : MaximumHeight(options.MaximumHeight)
  {
    const ArrayReader points = ArrayReader::OfPoints(trees, "The stand");
    vtkDataArray* heights = points.Need("Height", 1);
    vtkDataArray* stems = points.Find("DBH", 1);
    vtkDataArray* widths = stems ? points.Find("CrownDiameter", 1) : points.Need("CrownDiameter", 1);
    vtkDataArray* areas = points.Find("LeafArea", 1);
    vtkDataArray* species = points.Find("Species", 1);
    for (vtkDataArray* array : { heights, stems, widths, areas })
    {
      points.NeedFinite(array);
    }
    points.NeedFinite(trees->GetPoints() ? trees->GetPoints()->GetData() : nullptr);
    points.NeedIds(species, MostKinds, "species");
    const bool isKnown = areas || options.LeafAreaIndex > 0.0 || stems;
    Require(isKnown ? "" : "its trees have neither LeafArea nor DBH; set LeafAreaIndex.");
    double last = 0.0;
    for (vtkIdType tree = 0; species && tree < species->GetNumberOfTuples(); ++tree)
    {
      last = std::max(last, species->GetComponent(tree, 0));
    }
    this->KindList = KindsOf(trees, static_cast<std::size_t>(last) + 1, options);
    for (vtkIdType tree = 0; tree < trees->GetNumberOfPoints(); ++tree)
    {
      const std::string ofTree = " of tree " + std::to_string(tree);
      const int kind = species ? static_cast<int>(species->GetComponent(tree, 0)) : 0;
      StandCrown crown{ {}, kind, heights->GetComponent(tree, 0), 0.0, 0.0, options.MaximumHeight };
      trees->GetPoint(tree, &crown.Foot.x);
      ParameterCheck check;
      check.Positive("Height" + ofTree, crown.Height, "m", TallestTree);
      const double stem = stems ? stems->GetComponent(tree, 0) : 1.0;
      check.Positive("DBH" + ofTree, stem, "m");
      Require(check.Reason());
      crown.Diameter = widths ? widths->GetComponent(tree, 0) : CrownDiameterOf(stem, crown.Height);
      check.Positive("CrownDiameter" + ofTree, crown.Diameter, "m");
      const LeafTraits& traits = this->KindList[kind].Traits;
      crown.LeafArea = areas          ? areas->GetComponent(tree, 0)
        : options.LeafAreaIndex > 0.0 ? options.LeafAreaIndex * 0.25 * Pi * crown.Diameter * crown.Diameter
                                      : FoliageMassOf(traits, stem) / traits.MassPerArea;
      check.NotNegative("LeafArea" + ofTree, crown.LeafArea, "m2");
      Require(check.Reason());
      this->AreaOfLeaves += crown.LeafArea;
      this->AreaOfWood += traits.WoodPerLeaf * crown.LeafArea;
      this->List.push_back(crown);
    }
  }

  double LeafArea() const override { return this->AreaOfLeaves; }
  double WoodArea() const override { return this->AreaOfWood; }
  std::vector<StandCrown> Crowns() const override { return this->List; }

  void AddTo(CanopyDensity& density, LeafInclination& inclination, const ParallelFor& parallel) const override
  {
    const CanopyProfile profile(this->MaximumHeight);
    ForRanges(parallel, this->List.size(), TreesAtOnce, [&](std::size_t begin, std::size_t end) {
      for (std::size_t tree = begin; tree < end; ++tree)
      {
        const StandCrown& crown = this->List[tree];
        const double wood = this->KindList[crown.Kind].Traits.WoodPerLeaf;
        ShareBetweenCells(density.GetGrid(), { crown.Foot, crown.Height, crown.Diameter }, profile,
          [&](std::size_t cell, double share) {
            density.AddLeaf(crown.Kind, cell, share * crown.LeafArea);
            density.AddWood(cell, share * wood * crown.LeafArea);
          });
      }
    });
    inclination.AddSphere(this->AreaOfLeaves);
  }

private:
  double MaximumHeight;
  std::vector<StandCrown> List;
  double AreaOfLeaves = 0.0;
  double AreaOfWood = 0.0;
};

}

//----------------------------------------------------------------------------
std::unique_ptr<StandFoliage> ReadStand(vtkDataObject* data, const char* input, const StandOptions& options)
{
  std::unique_ptr<StandFoliage> stand;
  if (auto* trees = vtkPointSet::SafeDownCast(data))
  {
    RequireFit(trees, input);
    stand = std::make_unique<TreeStand>(trees, options);
  }
  else
  {
    const vtkSmartPointer<vtkMultiBlockDataSet> blocks = BlocksOf(data, input);
    auto* instances = vtkPolyData::SafeDownCast(FindBlock(blocks, "Instances"));
    if (instances)
    {
      stand = std::make_unique<InstancedStand>(blocks, instances, options);
    }
    else
    {
      stand = std::make_unique<MergedStand>(blocks, options);
    }
  }
  Require(stand->LeafArea() > 0.0 ? "" : "it has no leaf area.");
  const bool isSmall = stand->LeafArea() + stand->WoodArea() < OrderFreeSums::Largest;
  Require(isSmall ? "" : "it has more than 5e8 m2 of leaves and wood; take a part of it.");
  return stand;
}

}
