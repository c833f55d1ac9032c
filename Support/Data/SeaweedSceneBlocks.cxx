// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/SeaweedSceneBlocks.h"

#include "Data/Arrays.h"
#include "Data/JointBlock.h"
#include "Data/PlantBlocks.h"
#include "Data/PlantForm.h"
#include "Data/SeaweedBlocks.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"

#include <array>
#include <cstddef>
#include <mutex>
#include <utility>

namespace littoral
{

namespace
{

/// A skin on its way: arrays, and the ranges of their values, which are found while these are at hand.
struct MovedSkin
{
  RestSkin Rest;
  const SkinBinding* Binding;
  vtkSmartPointer<vtkFloatArray> Points;
  vtkSmartPointer<vtkFloatArray> Normals;
  std::array<TupleRanges, 2> Ranges;

  MovedSkin(const SeaweedSkinBlock& skin, FrameArrays& arrays)
    : Rest(ReadSkin(skin.Rest))
    , Binding(&skin.Binding)
    , Points(arrays.Like(FloatPointsOf(skin.Rest)))
    , Normals(arrays.Like(FindNormals(skin.Rest)))
  {
  }

  /// Moves a run of vertices; adds to the ranges of its points and normals.
  void Move(const SkinRun& run, const std::vector<JointChange>& changes, float rigidity,
    std::array<TupleRanges, 2>& ranges) const
  {
    float* p = this->Points->GetPointer(0);
    float* n = this->Normals->GetPointer(0);
    MoveSkin(this->Rest, *this->Binding, changes.data(), run.First, run.End, p, n, rigidity);
    ranges[0].AddTuples(p + 3 * run.First, p + 3 * run.End, 3);
    ranges[1].AddTuples(n + 3 * run.First, n + 3 * run.End, 3);
  }

  void Write(const SeaweedSkinBlock& skin, vtkMultiBlockDataSet* blocks) const
  {
    KeepRanges(this->Points.Get(), this->Ranges[0]);
    KeepRanges(this->Normals.Get(), this->Ranges[1]);
    vtkNew<vtkPolyData> block;
    block->ShallowCopy(skin.Rest);
    block->SetPoints(PointsWithRanges(this->Points));
    block->GetPointData()->SetNormals(this->Normals);
    ReplaceBlock(blocks, skin.Name, block);
  }
};

/// Replaces the skins among the blocks. All of a plant is done by one thread, at one go.
void WriteSkins(const SeaweedScene& scene, const std::vector<SeaweedSkinBlock>& skins, FrameArrays& arrays,
  vtkMultiBlockDataSet* blocks)
{
  arrays.BeginFrame();
  std::vector<MovedSkin> moved;
  moved.reserve(skins.size());
  for (const SeaweedSkinBlock& skin : skins)
  {
    moved.emplace_back(skin, arrays);
  }
  arrays.EndFrame();
  const std::vector<glm::dquat> rotations = scene.SkinRotations();
  std::vector<JointChange> changes(scene.GetStand().GetSkeleton().Nodes.size());
  std::mutex adding;
  SmpFor(scene.GetStand().GetPlants().size(), [&](std::size_t begin, std::size_t end) {
    std::vector<std::array<TupleRanges, 2>> parts(moved.size());
    for (std::size_t plant = begin; plant < end; ++plant)
    {
      scene.FindChanges(plant, rotations, changes);
      for (std::size_t skin = 0; skin < moved.size(); ++skin)
      {
        const SeaweedSkin& own = skins[skin].Skin;
        for (const SkinRun* run = own.RunsOf(plant); run != own.RunsOf(plant + 1); ++run)
        {
          moved[skin].Move(*run, changes, scene.RigidityOf(plant), parts[skin]);
        }
      }
    }
    const std::lock_guard<std::mutex> lock(adding);
    for (std::size_t skin = 0; skin < moved.size(); ++skin)
    {
      moved[skin].Ranges[0].Add(parts[skin][0]);
      moved[skin].Ranges[1].Add(parts[skin][1]);
    }
  });
  for (std::size_t skin = 0; skin < moved.size(); ++skin)
  {
    moved[skin].Write(skins[skin], blocks);
  }
}

void WriteSkeleton(const SeaweedScene& scene, vtkPolyData* bones, vtkMultiBlockDataSet* blocks)
{
  vtkNew<vtkPolyData> bent;
  bent->ShallowCopy(bones);
  vtkNew<vtkPoints> points;
  points->SetDataType(bones->GetPoints()->GetDataType());
  SetTuples(points->GetData(), bones->GetNumberOfPoints());
  const std::vector<Vector3> nodes = scene.NodePositions();
  for (std::size_t node = 0; node < nodes.size(); ++node)
  {
    points->SetPoint(static_cast<vtkIdType>(node), &nodes[node].x);
  }
  bent->SetPoints(PointsWithRanges(points->GetData()));
  if (!scene.GetVelocities().empty())
  {
    bent->GetPointData()->AddArray(ArrayOf<vtkFloatArray>("Velocity", 3, scene.GetVelocities()));
    bent->GetPointData()->AddArray(ArrayOf<vtkFloatArray>("Acceleration", 3, scene.GetAccelerations()));
  }
  ReplaceBlock(blocks, plant::Skeleton, bent);
}

std::vector<SeaweedSkinBlock> ReadSkins(vtkMultiBlockDataSet* plants, const SeaweedStand& stand)
{
  std::vector<SeaweedSkinBlock> skins;
  for (const char* name : { plant::Skin, plant::Leaves })
  {
    vtkPolyData* block = PlantPartOf(plants, plant::High, name);
    if (!block || block->GetNumberOfPoints() == 0)
    {
      continue;
    }
    RequireSkin(block, name, stand.GetSkeleton().Nodes.size());
    const auto vertices = static_cast<std::size_t>(block->GetNumberOfPoints());
    skins.push_back({ name, block, SeaweedSkin(ReadJointIds(block), vertices, stand), ReadBinding(block) });
  }
  return skins;
}

/// Reads the skeleton and its segments into a scene. Plants of a scattered forest have their PlantId.
void ReadBones(vtkPolyData* bones, const SeaweedOptions& options, const SeaState& sea, SeaweedScene& scene)
{
  Skeleton rest = ReadSkeleton(bones);
  const std::vector<SeaweedSegment> segments = ReadSegments(bones);
  vtkIntArray* ids = FindPlantIds(bones);
  Require(scene.SetPlants(std::move(rest), segments, ids ? ids->GetPointer(0) : nullptr, options, sea));
}

}

//----------------------------------------------------------------------------
void ReadSeaweeds(vtkMultiBlockDataSet* plants, const SeaweedOptions& options, const SeaState& sea, SeaweedScene& scene,
  std::vector<SeaweedSkinBlock>& skins)
{
  skins.clear();
  RequirePlants(plants);
  vtkPolyData* bones = PlantPartOf(plants, plant::High, plant::Skeleton);
  Require(bones ? "" : "the plants have no block High/Skeleton.");
  if (bones->GetNumberOfPoints() == 0)
  {
    Require(scene.SetPlants({}, {}, nullptr, options, sea));
    return;
  }
  RequireMemory(
    2000.0 * static_cast<double>(bones->GetNumberOfPoints()), "the motion of the plants", "take fewer plants");
  ReadBones(bones, options, sea, scene);
  skins = ReadSkins(plants, scene.GetStand());
}

//----------------------------------------------------------------------------
void WriteSeaweeds(const SeaweedScene& scene, const std::vector<SeaweedSkinBlock>& skins, FrameArrays& arrays,
  vtkMultiBlockDataSet* plants, vtkMultiBlockDataSet* output)
{
  if (scene.GetStand().GetSkeleton().Nodes.empty())
  {
    return;
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->ShallowCopy(FindBlock(plants, plant::High));
  WriteSkins(scene, skins, arrays, blocks);
  WriteSkeleton(scene, PlantPartOf(plants, plant::High, plant::Skeleton), blocks);
  ReplaceBlock(output, plant::High, blocks);
}

//----------------------------------------------------------------------------
void AddSeaweedJoints(const SeaweedScene& scene, vtkMultiBlockDataSet* output)
{
  const std::vector<SkeletonNode>& nodes = scene.GetStand().GetSkeleton().Nodes;
  const std::vector<glm::dquat> rotations = scene.SkinRotations();
  std::vector<JointChange> changes(nodes.size());
  for (std::size_t plant = 0; plant < scene.GetStand().GetPlants().size(); ++plant)
  {
    scene.FindChanges(plant, rotations, changes);
  }
  std::vector<int> parents;
  for (const SkeletonNode& node : nodes)
  {
    parents.push_back(node.Parent);
  }
  AddBlock(output, joint::Joints, JointBlock(changes, parents));
}

}
