// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ScatterInstances.h"

#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Data/PlantBlocks.h"
#include "Data/SeaweedBlocks.h"
#include "Numerics/Parallel.h"
#include "Pipeline/Threads.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"

#include <array>
#include <cmath>
#include <string>

namespace littoral
{

namespace
{

constexpr int Levels = 3;
constexpr std::size_t InstancesOfRange = 16384;
constexpr const char* PrototypeName = "Prototype";
constexpr const char* LevelNames[Levels] = { plant::High, plant::Medium, plant::Low };

/// The index of the block that a plant is drawn as; 0 is that of the instances.
int PrototypeOf(const std::vector<PlantPlace>& places, const ShownPlant& plant)
{
  return 1 + Levels * places[plant.Place].Species + static_cast<int>(plant.Level);
}

/// A field array of one number.
void AddNumber(vtkDataObject* block, const char* name, int number)
{
  block->GetFieldData()->AddArray(ArrayOf<vtkIntArray>(name, 1, std::vector<std::array<int, 1>>{ { number } }));
}

/// Numbers of plants, so many for each.
template <typename Array>
class Column
{
public:
  explicit Column(Array* values)
    : Values(values)
    , First(values->GetPointer(0))
    , Components(static_cast<std::size_t>(values->GetNumberOfComponents()))
  {
  }

  Column(vtkPointData* arrays, const char* name, int components, std::size_t plants)
    : Column(NewArray<Array>(name, components, static_cast<vtkIdType>(plants)))
  {
    arrays->AddArray(this->Values);
  }

  /// Sets all components of a plant.
  template <typename... Numbers>
  void Set(std::size_t plant, Numbers... values) const
  {
    auto* next = this->First + plant * this->Components;
    ((*next++ = static_cast<std::decay_t<decltype(*next)>>(values)), ...);
  }

private:
  vtkSmartPointer<Array> Values;
  decltype(Values->GetPointer(0)) First;
  std::size_t Components;
};

}

double InstanceBytes(std::size_t plants, bool hasGirths)
{
  // Position, rotation, scale, tint; prototype, plant, species, level; identity; vertex with its offset.
  const double scales = hasGirths ? 3.0 : 1.0;
  const double onePlant = (3 + 4 + scales + 3) * sizeof(float) + 4 * sizeof(int) + 8 + 2 * sizeof(vtkIdType);
  return onePlant * static_cast<double>(plants);
}

vtkSmartPointer<vtkPolyData> InstancesOf(
  const std::vector<PlantPlace>& places, const std::vector<ShownPlant>& shown, bool hasGirths)
{
  auto instances = vtkSmartPointer<vtkPolyData>::New();
  vtkPointData* arrays = instances->GetPointData();
  const std::size_t count = shown.size();
  const auto feet = NewArray<vtkFloatArray>("Points", 3, static_cast<vtkIdType>(count));
  const Column<vtkFloatArray> points(feet);
  const Column<vtkIntArray> prototypes(arrays, PrototypeName, 1, count);
  const Column<vtkFloatArray> rotations(arrays, "Rotation", 4, count);
  const Column<vtkFloatArray> scales(arrays, "Scale", hasGirths ? 3 : 1, count);
  const Column<vtkFloatArray> tints(arrays, "Tint", 3, count);
  const Column<vtkIntArray> plants(arrays, plant::PlantId, 1, count);
  const Column<vtkTypeInt64Array> sites(arrays, "SiteId", 1, count);
  const Column<vtkIntArray> species(arrays, "Species", 1, count);
  const Column<vtkIntArray> levels(arrays, "Level", 1, count);
  const auto offsets = NewArray<vtkTypeInt64Array>("", 1, static_cast<vtkIdType>(count) + 1);
  const auto connectivity = NewArray<vtkTypeInt64Array>("", 1, static_cast<vtkIdType>(count));
  const Column<vtkTypeInt64Array> starts(offsets);
  const Column<vtkTypeInt64Array> vertices(connectivity);
  starts.Set(count, count);
  ForRanges(SmpFor, count, InstancesOfRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t index = begin; index < end; ++index)
    {
      const ShownPlant& plant = shown[index];
      const PlantPlace& place = places[plant.Place];
      points.Set(index, place.Foot.x, place.Foot.y, place.Foot.z);
      prototypes.Set(index, PrototypeOf(places, plant));
      // Quaternion of a turn about the vertical: cos(a / 2) + k sin(a / 2).
      rotations.Set(index, std::cos(0.5 * place.Azimuth), 0.0, 0.0, std::sin(0.5 * place.Azimuth));
      if (hasGirths)
      {
        const double width = place.Scale * place.WidthScale;
        scales.Set(index, width, width, place.Scale);
      }
      else
      {
        scales.Set(index, place.Scale);
      }
      tints.Set(index, place.Tint[0], place.Tint[1], place.Tint[2]);
      plants.Set(index, place.Site);
      sites.Set(index, place.SiteId);
      species.Set(index, place.Species);
      levels.Set(index, static_cast<int>(plant.Level));
      starts.Set(index, index);
      vertices.Set(index, index);
    }
  });
  vtkNew<vtkPoints> all;
  all->SetData(feet);
  instances->SetPoints(all);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  instances->SetVerts(cells);
  return instances;
}

void AddLevels(const PrototypeBlocks& parts, vtkMultiBlockDataSet* blocks)
{
  const int first = static_cast<int>(blocks->GetNumberOfBlocks());
  const std::string species = std::to_string((first - 1) / Levels);
  vtkSmartPointer<vtkMultiBlockDataSet> levels[Levels];
  for (int level = 0; level < Levels; ++level)
  {
    levels[level] = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    AddBlock(blocks, (species + " " + LevelNames[level]).c_str(), levels[level]);
  }
  vtkPolyData* bones = parts[SkeletonPart];
  const bool isSeaweed = bones && bones->GetPointData()->HasArray(seaweed::Tissue);
  for (int part = 0; part < NumberOfParts; ++part)
  {
    if (parts[part] && !PartKinds[part].HasLines)
    {
      vtkNew<vtkPolyData> copy; // which stays as it is when the prototype changes
      copy->ShallowCopy(parts[part]);
      const int level = static_cast<int>(LevelOfPart[part]);
      AddNumber(copy, PrototypeName, first + level);
      AddNumber(copy, "Tinted", PartKinds[part].IsTinted ? 1 : 0);
      AddNumber(copy, "Seaweed", isSeaweed ? 1 : 0);
      AddBlock(levels[level], PartKinds[part].Name ? PartKinds[part].Name : PartKinds[part].Level, copy);
    }
  }
}

double PolygonsOf(
  vtkMultiBlockDataSet* blocks, const std::vector<PlantPlace>& places, const std::vector<ShownPlant>& shown)
{
  std::vector<double> ofPrototype{ 0.0 };
  for (unsigned int index = 1; index < blocks->GetNumberOfBlocks(); ++index)
  {
    auto* level = vtkMultiBlockDataSet::SafeDownCast(blocks->GetBlock(index));
    ofPrototype.push_back(static_cast<double>(level->GetNumberOfCells()));
  }
  double polygons = 0.0;
  for (const ShownPlant& plant : shown)
  {
    polygons += ofPrototype[PrototypeOf(places, plant)];
  }
  return polygons;
}

}
