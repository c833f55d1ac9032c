// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/StandForms.h"

#include "Data/ArrayReader.h"
#include "Data/FoliageTriangles.h"
#include "Data/Inputs.h"
#include "Data/PlantBlocks.h"
#include "Data/PlantForm.h"

#include <algorithm>
#include <map>

namespace littoral
{

namespace
{

constexpr std::size_t PolygonsAtOnce = 4096;

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
    if (options.HeightsAboveGround)
    {
      this->LowerFeet();
    }
  }

  double LeafArea() const override { return this->AreaOfLeaves; }
  double WoodArea() const override { return this->AreaOfWood; }

  std::vector<StandCrown> Crowns() const override
  {
    std::vector<StandCrown> crowns;
    for (std::size_t plant = 0; plant < this->Feet.size(); ++plant)
    {
      crowns.push_back(
        this->Measures[plant].Crown(this->Feet[plant], this->IdOfPlant[plant], this->KindOfPlant[plant]));
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
      const std::size_t plant = this->PlantOf(this->PlantOfLeaf, triangles);
      for (const FoliageTriangle& triangle : leaf)
      {
        AddLeaf(this->Lowered(triangle, plant), this->KindOfPlant[plant], density);
      }
      AddInclination(leaf, inclination);
    });
    forAll(this->Skin, nullptr, [&](const std::vector<FoliageTriangle>& bark, FoliageTriangles& triangles) {
      const std::size_t plant = this->PlantOf(this->PlantOfBark, triangles);
      for (const FoliageTriangle& triangle : bark)
      {
        AddWood(this->Lowered(triangle, plant), density);
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

  /// The triangle above the foot of its plant, if heights are those above the ground.
  FoliageTriangle Lowered(const FoliageTriangle& triangle, std::size_t plant) const
  {
    FoliageTriangle lowered = triangle;
    for (Vector3& corner : lowered.Corners)
    {
      corner.z -= this->Lowering.empty() ? 0.0 : this->Lowering[plant];
    }
    return lowered;
  }

  /// Sets all feet on z = 0.
  void LowerFeet()
  {
    Require(this->HasFeet || this->Feet.size() == 1 ? ""
                                                    : "its plants have no field array Position, above which heights "
                                                      "could be taken; switch HeightsAboveGround off.");
    for (Vector3& foot : this->Feet)
    {
      this->Lowering.push_back(foot.z);
      foot.z = 0.0;
    }
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
    this->HasFeet = feet != nullptr;
    std::size_t kinds = 1;
    for (vtkIdType row = 0; species && row < species->GetNumberOfTuples(); ++row)
    {
      this->RowOfPlant[static_cast<int>(ids->GetComponent(row, 0))] = static_cast<std::size_t>(row);
      const int kind = static_cast<int>(species->GetComponent(row, 0));
      this->KindOfPlant.push_back(kind);
      this->IdOfPlant.push_back(static_cast<int>(ids->GetComponent(row, 0)));
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
      this->IdOfPlant.push_back(0);
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
  std::vector<int> IdOfPlant;
  std::vector<Vector3> Feet;
  bool HasFeet = false;
  std::vector<double> Lowering; ///< of each plant [m]; empty: none
  std::vector<CrownMeasure> Measures;
  double AreaOfLeaves = 0.0;
  double AreaOfWood = 0.0;
};

}

//----------------------------------------------------------------------------
std::unique_ptr<StandFoliage> MergedFoliage(vtkMultiBlockDataSet* blocks, const StandOptions& options)
{
  return std::make_unique<MergedStand>(blocks, options);
}

}
