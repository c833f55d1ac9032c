// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/SwayForest.h"

#include "Numerics/Constants.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"
#include "Sway/TrunkSkin.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace littoral
{

namespace
{

constexpr vtkIdType LeafGrain = 1024;    // leaves a task
constexpr vtkIdType VertexGrain = 16384; // vertices a task
constexpr double MegaByte = 1e6;

/// The row of the plant to which a point belongs; 0 where plants are not scattered.
int RowAt(const PlantTable& table, vtkIntArray* plantIds, vtkIdType point)
{
  return plantIds ? table.RowOf(plantIds->GetValue(point)) : 0;
}

}

//----------------------------------------------------------------------------
std::string SwayForest::Read(vtkMultiBlockDataSet* plants, const std::vector<vtkMultiBlockDataSet*>& prototypes,
  vtkImageData* wind, const SwaySettings& settings, vtkAlgorithm* progress)
{
  this->Settings = settings;
  this->Wind = std::make_shared<WindImage>();
  this->PictureImage = vtkSmartPointer<vtkImageData>::New();
  std::string reason = this->Wind->Read(wind);
  if (!reason.empty())
  {
    return reason;
  }
  this->Settings.Leaves.Period = this->Wind->Period();
  this->Scattered = ReadTable(plants, this->Table);
  if (!this->Scattered)
  {
    this->Table.Places.assign(1, PlantPlace());
    this->Table.Levels.assign(1, PlantLevel::Medium);
  }
  this->Frequencies.assign(this->Table.Places.size(), 0.0);
  reason = this->ReadSpecies(plants, prototypes, progress);
  reason = reason.empty() ? this->ReadHigh(plants, progress) : reason;
  reason = reason.empty() ? this->ReadMedium(plants) : reason;
  this->Poses.resize(this->Rest.Nodes.size());
  this->Changes.resize(this->Rest.Nodes.size());
  this->Winds.resize(this->Plants.size());
  this->Whole = reason.empty() && !IsAborted(progress);
  return reason;
}

//----------------------------------------------------------------------------
std::string SwayForest::ReadSpecies(
  vtkMultiBlockDataSet* plants, const std::vector<vtkMultiBlockDataSet*>& prototypes, vtkAlgorithm* progress)
{
  std::vector<vtkMultiBlockDataSet*> species = prototypes;
  if (!this->Scattered)
  {
    species.assign(1, plants);
  }
  for (vtkMultiBlockDataSet* one : species)
  {
    this->Species.emplace_back();
    const std::string reason = this->Species.back().Read(one, this->Settings);
    if (!reason.empty())
    {
      return this->Scattered ? "Of Prototypes: " + reason : reason;
    }
  }
  const int count = static_cast<int>(species.size());
  for (const PlantPlace& place : this->Table.Places)
  {
    if (count > 0 && (place.Species < 0 || place.Species >= count))
    {
      return "Species of a plant is " + std::to_string(place.Species) + ", but there are " + std::to_string(count) +
        " Prototypes; connect those that the plants were made from.";
    }
  }
  const double texels = static_cast<double>(count) * this->Settings.Pictures * this->Settings.PictureSize[0] *
    this->Settings.PictureSize[1];
  std::string reason = this->WhyTooLarge(2.0 * sizeof(Texel) * texels);
  if (!reason.empty())
  {
    return reason;
  }
  const auto each = static_cast<std::size_t>(this->Settings.Pictures);
  std::vector<TextureImage> pictures(each * std::max<std::size_t>(1, this->Species.size()));
  RunWithProgress(progress, this->Species.size(), 0.0, 0.3, [&](std::size_t index) {
    std::vector<TextureImage> own = this->Species[index].Pictures(*this->Wind, this->Settings);
    std::move(own.begin(), own.end(), pictures.begin() + index * each);
  });
  for (TextureImage& picture : pictures) // where there is no species; the image has the size that was announced
  {
    if (picture.Texels.empty())
    {
      picture = TextureImage(this->Settings.PictureSize[0], this->Settings.PictureSize[1]);
    }
  }
  this->Atlas = StackTextures(pictures);
  CopyToImage(this->Atlas.Image, this->PictureImage);
  this->PictureFields = vtkSmartPointer<vtkPolyData>::New();
  AttachTexture(this->PictureFields, this->Atlas.Image);
  return {};
}

//----------------------------------------------------------------------------
const SwayPrototype* SwayForest::SpeciesOf(int row) const
{
  const bool known = row >= 0 && row < static_cast<int>(this->Table.Places.size()) && !this->Species.empty();
  return known ? &this->Species[this->Table.Places[row].Species] : nullptr;
}

//----------------------------------------------------------------------------
std::string SwayForest::WhyTooLarge(double bytes) const
{
  if (bytes <= AvailableMemory())
  {
    return {};
  }
  return "The plants need " + std::to_string(static_cast<long long>(bytes / MegaByte)) +
    " MB to sway; take fewer plants in full, fewer modes, Response Interpolated, or fewer and smaller pictures.";
}

//----------------------------------------------------------------------------
/// Heights in the wind are heights above a plant's foot.
WindAtPlace SwayForest::WindOver(double ground) const
{
  return [wind = this->Wind, ground](const Vector3& place, double first, std::size_t count, Vector3* velocities) {
    wind->Sample(place - Vector3(0.0, 0.0, ground), first, count, velocities);
  };
}

//----------------------------------------------------------------------------
std::string SwayForest::AddPlant(
  int row, const Skeleton& rest, const std::vector<BranchBeam>& beams, const SwayOptions& options)
{
  // The middle of the trunk's upper half is about that of the crown.
  const double ground = rest.Nodes.front().Position.z;
  int node = 0;
  const Vector3 middle = rest.Along(0, 0.75, node);
  if (!this->Wind->Reaches(middle - Vector3(0.0, 0.0, ground)))
  {
    return "The wind does not reach all plants; its grid must span them across the wind and in height.";
  }
  if (row >= 0 && row < static_cast<int>(this->Frequencies.size()))
  {
    this->Frequencies[row] = beams.front().Modes.front().Frequency / TwoPi;
  }
  One& one = this->Plants.emplace_back();
  one.FirstJoint = this->Rest.Nodes.size();
  one.Branches = static_cast<int>(rest.Branches.size());
  one.Motion = std::make_unique<PlantMotion>(rest, options.NumberOfModes, beams.front().Modes);
  one.Sway = std::make_unique<PlantSway>(beams, options, this->Wind->Times(), middle, this->WindOver(ground));
  this->Rest.Nodes.insert(this->Rest.Nodes.end(), rest.Nodes.begin(), rest.Nodes.end());
  return {};
}

//----------------------------------------------------------------------------
/// Cuts the skeleton at its trunks.
std::string SwayForest::CutIntoPlants(
  vtkPolyData* bones, std::vector<Skeleton>& skeletons, std::vector<int>& rows) const
{
  Skeleton all;
  const std::string reason = ReadSkeleton(bones, all);
  auto* plantIds = vtkIntArray::SafeDownCast(bones->GetPointData()->GetArray(plant::PlantId));
  for (std::size_t index = 0; reason.empty() && index < all.Branches.size(); ++index)
  {
    const SkeletonBranch& branch = all.Branches[index];
    if (all.Nodes[branch.First].Parent < 0)
    {
      skeletons.emplace_back();
      rows.push_back(this->Scattered ? RowAt(this->Table, plantIds, branch.First) : 0);
    }
    Skeleton& one = skeletons.back();
    const int firstNode = branch.First - static_cast<int>(one.Nodes.size());
    one.Branches.push_back({ branch.First - firstNode, branch.Count, branch.Order });
    for (int node = branch.First; node < branch.First + branch.Count; ++node)
    {
      SkeletonNode own = all.Nodes[node];
      own.Branch = static_cast<int>(one.Branches.size()) - 1;
      if (own.Parent >= 0 && own.Parent < firstNode)
      {
        return "High/Skeleton of the plants has branches that do not follow their own trunk.";
      }
      own.Parent = own.Parent < 0 ? -1 : own.Parent - firstNode;
      one.Nodes.push_back(own);
    }
  }
  return reason;
}

//----------------------------------------------------------------------------
std::string SwayForest::ReadHigh(vtkMultiBlockDataSet* plants, vtkAlgorithm* progress)
{
  vtkPolyData* bones = PlantPartOf(plants, plant::High, plant::Skeleton);
  if (!bones)
  {
    return "The plants have no block High/Skeleton.";
  }
  if (bones->GetNumberOfPoints() == 0)
  {
    return {};
  }
  std::vector<Skeleton> skeletons;
  std::vector<int> rows;
  std::string reason = this->CutIntoPlants(bones, skeletons, rows);
  if (!reason.empty())
  {
    return reason;
  }
  std::vector<double> leafAreas(static_cast<std::size_t>(bones->GetNumberOfPoints()), 0.0);
  reason = this->ReadHighSkins(plants, leafAreas);
  double bytes =
    static_cast<double>(leafAreas.size()) * (sizeof(SkeletonNode) + sizeof(JointPose) + sizeof(JointChange)) +
    static_cast<double>(this->Leaves.size()) * sizeof(Leaf);
  for (const Skeleton& one : skeletons)
  {
    bytes += PlantSway::BytesOf(one.Branches.size(), this->Settings.Options);
  }
  reason = reason.empty() ? this->WhyTooLarge(bytes) : reason;
  if (!reason.empty())
  {
    return reason;
  }
  std::vector<std::vector<BranchBeam>> beams(skeletons.size());
  std::vector<SwayOptions> options(skeletons.size(), this->Settings.Options);
  std::vector<std::size_t> firsts(skeletons.size(), 0);
  for (std::size_t index = 0; index < skeletons.size(); ++index)
  {
    const SwayPrototype* species = this->SpeciesOf(rows[index]);
    options[index] = species ? this->Settings.With(species->Wood) : options[index];
    firsts[index] = index > 0 ? firsts[index - 1] + skeletons[index - 1].Nodes.size() : 0;
  }
  RunWithProgress(progress, skeletons.size(), 0.3, 0.5, [&](std::size_t index) {
    const auto first = leafAreas.begin() + static_cast<std::ptrdiff_t>(firsts[index]);
    const std::vector<double> own(first, first + static_cast<std::ptrdiff_t>(skeletons[index].Nodes.size()));
    beams[index] = BeamsOf(skeletons[index], own, options[index]);
  });
  for (std::size_t index = 0; index < skeletons.size() && reason.empty() && !IsAborted(progress); ++index)
  {
    reason = this->AddPlant(rows[index], skeletons[index], beams[index], options[index]);
  }
  return reason;
}

//----------------------------------------------------------------------------
std::string SwayForest::ReadHighSkins(vtkMultiBlockDataSet* plants, std::vector<double>& leafAreas)
{
  for (const char* name : { plant::Skin, plant::Leaves })
  {
    vtkPolyData* block = PlantPartOf(plants, plant::High, name);
    if (!block || block->GetNumberOfPoints() == 0)
    {
      continue;
    }
    const std::string reason = WhyBadSkin(block, name, leafAreas.size());
    if (!reason.empty())
    {
      return reason;
    }
    this->Skins.push_back({ plant::High, name, block, {}, {} });
  }
  vtkPolyData* block = PlantPartOf(plants, plant::High, plant::Leaves);
  auto* plantIds = block ? vtkIntArray::SafeDownCast(block->GetPointData()->GetArray(plant::PlantId)) : nullptr;
  auto* parents = vtkIntArray::SafeDownCast(
    PlantPartOf(plants, plant::High, plant::Skeleton)->GetPointData()->GetArray(plant::ParentId));
  // Plants come one after the other in the skeleton, each with a node that has no parent.
  std::vector<int> plantOf(leafAreas.size(), 0);
  int count = -1;
  for (std::size_t node = 0; node < plantOf.size(); ++node)
  {
    count += parents->GetValue(static_cast<vtkIdType>(node)) < 0 ? 1 : 0;
    plantOf[node] = count;
  }
  std::uint64_t inPlant = 0;
  for (const LeafCorners& corners : ReadLeaves(block))
  {
    leafAreas[corners.Node] += corners.Area;
    const int own = plantOf[corners.Node];
    inPlant = this->Leaves.empty() || this->Leaves.back().Plant != own ? 0 : inPlant + 1;
    // A leaf flutters in its own way, whatever other plants are in view.
    const auto identity = static_cast<std::uint64_t>(plantIds ? plantIds->GetValue(corners.Corners[0]) : own);
    this->Leaves.push_back({ corners.Corners, own, (identity << 32) + inPlant });
  }
  return {};
}

//----------------------------------------------------------------------------
std::string SwayForest::ReadMedium(vtkMultiBlockDataSet* plants)
{
  if (this->Species.empty())
  {
    return {}; // a forest whose prototypes are not known
  }
  const double trunks =
    static_cast<double>(std::count(this->Table.Levels.begin(), this->Table.Levels.end(), PlantLevel::Medium));
  std::string reason = this->WhyTooLarge(trunks * (PlantSway::BytesOf(1, this->Settings.Options) + 4000.0));
  std::vector<int> trunkOfRow(this->Table.Places.size(), -2); // -2: not met yet; -1: it stands still
  for (const char* name : { plant::Trunk, plant::Crown })
  {
    vtkPolyData* block = PlantPartOf(plants, plant::Medium, name);
    if (reason.empty() && block && block->GetNumberOfPoints() > 0)
    {
      reason = this->ReadMediumSkin(block, name, trunkOfRow);
    }
  }
  return reason;
}

//----------------------------------------------------------------------------
/// The trunk of a plant in less detail as a plant without branches.
std::string SwayForest::AddTrunk(int row, std::vector<int>& trunkOfRow)
{
  const SwayPrototype& species = *this->SpeciesOf(row);
  trunkOfRow[row] = -1;
  if (species.Rest.Nodes.empty())
  {
    return {};
  }
  const PlantPlace& place = this->Table.Places[row];
  const Skeleton trunk = Placed(species.TrunkRest, place);
  const SwayOptions options = this->Settings.With(species.Wood);
  BranchBeam beam = TrunkBeam(species.Trunk, place.Scale, place.Azimuth, options);
  int node = 0;
  beam.Middle = trunk.Along(0, 0.5, node);
  trunkOfRow[row] = static_cast<int>(this->Plants.size());
  return this->AddPlant(row, trunk, { beam }, options);
}

//----------------------------------------------------------------------------
std::string SwayForest::ReadMediumSkin(vtkPolyData* block, const char* name, std::vector<int>& trunkOfRow)
{
  auto* plantIds = vtkIntArray::SafeDownCast(block->GetPointData()->GetArray(plant::PlantId));
  if (!FloatPointsOf(block) || (this->Scattered && !plantIds))
  {
    return std::string("Medium/") + name + " of the plants has no points of float or no PlantId of int.";
  }
  const bool isCrown = std::strcmp(name, plant::Crown) == 0;
  const auto count = static_cast<std::size_t>(block->GetNumberOfPoints());
  Skin skin{ plant::Medium, name, block, std::vector<int>(4 * count, 0), std::vector<float>(4 * count, 0.0f) };
  std::unique_ptr<TrunkSkin> hold;
  int last = -2;
  for (std::size_t point = 0; point < count; ++point)
  {
    const int row = RowAt(this->Table, this->Scattered ? plantIds : nullptr, static_cast<vtkIdType>(point));
    if (row < 0)
    {
      return std::string("PlantId of Medium/") + name + " points to no plant of the field data.";
    }
    if (row != last)
    {
      last = row;
      const std::string reason = trunkOfRow[row] == -2 ? this->AddTrunk(row, trunkOfRow) : std::string();
      if (!reason.empty())
      {
        return reason;
      }
      const SwayPrototype& species = *this->SpeciesOf(row);
      hold =
        trunkOfRow[row] < 0 ? nullptr : std::make_unique<TrunkSkin>(Placed(species.TrunkRest, this->Table.Places[row]));
      if (isCrown)
      {
        // Plants downwind show later what the wind carries past.
        const PlantPlace& place = this->Table.Places[row];
        this->Crowns.push_back({ point, place.Species, this->Wind->Arrival(place.Foot) });
      }
    }
    if (hold)
    {
      Vector3 position;
      block->GetPoint(static_cast<vtkIdType>(point), &position.x);
      const JointHold joints = hold->At(position);
      const int first = static_cast<int>(this->Plants[trunkOfRow[row]].FirstJoint);
      for (std::size_t i = 0; i < 4; ++i)
      {
        skin.Joints[4 * point + i] = first + joints.Joints[i];
        skin.Weights[4 * point + i] = joints.Weights[i];
      }
    }
  }
  this->Skins.push_back(std::move(skin));
  return {};
}

//----------------------------------------------------------------------------
void SwayForest::Pose(double time)
{
  const auto modes = static_cast<std::size_t>(this->Settings.Options.NumberOfModes);
  SmpFor(this->Plants.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Vector3> amplitudes;
    for (std::size_t index = begin; index < end; ++index)
    {
      One& one = this->Plants[index];
      amplitudes.resize(static_cast<std::size_t>(one.Branches) * modes);
      one.Sway->Amplitudes(time, amplitudes.data());
      one.Motion->Pose(amplitudes.data(), &this->Poses[one.FirstJoint]);
      this->Winds[index] = one.Sway->Wind(time);
      for (std::size_t node = one.FirstJoint; node < one.FirstJoint + one.Motion->GetNumberOfJoints(); ++node)
      {
        this->Changes[node] = ChangeOf(this->Poses[node], this->Rest.Nodes[node].Position);
      }
    }
  });
}

//----------------------------------------------------------------------------
void SwayForest::Move(double time, vtkMultiBlockDataSet* plants, vtkMultiBlockDataSet* output, vtkAlgorithm* progress)
{
  progress->UpdateProgress(0.5);
  this->Pose(time);
  std::vector<vtkSmartPointer<vtkPolyData>> moved;
  for (const Skin& skin : this->Skins)
  {
    if (IsAborted(progress))
    {
      return;
    }
    progress->UpdateProgress(0.6 + 0.4 * static_cast<double>(moved.size()) / static_cast<double>(this->Skins.size()));
    moved.push_back(vtkSmartPointer<vtkPolyData>::New());
    moved.back()->ShallowCopy(skin.Rest);
    this->MoveSkinOf(skin, time, moved.back());
  }
  for (const char* level : { plant::High, plant::Medium })
  {
    auto* rest = vtkMultiBlockDataSet::SafeDownCast(FindBlock(plants, level));
    if (!rest)
    {
      continue;
    }
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->ShallowCopy(rest);
    for (std::size_t index = 0; index < moved.size(); ++index)
    {
      if (std::strcmp(this->Skins[index].Level, level) == 0)
      {
        ReplaceBlock(blocks, this->Skins[index].Name, moved[index]);
      }
    }
    vtkPolyData* bones = std::strcmp(level, plant::High) == 0 ? PlantPartOf(plants, level, plant::Skeleton) : nullptr;
    if (bones && FloatPointsOf(bones))
    {
      vtkNew<vtkPolyData> bent;
      bent->ShallowCopy(bones);
      auto places = FloatsLike(FloatPointsOf(bones));
      for (vtkIdType node = 0; node < places->GetNumberOfTuples(); ++node)
      {
        const Vector3 place = this->Rest.Nodes[node].Position + this->Poses[node].Shift;
        places->SetTuple(node, &place.x);
      }
      vtkNew<vtkPoints> points;
      points->SetData(places);
      bent->SetPoints(points);
      ReplaceBlock(blocks, plant::Skeleton, bent);
    }
    ReplaceBlock(output, level, blocks);
  }
}

//----------------------------------------------------------------------------
void SwayForest::MoveSkinOf(const Skin& skin, double time, vtkPolyData* moved)
{
  vtkPointData* arrays = skin.Rest->GetPointData();
  auto* restNormals = vtkFloatArray::SafeDownCast(arrays->GetNormals());
  auto points = FloatsLike(FloatPointsOf(skin.Rest));
  const auto normals = restNormals ? FloatsLike(restNormals) : nullptr;
  RestSkin<float> rest{ FloatPointsOf(skin.Rest)->GetPointer(0), restNormals ? restNormals->GetPointer(0) : nullptr,
    skin.Joints.data(), skin.Weights.data() };
  if (skin.Joints.empty())
  {
    rest.JointIds = vtkIntArray::SafeDownCast(arrays->GetArray(plant::JointIds))->GetPointer(0);
    rest.JointWeights = vtkFloatArray::SafeDownCast(arrays->GetArray(plant::JointWeights))->GetPointer(0);
  }
  float* p = points->GetPointer(0);
  float* n = normals ? normals->GetPointer(0) : nullptr;
  vtkSMPTools::For(0, points->GetNumberOfTuples(), VertexGrain, [&](vtkIdType begin, vtkIdType end) {
    MoveSkin(rest, this->Changes.data(), static_cast<std::size_t>(begin), static_cast<std::size_t>(end), p, n);
  });
  if (std::strcmp(skin.Name, plant::Leaves) == 0)
  {
    this->TurnLeaves(time, p, n);
  }
  vtkNew<vtkPoints> places;
  places->SetData(points);
  moved->SetPoints(places);
  KeepRanges(points.Get());
  if (normals)
  {
    KeepRanges(normals.Get());
    moved->GetPointData()->SetNormals(normals);
  }
  if (std::strcmp(skin.Name, plant::Crown) == 0)
  {
    this->ShowPictures(time, moved);
  }
}

//----------------------------------------------------------------------------
void SwayForest::TurnLeaves(double time, float* points, float* normals) const
{
  const LeafFlutter flutter(this->Settings.Leaves);
  const auto count = static_cast<vtkIdType>(this->Leaves.size());
  vtkSMPTools::For(0, count, LeafGrain, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType index = begin; index < end; ++index)
    {
      const Leaf& leaf = this->Leaves[static_cast<std::size_t>(index)];
      TurnLeaf(
        leaf.Corners, this->Winds[leaf.Plant], flutter.At(leaf.Identity, time), this->Settings.Leaves, points, normals);
    }
  });
}

//----------------------------------------------------------------------------
/// Turns to the picture of the moment: as many swings in a period of the wind as the trunk makes, so that all repeats.
void SwayForest::ShowPictures(double time, vtkPolyData* crowns) const
{
  const auto points = static_cast<std::size_t>(crowns->GetNumberOfPoints());
  const auto tcoords = NewArray<vtkFloatArray>("TCoords", 2, crowns->GetNumberOfPoints());
  float* to = tcoords->GetPointer(0);
  const int pictures = this->Settings.Pictures;
  SmpFor(this->Crowns.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin; run < end; ++run)
    {
      const CrownRun& crown = this->Crowns[run];
      const std::size_t last = run + 1 < this->Crowns.size() ? this->Crowns[run + 1].First : points;
      const SwayPrototype& species = this->Species[crown.Species];
      const double swings = std::max(1.0, std::round(this->Wind->Period() * species.SwingFrequency));
      const double phase = swings * (time - crown.Arrival) / this->Wind->Period();
      const int picture = std::min(pictures - 1, static_cast<int>(pictures * (phase - std::floor(phase))));
      const AtlasArea& area = this->Atlas.Areas[crown.Species * pictures + picture];
      for (std::size_t point = crown.First; point < last; ++point)
      {
        const std::size_t vertex = point - crown.First;
        const std::array<double, 2> own =
          vertex < species.CrownTCoords.size() ? species.CrownTCoords[vertex] : std::array<double, 2>{ 0.5, 0.5 };
        const std::array<double, 2> at = area.Map(own[0], own[1]);
        to[2 * point] = static_cast<float>(at[0]);
        to[2 * point + 1] = static_cast<float>(at[1]);
      }
    }
  });
  KeepRanges(tcoords.Get());
  crowns->GetPointData()->SetTCoords(tcoords);
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(crowns->GetFieldData());
  for (const char* name : { plant::Texture, plant::TextureSize })
  {
    fields->AddArray(this->PictureFields->GetFieldData()->GetArray(name));
  }
  crowns->SetFieldData(fields);
}

}
