// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneMotion.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Data/JointBlock.h"
#include "Data/PlantBlocks.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"
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
    const auto blocks = IsComposite(data) ? BlocksOf(data, "") : nullptr;
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
  numbers.insert(
    numbers.end(), { static_cast<float>(triple.x), static_cast<float>(triple.y), static_cast<float>(triple.z) });
}

void SetTriple(std::vector<float>& numbers, std::size_t index, const Vector3& triple)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    numbers[3 * index + axis] = static_cast<float>(triple[axis]);
  }
}

/// A place in the world in the coordinates of a plant, which is as wide there as its girth makes it.
Vector3 ToPlant(const PlantPlace& plant, const Vector3& place)
{
  return (glm::conjugate(TurnOf(plant.Azimuth)) * (place - plant.Foot)) / plant.Scale;
}

/// Part of a mesh with some vertices; triangles, lines and points whose first vertex is among them.
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

/// Joints and weights of the vertices of a part.
struct Holds
{
  explicit Holds(vtkPolyData* data)
    : Joints(ArrayReader::OfPoints(data, "").Seek<vtkIntArray>(plant::JointIds, 4))
    , Weights(ArrayReader::OfPoints(data, "").Seek<vtkFloatArray>(plant::JointWeights, 4))
  {
  }

  vtkIntArray* Joints;
  vtkFloatArray* Weights;

  int JointOf(vtkIdType vertex, int hold) const { return this->Joints->GetTypedComponent(vertex, hold); }
  float WeightOf(vtkIdType vertex, int hold) const { return this->Weights->GetTypedComponent(vertex, hold); }
};

/// Numbers with few decimals, which are short as text.
Vector3 Short(const Vector3& place)
{
  constexpr double parts = 1e5; // of a metre
  return glm::round(place * parts) / parts;
}

/// The samples of a joint as those of its node, whose own place stands for a single one.
SceneTrack TrackOf(const JointTrack& joint, int index, SceneNode& node)
{
  SceneTrack track;
  track.Node = index;
  track.Stride = joint.Stride;
  track.IsSmooth = joint.IsSmooth;
  if (joint.Rotations.size() == 1)
  {
    constexpr double parts = 1e6;
    const std::array<std::int16_t, 4>& turn = joint.Rotations[0];
    const glm::dvec4 unit = glm::round(glm::normalize(glm::dvec4(turn[0], turn[1], turn[2], turn[3])) * parts) / parts;
    node.Rotation = { { unit.x, unit.y, unit.z, unit.w } };
    return track;
  }
  for (const std::array<std::int16_t, 4>& sample : joint.Rotations)
  {
    track.Rotations.insert(track.Rotations.end(), sample.begin(), sample.end());
  }
  for (const glm::vec3& sample : joint.Translations)
  {
    Append(track.Translations, Vector3(sample));
  }
  return track;
}

/// Frames a second.
double RateOf(const std::vector<float>& times)
{
  return times.size() > 1 ? static_cast<double>(times.size() - 1) / (times.back() - times.front()) : 1.0;
}

/// The sum of colors.
std::array<double, 3> SumOfColors(const SceneMesh& mesh, const std::vector<std::uint32_t>& vertices)
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
void MovingSurface::Follow(const std::vector<SceneSource>& sources, double time)
{
  const auto data = DataAt(sources, this->Address);
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (!surface)
  {
    return; // terrains of images stand still
  }
  const std::string owner = sources[this->Address.Source].Name + "/" + this->Name;
  RequireSurface(surface, owner);
  SceneMesh::Target frame = PlacesAt(surface, this->Place);
  const std::size_t first = this->Frames.empty() ? frame.Positions.size() : this->Frames[0].Positions.size();
  if (frame.Positions.size() != first)
  {
    Refuse(owner, " has ", frame.Positions.size() / 3, " points at ", TextOf(time), " s after the start, and ",
      first / 3, " there; only data that keep their points can move.");
  }
  // What stands still costs no memory.
  const bool isSame = !this->Frames.empty() && frame.Positions == this->Frames[0].Positions;
  this->Frames.push_back(isSame ? SceneMesh::Target() : std::move(frame));
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
  this->Table = ReadTable(plants);
  auto* joints = vtkPolyData::SafeDownCast(FindBlock(plants, joint::Joints));
  const ArrayReader arrays = ArrayReader::OfPoints(joints, "");
  this->Parents = ListOf(arrays.Find<vtkIntArray>(joint::ParentId, 1));
  this->Rests = ListOf(arrays.Find<vtkFloatArray>(joint::RestPosition, 3));
}

//----------------------------------------------------------------------------
void MovingPlants::AddPart(const std::string& level, vtkPolyData* data, SceneMesh mesh)
{
  Part part{ level, vtkSmartPointer<vtkPolyData>::New(), std::move(mesh) };
  part.Data->ShallowCopy(data);
  this->Parts.push_back(std::move(part));
}

//----------------------------------------------------------------------------
void MovingPlants::Follow(const std::vector<SceneSource>& sources, double time)
{
  const auto data = DataAt(sources, this->Address);
  const auto plants = IsComposite(data) ? BlocksOf(data, this->Name.c_str()) : nullptr;
  auto* joints = plants ? vtkPolyData::SafeDownCast(FindBlock(plants, joint::Joints)) : nullptr;
  if (!joints)
  {
    Refuse(this->Name, " has no block Joints at ", TextOf(time), " s after the start.");
  }
  RequireJoints(joints, this->Name);
  if (joints->GetNumberOfPoints() != static_cast<vtkIdType>(this->Parents.size()))
  {
    Refuse(this->Name, " has other joints at ", TextOf(time),
      " s after the start than there; levels of detail must not change during a motion.");
  }
  EndIfShortOfMemory(); // frame by frame
  this->Frames.push_back({ ListOf(ArrayReader::OfPoints(joints, "").Find<vtkFloatArray>(joint::Rotation, 4)),
    ListOf(vtkFloatArray::SafeDownCast(joints->GetPoints()->GetData())) });
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
    const ArrayReader arrays = ArrayReader::OfPoints(part.Data, "");
    auto* joints = arrays.Seek<vtkIntArray>(plant::JointIds, 4);
    auto* ids = arrays.Seek<vtkIntArray>(plant::PlantId, 1);
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
  using Key = std::tuple<int, int, double, std::string, std::size_t, std::vector<std::size_t>>;
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
      groups[Key(plant.Species, alone, plant.Place.WidthScale, plant.Level, plant.Joints.size(), vertices)].push_back(
        &plant);
    }
  }
  for (const auto& [key, group] : groups)
  {
    this->AddGroup(group, tolerance, scene);
  }
}

//----------------------------------------------------------------------------
/// A part of a plant at rest, in the coordinates of the plant; the boxes of its joints grow around it.
SceneMesh MovingPlants::RestOf(const Plant& plant, std::size_t part, JointTree& tree) const
{
  const Holds holds(this->Parts[part].Data);
  const glm::dquat back = glm::conjugate(TurnOf(plant.Place.Azimuth));
  SceneMesh mesh = Subset(this->Parts[part].Mesh, plant.Vertices[part]);
  for (std::size_t vertex = 0; vertex < mesh.GetNumberOfVertices(); ++vertex)
  {
    // p' = A p + b with A = sum of w R and b = sum of w (x - R r), of joints at rest in r and now in x
    const vtkIdType from = plant.Vertices[part][vertex];
    glm::dmat3 a(0.0);
    Vector3 b(0.0);
    for (int hold = 0; hold < 4; ++hold)
    {
      const int joint = holds.JointOf(from, hold);
      const double weight = holds.WeightOf(from, hold);
      const glm::dmat3 turn = glm::mat3_cast(TurnAt(this->Frames[0].Rotations, joint));
      a += weight * turn;
      b += weight * (TripleAt(this->Frames[0].Positions, joint) - turn * TripleAt(this->Rests, joint));
    }
    const glm::dmat3 inverse = glm::inverse(a);
    const Vector3 rest = ToPlant(plant.Place, inverse * (TripleAt(mesh.Positions, vertex) - b));
    SetTriple(mesh.Positions, vertex, rest);
    if (!mesh.Normals.empty())
    {
      SetTriple(mesh.Normals, vertex, Normalised(back * (inverse * TripleAt(mesh.Normals, vertex))));
    }
    for (int hold = 0; hold < 4; ++hold)
    {
      if (holds.WeightOf(from, hold) > 0.0f)
      {
        tree.Boxes[this->LocalJoints[holds.JointOf(from, hold)]].Add(rest);
      }
    }
  }
  return mesh;
}

//----------------------------------------------------------------------------
/// The kept joints that the vertices of a part follow; those that have become one add their weights.
void MovingPlants::AddHolds(const Plant& plant, std::size_t part, const ReducedJoints& reduced, SceneMesh& mesh) const
{
  constexpr float least = 2e-5f; // that is more than one part of 65535
  const Holds holds(this->Parts[part].Data);
  for (const std::uint32_t from : plant.Vertices[part])
  {
    std::array<std::uint16_t, 4> ids{};
    std::array<float, 4> shares{};
    float sum = 0.0f;
    std::ptrdiff_t count = 0;
    for (int hold = 0; hold < 4; ++hold)
    {
      const float weight = holds.WeightOf(from, hold);
      const auto id = static_cast<std::uint16_t>(reduced.Follows[this->LocalJoints[holds.JointOf(from, hold)]]);
      const std::ptrdiff_t place = std::find(ids.begin(), ids.begin() + count, id) - ids.begin();
      if (weight > least)
      {
        ids[place] = id;
        shares[place] += weight;
        sum += weight;
        count = std::max(count, place + 1);
      }
    }
    mesh.JointIds.insert(mesh.JointIds.end(), ids.begin(), ids.end());
    for (const float share : shares)
    {
      mesh.JointWeights.push_back(share / sum);
    }
  }
}

//----------------------------------------------------------------------------
/// The joints of a plant in its own coordinates: q' = z* q z, x' = z* (x - foot) / scale.
std::vector<JointFrame> MovingPlants::MotionOf(const Plant& plant) const
{
  const glm::dquat turn = TurnOf(plant.Place.Azimuth);
  std::vector<JointFrame> frames;
  for (const Frame& frame : this->Frames)
  {
    JointFrame own;
    for (const int joint : plant.Joints)
    {
      own.Rotations.emplace_back(glm::conjugate(turn) * TurnAt(frame.Rotations, joint) * turn);
      own.Positions.emplace_back(ToPlant(plant.Place, TripleAt(frame.Positions, joint)));
    }
    frames.push_back(std::move(own));
  }
  return frames;
}

//----------------------------------------------------------------------------
/// The joints of a plant at rest; the numbers that they have in it are kept.
JointTree MovingPlants::TreeOf(const Plant& plant)
{
  JointTree tree;
  this->LocalJoints.resize(this->Parents.size());
  for (const int joint : plant.Joints)
  {
    const int parent = this->Parents[joint];
    this->LocalJoints[joint] = static_cast<int>(tree.Parents.size());
    tree.Parents.push_back(parent < 0 ? -1 : this->LocalJoints[parent]);
    tree.Rests.push_back(Short(ToPlant(plant.Place, TripleAt(this->Rests, joint))));
  }
  tree.Boxes.resize(tree.Parents.size());
  return tree;
}

//----------------------------------------------------------------------------
/// Factor of the colors of a plant over those of another one: by the colors of the last part, leaves or crown.
std::optional<std::array<double, 3>> MovingPlants::TintOf(const Plant& plant, const Plant& other) const
{
  std::size_t part = this->Parts.size();
  while (part > 0 && other.Vertices[part - 1].empty())
  {
    --part;
  }
  if (part == 0 || this->Parts[part - 1].Mesh.Colors.empty() || &plant == &other)
  {
    return {};
  }
  const SceneMesh& mesh = this->Parts[part - 1].Mesh;
  const std::array<double, 3> own = SumOfColors(mesh, plant.Vertices[part - 1]);
  const std::array<double, 3> others = SumOfColors(mesh, other.Vertices[part - 1]);
  std::array<double, 3> tint{ { 1.0, 1.0, 1.0 } };
  for (int color = 0; color < 3; ++color)
  {
    tint[color] = others[color] > 0.0 ? own[color] / others[color] : 1.0;
  }
  return tint;
}

//----------------------------------------------------------------------------
/// Plants of one species and proportion in one level: one mesh, and a skin for each.
void MovingPlants::AddGroup(const std::vector<const Plant*>& group, double tolerance, Scene& scene)
{
  constexpr std::size_t mostJoints = 65536; // of a skin
  const Plant& first = *group[0];
  JointTree tree = this->TreeOf(first);
  std::vector<SceneMesh> meshes;
  std::vector<std::size_t> parts;
  for (std::size_t part = 0; part < this->Parts.size(); ++part)
  {
    if (!first.Vertices[part].empty())
    {
      meshes.push_back(this->RestOf(first, part, tree));
      parts.push_back(part);
    }
  }
  std::vector<PlantFrames> motions;
  for (const Plant* plant : group)
  {
    motions.push_back({ this->MotionOf(*plant), tolerance / plant->Place.Scale });
  }
  const ReducedJoints reduced = ReduceJoints(tree, motions, RateOf(scene.Times), SmpFor);
  if (reduced.Kept.size() > mostJoints)
  {
    Refuse(this->Name, " has a plant of more than 65536 joints; take a larger JointTolerance.");
  }
  SceneBinding binding;
  for (const int joint : reduced.Kept)
  {
    Append(binding.Rests, tree.Rests[joint]);
  }
  for (std::size_t index = 0; index < meshes.size(); ++index)
  {
    this->AddHolds(first, parts[index], reduced, meshes[index]);
  }
  SceneMesh mesh = std::move(meshes[0]);
  mesh.More.assign(std::make_move_iterator(meshes.begin() + 1), std::make_move_iterator(meshes.end()));
  mesh.Name = this->Name + " " + first.Level + " " + std::to_string(std::max(0, first.Species));
  scene.Meshes.push_back(std::move(mesh));
  scene.Bindings.push_back(std::move(binding));
  for (std::size_t index = 0; index < group.size(); ++index)
  {
    this->AddSkinned(*group[index], first, tree, reduced, reduced.Tracks[index], scene);
  }
}

//----------------------------------------------------------------------------
/// A plant of the last mesh and binding: its joints below the node of all plants, and the mesh that they move.
void MovingPlants::AddSkinned(const Plant& plant, const Plant& first, const JointTree& tree,
  const ReducedJoints& reduced, const std::vector<JointTrack>& tracks, Scene& scene) const
{
  const glm::dquat turn = TurnOf(plant.Place.Azimuth);
  SceneNode foot;
  foot.Name = this->Name + " " + plant.Level + " " + std::to_string(plant.Id);
  foot.Translation = { { plant.Place.Foot.x, plant.Place.Foot.y, plant.Place.Foot.z } };
  foot.Rotation = { { turn.x, turn.y, turn.z, turn.w } };
  foot.Scale.fill(plant.Place.Scale);
  SceneSkin skin;
  skin.Binding = static_cast<int>(scene.Bindings.size()) - 1;
  const int firstNode = static_cast<int>(scene.Nodes.size());
  for (std::size_t kept = 0; kept < reduced.Kept.size(); ++kept)
  {
    const int parent = reduced.Parents[kept];
    const Vector3 below = parent < 0 ? Vector3(0.0) : tree.Rests[reduced.Kept[parent]];
    const Vector3 offset = Short(tree.Rests[reduced.Kept[kept]] - below);
    const int index = firstNode + static_cast<int>(kept);
    SceneNode node; // without a name, as these are many
    node.Translation = { { offset.x, offset.y, offset.z } };
    SceneTrack track = TrackOf(tracks[kept], index, node);
    (parent < 0 ? foot : scene.Nodes[firstNode + parent]).Children.push_back(index);
    scene.Nodes.push_back(node);
    if (!track.Rotations.empty())
    {
      scene.Tracks.push_back(std::move(track));
    }
    skin.Joints.push_back(index);
  }
  scene.Nodes[this->Node].Children.push_back(static_cast<int>(scene.Nodes.size()));
  scene.Nodes.push_back(foot);
  SceneNode shown;
  shown.Name = foot.Name;
  shown.Mesh = static_cast<int>(scene.Meshes.size()) - 1;
  shown.Skin = static_cast<int>(scene.Skins.size());
  shown.Tint = this->TintOf(plant, first);
  scene.Skins.push_back(std::move(skin));
  scene.Skinned.push_back(static_cast<int>(scene.Nodes.size()));
  scene.Nodes.push_back(shown);
}

}
