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

#include <algorithm>
#include <array>
#include <cmath>

namespace littoral
{
namespace
{

constexpr const char* PrototypeName = "Prototype";
constexpr double Margin = 1.001; // of lengths, for numbers in single precision

/// The box of a prototype as InstanceMapper's shader places its points: p -> place + scale R (g x, g y, z)
InstanceBox BoxOf(const vtkBoundingBox& own, const std::array<float, InstanceBatch::Numbers>& instance)
{
  const double rotation[4] = { instance[7], instance[4], instance[5], instance[6] };
  const double scale = instance[3];
  const double wide = scale * instance[11];
  const double scales[3] = { wide, wide, scale };
  double center[3];
  own.GetCenter(center);
  InstanceBox box{};
  for (int axis = 0; axis < 3; ++axis)
  {
    center[axis] *= scales[axis];
    double half[3] = { 0.0, 0.0, 0.0 };
    half[axis] = Margin * 0.5 * scales[axis] * own.GetLength(axis);
    vtkMath::RotateVectorByNormalizedQuaternion(half, rotation, box.Halves[axis].data());
  }
  vtkMath::RotateVectorByNormalizedQuaternion(center, rotation, box.Center.data());
  for (int axis = 0; axis < 3; ++axis)
  {
    box.Center[axis] += instance[axis];
  }
  return box;
}

/// A number of bytes and of what was before them (FNV-1a)
std::uint64_t Hashed(std::uint64_t state, const void* bytes, std::size_t count)
{
  const auto* next = static_cast<const unsigned char*>(bytes);
  for (const unsigned char* end = next + count; next != end; ++next)
  {
    state = (state ^ *next) * 1099511628211ULL;
  }
  return state;
}

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

/// Instances of the points of prototypes from one index to another, by the pair's prototype.
std::shared_ptr<InstanceBatch> BatchFrom(const InstancedBlocks::Pair& pair, int first, int last)
{
  const auto& [instances, prototype] = pair;
  auto batch = std::make_shared<InstanceBatch>();
  vtkPointData* arrays = instances->GetPointData();
  vtkDataArray* prototypes = arrays->GetArray(PrototypeName);
  vtkDataArray* tinted = ArrayWith(prototype->GetFieldData(), "Tinted", 1);
  const bool isTinted = !tinted || tinted->GetNumberOfTuples() == 0 || tinted->GetTuple1(0) != 0.0;
  const vtkBoundingBox box(prototype->GetBounds());
  for (vtkIdType point = 0; point < instances->GetNumberOfPoints(); ++point)
  {
    const auto index = static_cast<int>(prototypes->GetTuple1(point));
    if (index < first || index > last)
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
    const std::array<double, InstanceBatch::Numbers> numbers{ place[0], place[1], place[2], scale, rotation[1],
      rotation[2], rotation[3], rotation[0], tint[0], tint[1], tint[2], girth };
    std::array<float, InstanceBatch::Numbers> values{};
    std::transform(numbers.begin(), numbers.end(), values.begin(), [](double n) { return static_cast<float>(n); });
    batch->Add(values, box);
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
void InstanceBatch::Add(const std::array<float, Numbers>& values, const vtkBoundingBox& prototype)
{
  this->Values.insert(this->Values.end(), values.begin(), values.end());
  this->Boxes.push_back(BoxOf(prototype, values));
}

//----------------------------------------------------------------------------
std::shared_ptr<const InstanceBatch> BatchOf(const InstancedBlocks::Pair& pair)
{
  const int index = PrototypeIndex(pair.Prototype);
  return BatchFrom(pair, index, index);
}

//----------------------------------------------------------------------------
std::shared_ptr<const InstanceBatch> CoarseBatchOf(const InstancedBlocks::Pair& pair)
{
  const int index = PrototypeIndex(pair.Prototype);
  if (!IsStill(pair.Prototype))
  {
    return nullptr;
  }
  if ((index - 1) % 3 != 1)
  {
    return std::make_shared<InstanceBatch>();
  }
  const auto batch = BatchFrom(pair, index - 1, index + 1);
  const vtkMTimeType time = pair.Prototype->GetPoints()->GetData()->GetMTime();
  batch->Shape = Hashed(1469598103934665603ULL, &time, sizeof(time));
  for (std::size_t at = 0; at < batch->Values.size(); at += InstanceBatch::Numbers)
  {
    batch->Shape = Hashed(batch->Shape, &batch->Values[at], 8 * sizeof(float)); // place, scale and rotation
    batch->Shape = Hashed(batch->Shape, &batch->Values[at + 11], sizeof(float));
  }
  return batch;
}

}
