// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/SwayScene.h"

#include "Numerics/Constants.h"
#include "Sway/CrownPictures.h"
#include "Sway/TrunkSkin.h"

#include <algorithm>

namespace littoral
{

namespace
{

constexpr int NotMet = -2;
constexpr int StandsStill = -1;

int LowestCorner(const FlutteringLeaf& leaf)
{
  return *std::min_element(leaf.Corners.begin(), leaf.Corners.end());
}

int HighestCorner(const FlutteringLeaf& leaf)
{
  return *std::max_element(leaf.Corners.begin(), leaf.Corners.end());
}

/// The settings, with the wind's period as that of the leaves.
SwaySettings InWind(SwaySettings settings, const FrozenWind& wind)
{
  settings.Leaves.Period = wind.GetTimes().Period();
  return settings;
}

}

SwayScene::SwayScene(const SwaySettings& settings, std::shared_ptr<const FrozenWind> wind,
  std::vector<PlantPlace> places, std::vector<SwaySpecies> species)
  : Settings(InWind(settings, *wind))
  , Wind(std::move(wind))
  , Places(std::move(places))
  , Species(std::move(species))
  , Frequencies(this->Places.size(), 0.0)
  , TrunkOfRow(this->Places.size(), NotMet)
  , Flutter(this->Settings.Leaves)
{
}

const SwaySpecies* SwayScene::SpeciesOf(int row) const
{
  const bool isKnown = row >= 0 && row < static_cast<int>(this->Places.size()) && !this->Species.empty();
  return isKnown ? &this->Species[this->Places[row].Species] : nullptr;
}

SwayOptions SwayScene::OptionsOf(int row) const
{
  const SwaySpecies* species = this->SpeciesOf(row);
  return species ? this->Settings.With(species->Wood) : this->Settings.Options;
}

double SwayScene::BytesOf(std::size_t nodes, std::size_t leaves)
{
  return static_cast<double>(nodes) * (sizeof(SkeletonNode) + sizeof(Vector3) + sizeof(JointChange)) +
    static_cast<double>(leaves) * sizeof(FlutteringLeaf);
}

std::vector<BranchBeam> SwayScene::BeamsOf(int row, const Skeleton& rest, const std::vector<double>& leafAreas) const
{
  return littoral::BeamsOf(rest, leafAreas, this->OptionsOf(row));
}

std::string SwayScene::AddPlant(int row, const Skeleton& rest, const std::vector<BranchBeam>& beams)
{
  // The middle of the trunk's upper half is about that of the crown. Heights in the wind are those above the foot.
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
  SwayingPlant& plant = this->Plants.emplace_back();
  plant.FirstJoint = this->Rest.Nodes.size();
  plant.Branches = rest.Branches.size();
  plant.Motion = std::make_unique<PlantMotion>(rest, this->Settings.Options.NumberOfModes, beams.front().Modes);
  plant.Sway =
    std::make_unique<PlantSway>(beams, this->OptionsOf(row), this->Wind->GetTimes(), middle, this->Wind->Over(ground));
  this->Rest.Nodes.insert(this->Rest.Nodes.end(), rest.Nodes.begin(), rest.Nodes.end());
  return {};
}

std::array<std::size_t, 2> SwayScene::VerticesOfLeaves(std::size_t begin, std::size_t end, std::size_t vertices) const
{
  const auto firstOf = [&](std::size_t leaf) { return static_cast<std::size_t>(LowestCorner(this->Leaves[leaf])); };
  return { begin == 0 ? 0 : firstOf(begin), end == this->Leaves.size() ? vertices : firstOf(end) };
}

void SwayScene::AddLeaf(const std::array<int, 4>& corners, int plant, std::uint64_t identity)
{
  const bool isFirst = this->Leaves.empty() || this->Leaves.back().Plant != plant;
  this->LeafOfPlant = isFirst ? 0 : this->LeafOfPlant + 1;
  const FlutteringLeaf leaf = this->Flutter.Leaf(corners, plant, (identity << 32) + this->LeafOfPlant);
  this->LeavesInOrder =
    this->LeavesInOrder && (this->Leaves.empty() || LowestCorner(leaf) > HighestCorner(this->Leaves.back()));
  this->Leaves.push_back(leaf);
}

std::string SwayScene::FindTrunk(int row, int& plant)
{
  plant = this->TrunkOfRow[row];
  if (plant != NotMet)
  {
    return {};
  }
  const SwaySpecies* species = this->SpeciesOf(row);
  plant = this->TrunkOfRow[row] = StandsStill;
  if (!species || species->Rest.Nodes.empty())
  {
    return {};
  }
  const PlantPlace& place = this->Places[row];
  const Skeleton trunk = Placed(species->TrunkRest, place);
  BranchBeam beam = place.WidthScale == 1.0
    ? TrunkBeam(species->Trunk, place.Scale, place.Azimuth, this->OptionsOf(row))
    : TrunkBeam(
        WideTrunk(*species, place.WidthScale, this->Settings), place.Scale, place.Azimuth, this->OptionsOf(row));
  int node = 0;
  beam.Middle = trunk.Along(0, 0.5, node);
  plant = this->TrunkOfRow[row] = static_cast<int>(this->Plants.size());
  return this->AddPlant(row, trunk, { beam });
}

void SwayScene::FollowTrunk(
  int plant, const float* points, std::size_t begin, std::size_t end, int* joints, float* weights) const
{
  const SwayingPlant& swaying = this->Plants[plant];
  const auto first = this->Rest.Nodes.begin() + static_cast<std::ptrdiff_t>(swaying.FirstJoint);
  const std::size_t count = swaying.Motion->GetNumberOfJoints();
  Skeleton trunk;
  trunk.Nodes.assign(first, first + static_cast<std::ptrdiff_t>(count));
  trunk.Branches.push_back({ 0, static_cast<int>(count), 0 });
  const TrunkSkin skin(trunk);
  for (std::size_t point = begin; point < end; ++point)
  {
    const float* p = points + 3 * point;
    const JointHold hold = skin.At({ p[0], p[1], p[2] });
    for (std::size_t i = 0; i < 4; ++i)
    {
      joints[4 * point + i] = static_cast<int>(swaying.FirstJoint) + hold.Joints[i];
      weights[4 * point + i] = hold.Weights[i];
    }
  }
}

void SwayScene::AddCrown(int row, std::size_t first)
{
  const PlantPlace& place = this->Places[row];
  this->Crowns.push_back({ first, place.Species, this->Wind->Arrival(place.Foot) });
}

std::vector<int> SwayScene::GetParents() const
{
  std::vector<int> parents;
  for (std::size_t plant = 0; plant < this->Plants.size(); ++plant)
  {
    const std::size_t first = this->Plants[plant].FirstJoint;
    const std::size_t end =
      plant + 1 < this->Plants.size() ? this->Plants[plant + 1].FirstJoint : this->Rest.Nodes.size();
    for (std::size_t node = first; node < end; ++node)
    {
      const int parent = this->Rest.Nodes[node].Parent;
      parents.push_back(parent < 0 ? -1 : parent + static_cast<int>(first));
    }
  }
  return parents;
}

void SwayScene::MoveTo(double time, const ParallelFor& parallel)
{
  this->Time = time;
  this->Rest.Nodes.shrink_to_fit(); // no work unless plants were added
  this->Shifts.resize(this->Rest.Nodes.size());
  this->Changes.resize(this->Rest.Nodes.size());
  this->Winds.resize(this->Plants.size());
  parallel(this->Plants.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Vector3> amplitudes;
    std::vector<JointPose> poses;
    for (std::size_t plant = begin; plant < end; ++plant)
    {
      this->Pose(plant, amplitudes, poses);
    }
  });
}

void SwayScene::Pose(std::size_t index, std::vector<Vector3>& amplitudes, std::vector<JointPose>& poses)
{
  SwayingPlant& plant = this->Plants[index];
  amplitudes.resize(plant.Branches * static_cast<std::size_t>(this->Settings.Options.NumberOfModes));
  poses.resize(plant.Motion->GetNumberOfJoints());
  plant.Sway->Amplitudes(this->Time, amplitudes.data());
  plant.Motion->Pose(amplitudes.data(), poses.data());
  this->Winds[index] = LeafWindOf(plant.Sway->Wind(this->Time), this->Settings.Leaves);
  for (std::size_t joint = 0; joint < poses.size(); ++joint)
  {
    const std::size_t node = plant.FirstJoint + joint;
    this->Shifts[node] = poses[joint].Shift;
    this->Changes[node] = ChangeOf(poses[joint], this->Rest.Nodes[node].Position);
  }
}

void SwayScene::TurnLeaves(std::size_t begin, std::size_t end, float* points, float* normals)
{
  littoral::TurnLeaves(this->Flutter, this->Flutter.MomentOf(this->Time), this->Winds.data(), begin, end,
    this->Leaves.data(), points, normals);
}

void SwayScene::ShowPictures(std::size_t vertices, float* tcoords, const ParallelFor& parallel) const
{
  const double period = this->Wind->GetTimes().Period();
  const int pictures = this->Settings.Pictures;
  parallel(this->Crowns.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t index = begin; index < end; ++index)
    {
      const Crown& crown = this->Crowns[index];
      const std::size_t last = index + 1 < this->Crowns.size() ? this->Crowns[index + 1].First : vertices;
      const SwaySpecies& species = this->Species[crown.Species];
      const int picture = CrownPictureAt(this->Time - crown.Arrival, species.SwingFrequency, period, pictures);
      const AtlasArea& area = this->Areas[crown.Species * pictures + picture];
      const std::size_t known = std::min(last - crown.First, species.CrownTCoords.size());
      for (std::size_t vertex = 0; vertex < last - crown.First; ++vertex)
      {
        const std::array<double, 2> own =
          vertex < known ? species.CrownTCoords[vertex] : std::array<double, 2>{ 0.5, 0.5 };
        const std::array<double, 2> at = area.Map(own[0], own[1]);
        tcoords[2 * (crown.First + vertex)] = static_cast<float>(at[0]);
        tcoords[2 * (crown.First + vertex) + 1] = static_cast<float>(at[1]);
      }
    }
  });
}

}
