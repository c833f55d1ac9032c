// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/PlantBlocks.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/SeaweedBlocks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// The wood that a plant is of, as field data: Young's modulus [Pa], density [kg/m3], damping ratio.
void AttachWood(vtkDataObject* plant, const WoodParameters& wood)
{
  const std::vector<std::array<double, 3>> numbers{ { wood.YoungModulus, wood.Density, wood.DampingRatio } };
  plant->GetFieldData()->AddArray(ArrayOf<vtkDoubleArray>(plant::Wood, 3, numbers));
}

/// Adds the data that CardTowards needs, and the pictures.
void AttachImpostor(vtkDataObject* low, const PlantImpostor& impostor)
{
  AttachTexture(low, impostor.Pictures);
  AttachTextureMean(low, impostor.TextureMean);
  AttachNormalTexture(low, impostor.Normals);
  const PlantExtent& extent = impostor.Shape.Extent;
  const std::vector<std::array<double, 3>> numbers{ { extent.Radius, extent.Low, extent.High } };
  low->GetFieldData()->AddArray(ArrayOf<vtkDoubleArray>(plant::ImpostorExtent, 3, numbers));
  std::vector<std::array<double, 1>> areas;
  for (double area : impostor.Shape.Areas)
  {
    areas.push_back({ area });
  }
  low->GetFieldData()->AddArray(ArrayOf<vtkDoubleArray>(plant::ImpostorAreas, 1, areas));
}

/// Adds a line of nodes, all of which there are, as a branch.
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

}

vtkSmartPointer<vtkPolyData> PolyDataOf(const PlantMesh& mesh)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(PointsOf(mesh.Points));
  vtkNew<vtkCellArray> polygons;
  polygons->Use32BitStorage();
  polygons->AllocateExact(mesh.NumberOfPolygons(), static_cast<vtkIdType>(mesh.Corners.size()));
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    polygons->InsertNextCell(mesh.Offsets[polygon + 1] - mesh.Offsets[polygon]);
    for (int corner = mesh.Offsets[polygon]; corner < mesh.Offsets[polygon + 1]; ++corner)
    {
      polygons->InsertCellPoint(mesh.Corners[corner]);
    }
  }
  data->SetPolys(polygons);
  vtkPointData* arrays = data->GetPointData();
  arrays->SetNormals(ArrayOf<vtkFloatArray>("Normals", 3, mesh.Normals));
  arrays->SetScalars(ArrayOf<vtkUnsignedCharArray>(plant::RGB, 3, mesh.Colors));
  if (!mesh.TCoords.empty())
  {
    arrays->SetTCoords(ArrayOf<vtkFloatArray>("TCoords", 2, mesh.TCoords));
  }
  if (!mesh.JointIds.empty())
  {
    arrays->AddArray(ArrayOf<vtkIntArray>(plant::JointIds, 4, mesh.JointIds));
    arrays->AddArray(ArrayOf<vtkFloatArray>(plant::JointWeights, 4, mesh.JointWeights));
  }
  return data;
}

vtkSmartPointer<vtkPolyData> PolyDataOf(const Skeleton& skeleton, const Color& bark)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  std::vector<Vector3> positions;
  std::vector<std::array<int, 1>> parents;
  std::vector<std::array<double, 1>> radii;
  std::vector<std::array<int, 1>> branchIds;
  std::vector<std::array<int, 1>> orders;
  for (const SkeletonNode& node : skeleton.Nodes)
  {
    positions.push_back(node.Position);
    parents.push_back({ node.Parent });
    radii.push_back({ node.Radius });
  }
  vtkNew<vtkCellArray> lines;
  lines->Use32BitStorage();
  for (const SkeletonBranch& branch : skeleton.Branches)
  {
    branchIds.push_back({ static_cast<int>(branchIds.size()) });
    orders.push_back({ branch.Order });
    lines->InsertNextCell(branch.Count);
    for (int node = branch.First; node < branch.First + branch.Count; ++node)
    {
      lines->InsertCellPoint(node);
    }
  }
  data->SetPoints(PointsOf(positions));
  data->SetLines(lines);
  vtkPointData* arrays = data->GetPointData();
  arrays->AddArray(ArrayOf<vtkIntArray>(plant::ParentId, 1, parents));
  arrays->AddArray(ArrayOf<vtkFloatArray>(plant::Radius, 1, radii));
  arrays->SetScalars(ArrayOf<vtkUnsignedCharArray>(plant::RGB, 3, std::vector<Color>(positions.size(), bark)));
  data->GetCellData()->AddArray(ArrayOf<vtkIntArray>(plant::BranchId, 1, branchIds));
  data->GetCellData()->AddArray(ArrayOf<vtkIntArray>(plant::Order, 1, orders));
  return data;
}

Color ColorOf(const double from[3])
{
  const auto byte = [](double part) { return static_cast<unsigned char>(std::lround(255.0 * part)); };
  return { byte(from[0]), byte(from[1]), byte(from[2]) };
}

void AttachTexture(vtkDataObject* block, const TextureImage& texture)
{
  block->GetFieldData()->AddArray(ArrayOf<vtkUnsignedCharArray>(plant::Texture, 4, texture.Texels));
  const std::vector<std::array<int, 1>> size{ { texture.Columns }, { texture.Rows } };
  block->GetFieldData()->AddArray(ArrayOf<vtkIntArray>(plant::TextureSize, 1, size));
}

void AttachTextureMean(vtkDataObject* block, const ColorSum& mean)
{
  block->GetFieldData()->AddArray(ArrayOf<vtkFloatArray>(plant::TextureMean, 3, std::vector<ColorSum>{ mean }));
}

void AttachNormalTexture(vtkDataObject* block, const std::vector<Color>& normals)
{
  block->GetFieldData()->AddArray(ArrayOf<vtkUnsignedCharArray>(plant::NormalTexture, 3, normals));
}

void CopyToImage(const TextureImage& texture, vtkImageData* image)
{
  image->SetExtent(0, texture.Columns - 1, 0, texture.Rows - 1, 0, 0);
  image->SetOrigin(0.0, 0.0, 0.0); // VTK would pass on those of an image that was an input once
  image->SetSpacing(1.0, 1.0, 1.0);
  image->GetPointData()->SetScalars(ArrayOf<vtkUnsignedCharArray>(plant::Texture, 4, texture.Texels));
}

void CopyToBlocks(const PlantPrototype& prototype, vtkMultiBlockDataSet* blocks)
{
  const Color bark = prototype.Skin.Colors.empty() ? Color{ 110, 90, 70 } : prototype.Skin.Colors.front();
  vtkNew<vtkMultiBlockDataSet> high;
  const auto skeleton = PolyDataOf(prototype.Wood, bark);
  if (!prototype.Segments.empty())
  {
    AddSegments(prototype.Wood, prototype.Segments, skeleton);
  }
  AddBlock(high, plant::Skeleton, skeleton);
  AddBlock(high, plant::Skin, PolyDataOf(prototype.Skin));
  const auto leaves = PolyDataOf(prototype.Leaves);
  AttachTexture(leaves, prototype.LeafTexture);
  AddBlock(high, plant::Leaves, leaves);
  vtkNew<vtkMultiBlockDataSet> medium;
  AddBlock(medium, plant::Trunk, PolyDataOf(prototype.Trunk));
  const auto crown = PolyDataOf(prototype.Crown);
  AttachTexture(crown, prototype.CrownTexture);
  AttachTextureMean(crown, prototype.CrownTextureMean);
  if (prototype.CrownIsEnvelope)
  {
    crown->GetFieldData()->AddArray(ArrayOf<vtkIntArray>(plant::Envelope, 1, std::vector<std::array<int, 1>>{ { 1 } }));
  }
  AddBlock(medium, plant::Crown, crown);
  AddBlock(blocks, plant::High, high);
  AddBlock(blocks, plant::Medium, medium);
  const auto low = PolyDataOf(prototype.Low);
  if (!prototype.Impostor.Pictures.Texels.empty())
  {
    AttachImpostor(low, prototype.Impostor);
  }
  AddBlock(blocks, plant::Low, low);
  if (prototype.Segments.empty())
  {
    AttachWood(blocks, prototype.Timber);
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

Skeleton ReadSkeleton(vtkPolyData* block)
{
  const ArrayReader points = ArrayReader::OfPoints(block, "High/Skeleton of the plants");
  auto* parents = points.Need<vtkIntArray>(plant::ParentId, 1);
  auto* radii = points.Need<vtkFloatArray>(plant::Radius, 1);
  Skeleton skeleton;
  const vtkIdType nodes = block->GetNumberOfPoints();
  SetSize(skeleton.Nodes, nodes);
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
  InContext("High/Skeleton of the plants is none: ", [&] { Require(WhyInvalid(skeleton)); });
  return skeleton;
}

namespace
{

std::string OwnerOf(const char* name)
{
  return std::string("High/") + name + " of the plants";
}

/// Leaves, each of which a node carries, by a function of its first vertex.
template <typename NodeOf>
std::vector<LeafCorners> LeavesOf(vtkPolyData* block, const NodeOf& nodeOf)
{
  std::vector<LeafCorners> leaves;
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
    one.Node = nodeOf(static_cast<std::size_t>(one.Corners[0]));
    one.Area = 0.5 * glm::length(glm::cross(corners[2] - corners[0], corners[3] - corners[1]));
    leaves.push_back(one);
  }
  return leaves;
}

}

void RequireRest(vtkPolyData* block, const char* name)
{
  Require(FloatPointsOf(block) && FindNormals(block) ? "" : OwnerOf(name) + " has no points and normals of float.");
}

void RequireSkin(vtkPolyData* block, const char* name, std::size_t joints)
{
  if (block->GetNumberOfPoints() == 0)
  {
    return;
  }
  const ArrayReader points = ArrayReader::OfPoints(block, OwnerOf(name));
  points.NeedIds(points.Need<vtkIntArray>(plant::JointIds, 4), static_cast<vtkIdType>(joints), "node");
  points.Need<vtkFloatArray>(plant::JointWeights, 4);
  RequireRest(block, name);
}

vtkFloatArray* FindNormals(vtkPolyData* block)
{
  return ArrayReader::OfPoints(block, "a skin").Seek<vtkFloatArray>(block->GetPointData()->GetNormals(), 3);
}

RestSkin ReadSkin(vtkPolyData* block)
{
  vtkFloatArray* normals = FindNormals(block);
  return { FloatPointsOf(block)->GetPointer(0), normals ? normals->GetPointer(0) : nullptr };
}

const int* ReadJointIds(vtkPolyData* block)
{
  return ArrayReader::OfPoints(block, "a skin").Need<vtkIntArray>(plant::JointIds, 4)->GetPointer(0);
}

const float* ReadJointWeights(vtkPolyData* block)
{
  return ArrayReader::OfPoints(block, "a skin").Need<vtkFloatArray>(plant::JointWeights, 4)->GetPointer(0);
}

SkinBinding ReadBinding(vtkPolyData* block)
{
  return { ReadJointIds(block), ReadJointWeights(block), static_cast<std::size_t>(block->GetNumberOfPoints()) };
}

vtkIntArray* FindPlantIds(vtkPolyData* block)
{
  return ArrayReader::OfPoints(block, "a block of the plants").Find<vtkIntArray>(plant::PlantId, 1);
}

std::vector<LeafCorners> ReadLeaves(vtkPolyData* block)
{
  if (!block || block->GetNumberOfPoints() == 0)
  {
    return {};
  }
  const int* nodes = ReadJointIds(block);
  return LeavesOf(block, [nodes](std::size_t vertex) { return nodes[4 * vertex]; });
}

std::vector<LeafCorners> ReadLeaves(vtkPolyData* block, const StandBinding& binding)
{
  return LeavesOf(block, [&binding](std::size_t vertex) { return binding.JointOf(vertex); });
}

bool ReadWood(vtkDataObject* plant, WoodParameters& wood)
{
  vtkDataArray* numbers = ArrayReader::OfFields(plant, "a plant", 1).Seek(plant::Wood, 3);
  if (numbers)
  {
    wood = { numbers->GetComponent(0, 0), numbers->GetComponent(0, 1), numbers->GetComponent(0, 2) };
  }
  return numbers != nullptr;
}

std::array<int, 2> ReadTextureSize(vtkDataArray* size)
{
  std::array<int, 2> sides{ 0, 0 };
  const int components = size ? size->GetNumberOfComponents() : 1;
  for (int side = 0; size && size->GetNumberOfValues() == 2 && side < 2; ++side)
  {
    const double number = size->GetComponent(side / components, side % components);
    sides[side] = IsWhole(number, 1, VTK_INT_MAX) ? static_cast<int>(number) : 0;
  }
  const bool fits = sides[0] > 0 && sides[1] > 0 && static_cast<long long>(sides[0]) * sides[1] <= VTK_INT_MAX;
  return fits ? sides : std::array<int, 2>{ 0, 0 };
}

std::array<int, 2> ReadTextureSize(vtkPolyData* block)
{
  if (!block)
  {
    return { 0, 0 };
  }
  auto* texels = ArrayReader::OfFields(block, "a block").Seek<vtkUnsignedCharArray>(plant::Texture, 4);
  const std::array<int, 2> size =
    ReadTextureSize(ArrayReader::OfFields(block, "a block", 2).Seek(plant::TextureSize, 1));
  const bool fits = texels && static_cast<vtkIdType>(size[0]) * size[1] == texels->GetNumberOfTuples();
  return fits ? size : std::array<int, 2>{ 0, 0 };
}

TextureImage ReadTexture(vtkPolyData* block)
{
  const std::array<int, 2> size = ReadTextureSize(block);
  if (size[0] == 0)
  {
    return {};
  }
  auto* texels = ArrayReader::OfFields(block, "a block").Need<vtkUnsignedCharArray>(plant::Texture, 4);
  TextureImage image(size[0], size[1]);
  std::copy_n(texels->GetPointer(0), 4 * image.Texels.size(), image.Texels.front().data());
  return image;
}

ColorSum ReadTextureMean(vtkPolyData* block)
{
  ColorSum mean{ 1.0f, 1.0f, 1.0f };
  vtkDataArray* numbers = block ? ArrayReader::OfFields(block, "a block", 1).Seek(plant::TextureMean, 3) : nullptr;
  for (int channel = 0; numbers && channel < 3; ++channel)
  {
    const double number = numbers->GetComponent(0, channel);
    mean[channel] = number > 0.0 && number <= 1.0 ? static_cast<float>(number) : 1.0f;
  }
  return mean;
}

bool IsEnvelope(vtkPolyData* crown)
{
  return crown && ArrayReader::OfFields(crown, "a crown", 1).Seek(plant::Envelope, 1);
}

PlantImpostor ReadImpostor(vtkPolyData* low)
{
  PlantImpostor impostor;
  constexpr int side = ImpostorSide * ImpostorSize;
  if (!low)
  {
    return impostor;
  }
  const std::string owner = "a card";
  vtkDataArray* extent = ArrayReader::OfFields(low, owner, 1).Seek(plant::ImpostorExtent, 3);
  vtkDataArray* areas = ArrayReader::OfFields(low, owner, ImpostorViews).Seek(plant::ImpostorAreas, 1);
  auto* normals = ArrayReader::OfFields(low, owner, side * side).Seek<vtkUnsignedCharArray>(plant::NormalTexture, 3);
  TextureImage pictures = extent && areas && normals ? ReadTexture(low) : TextureImage();
  if (pictures.Columns != side || pictures.Rows != side)
  {
    return impostor;
  }
  impostor.Pictures = std::move(pictures);
  impostor.TextureMean = ReadTextureMean(low);
  impostor.Normals.resize(impostor.Pictures.Texels.size());
  std::copy_n(normals->GetPointer(0), 3 * impostor.Normals.size(), impostor.Normals.front().data());
  impostor.Shape.Extent = { extent->GetComponent(0, 0), extent->GetComponent(0, 1), extent->GetComponent(0, 2) };
  for (int view = 0; view < ImpostorViews; ++view)
  {
    impostor.Shape.Areas[view] = areas->GetComponent(view, 0);
  }
  auto* colors = ArrayReader::OfPoints(low, owner).Seek<vtkUnsignedCharArray>(plant::RGB, 3);
  for (int channel = 0; colors && colors->GetNumberOfTuples() > 0 && channel < 3; ++channel)
  {
    impostor.Mean[channel] = colors->GetTypedComponent(0, channel);
  }
  return impostor;
}

PlantMesh ReadMesh(vtkPolyData* block)
{
  PlantMesh mesh;
  auto* colors = ArrayReader::OfPoints(block, "leaves").Seek<vtkUnsignedCharArray>(plant::RGB, 3);
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

}
