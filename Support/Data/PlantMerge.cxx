// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/PlantMerge.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/PlantBlocks.h"
#include "Data/SeaweedBlocks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace littoral
{

namespace
{

constexpr const char* PointsName = "Points";
constexpr const char* TCoordsName = "TCoords";

/// Arrays whose meaning is known.
struct KnownArray
{
  const char* Name;
  ArrayUse Use;
  int Type;
  int Components;
};

const KnownArray KnownArrays[] = {
  { PointsName, ArrayUse::Points, VTK_FLOAT, 3 },
  { NormalsName, ArrayUse::Directions, VTK_FLOAT, 3 },
  { TCoordsName, ArrayUse::Copy, VTK_FLOAT, 2 },
  { plant::RGB, ArrayUse::Colors, VTK_UNSIGNED_CHAR, 3 },
  { plant::JointIds, ArrayUse::Nodes, VTK_INT, 4 },
  { plant::ParentId, ArrayUse::Nodes, VTK_INT, 1 },
  { plant::Radius, ArrayUse::Lengths, VTK_FLOAT, 1 },
  { seaweed::Width, ArrayUse::Lengths, VTK_FLOAT, 1 },
  { seaweed::Thickness, ArrayUse::Lengths, VTK_FLOAT, 1 },
  { seaweed::Length, ArrayUse::Lengths, VTK_FLOAT, 1 },
  { seaweed::Attachment, ArrayUse::Lengths, VTK_FLOAT, 1 },
  { seaweed::Across, ArrayUse::Directions, VTK_FLOAT, 3 },
};

/// Use of an array of a block.
PartArray UseOf(const char* name, vtkDataArray* array)
{
  PartArray part;
  part.Name = name;
  part.Type = array->GetDataType();
  part.Components = array->GetNumberOfComponents();
  for (const KnownArray& known : KnownArrays)
  {
    if (part.Name == known.Name && part.Components == known.Components)
    {
      part.Use = known.Use;
      part.Type = known.Type;
    }
  }
  return part;
}

bool IsEmpty(vtkPolyData* block)
{
  return !block || block->GetNumberOfPoints() == 0;
}

/// The arrays of a name in all blocks, as one; leaves out an array that not all have with as many components.
void AddIfCommon(const char* name, const std::vector<vtkPolyData*>& blocks, const std::vector<vtkDataArray*>& ofSpecies,
  std::vector<PartArray>& parts)
{
  const auto first = std::find_if(ofSpecies.begin(), ofSpecies.end(), [](vtkDataArray* array) { return array; });
  if (first == ofSpecies.end())
  {
    return;
  }
  PartArray part = UseOf(name, *first);
  for (std::size_t species = 0; species < blocks.size(); ++species)
  {
    vtkDataArray* array = ofSpecies[species];
    if (IsEmpty(blocks[species]))
    {
      part.OfSpecies.emplace_back(nullptr);
      continue;
    }
    if (!array || array->GetNumberOfComponents() != part.Components)
    {
      return;
    }
    part.OfSpecies.push_back(WithType(array, part.Type));
  }
  parts.push_back(part);
}

vtkDataSetAttributes* AttributesOf(vtkPolyData* block, bool ofCells)
{
  return ofCells ? static_cast<vtkDataSetAttributes*>(block->GetCellData()) : block->GetPointData();
}

/// An array of numbers of any components; null if there is none.
vtkDataArray* FindAny(vtkPolyData* block, bool ofCells, const char* name)
{
  const ArrayReader reader = ofCells ? ArrayReader::OfCells(block, "") : ArrayReader::OfPoints(block, "");
  return reader.Any(name);
}

/// All common arrays but one.
void AddCommonArrays(
  const std::vector<vtkPolyData*>& blocks, bool ofCells, const char* but, std::vector<PartArray>& parts)
{
  const auto filled = std::find_if(blocks.begin(), blocks.end(), [](vtkPolyData* block) { return !IsEmpty(block); });
  if (filled == blocks.end())
  {
    return;
  }
  vtkDataSetAttributes* arrays = AttributesOf(*filled, ofCells);
  for (int index = 0; index < arrays->GetNumberOfArrays(); ++index)
  {
    const char* name = arrays->GetArrayName(index);
    if (!name || std::strcmp(name, but) == 0 || std::strcmp(name, plant::PlantId) == 0)
    {
      continue;
    }
    std::vector<vtkDataArray*> ofSpecies;
    ofSpecies.reserve(blocks.size());
    for (vtkPolyData* block : blocks)
    {
      ofSpecies.push_back(IsEmpty(block) ? nullptr : FindAny(block, ofCells, name));
    }
    AddIfCommon(name, blocks, ofSpecies, parts);
  }
}

/// Texture coordinates taken to the atlas; in the middle of its area where a species has none.
vtkSmartPointer<vtkDataArray> ToAtlas(vtkDataArray* from, vtkIdType points, const AtlasArea& area)
{
  auto to = vtkSmartPointer<vtkFloatArray>::New();
  to->SetNumberOfComponents(2);
  SetTuples(to, points);
  for (vtkIdType point = 0; point < points; ++point)
  {
    const auto mapped =
      from ? area.Map(from->GetComponent(point, 0), from->GetComponent(point, 1)) : area.Map(0.5, 0.5);
    to->SetTypedComponent(point, 0, static_cast<float>(mapped[0]));
    to->SetTypedComponent(point, 1, static_cast<float>(mapped[1]));
  }
  return to;
}

void AddAtlasCoordinates(
  const std::vector<vtkPolyData*>& blocks, const TextureAtlas& atlas, std::vector<PartArray>& parts)
{
  PartArray part;
  part.Name = TCoordsName;
  part.Type = VTK_FLOAT;
  part.Components = 2;
  for (std::size_t species = 0; species < blocks.size(); ++species)
  {
    vtkPolyData* block = blocks[species];
    vtkDataArray* own = IsEmpty(block) ? nullptr : block->GetPointData()->GetTCoords();
    own = own && own->GetNumberOfComponents() >= 2 ? own : nullptr;
    part.OfSpecies.push_back(IsEmpty(block) ? nullptr : ToAtlas(own, block->GetNumberOfPoints(), atlas.Areas[species]));
  }
  parts.push_back(part);
}

PlantPart::Mesh MeshOf(vtkPolyData* block, bool hasLines)
{
  PlantPart::Mesh mesh;
  if (IsEmpty(block))
  {
    return mesh;
  }
  mesh.NumberOfPoints = static_cast<std::size_t>(block->GetNumberOfPoints());
  vtkCellArray* cells = hasLines ? block->GetLines() : block->GetPolys();
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(cell, size, corners);
    mesh.Corners.insert(mesh.Corners.end(), corners, corners + size);
    mesh.Offsets.push_back(static_cast<int>(mesh.Corners.size()));
  }
  return mesh;
}

}

std::size_t PartArray::TupleBytes() const
{
  return static_cast<std::size_t>(this->Components) * vtkDataArray::GetDataTypeSize(this->Type);
}

PlantPart MakePart(const PartKind& kind, const std::vector<vtkPolyData*>& blocks, const TextureAtlas* atlas)
{
  PlantPart part;
  part.HasLines = kind.HasLines;
  std::vector<vtkDataArray*> points;
  for (vtkPolyData* block : blocks)
  {
    part.Meshes.push_back(MeshOf(block, kind.HasLines));
    points.push_back(IsEmpty(block) ? nullptr : block->GetPoints()->GetData());
  }
  AddIfCommon(PointsName, blocks, points, part.PointArrays);
  AddCommonArrays(blocks, false, atlas ? TCoordsName : "", part.PointArrays);
  AddCommonArrays(blocks, true, "", part.CellArrays);
  if (atlas)
  {
    AddAtlasCoordinates(blocks, *atlas, part.PointArrays);
  }
  for (PartArray& array : part.PointArrays)
  {
    array.Use = array.Use == ArrayUse::Colors && !kind.IsTinted ? ArrayUse::Copy : array.Use;
  }
  return part;
}

PlantMerge::PlantMerge(const PlantPart& part, const std::vector<PlantPlace>& places, const std::vector<int>& plants)
  : Part(part)
  , Places(places)
  , Plants(plants)
  , First(plants.size() + 1)
{
  for (std::size_t index = 0; index < plants.size(); ++index)
  {
    const PlantPart::Mesh& mesh = part.Meshes[places[plants[index]].Species];
    const Begin& begin = this->First[index];
    this->First[index + 1] = { begin.Point + mesh.NumberOfPoints, begin.Cell + mesh.NumberOfCells(),
      begin.Corner + mesh.Corners.size() };
  }
}

bool PlantMerge::NeedsLongIds() const
{
  const Begin& end = this->First.back();
  return std::max(end.Point, end.Corner) > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
}

double PlantMerge::GetBytes() const
{
  const Begin& end = this->First.back();
  const double idBytes = this->NeedsLongIds() ? 8.0 : 4.0;
  double pointBytes = sizeof(int); // PlantId
  for (const PartArray& array : this->Part.PointArrays)
  {
    pointBytes += static_cast<double>(array.TupleBytes());
  }
  double cellBytes = idBytes + (this->Part.HasLines ? sizeof(int) : 0);
  for (const PartArray& array : this->Part.CellArrays)
  {
    cellBytes += static_cast<double>(array.TupleBytes());
  }
  return pointBytes * static_cast<double>(end.Point) + cellBytes * static_cast<double>(end.Cell) +
    idBytes * static_cast<double>(end.Corner);
}

vtkSmartPointer<vtkDataArray> PlantMerge::Add(const PartArray& array, std::size_t tuples, std::vector<Target>& targets)
{
  auto to = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array.Type));
  to->SetName(array.Name.c_str());
  to->SetNumberOfComponents(array.Components);
  SetTuples(to, static_cast<vtkIdType>(tuples));
  targets.push_back({ &array, static_cast<unsigned char*>(to->GetVoidPointer(0)) });
  return to;
}

void PlantMerge::AllocateCells()
{
  const Begin& end = this->First.back();
  const auto numberOfOffsets = static_cast<vtkIdType>(end.Cell) + 1;
  const auto numberOfCorners = static_cast<vtkIdType>(end.Corner);
  vtkNew<vtkCellArray> cells;
  const auto allocate = [&](auto* offsets, auto* corners) {
    SetTuples(offsets, numberOfOffsets);
    offsets->SetValue(end.Cell, static_cast<std::decay_t<decltype(offsets->GetValue(0))>>(end.Corner));
    SetTuples(corners, numberOfCorners);
    this->OffsetTarget = offsets->GetPointer(0);
    this->CornerTarget = corners->GetPointer(0);
    cells->SetData(offsets, corners);
  };
  if (this->NeedsLongIds())
  {
    vtkNew<vtkTypeInt64Array> offsets;
    vtkNew<vtkTypeInt64Array> corners;
    allocate(offsets.Get(), corners.Get());
  }
  else
  {
    vtkNew<vtkTypeInt32Array> offsets;
    vtkNew<vtkTypeInt32Array> corners;
    allocate(offsets.Get(), corners.Get());
  }
  this->Part.HasLines ? this->Output->SetLines(cells) : this->Output->SetPolys(cells);
}

void PlantMerge::Allocate()
{
  const Begin& end = this->First.back();
  this->Output = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  this->Output->SetPoints(points);
  vtkPointData* pointArrays = this->Output->GetPointData();
  for (const PartArray& array : this->Part.PointArrays)
  {
    const auto to = this->Add(array, end.Point, this->PointTargets);
    array.Use == ArrayUse::Points ? points->SetData(to) : static_cast<void>(pointArrays->AddArray(to));
  }
  pointArrays->SetActiveNormals(NormalsName);
  pointArrays->SetActiveTCoords(TCoordsName);
  pointArrays->SetActiveScalars(plant::RGB);
  const auto addPlantIds = [&](vtkDataSetAttributes* arrays, std::size_t tuples) {
    vtkNew<vtkIntArray> ids;
    ids->SetName(plant::PlantId);
    SetTuples(ids, static_cast<vtkIdType>(tuples));
    arrays->AddArray(ids);
    return ids->GetPointer(0);
  };
  this->PlantOfPoint = addPlantIds(pointArrays, end.Point);
  for (const PartArray& array : this->Part.CellArrays)
  {
    this->Output->GetCellData()->AddArray(this->Add(array, end.Cell, this->CellTargets));
  }
  if (this->Part.HasLines)
  {
    this->PlantOfCell = addPlantIds(this->Output->GetCellData(), end.Cell);
  }
  this->AllocateCells();
}

void PlantMerge::FillArrays(
  const std::vector<Target>& targets, const PlantPlace& place, std::size_t tuple, int node) const
{
  const PlantPlacement placement(place);
  for (const Target& target : targets)
  {
    vtkDataArray* array = target.From->OfSpecies[place.Species];
    if (!array)
    {
      continue;
    }
    const void* from = array->GetVoidPointer(0);
    unsigned char* to = target.To + tuple * target.From->TupleBytes();
    const auto count = static_cast<std::size_t>(array->GetNumberOfTuples());
    const auto* numbers = static_cast<const float*>(from);
    auto* results = reinterpret_cast<float*>(to);
    switch (target.From->Use)
    {
      case ArrayUse::Points:
        placement.Points(numbers, count, results);
        break;
      case ArrayUse::Directions:
        placement.Directions(numbers, count, results);
        break;
      case ArrayUse::Lengths:
        placement.Lengths(numbers, count, results);
        break;
      case ArrayUse::Colors:
        placement.Colors(static_cast<const unsigned char*>(from), count, to);
        break;
      case ArrayUse::Nodes:
      {
        const int* ids = static_cast<const int*>(from);
        std::transform(ids, ids + count * target.From->Components, reinterpret_cast<int*>(to),
          [node](int id) { return id < 0 ? id : id + node; });
        break;
      }
      case ArrayUse::Copy:
        std::memcpy(to, from, count * target.From->TupleBytes());
        break;
    }
  }
}

template <typename Id>
void PlantMerge::FillCells(std::size_t plant, Id* offsets, Id* corners) const
{
  const PlantPart::Mesh& mesh = this->Part.Meshes[this->Places[this->Plants[plant]].Species];
  const Begin& begin = this->First[plant];
  const Id firstCorner = static_cast<Id>(begin.Corner);
  const Id firstPoint = static_cast<Id>(begin.Point);
  std::transform(mesh.Offsets.begin(), mesh.Offsets.end() - 1, offsets + begin.Cell,
    [=](int offset) { return firstCorner + static_cast<Id>(offset); });
  std::transform(mesh.Corners.begin(), mesh.Corners.end(), corners + begin.Corner,
    [=](int corner) { return firstPoint + static_cast<Id>(corner); });
}

void PlantMerge::Fill(std::size_t beginPlant, std::size_t endPlant)
{
  for (std::size_t plant = beginPlant; plant < endPlant; ++plant)
  {
    const PlantPlace& place = this->Places[this->Plants[plant]];
    const Begin& begin = this->First[plant];
    const Begin& end = this->First[plant + 1];
    const int node = this->SkeletonMerge ? static_cast<int>(this->SkeletonMerge->First[plant].Point) : 0;
    this->FillArrays(this->PointTargets, place, begin.Point, node);
    this->FillArrays(this->CellTargets, place, begin.Cell, node);
    std::fill(this->PlantOfPoint + begin.Point, this->PlantOfPoint + end.Point, place.Site);
    if (this->PlantOfCell)
    {
      std::fill(this->PlantOfCell + begin.Cell, this->PlantOfCell + end.Cell, place.Site);
    }
    if (this->NeedsLongIds())
    {
      this->FillCells(
        plant, static_cast<vtkTypeInt64*>(this->OffsetTarget), static_cast<vtkTypeInt64*>(this->CornerTarget));
    }
    else
    {
      this->FillCells(
        plant, static_cast<vtkTypeInt32*>(this->OffsetTarget), static_cast<vtkTypeInt32*>(this->CornerTarget));
    }
  }
}

}
