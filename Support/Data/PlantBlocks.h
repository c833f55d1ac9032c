// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportPlantBlocks_h
#define LittoralSupportPlantBlocks_h

// Plants between the numerics and VTK: the one place that knows names and types of their blocks and arrays. Private:
// never installed, never wrapped.

#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Data/SeaweedBlocks.h"
#include "Plants/PlantPrototype.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <type_traits>
#include <vector>

namespace littoral
{

/// Names of blocks and arrays.
namespace plant
{
constexpr const char* High = "High";
constexpr const char* Medium = "Medium";
constexpr const char* Low = "Low";
constexpr const char* Skeleton = "Skeleton";
constexpr const char* Skin = "Skin";
constexpr const char* Leaves = "Leaves";
constexpr const char* Trunk = "Trunk";
constexpr const char* Crown = "Crown";
constexpr const char* RGB = "RGB";
constexpr const char* JointIds = "JointIds";
constexpr const char* JointWeights = "JointWeights";
constexpr const char* ParentId = "ParentId";
constexpr const char* Radius = "Radius";
constexpr const char* BranchId = "BranchId";
constexpr const char* Order = "Order";
constexpr const char* Texture = "Texture";
constexpr const char* TextureSize = "TextureSize";
constexpr const char* PlantId = "PlantId";
constexpr const char* Wood = "Wood";
}

/// A color of 0 to 1 as bytes; false if it is none.
inline bool TakeColor(const double from[3], Color& to)
{
  for (int channel = 0; channel < 3; ++channel)
  {
    if (!(from[channel] >= 0.0 && from[channel] <= 1.0))
    {
      return false;
    }
    to[channel] = static_cast<unsigned char>(std::lround(255.0 * from[channel]));
  }
  return true;
}

/// A point or cell array from tuples of numbers, each converted to the array's type.
template <typename Array, typename Tuples>
vtkSmartPointer<Array> ArrayOf(const char* name, int components, const Tuples& tuples)
{
  auto array = NewArray<Array>(name, components, static_cast<vtkIdType>(tuples.size()));
  auto* value = array->GetPointer(0);
  for (const auto& tuple : tuples)
  {
    for (int component = 0; component < components; ++component)
    {
      *value++ = static_cast<std::decay_t<decltype(*value)>>(tuple[component]);
    }
  }
  return array;
}

inline vtkSmartPointer<vtkPoints> PointsOf(const std::vector<Vector3>& positions)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(ArrayOf<vtkFloatArray>("Points", 3, positions));
  return points;
}

/// A texture as field data of the block that it belongs to.
inline void AttachTexture(vtkDataObject* block, const TextureImage& texture)
{
  block->GetFieldData()->AddArray(ArrayOf<vtkUnsignedCharArray>(plant::Texture, 4, texture.Texels));
  const std::vector<std::array<int, 1>> size{ { texture.Columns }, { texture.Rows } };
  block->GetFieldData()->AddArray(ArrayOf<vtkIntArray>(plant::TextureSize, 1, size));
}

/// The wood that a plant is of, as field data: Young's modulus [Pa], density [kg/m3], damping ratio.
inline void AttachWood(vtkDataObject* plant, const WoodParameters& wood)
{
  const std::vector<std::array<double, 3>> numbers{ { wood.YoungModulus, wood.Density, wood.DampingRatio } };
  plant->GetFieldData()->AddArray(ArrayOf<vtkDoubleArray>(plant::Wood, 3, numbers));
}

/// A texture as an image, for vtkTexture.
inline void CopyToImage(const TextureImage& texture, vtkImageData* image)
{
  image->SetExtent(0, texture.Columns - 1, 0, texture.Rows - 1, 0, 0);
  image->GetPointData()->SetScalars(ArrayOf<vtkUnsignedCharArray>(plant::Texture, 4, texture.Texels));
}

/// Polygons with all that the mesh says of its vertices.
inline vtkSmartPointer<vtkPolyData> PolyDataOf(const PlantMesh& mesh)
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

/// A polyline a branch.
inline vtkSmartPointer<vtkPolyData> PolyDataOf(const Skeleton& skeleton, const Color& bark)
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

/// High {Skeleton, Skin, Leaves}, Medium {Trunk, Crown} and Low.
inline void CopyToBlocks(const PlantPrototype& prototype, vtkMultiBlockDataSet* blocks)
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
  AddBlock(medium, plant::Crown, crown);
  AddBlock(blocks, plant::High, high);
  AddBlock(blocks, plant::Medium, medium);
  AddBlock(blocks, plant::Low, PolyDataOf(prototype.Low));
  if (prototype.Segments.empty())
  {
    AttachWood(blocks, prototype.Timber);
  }
}

}

#endif
