// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneReader.h"

#include "Data/ArrayReader.h"
#include "Data/Blocks.h"
#include "Data/JointBlock.h"
#include "Data/PlantBlocks.h"
#include "SceneBlocks.h"
#include "ScenePictures.h"
#include "SceneSurface.h"

#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace littoral
{

namespace
{

constexpr int Levels = 3;

/// Species and level of a prototype by its number, 1 + 3 species + level.
int SpeciesOf(int prototype)
{
  return (prototype - 1) / Levels;
}

int LevelOf(int prototype)
{
  return (prototype - 1) % Levels;
}

/// Whether an instance whose own level is given is drawn at a level.
bool IsDrawn(int own, int level, SceneLevelForm form)
{
  return SpeciesOf(own) == SpeciesOf(level) && (form != SceneLevelForm::AsShown || own == level);
}

/// Whether prototypes of a level are in the file.
bool IsWritten(int level, SceneLevelForm form)
{
  return form == SceneLevelForm::Switched || form == SceneLevelForm::AsShown ||
    level == static_cast<int>(form) - static_cast<int>(SceneLevelForm::High);
}

}

//----------------------------------------------------------------------------
void SceneReader::Add(const std::vector<SceneSource>& sources)
{
  for (std::size_t source = 0; source < sources.size(); ++source)
  {
    Surroundings around;
    around.Kind = sources[source].Kind;
    this->Address = { source, {} };
    const int node = this->AddData(sources[source].Data, sources[source].Name, around);
    this->To.Sources.push_back(node < 0 ? this->AddNode(sources[source].Name) : node);
  }
}

//----------------------------------------------------------------------------
void SceneReader::Follow(const std::vector<SceneSource>& sources, double time)
{
  this->To.Times.push_back(static_cast<float>(time));
  const auto follow = [&](auto& things) {
    for (auto& thing : things)
    {
      thing.Follow(sources, time);
    }
  };
  follow(this->Surfaces);
  follow(this->Plants);
}

//----------------------------------------------------------------------------
void SceneReader::Finish()
{
  for (MovingSurface& surface : this->Surfaces)
  {
    surface.Finish(this->To);
  }
  for (MovingPlants& plants : this->Plants)
  {
    plants.Finish(this->Options.JointTolerance, this->To);
  }
}

//----------------------------------------------------------------------------
int SceneReader::AddNode(const std::string& name, std::vector<int> children)
{
  SceneNode node;
  node.Name = name;
  node.Children = std::move(children);
  this->To.Nodes.push_back(std::move(node));
  return static_cast<int>(this->To.Nodes.size()) - 1;
}

//----------------------------------------------------------------------------
int SceneReader::AddBlock(const NamedBlock& block, const Surroundings& around)
{
  this->Address.Blocks.push_back(block.Index);
  const int node = this->AddData(block.Data, block.Name, around);
  this->Address.Blocks.pop_back();
  return node;
}

//----------------------------------------------------------------------------
/// Plants whose joints are told; what has none, as the level Low, stands still.
int SceneReader::AddMovingPlants(vtkMultiBlockDataSet* plants, const std::string& name, const Surroundings& around)
{
  const int node = this->AddNode(name);
  MovingPlants moving(this->Address, name, node, plants);
  std::vector<int> still;
  for (const NamedBlock& level : NamedBlocks(plants))
  {
    const bool isAlone = AreLevelsOfOne(plants) && level.Name != plant::High; // in the place of High
    auto* parts = vtkMultiBlockDataSet::SafeDownCast(level.Data);
    for (const NamedBlock& part : parts && !isAlone ? NamedBlocks(parts) : std::vector<NamedBlock>())
    {
      auto* data = vtkPolyData::SafeDownCast(part.Data);
      if (data && part.Name != plant::Skeleton && data->GetNumberOfPoints() > 0)
      {
        std::array<double, 3> place{};
        moving.AddPart(level.Name, data, this->MeshFor(data, part.Name, around, place));
      }
    }
    const bool isStill = !parts && level.Name != joint::Joints && !isAlone;
    const int child = isStill ? this->AddBlock(level, around) : -1;
    if (child >= 0)
    {
      still.push_back(child);
    }
  }
  this->To.Nodes[node].Children = still;
  this->Plants.push_back(std::move(moving));
  return node;
}

//----------------------------------------------------------------------------
int SceneReader::AddData(vtkDataObject* data, const std::string& name, const Surroundings& around)
{
  if (IsComposite(data))
  {
    return this->AddBlocks(BlocksOf(data, name.c_str()), name, around);
  }
  auto* image = vtkImageData::SafeDownCast(data);
  const vtkSmartPointer<vtkPolyData> terrain = image ? TerrainOf(image) : nullptr;
  return this->AddSurface(image ? terrain.Get() : vtkPolyData::SafeDownCast(data), name, around);
}

//----------------------------------------------------------------------------
/// The node of blocks; -1 where nothing is drawn.
int SceneReader::AddBlocks(vtkMultiBlockDataSet* blocks, const std::string& name, const Surroundings& around)
{
  if (vtkPolyData* points = InstancesOf(blocks))
  {
    return this->AddInstances(blocks, points, name, around);
  }
  Surroundings own = around;
  if (ArePlants(blocks))
  {
    own.IsPlant = true;
    own.IsSeaweed = AreSeaweeds(blocks);
    if (this->Options.HasMotion && FindBlock(blocks, joint::Joints))
    {
      return this->AddMovingPlants(blocks, name, own);
    }
    if (AreLevelsOfOne(blocks))
    {
      return this->AddLevels(blocks, name, own);
    }
  }
  std::vector<int> children;
  for (const NamedBlock& block : NamedBlocks(blocks))
  {
    const bool isDrawn = !own.IsPlant || (block.Name != plant::Skeleton && block.Name != joint::Joints);
    const int child = isDrawn ? this->AddBlock(block, own) : -1;
    if (child >= 0)
    {
      children.push_back(child);
    }
  }
  return children.empty() ? -1 : this->AddNode(name, children);
}

//----------------------------------------------------------------------------
int SceneReader::AddSurface(vtkPolyData* data, const std::string& name, const Surroundings& around)
{
  SceneNode node;
  node.Name = name;
  node.Mesh = data->GetNumberOfPoints() > 0 ? this->AddMesh(data, name, around, node.Translation) : -1;
  if (node.Mesh < 0)
  {
    return -1;
  }
  this->To.Nodes.push_back(node);
  const int index = static_cast<int>(this->To.Nodes.size()) - 1;
  if (this->Options.HasMotion)
  {
    this->Surfaces.emplace_back(this->Address, name, index, node.Mesh, node.Translation);
  }
  return index;
}

//----------------------------------------------------------------------------
/// The mesh of data with its material; without positions where nothing is drawn.
SceneMesh SceneReader::MeshFor(
  vtkPolyData* data, const std::string& name, const Surroundings& around, std::array<double, 3>& place)
{
  SceneMesh mesh = MeshOf(data, this->Options.HasVelocity, place);
  if (mesh.Positions.empty())
  {
    return mesh;
  }
  mesh.Name = name;
  const SceneKind told = KindOf(data, name, around.IsPlant, around.IsSeaweed);
  mesh.Material =
    this->MaterialOf(data, around.Kind == SceneKind::Automatic ? told : around.Kind, mesh.ColorParts == 4);
  return mesh;
}

//----------------------------------------------------------------------------
int SceneReader::AddMesh(
  vtkPolyData* data, const std::string& name, const Surroundings& around, std::array<double, 3>& place)
{
  SceneMesh mesh = this->MeshFor(data, name, around, place);
  if (mesh.Positions.empty())
  {
    return -1;
  }
  this->To.Meshes.push_back(std::move(mesh));
  return static_cast<int>(this->To.Meshes.size()) - 1;
}

//----------------------------------------------------------------------------
int SceneReader::MaterialOf(vtkPolyData* data, SceneKind kind, bool isBlended)
{
  int picture = -1;
  if (vtkAbstractArray* texels = ArrayReader::OfFields(data, "").Any(plant::Texture))
  {
    const auto known = this->Pictures.emplace(texels, static_cast<int>(this->To.Pictures.size()));
    picture = known.first->second;
    if (known.second)
    {
      this->Texels.emplace_back(texels);
      this->To.Pictures.push_back(PictureOf(data));
    }
  }
  const auto known =
    this->Materials.emplace(std::make_tuple(kind, picture, isBlended), static_cast<int>(this->To.Materials.size()));
  if (known.second)
  {
    SceneMaterial material;
    material.Name = SceneKindNames[static_cast<int>(kind)];
    const auto same = std::count_if(this->To.Materials.begin(), this->To.Materials.end(),
      [&](const SceneMaterial& other) { return other.Kind == kind; });
    material.Name += same > 0 ? " " + std::to_string(same + 1) : "";
    material.Kind = kind;
    material.Picture = picture;
    material.Blended = isBlended;
    this->To.Materials.push_back(material);
  }
  return known.first->second;
}

//----------------------------------------------------------------------------
/// The first node shows a thing from near, those behind it from afar.
void SceneReader::Switch(const std::vector<int>& nodes)
{
  if (nodes.size() > 1)
  {
    this->To.Nodes[nodes[0]].CoarserLevels.assign(nodes.begin() + 1, nodes.end());
  }
}

//----------------------------------------------------------------------------
/// One plant, whose levels are in one place.
int SceneReader::AddLevels(vtkMultiBlockDataSet* plant, const std::string& name, const Surroundings& around)
{
  constexpr const char* names[Levels] = { plant::High, plant::Medium, plant::Low };
  std::vector<int> nodes;
  for (int level = 0; level < Levels; ++level)
  {
    vtkDataObject* block = FindBlock(plant, names[level]);
    const bool isShown = this->Options.Levels != SceneLevelForm::AsShown || nodes.empty();
    const bool isWritten = block && isShown && IsWritten(level, this->Options.Levels);
    const int node = isWritten ? this->AddData(block, names[level], around) : -1;
    if (node >= 0)
    {
      nodes.push_back(node);
    }
  }
  this->Switch(nodes);
  return nodes.empty() ? -1 : this->AddNode(name, { nodes[0] });
}

//----------------------------------------------------------------------------
/// The prototypes of instances by their levels, with those parts that draw something.
std::vector<SceneReader::Level> SceneReader::LevelsOf(vtkMultiBlockDataSet* blocks, const Surroundings& around)
{
  std::vector<Level> levels;
  for (const NamedBlock& block : NamedBlocks(blocks))
  {
    auto* parts = vtkMultiBlockDataSet::SafeDownCast(block.Data);
    Level level{ block.Name, -1, {} };
    for (const NamedBlock& part : parts ? NamedBlocks(parts) : std::vector<NamedBlock>())
    {
      auto* data = vtkPolyData::SafeDownCast(part.Data);
      const int prototype = PrototypeOf(data);
      if (prototype < 1 || !IsWritten(LevelOf(prototype), this->Options.Levels) || data->GetNumberOfPoints() == 0)
      {
        continue;
      }
      Surroundings own = around;
      own.IsPlant = true;
      own.IsSeaweed = IsOfSeaweed(data);
      std::array<double, 3> place{};
      const int mesh = this->AddMesh(data, part.Name, own, place);
      if (mesh >= 0)
      {
        this->To.Meshes[mesh].Name = block.Name + " " + part.Name;
        level.Prototype = prototype;
        level.Parts.push_back({ part.Name, mesh, IsTinted(data) });
      }
    }
    if (!level.Parts.empty())
    {
      levels.push_back(std::move(level));
    }
  }
  return levels;
}

//----------------------------------------------------------------------------
std::map<int, std::array<std::vector<int>, 3>> SceneReader::AddPrototypes(vtkMultiBlockDataSet* blocks)
{
  std::map<int, std::array<std::vector<int>, Levels>> meshes;
  for (const Level& level : this->LevelsOf(blocks, {}))
  {
    for (const Part& part : level.Parts)
    {
      meshes[SpeciesOf(level.Prototype)][LevelOf(level.Prototype)].push_back(part.Mesh);
    }
  }
  return meshes;
}

//----------------------------------------------------------------------------
int SceneReader::AddInstancedLevel(const Level& level, int instances)
{
  std::vector<int> parts;
  for (const Part& part : level.Parts)
  {
    SceneNode node;
    node.Name = part.Name;
    node.Mesh = part.Mesh;
    node.Instances = instances;
    node.IsTinted = part.IsTinted;
    parts.push_back(static_cast<int>(this->To.Nodes.size()));
    this->To.Nodes.push_back(node);
  }
  return this->AddNode(level.Name, parts);
}

//----------------------------------------------------------------------------
/// A node for each plant, with its parts as children.
std::vector<int> SceneReader::AddPlantNodes(const Level& level, const SceneInstances& places)
{
  std::vector<int> nodes;
  for (std::size_t plant = 0; plant < places.Scales.size() / 3; ++plant)
  {
    std::vector<int> parts;
    for (const Part& part : level.Parts)
    {
      SceneNode node;
      node.Name = part.Name;
      node.Mesh = part.Mesh;
      if (part.IsTinted)
      {
        const float* tint = &places.Tints[3 * plant];
        node.Tint = { { tint[0], tint[1], tint[2] } };
      }
      parts.push_back(static_cast<int>(this->To.Nodes.size()));
      this->To.Nodes.push_back(node);
    }
    nodes.push_back(this->AddNode(level.Name + " " + std::to_string(plant), parts));
    SceneNode& node = this->To.Nodes.back();
    std::copy_n(&places.Translations[3 * plant], 3, node.Translation.begin());
    std::copy_n(&places.Rotations[4 * plant], 4, node.Rotation.begin());
    std::copy_n(&places.Scales[3 * plant], 3, node.Scale.begin());
  }
  return nodes;
}

//----------------------------------------------------------------------------
int SceneReader::AddInstances(
  vtkMultiBlockDataSet* blocks, vtkPolyData* points, const std::string& name, const Surroundings& around)
{
  const bool isSwitched = this->Options.Levels == SceneLevelForm::Switched;
  std::map<int, std::vector<std::vector<int>>> ofSpecies; // nodes of each level
  std::map<int, int> instancesOf;                         // by species, where all levels have the same
  for (const Level& level : this->LevelsOf(blocks, around))
  {
    const auto isChosen = [&](int own) { return IsDrawn(own, level.Prototype, this->Options.Levels); };
    const int species = SpeciesOf(level.Prototype);
    SceneInstances places = PlacesOf(points, isChosen);
    if (places.Scales.empty())
    {
      continue;
    }
    if (this->Options.Instances == SceneInstanceForm::Nodes)
    {
      ofSpecies[species].push_back(this->AddPlantNodes(level, places));
      continue;
    }
    const bool isKnown = isSwitched && instancesOf.count(species) > 0;
    const int instances = isKnown ? instancesOf[species] : static_cast<int>(this->To.Instances.size());
    if (!isKnown)
    {
      this->To.Instances.push_back(std::move(places));
    }
    instancesOf[species] = instances;
    ofSpecies[species].push_back({ this->AddInstancedLevel(level, instances) });
  }
  std::vector<int> children;
  for (const auto& [species, levels] : ofSpecies)
  {
    for (std::size_t thing = 0; isSwitched && thing < levels[0].size(); ++thing)
    {
      std::vector<int> nodes;
      for (const std::vector<int>& level : levels)
      {
        nodes.push_back(level[thing]);
      }
      this->Switch(nodes);
    }
    for (std::size_t level = 0; level < (isSwitched ? 1 : levels.size()); ++level)
    {
      children.insert(children.end(), levels[level].begin(), levels[level].end());
    }
  }
  return children.empty() ? -1 : this->AddNode(name, children);
}

}
