// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/SwayBlocks.h"

#include "Data/JointBlock.h"
#include "Data/PlantForm.h"
#include "Data/ScatteredJoints.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"

#include <algorithm>
#include <cstring>
#include <mutex>

namespace littoral
{

namespace
{

constexpr std::size_t LeafGrain = 1024;   // leaves a task
constexpr std::size_t VertexGrain = 4096; // vertices a task
constexpr double BytesOfTrunk = 4000.0;   // of a trunk's skeleton, about

}

//----------------------------------------------------------------------------
void SwayBlocks::Read(vtkMultiBlockDataSet* plants, const std::vector<vtkMultiBlockDataSet*>& prototypes,
  vtkImageData* wind, const SwaySettings& settings, std::shared_ptr<SwayKinds> known, vtkAlgorithm* progress)
{
  RequirePlants(plants);
  this->Kinds = std::move(known);
  this->MakeScene(plants, prototypes, wind, settings, progress);
  if (this->Table.HasTints)
  {
    this->Surfaces.Make(plants, this->Table, this->Kinds->SurfacesOf(prototypes), AbortableFor(progress));
    plants = this->Surfaces.Plants;
  }
  this->ReadHigh(plants, prototypes, progress);
  this->ReadMedium(plants);
  this->ForgetRest();
  this->Table = PlantTable(); // the scene has what it needs of it
  this->Whole = !IsAborted(progress);
}

//----------------------------------------------------------------------------
/// The row of the plant to which a point belongs; 0 where plants are not scattered.
int SwayBlocks::RowAt(vtkIntArray* plantIds, vtkIdType point) const
{
  return this->Scattered && plantIds ? this->Table.RowOf(plantIds->GetValue(point)) : 0;
}

//----------------------------------------------------------------------------
void SwayBlocks::MakeScene(vtkMultiBlockDataSet* plants, const std::vector<vtkMultiBlockDataSet*>& prototypes,
  vtkImageData* wind, const SwaySettings& settings, vtkAlgorithm* progress)
{
  this->Table = ReadTable(plants);
  this->Scattered = this->Table.IsThere;
  if (!this->Scattered)
  {
    this->Table.Places.assign(1, PlantPlace());
    this->Table.Levels.assign(1, PlantLevel::Medium);
    this->Kinds.reset();
  }
  if (!this->Kinds)
  {
    this->Kinds = std::make_shared<SwayKinds>();
    this->Kinds->Read(this->Scattered ? prototypes : std::vector{ plants }, this->Scattered, wind, settings, progress);
  }
  this->RequireKnownSpecies(this->Kinds->Species.size());
  this->Scene = std::make_unique<SwayScene>(settings, this->Kinds->Wind, this->Table.Places, this->Kinds->Species);
  this->Scene->SetPictureAreas(this->Kinds->Areas);
}

//----------------------------------------------------------------------------
void SwayBlocks::RequireKnownSpecies(std::size_t prototypes) const
{
  const int count = static_cast<int>(prototypes);
  for (const PlantPlace& place : this->Table.Places)
  {
    if (count > 0 && (place.Species < 0 || place.Species >= count))
    {
      Refuse("Species of a plant is ", place.Species, ", but there are ", count,
        " Prototypes; connect those that the plants were made from.");
    }
  }
}

//----------------------------------------------------------------------------
void SwayBlocks::ReadHigh(
  vtkMultiBlockDataSet* plants, const std::vector<vtkMultiBlockDataSet*>& prototypes, vtkAlgorithm* progress)
{
  vtkPolyData* bones = PlantPartOf(plants, plant::High, plant::Skeleton);
  Require(bones ? "" : "The plants have no block High/Skeleton.");
  if (bones->GetNumberOfPoints() == 0)
  {
    return;
  }
  const Skeleton all = ReadSkeleton(bones);
  const std::vector<Skeleton> skeletons = PlantsOf(all);
  Require(skeletons.empty() ? "High/Skeleton of the plants has branches that do not follow their own trunk." : "");
  std::vector<double> leafAreas(all.Nodes.size(), 0.0);
  this->ReadHighSkins(plants, prototypes, skeletons, leafAreas);
  double bytes = SwayScene::BytesOf(all.Nodes.size(), this->Scene->GetNumberOfLeaves());
  for (const Skeleton& one : skeletons)
  {
    bytes += PlantSway::BytesOf(one.Branches.size(), this->Scene->GetSettings().Options);
  }
  RequireMemoryToSway(bytes);
  this->AddPlants(skeletons, FindPlantIds(bones), leafAreas, progress);
}

//----------------------------------------------------------------------------
void SwayBlocks::ReadHighSkins(vtkMultiBlockDataSet* plants, const std::vector<vtkMultiBlockDataSet*>& prototypes,
  const std::vector<Skeleton>& skeletons, std::vector<double>& leafAreas)
{
  std::vector<LeafCorners> corners;
  for (const char* name : { plant::Skin, plant::Leaves })
  {
    vtkPolyData* block = PlantPartOf(plants, plant::High, name);
    if (!block || block->GetNumberOfPoints() == 0)
    {
      continue;
    }
    StandBinding binding;
    if (this->Scattered && !prototypes.empty() && !TellsJoints(block))
    {
      RequireRest(block, name);
      vtkIntArray* plantIds = FindPlantIds(PlantPartOf(plants, plant::High, plant::Skeleton));
      binding = BindingOfPrototypes(block, name, this->Table, NodesByRow(this->Table, skeletons, plantIds), prototypes);
    }
    else
    {
      RequireSkin(block, name, leafAreas.size());
      binding = StandBinding(ReadBinding(block));
    }
    if (std::strcmp(name, plant::Leaves) == 0)
    {
      corners = ReadLeaves(block, binding);
    }
    this->Skins.push_back({ plant::High, name, block, std::move(binding) });
  }
  std::vector<int> plantOf;
  for (std::size_t index = 0; index < skeletons.size(); ++index)
  {
    plantOf.insert(plantOf.end(), skeletons[index].Nodes.size(), static_cast<int>(index));
  }
  vtkPolyData* leaves = PlantPartOf(plants, plant::High, plant::Leaves);
  vtkIntArray* plantIds = leaves ? FindPlantIds(leaves) : nullptr;
  this->Scene->ReserveLeaves(corners.size());
  for (const LeafCorners& leaf : corners)
  {
    leafAreas[leaf.Node] += leaf.Area;
    const int own = plantOf[leaf.Node];
    // The same whatever other plants are in view.
    const auto identity = static_cast<std::uint64_t>(plantIds ? plantIds->GetValue(leaf.Corners[0]) : own);
    this->Scene->AddLeaf(leaf.Corners, own, identity);
  }
}

//----------------------------------------------------------------------------
void SwayBlocks::AddPlants(const std::vector<Skeleton>& skeletons, vtkIntArray* plantIds,
  const std::vector<double>& leafAreas, vtkAlgorithm* progress)
{
  std::vector<std::ptrdiff_t> firsts(1, 0);
  std::vector<int> rows;
  for (const Skeleton& one : skeletons)
  {
    rows.push_back(this->RowAt(plantIds, firsts.back()));
    firsts.push_back(firsts.back() + static_cast<std::ptrdiff_t>(one.Nodes.size()));
  }
  std::vector<std::vector<BranchBeam>> beams(skeletons.size());
  RunWithProgress(progress, skeletons.size(), 0.3, 0.5, [&](std::size_t index) {
    const std::vector<double> own(leafAreas.begin() + firsts[index], leafAreas.begin() + firsts[index + 1]);
    beams[index] = this->Scene->BeamsOf(rows[index], skeletons[index], own);
  });
  for (std::size_t index = 0; index < skeletons.size() && !IsAborted(progress); ++index)
  {
    Require(this->Scene->AddPlant(rows[index], skeletons[index], beams[index]));
  }
}

//----------------------------------------------------------------------------
void SwayBlocks::ReadMedium(vtkMultiBlockDataSet* plants)
{
  if (this->Scene->GetSpecies().empty())
  {
    return; // a forest whose prototypes are not known
  }
  const double trunks =
    static_cast<double>(std::count(this->Table.Levels.begin(), this->Table.Levels.end(), PlantLevel::Medium));
  RequireMemoryToSway(trunks * (PlantSway::BytesOf(1, this->Scene->GetSettings().Options) + BytesOfTrunk));
  for (const char* name : { plant::Trunk, plant::Crown })
  {
    vtkPolyData* block = PlantPartOf(plants, plant::Medium, name);
    if (block && block->GetNumberOfPoints() > 0)
    {
      this->ReadMediumSkin(block, name);
    }
  }
}

//----------------------------------------------------------------------------
void SwayBlocks::ReadMediumSkin(vtkPolyData* block, const char* name)
{
  vtkIntArray* plantIds = FindPlantIds(block);
  vtkFloatArray* points = FloatPointsOf(block);
  if (!points || (this->Scattered && !plantIds))
  {
    Refuse("Medium/", name, " of the plants has no points of float or no PlantId of int.");
  }
  const bool isCrown = std::strcmp(name, plant::Crown) == 0;
  const vtkIdType count = block->GetNumberOfPoints();
  std::vector<int> joints(4 * static_cast<std::size_t>(count), 0);
  std::vector<float> weights(joints.size(), 0.0f);
  for (vtkIdType begin = 0, end = 0; begin < count; begin = end)
  {
    const int row = this->RowAt(plantIds, begin);
    if (row < 0)
    {
      Refuse("PlantId of Medium/", name, " points to no plant of the field data.");
    }
    while (end < count && this->RowAt(plantIds, end) == row)
    {
      ++end;
    }
    int plant = -1;
    Require(this->Scene->FindTrunk(row, plant));
    if (isCrown)
    {
      this->Scene->AddCrown(row, static_cast<std::size_t>(begin));
    }
    if (plant >= 0)
    {
      this->Scene->FollowTrunk(plant, points->GetPointer(0), static_cast<std::size_t>(begin),
        static_cast<std::size_t>(end), joints.data(), weights.data());
    }
  }
  this->Skins.push_back(
    { plant::Medium, name, block, StandBinding({ joints.data(), weights.data(), static_cast<std::size_t>(count) }) });
}

//----------------------------------------------------------------------------
/// Points and normals at rest of surfaces that were made are placed again for each frame.
void SwayBlocks::ForgetRest()
{
  for (int part = 0; part < NumberOfParts && this->Surfaces.Plants; ++part)
  {
    for (Skin& skin : this->Skins)
    {
      if (std::strcmp(skin.Level, PartKinds[part].Level) == 0 && std::strcmp(skin.Name, PartKinds[part].Name) == 0)
      {
        skin.AtRest = std::move(this->Surfaces.AtRest[part]);
        skin.Rest = this->Surfaces.Bare(part);
      }
    }
  }
}

//----------------------------------------------------------------------------
void SwayBlocks::Move(double time, vtkMultiBlockDataSet* plants, vtkMultiBlockDataSet* output, vtkAlgorithm* progress)
{
  progress->UpdateProgress(0.5);
  this->Scene->MoveTo(time, SmpFor);
  this->Arrays.BeginFrame();
  std::vector<vtkSmartPointer<vtkPolyData>> moved;
  for (const Skin& skin : this->Skins)
  {
    if (IsAborted(progress))
    {
      return;
    }
    progress->UpdateProgress(0.6 + 0.4 * static_cast<double>(moved.size()) / static_cast<double>(this->Skins.size()));
    moved.push_back(this->MovedSkin(skin));
  }
  plants = this->Surfaces.Plants ? this->Surfaces.Plants.Get() : plants;
  for (const char* level : { plant::High, plant::Medium })
  {
    auto* rest = vtkMultiBlockDataSet::SafeDownCast(FindBlock(plants, level));
    if (rest)
    {
      ReplaceBlock(output, level, this->MovedLevel(level, rest, moved));
    }
  }
  this->Arrays.EndFrame();
}

//----------------------------------------------------------------------------
void SwayBlocks::AddJoints(vtkMultiBlockDataSet* output) const
{
  AddBlock(output, joint::Joints, JointBlock(this->Scene->GetChanges(), this->Scene->GetParents()));
  for (const Skin& skin : this->Skins)
  {
    vtkPolyData* block = PlantPartOf(output, skin.Level, skin.Name);
    if (block && !TellsJoints(block))
    {
      const vtkIdType points = block->GetNumberOfPoints();
      const auto joints = NewArray<vtkIntArray>(plant::JointIds, 4, points);
      const auto weights = NewArray<vtkFloatArray>(plant::JointWeights, 4, points);
      skin.Binding.Write(joints->GetPointer(0), weights->GetPointer(0));
      block->GetPointData()->AddArray(joints);
      block->GetPointData()->AddArray(weights);
    }
  }
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkMultiBlockDataSet> SwayBlocks::MovedLevel(
  const char* level, vtkMultiBlockDataSet* rest, const std::vector<vtkSmartPointer<vtkPolyData>>& moved)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->ShallowCopy(rest);
  for (std::size_t index = 0; index < moved.size(); ++index)
  {
    if (std::strcmp(this->Skins[index].Level, level) == 0)
    {
      ReplaceBlock(blocks, this->Skins[index].Name, moved[index]);
    }
  }
  auto* bones =
    std::strcmp(level, plant::High) == 0 ? vtkPolyData::SafeDownCast(FindBlock(rest, plant::Skeleton)) : nullptr;
  if (FloatPointsOf(bones))
  {
    ReplaceBlock(blocks, plant::Skeleton, this->MovedBones(bones));
  }
  return blocks;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SwayBlocks::MovedBones(vtkPolyData* bones)
{
  const auto positions = this->Arrays.Like(FloatPointsOf(bones));
  float* to = positions->GetPointer(0);
  SmpFor(static_cast<std::size_t>(positions->GetNumberOfTuples()), [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
    {
      const Vector3 position = this->Scene->JointPosition(node);
      std::transform(&position.x, &position.x + 3, to + 3 * node, [](double x) { return static_cast<float>(x); });
    }
  });
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(bones);
  moved->SetPoints(PointsWithRanges(positions));
  return moved;
}

//----------------------------------------------------------------------------
/// The arrays of points and normals for a frame of a skin; there may be no normals.
std::array<vtkSmartPointer<vtkFloatArray>, 2> SwayBlocks::ArraysFor(const Skin& skin)
{
  const auto vertices = static_cast<vtkIdType>(skin.AtRest.GetNumberOfVertices());
  if (vertices > 0)
  {
    const auto state = 1 + 2 * static_cast<std::size_t>(&skin - this->Skins.data());
    return { this->Arrays.New<vtkFloatArray>("Points", 3, vertices, state),
      skin.AtRest.HasNormals() ? this->Arrays.New<vtkFloatArray>(NormalsName, 3, vertices, state + 1) : nullptr };
  }
  vtkFloatArray* normals = FindNormals(skin.Rest);
  return { this->Arrays.Like(FloatPointsOf(skin.Rest)), normals ? this->Arrays.Like(normals) : nullptr };
}

//----------------------------------------------------------------------------
/// Moves the vertices [begin, end) of a skin; those that are not kept at rest are placed, some at a time.
void SwayBlocks::MoveVertices(const Skin& skin, std::size_t begin, std::size_t end, float* points, float* normals) const
{
  const JointChange* changes = this->Scene->GetChanges().data();
  if (skin.AtRest.GetNumberOfVertices() == 0)
  {
    skin.Binding.Move(ReadSkin(skin.Rest), changes, begin, end, points, normals);
    return;
  }
  const std::unique_ptr<float[]> rest(new float[6 * std::min(end - begin, VertexGrain)]);
  for (std::size_t first = begin; first < end; first += VertexGrain)
  {
    const std::size_t last = std::min(end, first + VertexGrain);
    float* restNormals = normals ? rest.get() + 3 * (last - first) : nullptr;
    skin.AtRest.Place(first, last, rest.get(), restNormals);
    skin.Binding.Move({ rest.get(), restNormals, first }, changes, first, last, points, normals);
  }
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SwayBlocks::MovedSkin(const Skin& skin)
{
  const auto [points, normals] = this->ArraysFor(skin);
  const auto vertices = static_cast<std::size_t>(points->GetNumberOfTuples());
  float* p = points->GetPointer(0);
  float* n = normals ? normals->GetPointer(0) : nullptr;
  TupleRanges places;
  TupleRanges directions;
  std::mutex adding;
  const auto addToRanges = [&](std::size_t begin, std::size_t end) {
    TupleRanges ofPlaces;
    TupleRanges ofDirections;
    ofPlaces.AddTuples(p + 3 * begin, p + 3 * end, 3);
    if (n)
    {
      ofDirections.AddTuples(n + 3 * begin, n + 3 * end, 3);
    }
    const std::lock_guard<std::mutex> lock(adding);
    places.Add(ofPlaces);
    directions.Add(ofDirections);
  };
  // Leaves are turned, and ranges found, while the vertices are at hand.
  if (std::strcmp(skin.Name, plant::Leaves) == 0)
  {
    const std::size_t leaves = this->Scene->GetNumberOfLeaves();
    ForRanges(
      SmpFor, leaves, this->Scene->AreLeavesInOrder() ? LeafGrain : leaves, [&](std::size_t begin, std::size_t end) {
        const auto [first, last] = this->Scene->VerticesOfLeaves(begin, end, vertices);
        this->MoveVertices(skin, first, last, p, n);
        this->Scene->TurnLeaves(begin, end, p, n);
        addToRanges(first, last);
      });
  }
  else
  {
    ForRanges(SmpFor, vertices, VertexGrain, [&](std::size_t begin, std::size_t end) {
      this->MoveVertices(skin, begin, end, p, n);
      addToRanges(begin, end);
    });
  }
  KeepRanges(points, places);
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(skin.Rest);
  moved->SetPoints(PointsWithRanges(points));
  if (normals)
  {
    KeepRanges(normals, directions);
    moved->GetPointData()->SetNormals(normals);
  }
  if (std::strcmp(skin.Name, plant::Crown) == 0)
  {
    this->ShowPictures(moved);
  }
  return moved;
}

//----------------------------------------------------------------------------
/// Texture coordinates and texture of the crowns, each with its picture of the moment.
void SwayBlocks::ShowPictures(vtkPolyData* crowns)
{
  const vtkIdType points = crowns->GetNumberOfPoints();
  const auto tcoords = this->Arrays.New<vtkFloatArray>("TCoords", 2, points);
  this->Scene->ShowPictures(static_cast<std::size_t>(points), tcoords->GetPointer(0), SmpFor);
  KeepRanges(tcoords.Get());
  crowns->GetPointData()->SetTCoords(tcoords);
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(crowns->GetFieldData());
  vtkFieldData* pictures = this->Kinds->PictureFields->GetFieldData();
  for (int index = 0; index < pictures->GetNumberOfArrays(); ++index)
  {
    fields->AddArray(pictures->GetAbstractArray(index));
  }
  crowns->SetFieldData(fields);
}

}
