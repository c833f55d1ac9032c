// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ScatterInstances.h"

#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Data/PlantBlocks.h"
#include "Data/ScatterTable.h"
#include "Data/SeaweedBlocks.h"

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

/// Writes numbers of plants one after the other.
template <typename Array>
class Column
{
public:
  Column(vtkPointData* arrays, const char* name, int components, std::size_t plants)
    : Values(NewArray<Array>(name, components, static_cast<vtkIdType>(plants)))
    , Next(this->Values->GetPointer(0))
  {
    arrays->AddArray(this->Values);
  }

  template <typename Number>
  void Add(Number value)
  {
    *this->Next++ = static_cast<std::decay_t<decltype(*this->Next)>>(value);
  }

private:
  vtkSmartPointer<Array> Values;
  decltype(Values->GetPointer(0)) Next;
};

}

double InstanceBytes(std::size_t plants, bool hasGirths)
{
  // Position, rotation, scale, tint; prototype, plant, species, level; identity; vertex with its offset.
  const double scales = hasGirths ? 3.0 : 1.0;
  const double onePlant = (3 + 4 + scales + 3) * sizeof(float) + 4 * sizeof(int) + 8 + 2 * sizeof(vtkIdType);
  return onePlant * static_cast<double>(plants);
}

vtkSmartPointer<vtkPolyData> InstancesOf(const std::vector<PlantPlace>& places, const std::vector<ShownPlant>& shown)
{
  auto instances = vtkSmartPointer<vtkPolyData>::New();
  vtkPointData* arrays = instances->GetPointData();
  const std::size_t count = shown.size();
  std::vector<Vector3> feet;
  feet.reserve(count);
  Column<vtkIntArray> prototypes(arrays, PrototypeName, 1, count);
  Column<vtkFloatArray> rotations(arrays, "Rotation", 4, count);
  const bool hasGirths = HasGirths(places);
  Column<vtkFloatArray> scales(arrays, "Scale", hasGirths ? 3 : 1, count);
  Column<vtkFloatArray> tints(arrays, "Tint", 3, count);
  Column<vtkIntArray> plants(arrays, plant::PlantId, 1, count);
  Column<vtkTypeInt64Array> sites(arrays, "SiteId", 1, count);
  Column<vtkIntArray> species(arrays, "Species", 1, count);
  Column<vtkIntArray> levels(arrays, "Level", 1, count);
  for (const ShownPlant& plant : shown)
  {
    const PlantPlace& place = places[plant.Place];
    feet.push_back(place.Foot);
    prototypes.Add(PrototypeOf(places, plant));
    // Quaternion of a turn about the vertical: cos(a / 2) + k sin(a / 2).
    rotations.Add(std::cos(0.5 * place.Azimuth));
    rotations.Add(0.0);
    rotations.Add(0.0);
    rotations.Add(std::sin(0.5 * place.Azimuth));
    if (hasGirths)
    {
      scales.Add(place.Scale * place.WidthScale);
      scales.Add(place.Scale * place.WidthScale);
    }
    scales.Add(place.Scale);
    for (const float factor : place.Tint)
    {
      tints.Add(factor);
    }
    plants.Add(place.Site);
    sites.Add(place.SiteId);
    species.Add(place.Species);
    levels.Add(static_cast<int>(plant.Level));
  }
  instances->SetPoints(PointsOf(feet));
  vtkNew<vtkCellArray> vertices;
  vertices->AllocateExact(static_cast<vtkIdType>(count), static_cast<vtkIdType>(count));
  for (vtkIdType point = 0; point < static_cast<vtkIdType>(count); ++point)
  {
    vertices->InsertNextCell(1, &point);
  }
  instances->SetVerts(vertices);
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
