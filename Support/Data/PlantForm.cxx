// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/PlantForm.h"

#include "Data/ArrayReader.h"
#include "Data/Cells.h"
#include "Data/Inputs.h"
#include "Data/PlantBlocks.h"
#include "Data/SeaweedBlocks.h"

namespace littoral
{

namespace
{

/// A block of plants.
struct BlockName
{
  const char* Level;
  const char* Part; ///< null: the level is the block
};

constexpr BlockName BlockNames[] = { { plant::High, plant::Skeleton }, { plant::High, plant::Skin },
  { plant::High, plant::Leaves }, { plant::Medium, plant::Trunk }, { plant::Medium, plant::Crown },
  { plant::Low, nullptr } };

/// Finds a block; null if there is none. Other data are refused.
vtkPolyData* FindPart(vtkMultiBlockDataSet* plants, const BlockName& name)
{
  vtkDataObject* data = FindBlock(plants, name.Level);
  std::string path = name.Level;
  if (data && name.Part)
  {
    auto* level = vtkMultiBlockDataSet::SafeDownCast(data);
    Require(level ? "" : WhyOtherType(data, ("Block " + path).c_str(), "blocks (vtkMultiBlockDataSet)"));
    data = FindBlock(level, name.Part);
    path += std::string("/") + name.Part;
  }
  auto* part = vtkPolyData::SafeDownCast(data);
  Require(data && !part ? WhyOtherType(data, ("Block " + path).c_str(), WordsForType<vtkPolyData>()) : "");
  return part;
}

/// Checks arrays that tell how a block is drawn.
void RequireLook(vtkPolyData* block, const std::string& owner)
{
  const ArrayReader points = ArrayReader::OfPoints(block, owner);
  points.NeedFinite(block->GetPoints() ? block->GetPoints()->GetData() : nullptr);
  points.NeedFinite(points.Fit(block->GetPointData()->GetNormals(), 3));
  points.NeedFinite(points.Find("Normals", 3));
  vtkDataArray* places = block->GetPointData()->GetTCoords();
  const int axes = places && places->GetNumberOfComponents() == 3 ? 3 : 2;
  points.NeedFinite(points.Fit(places, axes));
  points.NeedFinite(points.Find("TCoords", axes));
}

/// Checks arrays that all plants have.
void RequireColors(vtkPolyData* block, const std::string& owner)
{
  const ArrayReader points = ArrayReader::OfPoints(block, owner);
  points.Find(plant::RGB, 3);
  points.Find(plant::PlantId, 1);
}

/// Checks arrays that tell how a block moves.
void RequireMotion(vtkPolyData* block, vtkIdType nodes, const std::string& owner)
{
  const ArrayReader points = ArrayReader::OfPoints(block, owner);
  points.NeedIds(points.Find<vtkIntArray>(plant::JointIds, 4), nodes, "node");
  points.NeedFinite(points.Find<vtkFloatArray>(plant::JointWeights, 4));
  points.NeedIds(points.Find<vtkIntArray>(plant::ParentId, 1), nodes, "node", -1);
  points.Find<vtkFloatArray>(plant::Radius, 1);
  points.NeedFinite(points.Find(seaweed::Across, 3));
  for (const char* name : { seaweed::Tissue, seaweed::Width, seaweed::Thickness, seaweed::YoungModulus,
         seaweed::DampingRatio, seaweed::Density, seaweed::Length, seaweed::Attachment })
  {
    points.NeedFinite(points.Find(name, 1));
  }
}

void RequireBlock(vtkPolyData* block, vtkIdType nodes, const std::string& owner)
{
  RequireDrawing(block, owner);
  RequireColors(block, owner);
  RequireMotion(block, nodes, owner);
  RequireTexture(block, owner);
}

}

//----------------------------------------------------------------------------
void RequireTexture(vtkPolyData* block, const std::string& owner)
{
  const ArrayReader fields = ArrayReader::OfFields(block, owner);
  const ArrayReader single = ArrayReader::OfFields(block, owner, 1);
  auto* texels = fields.Find<vtkUnsignedCharArray>(plant::Texture, 4);
  const ArrayReader normals = ArrayReader::OfFields(block, owner, texels ? texels->GetNumberOfTuples() : -1);
  normals.Find<vtkUnsignedCharArray>(plant::NormalTexture, 3);
  const ArrayReader views = ArrayReader::OfFields(block, owner, ImpostorViews);
  views.NeedFinite(views.Find(plant::ImpostorAreas, 1));
  single.NeedFinite(single.Find(plant::TextureMean, 3));
  single.NeedFinite(single.Find(plant::ImpostorExtent, 3));
  single.Find(plant::Envelope, 1);
  const ArrayReader pair = ArrayReader::OfFields(block, owner, 2);
  vtkDataArray* size = texels ? pair.Need(plant::TextureSize, 1) : pair.Find(plant::TextureSize, 1);
  if (!texels)
  {
    return;
  }
  int sides[2] = { 0, 0 };
  for (int side = 0; side < 2; ++side)
  {
    ReadWhole("TextureSize of " + owner, size->GetComponent(side, 0), 1, VTK_INT_MAX, sides[side]);
  }
  const bool fits = static_cast<vtkIdType>(sides[0]) * sides[1] == texels->GetNumberOfTuples();
  Require(fits ? "" : "Texture of " + owner + " has not as many texels as TextureSize tells.");
}

//----------------------------------------------------------------------------
void RequireDrawing(vtkPolyData* block, const std::string& owner)
{
  RequireFit(block, owner.c_str());
  RequireCells(block, owner);
  RequireLook(block, owner);
}

//----------------------------------------------------------------------------
void RequireSkeleton(vtkMultiBlockDataSet* plants)
{
  vtkPolyData* bones = PlantPartOf(plants, plant::High, plant::Skeleton);
  bones ? RequireBlock(bones, bones->GetNumberOfPoints(), "High/Skeleton of the plants") : RequirePlants(plants);
}

//----------------------------------------------------------------------------
void RequirePlants(vtkMultiBlockDataSet* plants)
{
  const ArrayReader fields = ArrayReader::OfFields(plants, "The plants", 1);
  fields.NeedFinite(fields.Find(plant::Wood, 3));
  vtkIdType nodes = 0;
  for (const BlockName& name : BlockNames)
  {
    vtkPolyData* block = FindPart(plants, name);
    nodes = &name == BlockNames && block ? block->GetNumberOfPoints() : nodes;
    if (block)
    {
      const std::string path = name.Part ? std::string(name.Level) + "/" + name.Part : name.Level;
      RequireBlock(block, nodes, path + " of the plants");
    }
  }
}

}
