// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneBlocks.h"

#include "Data/ArrayReader.h"
#include "Data/JointBlock.h"
#include "Data/PlantBlocks.h"
#include "Data/PlantTable.h"
#include "Data/SeaweedBlocks.h"

#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace littoral
{

namespace
{

constexpr const char* Prototype = "Prototype";

/// A field number of a block; `otherwise` where it has none.
int NumberOf(vtkPolyData* block, const char* name, int otherwise)
{
  vtkDataArray* numbers = block ? ArrayReader::OfFields(block, "", 1).Seek(name, 1) : nullptr;
  return numbers ? static_cast<int>(numbers->GetComponent(0, 0)) : otherwise;
}

/// The scales of plants, one each or one for each axis.
vtkDataArray* ScalesOf(const ArrayReader& arrays)
{
  vtkDataArray* any = arrays.Any("Scale");
  return arrays.Need("Scale", any && any->GetNumberOfComponents() == 3 ? 3 : 1);
}

/// Tints are factors of displayed colors; those of linear light are nearly a power of them.
float LinearFactor(double factor)
{
  constexpr double gamma = 2.2;
  return static_cast<float>(std::pow(factor, gamma));
}

}

//----------------------------------------------------------------------------
bool IsComposite(vtkDataObject* data)
{
  return data && data->IsA("vtkCompositeDataSet");
}

//----------------------------------------------------------------------------
std::vector<NamedBlock> NamedBlocks(vtkMultiBlockDataSet* blocks)
{
  std::vector<NamedBlock> named;
  for (unsigned int index = 0; index < blocks->GetNumberOfBlocks(); ++index)
  {
    const char* name =
      blocks->HasMetaData(index) ? blocks->GetMetaData(index)->Get(vtkCompositeDataSet::NAME()) : nullptr;
    if (blocks->GetBlock(index))
    {
      named.push_back({ name && *name ? name : "Block " + std::to_string(index), blocks->GetBlock(index), index });
    }
  }
  return named;
}

//----------------------------------------------------------------------------
bool ArePlants(vtkMultiBlockDataSet* blocks)
{
  return vtkMultiBlockDataSet::SafeDownCast(FindBlock(blocks, plant::High)) != nullptr;
}

//----------------------------------------------------------------------------
bool AreLevelsOfOne(vtkMultiBlockDataSet* plants)
{
  return !ArrayReader::OfFields(plants, "").Has(plant::PlantId);
}

//----------------------------------------------------------------------------
bool AreSeaweeds(vtkMultiBlockDataSet* plants)
{
  vtkPolyData* bones = PlantPartOf(plants, plant::High, plant::Skeleton);
  return bones && bones->GetPointData()->HasArray(seaweed::Tissue);
}

//----------------------------------------------------------------------------
SceneKind KindOf(vtkPolyData* block, const std::string& name, bool isOfPlant, bool isOfSeaweed)
{
  if (isOfPlant)
  {
    const bool isWood = name == plant::Skin || name == plant::Trunk;
    return isOfSeaweed ? SceneKind::Blade : isWood ? SceneKind::Bark : SceneKind::Leaf;
  }
  const ArrayReader points = ArrayReader::OfPoints(block, "");
  return points.Has("Jacobian") ? SceneKind::Water
    : points.Has("ParticleId")  ? SceneKind::Particle
    : points.Has("Elevation")   ? SceneKind::Ground
                                : SceneKind::Plain;
}

//----------------------------------------------------------------------------
void RequireJoints(vtkPolyData* joints, const std::string& owner)
{
  const ArrayReader arrays = ArrayReader::OfPoints(joints, "the joints of " + owner);
  vtkDataArray* points = joints->GetPoints() ? joints->GetPoints()->GetData() : nullptr;
  arrays.NeedFinite(arrays.Fit<vtkFloatArray>(points, 3));
  arrays.NeedFinite(arrays.Need<vtkFloatArray>(joint::RestPosition, 3));
  arrays.NeedFinite(arrays.Need<vtkFloatArray>(joint::Rotation, 4));
  auto* parents = arrays.Need<vtkIntArray>(joint::ParentId, 1);
  for (vtkIdType joint = 0; joint < parents->GetNumberOfValues(); ++joint)
  {
    if (parents->GetValue(joint) < -1 || parents->GetValue(joint) >= joint)
    {
      Refuse("joint ", joint, " of ", owner, " comes before its parent.");
    }
  }
}

//----------------------------------------------------------------------------
void RequireMotion(vtkMultiBlockDataSet* plants, const std::string& owner)
{
  vtkDataObject* block = FindBlock(plants, joint::Joints);
  if (!block)
  {
    return;
  }
  auto* joints = vtkPolyData::SafeDownCast(block);
  Require(joints ? "" : "the block Joints of " + owner + " is not polygonal data.");
  RequireJoints(joints, owner);
  ReadTable(plants);
  for (const char* level : { plant::High, plant::Medium })
  {
    for (const char* name : { plant::Skin, plant::Leaves, plant::Trunk, plant::Crown })
    {
      vtkPolyData* part = PlantPartOf(plants, level, name);
      if (part && part->GetNumberOfPoints() > 0)
      {
        const ArrayReader points = ArrayReader::OfPoints(part, owner + "/" + level + "/" + name);
        points.NeedIds(points.Find<vtkIntArray>(plant::JointIds, 4), joints->GetNumberOfPoints(), "joint");
        points.NeedFinite(points.Find<vtkFloatArray>(plant::JointWeights, 4));
        points.Find<vtkIntArray>(plant::PlantId, 1);
      }
    }
  }
}

//----------------------------------------------------------------------------
vtkPolyData* InstancesOf(vtkMultiBlockDataSet* blocks)
{
  for (unsigned int index = 0; index < blocks->GetNumberOfBlocks(); ++index)
  {
    auto* block = vtkPolyData::SafeDownCast(blocks->GetBlock(index));
    if (block && ArrayReader::OfPoints(block, "").Seek(Prototype, 1) && PrototypeOf(block) < 0)
    {
      return block;
    }
  }
  return nullptr;
}

//----------------------------------------------------------------------------
int PrototypeOf(vtkPolyData* part)
{
  return NumberOf(part, Prototype, -1);
}

//----------------------------------------------------------------------------
bool IsTinted(vtkPolyData* part)
{
  return NumberOf(part, "Tinted", 1) != 0;
}

//----------------------------------------------------------------------------
bool IsOfSeaweed(vtkPolyData* part)
{
  return NumberOf(part, "Seaweed", 0) != 0;
}

//----------------------------------------------------------------------------
void RequireInstances(vtkPolyData* points, const std::string& owner)
{
  const ArrayReader arrays = ArrayReader::OfPoints(points, owner);
  arrays.NeedFinite(points->GetPoints() ? points->GetPoints()->GetData() : nullptr);
  arrays.NeedFinite(arrays.Need(Prototype, 1));
  arrays.NeedFinite(arrays.Need("Rotation", 4));
  arrays.NeedFinite(ScalesOf(arrays));
  arrays.NeedFinite(arrays.Need("Tint", 3));
}

//----------------------------------------------------------------------------
SceneInstances PlacesOf(vtkPolyData* points, const std::function<bool(int prototype)>& isChosen)
{
  const ArrayReader arrays = ArrayReader::OfPoints(points, "");
  vtkDataArray* prototypes = arrays.Find(Prototype, 1);
  vtkDataArray* rotations = arrays.Find("Rotation", 4);
  vtkDataArray* scales = ScalesOf(arrays);
  const int up = scales->GetNumberOfComponents() - 1;
  vtkDataArray* tints = arrays.Find("Tint", 3);
  SceneInstances places;
  for (vtkIdType point = 0; point < points->GetNumberOfPoints(); ++point)
  {
    if (!isChosen(static_cast<int>(prototypes->GetComponent(point, 0))))
    {
      continue;
    }
    double at[3];
    points->GetPoint(point, at);
    places.Translations.insert(places.Translations.end(), at, at + 3);
    double turn[4]; // w, x, y, z
    rotations->GetTuple(point, turn);
    const double length = std::sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3]);
    for (const int part : { 1, 2, 3, 0 })
    {
      places.Rotations.push_back(static_cast<float>(length > 0.0 ? turn[part] / length : part == 0 ? 1.0 : 0.0));
    }
    for (const int axis : { 0, up / 2, up })
    {
      places.Scales.push_back(static_cast<float>(scales->GetComponent(point, axis)));
    }
    for (int part = 0; part < 3; ++part)
    {
      places.Tints.push_back(LinearFactor(tints->GetComponent(point, part)));
    }
  }
  return places;
}

}
