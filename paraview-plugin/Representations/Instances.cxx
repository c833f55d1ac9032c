// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Instances.h"

#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <array>

namespace littoral
{
namespace
{

constexpr const char* PrototypeName = "Prototype";

vtkDataArray* ArrayWith(vtkFieldData* arrays, const char* name, int components)
{
  vtkDataArray* array = arrays ? arrays->GetArray(name) : nullptr;
  return array && array->GetNumberOfComponents() == components ? array : nullptr;
}

/// One scale a plant, or one for each axis.
vtkDataArray* ScalesOf(vtkPointData* arrays)
{
  vtkDataArray* same = ArrayWith(arrays, "Scale", 1);
  return same ? same : ArrayWith(arrays, "Scale", 3);
}

bool ArePoints(vtkPolyData* block)
{
  vtkPointData* arrays = block ? block->GetPointData() : nullptr;
  return ArrayWith(arrays, PrototypeName, 1) && ArrayWith(arrays, "Rotation", 4) && ScalesOf(arrays) &&
    ArrayWith(arrays, "Tint", 3);
}

/// The index of a block among the prototypes; -1 if it is none.
int PrototypeIndex(vtkPolyData* block)
{
  vtkDataArray* index = block ? ArrayWith(block->GetFieldData(), PrototypeName, 1) : nullptr;
  return index && index->GetNumberOfTuples() > 0 ? static_cast<int>(index->GetTuple1(0)) : -1;
}

/// Whether a block is one of vtkPlantScatterFilter and no seaweed, which moves.
bool IsStill(vtkPolyData* block)
{
  vtkDataArray* seaweed = ArrayWith(block->GetFieldData(), "Seaweed", 1);
  return seaweed && seaweed->GetNumberOfTuples() > 0 && seaweed->GetTuple1(0) == 0.0;
}

}

//----------------------------------------------------------------------------
InstancedBlocks InstancesIn(vtkDataObject* data)
{
  InstancedBlocks found;
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return found;
  }
  vtkPolyData* points = nullptr;
  const auto leaf = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    auto* block = vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject());
    if (ArePoints(block))
    {
      points = block;
      found.Blocks.insert(block);
    }
    else if (points && PrototypeIndex(block) >= 0)
    {
      found.Pairs.push_back({ points, block });
      found.Blocks.insert(block);
    }
  }
  return found;
}

//----------------------------------------------------------------------------
std::vector<vtkPolyData*> MediumPlantOf(const InstancedBlocks& instanced, const InstancedBlocks::Pair& pair)
{
  // 1 + 3 species + level: High, Medium, Low
  const int index = PrototypeIndex(pair.Prototype);
  std::vector<vtkPolyData*> blocks;
  if (index % 3 != 0 || !IsStill(pair.Prototype))
  {
    return blocks;
  }
  for (const InstancedBlocks::Pair& other : instanced.Pairs)
  {
    if (other.Points == pair.Points && PrototypeIndex(other.Prototype) == index - 1)
    {
      blocks.push_back(other.Prototype);
    }
  }
  return blocks;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> PlacesOf(const InstancedBlocks::Pair& pair)
{
  vtkPointData* given = pair.Points->GetPointData();
  vtkDataArray* prototypes = given->GetArray(PrototypeName);
  const int index = PrototypeIndex(pair.Prototype);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto places = vtkSmartPointer<vtkPolyData>::New();
  places->GetPointData()->CopyAllocate(given);
  vtkNew<vtkUnsignedCharArray> fades;
  fades->SetName("Fades");
  for (vtkIdType point = 0; point < pair.Points->GetNumberOfPoints(); ++point)
  {
    const int own = static_cast<int>(prototypes->GetTuple1(point));
    if (own == index || own == index - 1)
    {
      fades->InsertNextValue(own != index);
      places->GetPointData()->CopyData(given, point, points->InsertNextPoint(pair.Points->GetPoint(point)));
    }
  }
  places->SetPoints(points);
  places->GetPointData()->AddArray(fades);
  return places;
}

//----------------------------------------------------------------------------
std::array<double, 2> FadeRangeOf(const InstancedBlocks::Pair& pair)
{
  constexpr double begin = 0.8; // of the far level's distance
  const int level = (PrototypeIndex(pair.Prototype) - 1) % 3;
  vtkDataArray* far = ArrayWith(pair.Points->GetFieldData(), "FarDistance", 1);
  return level > 0 && IsStill(pair.Prototype) && far && far->GetNumberOfTuples() > 0
    ? std::array<double, 2>{ begin * far->GetTuple1(0), far->GetTuple1(0) }
    : std::array<double, 2>{ 0.0, 0.0 };
}

//----------------------------------------------------------------------------
std::shared_ptr<const InstanceBatch> BatchOf(const InstancedBlocks::Pair& pair)
{
  const auto& [instances, prototype] = pair;
  auto batch = std::make_shared<InstanceBatch>();
  vtkPointData* arrays = instances->GetPointData();
  vtkDataArray* prototypes = arrays->GetArray(PrototypeName);
  vtkDataArray* tinted = ArrayWith(prototype->GetFieldData(), "Tinted", 1);
  const bool isTinted = !tinted || tinted->GetNumberOfTuples() == 0 || tinted->GetTuple1(0) != 0.0;
  const int index = PrototypeIndex(prototype);
  const vtkBoundingBox box(prototype->GetBounds());
  batch->Prototype = box;
  for (vtkIdType point = 0; point < instances->GetNumberOfPoints(); ++point)
  {
    if (static_cast<int>(prototypes->GetTuple1(point)) != index)
    {
      continue;
    }
    std::array<double, 3> place{};
    std::array<double, 4> rotation{};
    std::array<double, 3> tint{ 1.0, 1.0, 1.0 };
    instances->GetPoint(point, place.data());
    arrays->GetArray("Rotation")->GetTuple(point, rotation.data());
    vtkDataArray* scales = ScalesOf(arrays);
    const double wide = scales->GetComponent(point, 0);
    const double scale = scales->GetComponent(point, scales->GetNumberOfComponents() - 1);
    const double girth = scale > 0.0 ? wide / scale : 1.0;
    if (isTinted)
    {
      arrays->GetArray("Tint")->GetTuple(point, tint.data());
    }
    for (const double number : { place[0], place[1], place[2], scale, rotation[1], rotation[2], rotation[3],
           rotation[0], tint[0], tint[1], tint[2], girth })
    {
      batch->Values.push_back(static_cast<float>(number));
    }
    for (int corner = 0; corner < 8 && box.IsValid(); ++corner)
    {
      std::array<double, 3> own{};
      std::array<double, 3> at{};
      box.GetCorner(corner, own.data());
      own[0] *= girth;
      own[1] *= girth;
      vtkMath::RotateVectorByNormalizedQuaternion(own.data(), rotation.data(), at.data());
      batch->Bounds.AddPoint(place[0] + scale * at[0], place[1] + scale * at[1], place[2] + scale * at[2]);
    }
  }
  return batch;
}

}
