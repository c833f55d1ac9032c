// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ScatterMerge.h"

#include "Data/Blocks.h"
#include "Data/ScatterTable.h"

#include "vtkNew.h"

#include <algorithm>
#include <utility>

namespace littoral
{

namespace
{

/// Polygons that one thread copies at a time, in whole plants.
constexpr std::size_t PolygonsAtOnce = 100000;

}

ScatterMerge::ScatterMerge(const ScatterPrototypes& prototypes, const std::vector<PlantPlace>& places,
  const std::vector<ShownPlant>& shown, const View* facing, bool withSurfaces, const MergedBlocks& last)
  : Species(prototypes)
  , Places(places)
  , Facing(facing)
{
  for (const ShownPlant& plant : shown)
  {
    this->Blocks.Shown[static_cast<int>(plant.Level)].push_back(plant.Place);
  }
  this->Merges.reserve(NumberOfParts);
  const double girthBytes = HasGirths(places) ? sizeof(double) : 0.0;
  this->Bytes = (TableBytes + girthBytes) * static_cast<double>(shown.size());
  for (int part = 0; part < NumberOfParts; ++part)
  {
    const auto level = static_cast<std::size_t>(LevelOfPart[part]);
    const bool isMade = withSurfaces || !IsSurface(part);
    this->Merges.emplace_back(this->AreCards(part) ? prototypes.FacingLow : prototypes.Parts[part], places,
      isMade ? this->Blocks.Shown[level] : this->None);
    this->Bytes += this->Merges.back().GetBytes();
    if (!this->AreCards(part) && this->Blocks.Shown[level] == last.Shown[level])
    {
      this->Blocks.Parts[part] = last.Parts[part];
    }
  }
  for (int part : { SkeletonPart, SkinPart, LeavesPart })
  {
    this->Merges[part].SetSkeleton(&this->Merges[SkeletonPart]);
  }
}

double ScatterMerge::GetNumberOfPolygons() const
{
  double polygons = 0.0;
  for (int part = 0; part < NumberOfParts; ++part)
  {
    polygons += PartKinds[part].HasLines ? 0.0 : static_cast<double>(this->Merges[part].GetNumberOfCells());
  }
  return polygons;
}

std::size_t ScatterMerge::Begin()
{
  for (int part = 0; part < NumberOfParts; ++part)
  {
    if (!this->Blocks.Parts[part])
    {
      this->Make(part);
    }
  }
  return this->Jobs.size();
}

void ScatterMerge::Make(int part)
{
  this->Merges[part].Allocate();
  this->Blocks.Parts[part] = this->Merges[part].GetOutput();
  if (this->Species.Textures[part])
  {
    this->Blocks.Parts[part]->GetFieldData()->ShallowCopy(this->Species.Textures[part]);
  }
  const std::size_t plants = this->Merges[part].GetNumberOfPlants();
  const std::size_t polygons = std::max<std::size_t>(1, this->Merges[part].GetNumberOfCells());
  const std::size_t atOnce = std::clamp<std::size_t>(PolygonsAtOnce * plants / polygons, 1, 1024);
  for (std::size_t plant = 0; plant < plants; plant += atOnce)
  {
    this->Jobs.push_back({ part, plant, std::min(plant + atOnce, plants) });
  }
}

void ScatterMerge::Do(std::size_t job)
{
  const auto [part, plant, end] = this->Jobs[job];
  this->Merges[part].Fill(plant, end);
  for (std::size_t index = plant; this->AreCards(part) && index < end; ++index)
  {
    this->PlaceCard(index);
  }
}

void ScatterMerge::AddTo(vtkMultiBlockDataSet* output) const
{
  vtkNew<vtkMultiBlockDataSet> high;
  vtkNew<vtkMultiBlockDataSet> medium;
  AddBlock(output, plant::High, high);
  AddBlock(output, plant::Medium, medium);
  vtkMultiBlockDataSet* const levels[] = { high, medium, output };
  for (int part = 0; part < NumberOfParts; ++part)
  {
    const char* name = PartKinds[part].Name ? PartKinds[part].Name : PartKinds[part].Level;
    AddBlock(levels[static_cast<int>(LevelOfPart[part])], name, this->Blocks.Parts[part]);
  }
}

MergedBlocks ScatterMerge::TakeBlocks()
{
  if (this->Facing)
  {
    this->Blocks.Parts[LowPart] = nullptr;
  }
  return std::move(this->Blocks);
}

void ScatterMerge::PlaceCard(std::size_t plant)
{
  const PlantMerge& merge = this->Merges[LowPart];
  const PlantPlace& place = this->Places[this->Blocks.Shown[static_cast<int>(PlantLevel::Low)][plant]];
  if (!this->Species.Shapes[place.Species])
  {
    return;
  }
  const ImpostorCard card = FacingCard(*this->Species.Shapes[place.Species], place, *this->Facing);
  const auto ofPicture = CardTCoords(card.View);
  vtkPointData* arrays = merge.GetOutput()->GetPointData();
  auto* points = vtkFloatArray::FastDownCast(merge.GetOutput()->GetPoints()->GetData());
  auto* normals = vtkFloatArray::FastDownCast(arrays->GetNormals());
  auto* tcoords = vtkFloatArray::FastDownCast(arrays->GetTCoords());
  for (int corner = 0; corner < 4; ++corner)
  {
    const auto at = static_cast<vtkIdType>(merge.GetFirstPoint(plant)) + corner;
    const auto inAtlas = this->Species.LowAreas[place.Species].Map(ofPicture[corner][0], ofPicture[corner][1]);
    for (int axis = 0; axis < 3; ++axis)
    {
      points->SetTypedComponent(at, axis, static_cast<float>(card.Corners[corner][axis]));
      if (normals) // all species have them
      {
        normals->SetTypedComponent(at, axis, static_cast<float>(card.Normals[corner][axis]));
      }
      if (axis < 2)
      {
        tcoords->SetTypedComponent(at, axis, static_cast<float>(inAtlas[axis]));
      }
    }
  }
}

}
