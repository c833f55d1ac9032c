// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ScatterPrototypes.h"

#include "Data/ArrayReader.h"
#include "Data/Blocks.h"
#include "Numerics/InvalidInput.h"

#include "vtkCellArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace littoral
{

namespace
{

void RequireCells(vtkPolyData* block, const PartKind& kind)
{
  const vtkIdType cells = kind.HasLines ? block->GetNumberOfLines() : block->GetNumberOfPolys();
  if (cells != block->GetNumberOfCells())
  {
    Refuse(
      "its ", kind.Name ? kind.Name : kind.Level, " has cells that are not ", kind.HasLines ? "lines." : "polygons.");
  }
}

/// The cylinder that holds all levels of a prototype. Cards have transparent corners beyond it.
PlantExtent ExtentOf(const PrototypeBlocks& blocks)
{
  PlantExtent extent;
  for (vtkPolyData* block : blocks)
  {
    const bool isCards = block && block == blocks[LowPart] && block->GetFieldData()->HasArray(plant::ImpostorExtent);
    for (vtkIdType point = 0; block && !isCards && point < block->GetNumberOfPoints(); ++point)
    {
      double position[3];
      block->GetPoint(point, position);
      extent.Radius = std::max(extent.Radius, std::hypot(position[0], position[1]));
      extent.Low = std::min(extent.Low, position[2]);
      extent.High = std::max(extent.High, position[2]);
    }
  }
  return extent;
}

/// The top of a level, and the stem of its bark.
StemShape StemOf(const PrototypeBlocks& blocks, PartIndex bark, PartIndex leaves)
{
  double top = 0.0;
  for (const PartIndex part : { bark, leaves })
  {
    if (blocks[part] && blocks[part]->GetNumberOfPoints() > 0)
    {
      top = std::max(top, blocks[part]->GetBounds()[5]);
    }
  }
  std::vector<Vector3> points;
  std::vector<std::array<int, 3>> triangles;
  vtkPolyData* skin = blocks[bark];
  for (vtkIdType point = 0; skin && point < skin->GetNumberOfPoints(); ++point)
  {
    Vector3& position = points.emplace_back();
    skin->GetPoint(point, &position.x);
  }
  for (vtkIdType cell = 0; skin && cell < skin->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    skin->GetPolys()->GetCellAtId(cell, size, corners);
    for (vtkIdType corner = 2; corner < size; ++corner)
    {
      triangles.push_back(
        { static_cast<int>(corners[0]), static_cast<int>(corners[corner - 1]), static_cast<int>(corners[corner]) });
    }
  }
  return { points, triangles, top };
}

/// A block that is one card, to be placed.
vtkSmartPointer<vtkPolyData> CardBlock(const PlantImpostor& impostor)
{
  PlantMesh mesh;
  mesh.Points.resize(4);
  mesh.Normals.resize(4);
  mesh.TCoords.resize(4);
  mesh.Colors.assign(4, impostor.Mean);
  mesh.AddPolygon(std::array<int, 4>{ 0, 1, 2, 3 });
  return PolyDataOf(mesh);
}

/// Joins the textures of a part, which become its field data.
TextureAtlas JoinTextures(const std::vector<PrototypeBlocks>& blocks, PartIndex part, ScatterPrototypes& prototypes)
{
  std::vector<TextureImage> textures;
  std::vector<ColorSum> means;
  for (const PrototypeBlocks& each : blocks)
  {
    textures.push_back(ReadTexture(each[part]));
    means.push_back(ReadTextureMean(each[part]));
  }
  const ColorSum mean = ShareMean(textures, means);
  TextureAtlas atlas = StackTextures(textures);
  vtkNew<vtkPolyData> carrier;
  AttachTexture(carrier, atlas.Image);
  if (mean != ColorSum{ 1.0f, 1.0f, 1.0f })
  {
    AttachTextureMean(carrier, mean);
  }
  prototypes.Textures[part] = carrier->GetFieldData();
  return atlas;
}

/// Joins the normals of impostors; flat where there are none.
void JoinNormals(const std::vector<PlantImpostor>& impostors, ScatterPrototypes& prototypes)
{
  std::vector<TextureImage> textures;
  for (const PlantImpostor& impostor : impostors)
  {
    TextureImage& normals = textures.emplace_back(impostor.Pictures.Columns, impostor.Pictures.Rows);
    std::transform(impostor.Normals.begin(), impostor.Normals.end(), normals.Texels.begin(), [](const Color& n) {
      return Texel{ n[0], n[1], n[2], 255 };
    });
  }
  const TextureImage atlas = StackTextures(textures).Image;
  std::vector<Color> normals;
  normals.reserve(atlas.Texels.size());
  for (const Texel& texel : atlas.Texels)
  {
    normals.push_back({ texel[0], texel[1], texel[2] });
  }
  vtkNew<vtkPolyData> carrier;
  carrier->SetFieldData(prototypes.Textures[LowPart]);
  AttachNormalTexture(carrier, normals);
}

void DropJoints(PlantPart& part)
{
  std::vector<PartArray>& arrays = part.PointArrays;
  const auto areJoints = [](const PartArray& array) {
    return array.Name == plant::JointIds || array.Name == plant::JointWeights;
  };
  arrays.erase(std::remove_if(arrays.begin(), arrays.end(), areJoints), arrays.end());
}

/// Takes the lowest level, both as it is and as cards.
void TakeLow(const std::vector<PrototypeBlocks>& blocks, ScatterPrototypes& prototypes)
{
  std::vector<PlantImpostor> impostors;
  std::vector<vtkPolyData*> own;
  std::vector<vtkPolyData*> facing;
  std::vector<vtkSmartPointer<vtkPolyData>> cards;
  bool hasPictures = false;
  for (const PrototypeBlocks& each : blocks)
  {
    const PlantImpostor& impostor = impostors.emplace_back(ReadImpostor(each[LowPart]));
    const bool isCard = !impostor.Pictures.Texels.empty();
    hasPictures |= isCard;
    prototypes.Shapes.push_back(isCard ? std::optional(impostor.Shape) : std::nullopt);
    cards.push_back(isCard ? CardBlock(impostor) : nullptr);
    own.push_back(each[LowPart]);
    facing.push_back(isCard ? cards.back().Get() : each[LowPart]);
  }
  TextureAtlas atlas;
  if (hasPictures)
  {
    atlas = JoinTextures(blocks, LowPart, prototypes);
    JoinNormals(impostors, prototypes);
  }
  prototypes.Parts.push_back(MakePart(PartKinds[LowPart], own, hasPictures ? &atlas : nullptr));
  prototypes.FacingLow = MakePart(PartKinds[LowPart], facing, hasPictures ? &atlas : nullptr);
  prototypes.LowAreas = std::move(atlas.Areas);
}

}

vtkPolyData* PartOf(vtkMultiBlockDataSet* prototype, const PartKind& kind)
{
  vtkDataObject* level = FindBlock(prototype, kind.Level);
  return vtkPolyData::SafeDownCast(kind.Name ? FindBlock(vtkMultiBlockDataSet::SafeDownCast(level), kind.Name) : level);
}

PrototypeBlocks PartsOf(vtkMultiBlockDataSet* prototype)
{
  PrototypeBlocks blocks{};
  std::transform(std::begin(PartKinds), std::end(PartKinds), blocks.begin(),
    [prototype](const PartKind& kind) { return PartOf(prototype, kind); });
  return blocks;
}

void RequirePrototype(const PrototypeBlocks& blocks)
{
  std::array<vtkIdType, 3> polygons{ 0, 0, 0 };
  for (int part = 0; part < NumberOfParts; ++part)
  {
    if (blocks[part])
    {
      RequireCells(blocks[part], PartKinds[part]);
      polygons[static_cast<int>(LevelOfPart[part])] += blocks[part]->GetNumberOfPolys();
    }
  }
  for (int part : { SkeletonPart, TrunkPart, LowPart })
  {
    if (polygons[static_cast<int>(LevelOfPart[part])] == 0)
    {
      Refuse("its level ", PartKinds[part].Level, " is missing or empty.");
    }
  }
  if (blocks[SkeletonPart])
  {
    const ArrayReader points = ArrayReader::OfPoints(blocks[SkeletonPart], "its Skeleton");
    points.NeedFinite(points.Find(plant::Radius, 1));
  }
}

void TakeParts(const std::vector<PrototypeBlocks>& blocks, bool withJoints, ScatterPrototypes& prototypes)
{
  for (const PrototypeBlocks& each : blocks)
  {
    prototypes.Extents.push_back(ExtentOf(each));
    prototypes.Stems.push_back(StemOf(each, SkinPart, LeavesPart));
    prototypes.MediumStems.push_back(StemOf(each, TrunkPart, CrownPart));
  }
  TextureAtlas crownAtlas = JoinTextures(blocks, CrownPart, prototypes);
  TextureAtlas leafAtlas = JoinTextures(blocks, LeavesPart, prototypes);
  for (int part = 0; part < LowPart; ++part)
  {
    std::vector<vtkPolyData*> own;
    own.reserve(blocks.size());
    for (const PrototypeBlocks& each : blocks)
    {
      own.push_back(each[part]);
    }
    const TextureAtlas* atlas = part == CrownPart ? &crownAtlas : part == LeavesPart ? &leafAtlas : nullptr;
    prototypes.Parts.push_back(MakePart(PartKinds[part], own, atlas));
    if (!withJoints)
    {
      DropJoints(prototypes.Parts.back());
    }
  }
  TakeLow(blocks, prototypes);
  prototypes.CrownAtlas = std::move(crownAtlas.Image);
  prototypes.LeafAtlas = std::move(leafAtlas.Image);
}

}
