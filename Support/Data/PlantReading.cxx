// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/PlantReading.h"

#include "vtkIdList.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace littoral
{

namespace
{

/// Adds a line of nodes as a branch.
void AddBranch(vtkIdList* line, Skeleton& skeleton)
{
  const int index = static_cast<int>(skeleton.Branches.size());
  SkeletonBranch branch{ line->GetNumberOfIds() > 0 ? static_cast<int>(line->GetId(0)) : 0,
    static_cast<int>(line->GetNumberOfIds()), 0 };
  for (vtkIdType i = 0; i < line->GetNumberOfIds(); ++i)
  {
    skeleton.Nodes[static_cast<std::size_t>(line->GetId(i))].Branch = index;
  }
  if (branch.Count > 0)
  {
    const int parent = skeleton.Nodes[static_cast<std::size_t>(branch.First)].Parent;
    const int below = parent >= 0 && parent < branch.First ? skeleton.Nodes[parent].Branch : -1;
    branch.Order = below >= 0 && below < index ? skeleton.Branches[below].Order + 1 : 0;
  }
  skeleton.Branches.push_back(branch);
}

vtkDataArray* FieldArray(vtkDataObject* data, const char* name, int components, vtkIdType tuples)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  const bool fits =
    array && array->GetNumberOfComponents() == components && (tuples < 0 || array->GetNumberOfTuples() == tuples);
  return fits ? array : nullptr;
}

}

vtkPolyData* PlantPartOf(vtkMultiBlockDataSet* plants, const char* level, const char* part)
{
  return vtkPolyData::SafeDownCast(FindBlock(vtkMultiBlockDataSet::SafeDownCast(FindBlock(plants, level)), part));
}

vtkFloatArray* FloatPointsOf(vtkPolyData* block)
{
  return block && block->GetPoints() ? vtkFloatArray::SafeDownCast(block->GetPoints()->GetData()) : nullptr;
}

std::string ReadSkeleton(vtkPolyData* block, Skeleton& skeleton)
{
  auto* parents = vtkIntArray::SafeDownCast(block->GetPointData()->GetArray(plant::ParentId));
  auto* radii = vtkFloatArray::SafeDownCast(block->GetPointData()->GetArray(plant::Radius));
  if (!parents || !radii)
  {
    return "High/Skeleton of the plants has no point arrays ParentId (int) and Radius (float).";
  }
  const vtkIdType nodes = block->GetNumberOfPoints();
  skeleton.Nodes.resize(static_cast<std::size_t>(nodes));
  for (vtkIdType node = 0; node < nodes; ++node)
  {
    SkeletonNode& to = skeleton.Nodes[static_cast<std::size_t>(node)];
    block->GetPoint(node, &to.Position.x);
    to.Parent = parents->GetValue(node);
    to.Radius = radii->GetValue(node);
    to.Branch = -1;
  }
  vtkNew<vtkIdList> line;
  for (vtkIdType cell = 0; cell < block->GetNumberOfLines(); ++cell)
  {
    block->GetLines()->GetCellAtId(cell, line);
    AddBranch(line, skeleton);
  }
  const std::string reason = WhyInvalid(skeleton);
  return reason.empty() ? reason : "High/Skeleton of the plants is none: " + reason;
}

std::string WhyBadSkin(vtkPolyData* block, const char* name, std::size_t joints)
{
  auto* ids = vtkIntArray::SafeDownCast(block->GetPointData()->GetArray(plant::JointIds));
  auto* weights = vtkFloatArray::SafeDownCast(block->GetPointData()->GetArray(plant::JointWeights));
  const bool four = ids && weights && ids->GetNumberOfComponents() == 4 && weights->GetNumberOfComponents() == 4;
  if (block->GetNumberOfPoints() > 0 &&
    (!four || !FloatPointsOf(block) || !vtkFloatArray::SafeDownCast(block->GetPointData()->GetNormals())))
  {
    return std::string("High/") + name +
      " of the plants has no points, normals, JointIds[4] and JointWeights[4] of int and float.";
  }
  for (vtkIdType i = 0; four && i < ids->GetNumberOfValues(); ++i)
  {
    if (ids->GetValue(i) < 0 || static_cast<std::size_t>(ids->GetValue(i)) >= joints)
    {
      return std::string("JointIds of High/") + name + " of the plants point to no node of Skeleton.";
    }
  }
  return {};
}

std::vector<LeafCorners> ReadLeaves(vtkPolyData* block)
{
  std::vector<LeafCorners> leaves;
  if (!block || block->GetNumberOfPoints() == 0)
  {
    return leaves;
  }
  auto* ids = vtkIntArray::SafeDownCast(block->GetPointData()->GetArray(plant::JointIds));
  vtkNew<vtkIdList> cell;
  for (vtkIdType leaf = 0; leaf < block->GetNumberOfPolys(); ++leaf)
  {
    block->GetPolys()->GetCellAtId(leaf, cell);
    if (cell->GetNumberOfIds() != 4)
    {
      continue;
    }
    Vector3 corners[4];
    LeafCorners one;
    for (int i = 0; i < 4; ++i)
    {
      one.Corners[i] = static_cast<int>(cell->GetId(i));
      block->GetPoint(cell->GetId(i), &corners[i].x);
    }
    one.Node = ids->GetValue(4 * one.Corners[0]);
    one.Area = 0.5 * glm::length(glm::cross(corners[2] - corners[0], corners[3] - corners[1]));
    leaves.push_back(one);
  }
  return leaves;
}

bool ReadWood(vtkDataObject* plant, WoodParameters& wood)
{
  vtkDataArray* numbers = FieldArray(plant, plant::Wood, 3, 1);
  if (numbers)
  {
    wood = { numbers->GetComponent(0, 0), numbers->GetComponent(0, 1), numbers->GetComponent(0, 2) };
  }
  return numbers != nullptr;
}

int PlantTable::RowOf(int plant) const
{
  const auto found = std::lower_bound(this->Rows.begin(), this->Rows.end(), std::make_pair(plant, -1));
  return found != this->Rows.end() && found->first == plant ? found->second : -1;
}

bool ReadTable(vtkDataObject* forest, PlantTable& table)
{
  vtkDataArray* plants = FieldArray(forest, plant::PlantId, 1, -1);
  const vtkIdType count = plants ? plants->GetNumberOfTuples() : 0;
  vtkDataArray* species = FieldArray(forest, "Species", 1, count);
  vtkDataArray* scales = FieldArray(forest, "Scale", 1, count);
  vtkDataArray* azimuths = FieldArray(forest, "Azimuth", 1, count);
  vtkDataArray* positions = FieldArray(forest, "Position", 3, count);
  vtkDataArray* levels = FieldArray(forest, "Level", 1, count);
  if (!plants || !species || !scales || !azimuths || !positions || !levels)
  {
    return false;
  }
  for (vtkIdType row = 0; row < count; ++row)
  {
    PlantPlace place;
    place.Site = static_cast<int>(plants->GetTuple1(row));
    place.Species = static_cast<int>(species->GetTuple1(row));
    place.Scale = scales->GetTuple1(row);
    place.Azimuth = azimuths->GetTuple1(row);
    positions->GetTuple(row, &place.Foot.x);
    table.Rows.emplace_back(place.Site, static_cast<int>(row));
    table.Places.push_back(place);
    table.Levels.push_back(static_cast<PlantLevel>(static_cast<int>(levels->GetTuple1(row))));
  }
  std::sort(table.Rows.begin(), table.Rows.end());
  return true;
}

TextureImage ReadTexture(vtkPolyData* block)
{
  auto* texels = block ? vtkUnsignedCharArray::SafeDownCast(block->GetFieldData()->GetArray(plant::Texture)) : nullptr;
  vtkDataArray* size = block ? block->GetFieldData()->GetArray(plant::TextureSize) : nullptr;
  if (!texels || !size || texels->GetNumberOfComponents() != 4 || size->GetNumberOfValues() != 2)
  {
    return {};
  }
  const int columns = size->GetVariantValue(0).ToInt();
  const int rows = size->GetVariantValue(1).ToInt();
  if (columns < 1 || rows < 1 || static_cast<vtkIdType>(columns) * rows != texels->GetNumberOfTuples())
  {
    return {};
  }
  TextureImage image(columns, rows);
  std::copy_n(texels->GetPointer(0), 4 * image.Texels.size(), image.Texels.front().data());
  return image;
}

PlantMesh ReadMesh(vtkPolyData* block)
{
  PlantMesh mesh;
  auto* colors = vtkUnsignedCharArray::SafeDownCast(block->GetPointData()->GetArray(plant::RGB));
  vtkDataArray* places = block->GetPointData()->GetTCoords();
  for (vtkIdType point = 0; point < block->GetNumberOfPoints(); ++point)
  {
    Vector3 position;
    block->GetPoint(point, &position.x);
    mesh.Points.push_back(position);
    Color color{ 112, 146, 60 };
    for (int channel = 0; colors && channel < 3; ++channel)
    {
      color[channel] = colors->GetTypedComponent(point, channel);
    }
    mesh.Colors.push_back(color);
    mesh.TCoords.push_back(places
        ? std::array<double, 2>{ places->GetComponent(point, 0), places->GetComponent(point, 1) }
        : std::array<double, 2>{ 0.5, 0.5 });
  }
  vtkNew<vtkIdList> cell;
  for (vtkIdType polygon = 0; polygon < block->GetNumberOfPolys(); ++polygon)
  {
    block->GetPolys()->GetCellAtId(polygon, cell);
    std::vector<int> corners;
    for (vtkIdType corner = 0; corner < cell->GetNumberOfIds(); ++corner)
    {
      corners.push_back(static_cast<int>(cell->GetId(corner)));
    }
    mesh.AddPolygon(corners);
  }
  return mesh;
}

void ReplaceBlock(vtkMultiBlockDataSet* blocks, const char* name, vtkDataObject* data)
{
  for (unsigned int block = 0; block < blocks->GetNumberOfBlocks(); ++block)
  {
    const char* own = blocks->HasMetaData(block) ? blocks->GetMetaData(block)->Get(vtkCompositeDataSet::NAME()) : "";
    if (own && std::strcmp(own, name) == 0)
    {
      blocks->SetBlock(block, data);
    }
  }
}

vtkSmartPointer<vtkFloatArray> FloatsLike(vtkFloatArray* other)
{
  return NewArray<vtkFloatArray>(other->GetName(), other->GetNumberOfComponents(), other->GetNumberOfTuples());
}

}
