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

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>

namespace littoral
{

namespace
{

/// Asks for memory that is needed soon.
void Fetch(const float* numbers)
{
#if defined(__GNUC__)
  __builtin_prefetch(numbers);
#endif
}

constexpr std::size_t PlantsAhead = 4;

/// Ranges of the plants of one thread.
struct PlantSums
{
  SkinRanges Moving;
  std::array<TupleRanges, 2> Staying; ///< of points and of normals
};

/// A skin on its way: arrays, and the ranges of their values, which are found while these are at hand.
class MovedSkin
{
public:
  MovedSkin(const SeaweedScene& scene, SeaweedSkinBlock& skin, FrameArrays& arrays)
    : Block(skin)
    , Rest(ReadSkin(skin.Rest))
    , Points(arrays.Like(FloatPointsOf(skin.Rest)))
    , Normals(arrays.Like(FindNormals(skin.Rest)))
    , HasFixed(arrays.IsFormer(this->Points) && arrays.IsFormer(this->Normals))
    , Since(std::min(arrays.NotedWith(this->Points), arrays.NotedWith(this->Normals)))
  {
    arrays.Note(this->Points, scene.GetShow());
    arrays.Note(this->Normals, scene.GetShow());
  }

  /// Sees to the vertices that never move: an array that is used again has them.
  void MoveFixed(const std::vector<JointChange>& changes)
  {
    if (!this->HasFixed)
    {
      const std::vector<SkinRun>& runs = this->Block.Skin.GetFixedRuns();
      this->Block.FixedRanges = {};
      SmpFor(runs.size(), [&](std::size_t begin, std::size_t end) {
        SkinRanges ranges;
        std::for_each(runs.data() + begin, runs.data() + end,
          [&](const SkinRun& run) { this->Bend(run, changes, 0.0f, nullptr, ranges); });
        this->Add(ranges, this->Block.FixedRanges);
      });
    }
    this->Found[0].Add(this->Block.FixedRanges[0]);
    this->Found[1].Add(this->Block.FixedRanges[1]);
  }

  /// Whether the arrays have a plant that stays for some pictures as it is, and its ranges are known.
  bool HasPlant(const SeaweedScene& scene, std::size_t plant) const
  {
    return scene.Stays(plant) && !scene.HasChangedSince(plant, this->Since) &&
      !scene.HasChangedSince(plant, this->Block.PlantRanges[plant].Show);
  }

  /// Adds the ranges of a plant that stays.
  void AddPlant(std::size_t plant, PlantSums& sums) const
  {
    const std::array<VectorRange, 2>& ranges = this->Block.PlantRanges[plant].Ranges;
    sums.Staying[0].Add(ranges[0], 3);
    sums.Staying[1].Add(ranges[1], 3);
  }

  /// Moves a plant, and keeps its ranges if it stays.
  void MovePlant(
    const SeaweedScene& scene, std::size_t plant, const std::vector<JointChange>& changes, PlantSums& sums) const
  {
    if (!scene.Stays(plant))
    {
      this->MoveRuns(scene, plant, changes, sums.Moving);
      return;
    }
    SkinRanges ranges;
    this->MoveRuns(scene, plant, changes, ranges);
    this->Block.PlantRanges[plant] = { { ranges.Points.Range(), ranges.Normals.Range() }, scene.GetShow() };
    this->AddPlant(plant, sums);
  }

  /// Asks for the memory of a plant whose turn comes soon.
  void FetchPlant(std::size_t plant) const
  {
    const SeaweedSkin& own = this->Block.Skin;
    std::for_each(own.RunsOf(plant), own.RunsOf(plant + 1), [&](const SkinRun& run) {
      for (const float* vectors :
        { this->Rest.Points, this->Rest.Normals, static_cast<const float*>(this->Points->GetPointer(0)),
          static_cast<const float*>(this->Normals->GetPointer(0)) })
      {
        Fetch(vectors + 3 * run.First);
        Fetch(vectors + 3 * run.First + 16);
        Fetch(vectors + 3 * run.First + 32);
      }
    });
  }

  void AddRanges(const PlantSums& sums)
  {
    this->Add(sums.Moving, this->Found);
    const std::lock_guard<std::mutex> lock(this->Adding);
    this->Found[0].Add(sums.Staying[0]);
    this->Found[1].Add(sums.Staying[1]);
  }

  void Write(vtkMultiBlockDataSet* blocks) const
  {
    KeepRanges(this->Points.Get(), this->Found[0]);
    KeepRanges(this->Normals.Get(), this->Found[1]);
    vtkNew<vtkPolyData> block;
    block->ShallowCopy(this->Block.Rest);
    block->SetPoints(PointsWithRanges(this->Points));
    block->GetPointData()->SetNormals(this->Normals);
    ReplaceBlock(blocks, this->Block.Name, block);
  }

private:
  SeaweedSkinBlock& Block;
  RestSkin Rest;
  vtkSmartPointer<vtkFloatArray> Points;
  vtkSmartPointer<vtkFloatArray> Normals;
  bool HasFixed;
  long long Since;                  ///< the Show() that the arrays are of; 0: of none
  std::array<TupleRanges, 2> Found; ///< of points and of normals
  std::mutex Adding;

  /// Moves all of a plant; adds to the ranges.
  void MoveRuns(
    const SeaweedScene& scene, std::size_t plant, const std::vector<JointChange>& changes, SkinRanges& ranges) const
  {
    const SeaweedSkin& own = this->Block.Skin;
    const float rigidity = scene.RigidityOf(plant);
    const std::size_t kind = rigidity < 1.0f ? 2 : (scene.IsFar(plant) ? 1 : 0);
    const RigidBinding& rigid = kind == 1 ? this->Block.Far : this->Block.Rigid;
    std::for_each(own.RunsOf(plant), own.RunsOf(plant + 1), [&](const SkinRun& run) {
      const std::size_t first = this->Block.FirstRuns[kind][own.IndexOf(&run)];
      kind == 2 ? this->Bend(run, changes, rigidity, this->Block.Binding.RunAt(first), ranges)
                : MoveRigidly(this->Rest, rigid.RunAt(first), changes.data(), run.First, run.End,
                    this->Points->GetPointer(0), this->Normals->GetPointer(0), ranges);
    });
  }

  void Bend(const SkinRun& run, const std::vector<JointChange>& changes, float rigidity, const SkinBinding::Run* first,
    SkinRanges& ranges) const
  {
    float* p = this->Points->GetPointer(0);
    float* n = this->Normals->GetPointer(0);
    MoveSkin(this->Rest, this->Block.Binding, changes.data(), run.First, run.End, p, n, rigidity, first);
    AddVectors(p + 3 * run.First, run.End - run.First, ranges.Points);
    AddVectors(n + 3 * run.First, run.End - run.First, ranges.Normals);
  }

  void Add(const SkinRanges& part, std::array<TupleRanges, 2>& sum)
  {
    const std::lock_guard<std::mutex> lock(this->Adding);
    sum[0].Add(part.Points.Range(), 3);
    sum[1].Add(part.Normals.Range(), 3);
  }
};

bool HasStaying(const SeaweedScene& scene)
{
  const std::size_t plants = scene.GetStand().GetPlants().size();
  std::size_t plant = 0;
  while (plant < plants && !scene.Stays(plant))
  {
    ++plant;
  }
  return plant < plants;
}

/// Moves plants in all skins, but for those that these have. All of a plant is done by one thread, at one go.
void MovePlants(const SeaweedScene& scene, std::deque<MovedSkin>& skins, std::vector<JointChange>& changes)
{
  const bool someStay = HasStaying(scene);
  const std::vector<glm::dquat> rotations = scene.SkinRotations();
  const auto isThere = [&](std::size_t plant) {
    const auto has = [&](const MovedSkin& skin) { return skin.HasPlant(scene, plant); };
    return someStay && std::all_of(skins.begin(), skins.end(), has);
  };
  SmpFor(scene.GetStand().GetPlants().size(), [&](std::size_t begin, std::size_t end) {
    std::vector<PlantSums> sums(skins.size());
    for (std::size_t plant = begin; plant < end; ++plant)
    {
      const std::size_t ahead = std::min(plant + PlantsAhead, end - 1);
      if (!isThere(ahead))
      {
        std::for_each(skins.begin(), skins.end(), [ahead](const MovedSkin& skin) { skin.FetchPlant(ahead); });
      }
      const bool isDone = isThere(plant);
      if (!isDone)
      {
        scene.FindChanges(plant, rotations, changes, scene.IsFar(plant));
      }
      for (std::size_t skin = 0; skin < skins.size(); ++skin)
      {
        isDone ? skins[skin].AddPlant(plant, sums[skin]) : skins[skin].MovePlant(scene, plant, changes, sums[skin]);
      }
    }
    for (std::size_t skin = 0; skin < skins.size(); ++skin)
    {
      skins[skin].AddRanges(sums[skin]);
    }
  });
}

/// Replaces the skins among the blocks.
void WriteSkins(
  const SeaweedScene& scene, std::vector<SeaweedSkinBlock>& skins, SeaweedFrames& frames, vtkMultiBlockDataSet* blocks)
{
  frames.Changes.resize(scene.GetStand().GetSkeleton().Nodes.size());
  std::deque<MovedSkin> moved;
  for (SeaweedSkinBlock& skin : skins)
  {
    skin.PlantRanges.resize(HasStaying(scene) ? scene.GetStand().GetPlants().size() : skin.PlantRanges.size());
    moved.emplace_back(scene, skin, frames.Arrays).MoveFixed(frames.Changes);
  }
  MovePlants(scene, moved, frames.Changes);
  for (const MovedSkin& skin : moved)
  {
    skin.Write(blocks);
  }
}

/// Positions of the nodes as shown: in an array of an earlier frame where they are of single precision.
vtkSmartPointer<vtkDataArray> MovedNodes(const SeaweedScene& scene, vtkDataArray* rest, FrameArrays& arrays)
{
  const std::size_t nodes = scene.GetStand().GetSkeleton().Nodes.size();
  if (auto* floats = vtkFloatArray::SafeDownCast(rest))
  {
    const auto moved = arrays.Like(floats);
    const long long since = arrays.NotedWith(moved);
    arrays.Note(moved, scene.GetShow());
    float* to = moved->GetPointer(0);
    SmpFor(nodes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t node = begin; node < end; ++node)
      {
        if (!scene.HasChangedSince(scene.GetStand().PlantOf(node), since))
        {
          continue;
        }
        const Vector3 place = scene.NodePosition(node);
        to[3 * node] = static_cast<float>(place.x);
        to[3 * node + 1] = static_cast<float>(place.y);
        to[3 * node + 2] = static_cast<float>(place.z);
      }
    });
    return moved;
  }
  const auto moved = vtkSmartPointer<vtkDataArray>::Take(rest->NewInstance());
  moved->SetNumberOfComponents(3);
  SetTuples(moved, static_cast<vtkIdType>(nodes));
  for (std::size_t node = 0; node < nodes; ++node)
  {
    const Vector3 place = scene.NodePosition(node);
    moved->SetTuple(static_cast<vtkIdType>(node), &place.x);
  }
  return moved;
}

void WriteSkeleton(const SeaweedScene& scene, vtkPolyData* bones, FrameArrays& arrays, vtkMultiBlockDataSet* blocks)
{
  vtkNew<vtkPolyData> bent;
  bent->ShallowCopy(bones);
  bent->SetPoints(PointsWithRanges(MovedNodes(scene, bones->GetPoints()->GetData(), arrays)));
  if (!scene.GetVelocities().empty())
  {
    bent->GetPointData()->AddArray(ArrayOf<vtkFloatArray>("Velocity", 3, scene.GetVelocities()));
    bent->GetPointData()->AddArray(ArrayOf<vtkFloatArray>("Acceleration", 3, scene.GetAccelerations()));
  }
  ReplaceBlock(blocks, plant::Skeleton, bent);
}

std::vector<SeaweedSkinBlock> ReadSkins(vtkMultiBlockDataSet* plants, const SeaweedScene& scene)
{
  const SeaweedStand& stand = scene.GetStand();
  const std::vector<int> carriers = stand.CarriersOf(scene.GetLinks());
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
    const SkinBinding binding = ReadBinding(block);
    skins.push_back({ name, block, SeaweedSkin(ReadJointIds(block), vertices, stand), binding, RigidBinding(binding),
      RigidBinding(binding, carriers), {}, {}, {} });
    SeaweedSkinBlock& skin = skins.back();
    for (const SkinRun& run : skin.Skin.GetRuns())
    {
      const auto add = [&run](const auto& bound, std::vector<std::uint32_t>& firsts) {
        firsts.push_back(static_cast<std::uint32_t>(bound.IndexOf(bound.RunOf(run.First))));
      };
      add(skin.Rigid, skin.FirstRuns[0]);
      add(skin.Far, skin.FirstRuns[1]);
      add(skin.Binding, skin.FirstRuns[2]);
    }
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
  skins = ReadSkins(plants, scene);
}

//----------------------------------------------------------------------------
void WriteSeaweeds(const SeaweedScene& scene, std::vector<SeaweedSkinBlock>& skins, SeaweedFrames& frames,
  vtkMultiBlockDataSet* plants, vtkMultiBlockDataSet* output)
{
  if (scene.GetStand().GetSkeleton().Nodes.empty())
  {
    return;
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->ShallowCopy(FindBlock(plants, plant::High));
  frames.Arrays.BeginFrame();
  WriteSkins(scene, skins, frames, blocks);
  WriteSkeleton(scene, PlantPartOf(plants, plant::High, plant::Skeleton), frames.Arrays, blocks);
  frames.Arrays.EndFrame();
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
