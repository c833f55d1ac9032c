// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneMotion.h"

#include "Data/ArrayReader.h"
#include "Data/Blocks.h"
#include "Data/JointBlock.h"
#include "Data/PlantBlocks.h"
#include "Numerics/ParameterCheck.h"
#include "Plants/JointReduction.h"
#include "SceneBlocks.h"
#include "SceneSurface.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <tuple>

namespace littoral
{

namespace
{

/// The data of an address; null where there are none any more.
vtkSmartPointer<vtkDataObject> DataAt(const std::vector<SceneSource>& sources, const SceneAddress& address)
{
  vtkSmartPointer<vtkDataObject> data = sources[address.Source].Data;
  for (const unsigned int index : address.Blocks)
  {
    std::string reason;
    const auto blocks = IsComposite(data) ? BlocksOf(data, "", reason) : nullptr;
    data = blocks && index < blocks->GetNumberOfBlocks() ? blocks->GetBlock(index) : nullptr;
  }
  return data;
}

std::vector<float> Difference(const std::vector<float>& to, const std::vector<float>& from)
{
  std::vector<float> difference(to.size());
  std::transform(to.begin(), to.end(), from.begin(), difference.begin(), std::minus<float>());
  return difference;
}

/// A turn about the vertical.
glm::dquat TurnOf(double azimuth)
{
  return { std::cos(0.5 * azimuth), 0.0, 0.0, std::sin(0.5 * azimuth) };
}

Vector3 TripleAt(const std::vector<float>& numbers, std::size_t index)
{
  return { numbers[3 * index], numbers[3 * index + 1], numbers[3 * index + 2] };
}

glm::dquat TurnAt(const std::vector<float>& numbers, std::size_t index)
{
  const float* q = &numbers[4 * index];
  return glm::normalize(glm::dquat(q[0], q[1], q[2], q[3]));
}

void Append(std::vector<float>& numbers, const Vector3& triple)
{
  numbers.insert(numbers.end(),
    { static_cast<float>(triple.x), static_cast<float>(triple.y), static_cast<float>(triple.z) });
}

/// A place in the world in the coordinates of a plant.
Vector3 ToPlant(const PlantPlace& plant, const Vector3& place)
{
  return (glm::conjugate(TurnOf(plant.Azimuth)) * (place - plant.Foot)) / plant.Scale;
}

/// What a mesh has of some vertices; triangles, lines and points whose first vertex is among them.
SceneMesh Subset(const SceneMesh& mesh, const std::vector<std::uint32_t>& vertices)
{
  SceneMesh part;
  part.Material = mesh.Material;
  part.ColorParts = mesh.ColorParts;
  std::vector<std::int64_t> indexOf(mesh.GetNumberOfVertices(), -1);
  for (std::size_t index = 0; index < vertices.size(); ++index)
  {
    indexOf[vertices[index]] = static_cast<std::int64_t>(index);
  }
  const auto take = [&](const std::vector<float>& from, int components, std::vector<float>& to) {
    for (std::size_t index = 0; !from.empty() && index < vertices.size(); ++index)
    {
      const float* tuple = &from[static_cast<std::size_t>(vertices[index]) * components];
      to.insert(to.end(), tuple, tuple + components);
    }
  };
  take(mesh.Positions, 3, part.Positions);
  take(mesh.Normals, 3, part.Normals);
  take(mesh.TextureCoordinates, 2, part.TextureCoordinates);
  take(mesh.Colors, mesh.ColorParts, part.Colors);
  take(mesh.Velocities, 3, part.Velocities);
  const auto pick = [&](const std::vector<std::uint32_t>& from, std::size_t each, std::vector<std::uint32_t>& to) {
    for (std::size_t first = 0; first < from.size(); first += each)
    {
      for (std::size_t corner = 0; indexOf[from[first]] >= 0 && corner < each; ++corner)
      {
        to.push_back(static_cast<std::uint32_t>(indexOf[from[first + corner]]));
      }
    }
  };
  pick(mesh.Triangles, 3, part.Triangles);
  pick(mesh.Lines, 2, part.Lines);
  pick(mesh.Points, 1, part.Points);
  return part;
}

/// The mean of colors.
std::array<double, 3> MeanColor(const SceneMesh& mesh, const std::vector<std::uint32_t>& vertices)
{
  std::array<double, 3> sum{};
  for (const std::uint32_t vertex : vertices)
  {
    for (int part = 0; part < 3; ++part)
    {
      sum[part] += mesh.Colors[static_cast<std::size_t>(vertex) * mesh.ColorParts + part];
    }
  }
  return sum;
}

}

//----------------------------------------------------------------------------
std::string MovingSurface::Follow(const std::vector<SceneSource>& sources, double time)
{
  const auto data = DataAt(sources, this->Address);
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (!surface)
  {
    return {}; // terrains of images stand still
  }
  const std::string owner = sources[this->Address.Source].Name + "/" + this->Name;
  const std::string reason = WhyNoSurface(surface, owner);
  if (!reason.empty())
  {
    return reason;
  }
  SceneMesh::Target frame = PlacesAt(surface, this->Place);
  const std::size_t first = this->Frames.empty() ? frame.Positions.size() : this->Frames[0].Positions.size();
  if (frame.Positions.size() != first)
  {
    return owner + " has " + std::to_string(frame.Positions.size() / 3) + " points at " + TextOf(time) +
      " s after the start, and " + std::to_string(first / 3) + " there; only data that keep their points can move.";
  }
  // What stands still costs no memory.
  const bool isSame = !this->Frames.empty() && frame.Positions == this->Frames[0].Positions;
  this->Frames.push_back(isSame ? SceneMesh::Target() : std::move(frame));
  return {};
}

//----------------------------------------------------------------------------
void MovingSurface::Finish(Scene& scene)
{
  const bool hasMoved = std::any_of(this->Frames.begin() + (this->Frames.empty() ? 0 : 1), this->Frames.end(),
    [](const SceneMesh::Target& frame) { return !frame.Positions.empty(); });
  if (!hasMoved)
  {
    return;
  }
  SceneMesh& mesh = scene.Meshes[this->Mesh];
  const SceneMesh::Target& first = this->Frames[0];
  std::vector<int> targetOf(this->Frames.size(), -1);
  for (std::size_t frame = 1; frame < this->Frames.size(); ++frame)
  {
    if (!this->Frames[frame].Positions.empty())
    {
      targetOf[frame] = static_cast<int>(mesh.Targets.size());
      mesh.Targets.push_back({ Difference(this->Frames[frame].Positions, first.Positions),
        Difference(this->Frames[frame].Normals, first.Normals) });
      this->Frames[frame] = {};
    }
  }
  SceneTrack track;
  track.Node = this->Node;
  track.Weights.assign(this->Frames.size() * mesh.Targets.size(), 0.0f);
  for (std::size_t frame = 0; frame < this->Frames.size(); ++frame)
  {
    if (targetOf[frame] >= 0)
    {
      track.Weights[frame * mesh.Targets.size() + targetOf[frame]] = 1.0f;
    }
  }
  scene.Tracks.push_back(std::move(track));
}

//----------------------------------------------------------------------------
MovingPlants::MovingPlants(SceneAddress address, std::string name, int node, vtkMultiBlockDataSet* plants)
  : Address(std::move(address))
  , Name(std::move(name))
  , Node(node)
{
  ReadTable(plants, this->Table);
  auto* joints = vtkPolyData::SafeDownCast(FindBlock(plants, joint::Joints));
  ArrayReader arrays = ArrayReader::OfPoints(joints, "");
  vtkIntArray* parents = arrays.Find<vtkIntArray>(joint::ParentId, 1);
  vtkFloatArray* rests = arrays.Find<vtkFloatArray>(joint::RestPosition, 3);
  this->Parents.assign(parents->GetPointer(0), parents->GetPointer(0) + parents->GetNumberOfValues());
  this->Rests.assign(rests->GetPointer(0), rests->GetPointer(0) + rests->GetNumberOfValues());
}

//----------------------------------------------------------------------------
void MovingPlants::AddPart(const std::string& level, vtkPolyData* data, SceneMesh mesh)
{
  Part part{ level, vtkSmartPointer<vtkPolyData>::New(), std::move(mesh) };
  part.Data->ShallowCopy(data);
  this->Parts.push_back(std::move(part));
}

//----------------------------------------------------------------------------
std::string MovingPlants::Follow(const std::vector<SceneSource>& sources, double time)
{
  std::string reason;
  const auto data = DataAt(sources, this->Address);
  const auto plants = IsComposite(data) ? BlocksOf(data, this->Name.c_str(), reason) : nullptr;
  auto* joints = plants ? vtkPolyData::SafeDownCast(FindBlock(plants, joint::Joints)) : nullptr;
  reason = reason.empty() && joints ? WhyNoJoints(joints, this->Name) : reason;
  if (!joints || !reason.empty())
  {
    return joints ? reason : this->Name + " has no block Joints at " + TextOf(time) + " s after the start.";
  }
  if (joints->GetNumberOfPoints() != static_cast<vtkIdType>(this->Parents.size()))
  {
    return this->Name + " has other joints at " + TextOf(time) +
      " s after the start than there; levels of detail must not change during a motion.";
  }
  auto* rotations = ArrayReader::OfPoints(joints, "").Find<vtkFloatArray>(joint::Rotation, 4);
  auto* positions = vtkFloatArray::SafeDownCast(joints->GetPoints()->GetData());
  Frame frame;
  frame.Rotations.assign(rotations->GetPointer(0), rotations->GetPointer(0) + rotations->GetNumberOfValues());
  frame.Positions.assign(positions->GetPointer(0), positions->GetPointer(0) + positions->GetNumberOfValues());
  this->Frames.push_back(std::move(frame));
  return {};
}

//----------------------------------------------------------------------------
/// Joints that hang together are a plant; vertices belong to that of their first joint.
std::vector<MovingPlants::Plant> MovingPlants::FindPlants() const
{
  std::vector<int> plantOf(this->Parents.size());
  std::vector<Plant> plants;
  for (std::size_t joint = 0; joint < this->Parents.size(); ++joint)
  {
    const int parent = this->Parents[joint];
    plantOf[joint] = parent < 0 ? static_cast<int>(plants.size()) : plantOf[parent];
    if (parent < 0)
    {
      plants.emplace_back();
      plants.back().Vertices.resize(this->Parts.size());
    }
    plants[plantOf[joint]].Joints.push_back(static_cast<int>(joint));
  }
  for (std::size_t index = 0; index < this->Parts.size(); ++index)
  {
    const Part& part = this->Parts[index];
    ArrayReader arrays = ArrayReader::OfPoints(part.Data, "");
    auto* joints = arrays.Find<vtkIntArray>(plant::JointIds, 4);
    auto* ids = arrays.Find<vtkIntArray>(plant::PlantId, 1);
    for (vtkIdType vertex = 0; joints && vertex < joints->GetNumberOfTuples(); ++vertex)
    {
      Plant& plant = plants[plantOf[joints->GetTypedComponent(vertex, 0)]];
      plant.Vertices[index].push_back(static_cast<std::uint32_t>(vertex));
      plant.Level = part.Level;
      plant.Id = ids ? ids->GetValue(vertex) : 0;
    }
  }
  for (Plant& plant : plants)
  {
    const int row = this->Table.IsThere && !plant.Level.empty() ? this->Table.RowOf(plant.Id) : -1;
    if (row >= 0)
    {
      plant.Place = this->Table.Places[row];
      plant.Species = plant.Place.Species;
    }
  }
  return plants;
}

//----------------------------------------------------------------------------
void MovingPlants::Finish(double tolerance, Scene& scene)
{
  const std::vector<Plant> plants = this->FindPlants();
  using Key = std::tuple<int, int, std::string, std::size_t, std::vector<std::size_t>>;
  std::map<Key, std::vector<const Plant*>> groups;
  for (std::size_t index = 0; index < plants.size(); ++index)
  {
    const Plant& plant = plants[index];
    std::vector<std::size_t> vertices;
    for (const std::vector<std::uint32_t>& own : plant.Vertices)
    {
      vertices.push_back(own.size());
    }
    const int alone = plant.Species < 0 ? static_cast<int>(index) : -1;
    if (!plant.Level.empty())
    {
      groups[Key(plant.Species, alone, plant.Level, plant.Joints.size(), vertices)].push_back(&plant);
    }
  }
  for (const auto& [key, group] : groups)
  {
    this->AddGroup(group, tolerance, scene);
  }
}

//----------------------------------------------------------------------------
/// Plants of one species in one level: one mesh, and a skin for each.
void MovingPlants::AddGroup(const std::vector<const Plant*>& group, double tolerance, Scene& scene)
{
  const Plant& first = *group[0];
  std::map<int, int> indexOf; // joints of the first plant
  JointTree tree;
  for (const int joint : first.Joints)
  {
    indexOf[joint] = static_cast<int>(tree.Parents.size());
    tree.Parents.push_back(this->Parents[joint] < 0 ? -1 : indexOf[this->Parents[joint]]);
    tree.Rests.push_back(ToPlant(first.Place, TripleAt(this->Rests, joint)));
  }
  tree.Boxes.resize(tree.Parents.size());
  const glm::dquat back = glm::conjugate(TurnOf(first.Place.Azimuth));
  SceneMesh mesh;
  double largest = 0.0;
  for (const Plant* plant : group)
  {
    largest = std::max(largest, plant->Place.Scale);
  }
  std::vector<SceneMesh> parts;
  std::vector<std::size_t> partOf;
  for (std::size_t index = 0; index < this->Parts.size(); ++index)
  {
    if (first.Vertices[index].empty())
    {
      continue;
    }
    ArrayReader arrays = ArrayReader::OfPoints(this->Parts[index].Data, "");
    auto* joints = arrays.Find<vtkIntArray>(plant::JointIds, 4);
    auto* weights = arrays.Find<vtkFloatArray>(plant::JointWeights, 4);
    SceneMesh own = Subset(this->Parts[index].Mesh, first.Vertices[index]);
    for (std::size_t vertex = 0; vertex < own.GetNumberOfVertices(); ++vertex)
    {
      // p' = A p + b with A = sum of w R and b = sum of w (x - R r), of joints at rest in r and now in x
      const vtkIdType from = first.Vertices[index][vertex];
      glm::dmat3 a(0.0);
      Vector3 b(0.0);
      for (int hold = 0; hold < 4; ++hold)
      {
        const int joint = joints->GetTypedComponent(from, hold);
        const double weight = weights->GetTypedComponent(from, hold);
        const glm::dmat3 turn = glm::mat3_cast(TurnAt(this->Frames[0].Rotations, joint));
        a += weight * turn;
        b += weight * (TripleAt(this->Frames[0].Positions, joint) - turn * TripleAt(this->Rests, joint));
      }
      const glm::dmat3 inverse = glm::inverse(a);
      const Vector3 rest = ToPlant(first.Place, inverse * (TripleAt(own.Positions, vertex) - b));
      for (int axis = 0; axis < 3; ++axis)
      {
        own.Positions[3 * vertex + axis] = static_cast<float>(rest[axis]);
      }
      if (!own.Normals.empty())
      {
        const Vector3 normal = Normalised(back * (inverse * TripleAt(own.Normals, vertex)));
        for (int axis = 0; axis < 3; ++axis)
        {
          own.Normals[3 * vertex + axis] = static_cast<float>(normal[axis]);
        }
      }
      for (int hold = 0; hold < 4; ++hold)
      {
        if (weights->GetTypedComponent(from, hold) > 0.0f)
        {
          tree.Boxes[indexOf[joints->GetTypedComponent(from, hold)]].Add(rest);
        }
      }
    }
    parts.push_back(std::move(own));
    partOf.push_back(index);
  }
  // The motion of all plants in their own coordinates: q' = z* q z, x' = z* (x - foot) / scale.
  std::vector<std::vector<JointFrame>> motions;
  for (const Plant* plant : group)
  {
    const glm::dquat turn = TurnOf(plant->Place.Azimuth);
    std::vector<JointFrame> frames;
    for (const Frame& frame : this->Frames)
    {
      JointFrame own;
      for (const int joint : plant->Joints)
      {
        own.Rotations.emplace_back(glm::conjugate(turn) * TurnAt(frame.Rotations, joint) * turn);
        own.Positions.emplace_back(ToPlant(plant->Place, TripleAt(frame.Positions, joint)));
      }
      frames.push_back(std::move(own));
    }
    motions.push_back(std::move(frames));
  }
  const ReducedJoints reduced = ReduceJoints(tree, motions, tolerance / largest);
  SceneBinding binding;
  for (const int joint : reduced.Kept)
  {
    Append(binding.Rests, tree.Rests[joint]);
  }
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    ArrayReader arrays = ArrayReader::OfPoints(this->Parts[partOf[part]].Data, "");
    auto* joints = arrays.Find<vtkIntArray>(plant::JointIds, 4);
    auto* weights = arrays.Find<vtkFloatArray>(plant::JointWeights, 4);
    for (const std::uint32_t from : first.Vertices[partOf[part]])
    {
      std::array<std::uint16_t, 4> ids{};
      std::array<float, 4> shares{};
      float sum = 0.0f;
      int count = 0;
      for (int hold = 0; hold < 4; ++hold)
      {
        const float weight = weights->GetTypedComponent(from, hold);
        const auto id =
          static_cast<std::uint16_t>(reduced.Follows[indexOf[joints->GetTypedComponent(from, hold)]]);
        const auto known = std::find(ids.begin(), ids.begin() + count, id) - ids.begin();
        if (weight > 0.0f)
        {
          ids[known] = id;
          shares[known] += weight;
          sum += weight;
          count = std::max(count, static_cast<int>(known) + 1);
        }
      }
      parts[part].JointIds.insert(parts[part].JointIds.end(), ids.begin(), ids.end());
      for (const float share : shares)
      {
        parts[part].JointWeights.push_back(share / sum);
      }
    }
  }
  mesh = std::move(parts[0]);
  mesh.More.assign(std::make_move_iterator(parts.begin() + 1), std::make_move_iterator(parts.end()));
  mesh.Name = this->Name + " " + first.Level + " " + std::to_string(std::max(0, first.Species));
  scene.Meshes.push_back(std::move(mesh));
  scene.Bindings.push_back(std::move(binding));
  for (std::size_t index = 0; index < group.size(); ++index)
  {
    const Plant& plant = *group[index];
    SceneNode top;
    top.Name = this->Name + " " + plant.Level + " " + std::to_string(plant.Id);
    top.Translation = { { plant.Place.Foot.x, plant.Place.Foot.y, plant.Place.Foot.z } };
    const glm::dquat turn = TurnOf(plant.Place.Azimuth);
    top.Rotation = { { turn.x, turn.y, turn.z, turn.w } };
    top.Scale = plant.Place.Scale;
    SceneSkin skin;
    skin.Binding = static_cast<int>(scene.Bindings.size()) - 1;
    const int firstNode = static_cast<int>(scene.Nodes.size());
    for (std::size_t kept = 0; kept < reduced.Kept.size(); ++kept)
    {
      const int parent = reduced.Parents[kept];
      SceneNode node;
      node.Name = "j" + std::to_string(kept);
      const Vector3 offset =
        tree.Rests[reduced.Kept[kept]] - (parent < 0 ? Vector3(0.0) : tree.Rests[reduced.Kept[parent]]);
      node.Translation = { { offset.x, offset.y, offset.z } };
      (parent < 0 ? top : scene.Nodes[firstNode + parent]).Children.push_back(firstNode + static_cast<int>(kept));
      skin.Joints.push_back(firstNode + static_cast<int>(kept));
      scene.Nodes.push_back(node);
      const JointTrack& from = reduced.Tracks[index][kept];
      SceneTrack track;
      track.Node = skin.Joints.back();
      for (const std::array<std::int16_t, 4>& sample : from.Rotations)
      {
        track.Rotations.insert(track.Rotations.end(), sample.begin(), sample.end());
      }
      for (const glm::vec3& sample : from.Translations)
      {
        Append(track.Translations, Vector3(sample));
      }
      scene.Tracks.push_back(std::move(track));
    }
    scene.Nodes[this->Node].Children.push_back(static_cast<int>(scene.Nodes.size()));
    scene.Nodes.push_back(top);
    SceneNode shown;
    shown.Name = top.Name;
    shown.Mesh = static_cast<int>(scene.Meshes.size()) - 1;
    shown.Skin = static_cast<int>(scene.Skins.size());
    if (index > 0)
    {
      const std::size_t tinted = partOf.back();
      const SceneMesh& colors = this->Parts[tinted].Mesh;
      if (!colors.Colors.empty())
      {
        const std::array<double, 3> own = MeanColor(colors, plant.Vertices[tinted]);
        const std::array<double, 3> other = MeanColor(colors, first.Vertices[tinted]);
        shown.Tint = { { own[0] / other[0], own[1] / other[1], own[2] / other[2] } };
      }
    }
    scene.Skins.push_back(std::move(skin));
    scene.Skinned.push_back(static_cast<int>(scene.Nodes.size()));
    scene.Nodes.push_back(shown);
  }
}

}
