// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneFile.h"

#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"
#include "Plants/SampledCurve.h"
#include "ReplacedFile.h"
#include "SceneBuffer.h"
#include "SceneView.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace littoral
{

namespace
{

using tinygltf::Value;

constexpr const char* Instancing = "EXT_mesh_gpu_instancing";
constexpr const char* LevelsOfDetail = "MSFT_lod";
constexpr const char* Lights = "KHR_lights_punctual";

Value NumbersOf(const std::vector<int>& numbers)
{
  Value::Array values;
  for (const int number : numbers)
  {
    values.emplace_back(number);
  }
  return Value(std::move(values));
}

Value NumbersOf(const std::array<double, 3>& numbers)
{
  return Value(Value::Array{ Value(numbers[0]), Value(numbers[1]), Value(numbers[2]) });
}

/// Members of the library for lights and levels from 2.9 on, which removes the extensions of nodes where these are
/// empty.
template <typename Node>
auto SetLight(Node& node, int light) -> decltype(node.light, void())
{
  node.light = light;
}

template <typename Node, typename... Before>
void SetLight(Node& node, int light, Before...)
{
  node.extensions[Lights] = Value(Value::Object{ { "light", Value(light) } });
}

template <typename Node>
auto SetLevels(Node& node, const std::vector<int>& levels) -> decltype(node.lods, void())
{
  node.lods = levels;
}

template <typename Node, typename... Before>
void SetLevels(Node& node, const std::vector<int>& levels, Before...)
{
  node.extensions[LevelsOfDetail] = Value(Value::Object{ { "ids", NumbersOf(levels) } });
}

/// The object that a text in JSON says, by the reader of the library.
Value ObjectOf(const std::string& json)
{
  tinygltf::TinyGLTF reader;
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const std::string text = R"({"asset":{"version":"2.0"},"extras":)" + json + "}";
  const bool isRead = reader.LoadASCIIFromString(
    &model, &error, &warning, text.c_str(), static_cast<unsigned int>(text.size()), "", tinygltf::NO_REQUIRE);
  // The library leaves out what is empty: of {"volumes": []} nothing stays.
  const std::size_t first = json.find_first_not_of(" \t\r\n");
  const bool isEmpty = model.extras.Type() == tinygltf::NULL_TYPE && first != std::string::npos && json[first] == '{';
  const bool isObject = isRead && (model.extras.IsObject() || isEmpty);
  Require(isObject ? "" : "Extras must be an object as JSON, such as {\"water\": {\"level\": 0}}.");
  return model.extras;
}

/// Model of the library for a scene.
class ModelMaker
{
public:
  explicit ModelMaker(const Scene& scene)
    : From(scene)
    , Buffer(this->Model)
  {
  }

  /// All but the arrays of the buffer, which are large.
  const tinygltf::Model& Make();

private:
  const Scene& From;
  tinygltf::Model Model;
  SceneBuffer Buffer;
  std::vector<std::map<std::string, int>> Places; // accessors of instances
  std::map<std::string, bool> Used;               // extensions

  void AddPictures();
  void AddMaterials();
  void AddMesh(const SceneMesh& mesh);
  void AddPrimitives(const SceneMesh& from, tinygltf::Mesh& mesh);
  void AddSkins();
  int AddTimes(int stride);
  void AddAnimation();
  void AddInstances(const SceneInstances& instances);
  void AddNode(const SceneNode& node);
  void AddCamera(const SceneCamera& camera, std::vector<int>& nodes);
  void AddSun(const SceneSun& sun, std::vector<int>& nodes);
};

//----------------------------------------------------------------------------
void ModelMaker::AddPictures()
{
  for (const ScenePicture& picture : this->From.Pictures)
  {
    tinygltf::Image image;
    image.mimeType = "image/png";
    image.bufferView = this->Buffer.AddBytes(picture.Png);
    tinygltf::Texture texture;
    texture.source = static_cast<int>(this->Model.images.size());
    texture.sampler = 0;
    this->Model.images.push_back(image);
    this->Model.textures.push_back(texture);
  }
  if (!this->From.Pictures.empty())
  {
    // As the representation of textured blocks in ParaView draws them: a mean of thin leaves and gaps would have holes.
    tinygltf::Sampler sampler;
    sampler.magFilter = sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
    sampler.wrapS = sampler.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    this->Model.samplers.push_back(sampler);
  }
}

//----------------------------------------------------------------------------
void ModelMaker::AddMaterials()
{
  constexpr double waterRoughness = 0.05;
  for (const SceneMaterial& from : this->From.Materials)
  {
    tinygltf::Material material;
    material.name = from.Name;
    material.pbrMetallicRoughness.metallicFactor = 0.0;
    material.pbrMetallicRoughness.roughnessFactor = from.Kind == SceneKind::Water ? waterRoughness : 1.0;
    material.pbrMetallicRoughness.baseColorTexture.index = from.Picture;
    material.alphaMode = from.Picture >= 0 ? "MASK" : from.Blended ? "BLEND" : "OPAQUE";
    material.doubleSided = from.Kind != SceneKind::Bark; // wood is closed
    material.extras =
      Value(Value::Object{ { "kind", Value(std::string(SceneKindNames[static_cast<int>(from.Kind)])) } });
    this->Model.materials.push_back(material);
  }
}

//----------------------------------------------------------------------------
void ModelMaker::AddMesh(const SceneMesh& from)
{
  tinygltf::Mesh mesh;
  mesh.name = from.Name;
  this->AddPrimitives(from, mesh);
  for (const SceneMesh& more : from.More)
  {
    this->AddPrimitives(more, mesh);
  }
  mesh.weights.assign(from.Targets.size(), 0.0);
  this->Model.meshes.push_back(mesh);
}

//----------------------------------------------------------------------------
void ModelMaker::AddPrimitives(const SceneMesh& from, tinygltf::Mesh& mesh)
{
  std::map<std::string, int> attributes;
  const auto add = [&](const char* name, const std::vector<float>& numbers, int components) {
    if (!numbers.empty())
    {
      attributes[name] = this->Buffer.AddVertices(numbers, components);
    }
  };
  add("POSITION", from.Positions, 3);
  add("NORMAL", from.Normals, 3);
  add("TEXCOORD_0", from.TextureCoordinates, 2);
  add("_VELOCITY", from.Velocities, 3);
  add("_RADIUS", from.Radii, 1);
  const SceneMesh& vertices = from.SharesVertices ? this->From.Meshes[0] : from;
  if (from.SharesVertices)
  {
    attributes =
      this->Model.meshes.empty() ? mesh.primitives[0].attributes : this->Model.meshes[0].primitives[0].attributes;
  }
  if (!from.Colors.empty())
  {
    attributes["COLOR_0"] = this->Buffer.AddColors(from.Colors, from.ColorParts);
  }
  if (!from.JointIds.empty())
  {
    attributes["JOINTS_0"] = this->Buffer.AddJoints(from.JointIds);
    attributes["WEIGHTS_0"] = this->Buffer.AddWeights(from.JointWeights);
  }
  std::vector<std::map<std::string, int>> targets;
  for (const SceneMesh::Target& target : from.Targets)
  {
    targets.push_back({ { "POSITION", this->Buffer.AddVertices(target.Positions, 3) } });
    if (!target.Normals.empty())
    {
      targets.back()["NORMAL"] = this->Buffer.AddVertices(target.Normals, 3);
    }
  }
  const std::pair<const std::vector<std::uint32_t>*, int> drawn[] = { { &from.Triangles, TINYGLTF_MODE_TRIANGLES },
    { &from.Lines, TINYGLTF_MODE_LINE }, { &from.Points, TINYGLTF_MODE_POINTS } };
  for (const auto& [indices, mode] : drawn)
  {
    if (!indices->empty())
    {
      tinygltf::Primitive primitive;
      primitive.attributes = attributes;
      primitive.indices = this->Buffer.AddIndices(*indices, vertices.GetNumberOfVertices());
      primitive.material = from.Material;
      primitive.mode = mode;
      primitive.targets = targets;
      mesh.primitives.push_back(primitive);
    }
  }
}

//----------------------------------------------------------------------------
void ModelMaker::AddSkins()
{
  std::vector<int> inverses;
  for (const SceneBinding& binding : this->From.Bindings)
  {
    inverses.push_back(this->Buffer.AddInverses(binding.Rests));
  }
  for (const SceneSkin& from : this->From.Skins)
  {
    tinygltf::Skin skin;
    skin.joints = from.Joints;
    skin.inverseBindMatrices = inverses[from.Binding];
    this->Model.skins.push_back(skin);
  }
}

//----------------------------------------------------------------------------
/// The times of samples with a stride.
int ModelMaker::AddTimes(int stride)
{
  std::vector<float> times;
  for (const int frame : SampledFrames(static_cast<int>(this->From.Times.size()), stride))
  {
    times.push_back(this->From.Times[frame]);
  }
  return this->Buffer.AddBounded(times, 1);
}

//----------------------------------------------------------------------------
void ModelMaker::AddAnimation()
{
  if (this->From.Tracks.empty())
  {
    return;
  }
  std::map<int, int> times; // by strides
  for (const SceneTrack& track : this->From.Tracks)
  {
    const auto known = times.try_emplace(track.Stride, -1);
    if (known.second)
    {
      known.first->second = this->AddTimes(track.Stride);
    }
  }
  tinygltf::Animation animation;
  animation.name = "Motion";
  int stride = 1;
  const char* between = "LINEAR";
  const auto add = [&](int node, const char* path, int output) {
    tinygltf::AnimationSampler sampler;
    sampler.input = times[stride];
    sampler.output = output;
    sampler.interpolation = between;
    tinygltf::AnimationChannel channel;
    channel.sampler = static_cast<int>(animation.samplers.size());
    channel.target_node = node;
    channel.target_path = path;
    animation.samplers.push_back(sampler);
    animation.channels.push_back(channel);
  };
  for (const SceneTrack& track : this->From.Tracks)
  {
    stride = track.Stride;
    between = track.IsSmooth ? "CUBICSPLINE" : "LINEAR";
    if (!track.Rotations.empty())
    {
      add(track.Node, "rotation", this->Buffer.AddRotations(track.Rotations));
    }
    if (!track.Translations.empty())
    {
      add(track.Node, "translation", this->Buffer.AddSamples(track.Translations, 3));
    }
    if (!track.Weights.empty())
    {
      add(track.Node, "weights", this->Buffer.AddSamples(track.Weights, 1));
    }
  }
  this->Model.animations.push_back(animation);
}

//----------------------------------------------------------------------------
void ModelMaker::AddInstances(const SceneInstances& from)
{
  this->Places.push_back({ { "TRANSLATION", this->Buffer.AddNumbers(from.Translations, 3) },
    { "ROTATION", this->Buffer.AddNumbers(from.Rotations, 4) }, { "SCALE", this->Buffer.AddNumbers(from.Scales, 3) },
    { "_TINT", this->Buffer.AddNumbers(from.Tints, 3) } });
}

//----------------------------------------------------------------------------
void ModelMaker::AddNode(const SceneNode& from)
{
  tinygltf::Node node;
  node.name = from.Name;
  node.mesh = from.Mesh;
  node.skin = from.Skin;
  node.children = from.Children;
  if (from.Translation != std::array<double, 3>{})
  {
    node.translation.assign(from.Translation.begin(), from.Translation.end());
  }
  if (from.Rotation != SceneNode().Rotation)
  {
    node.rotation.assign(from.Rotation.begin(), from.Rotation.end());
  }
  if (from.Scale != SceneNode().Scale)
  {
    node.scale.assign(from.Scale.begin(), from.Scale.end());
  }
  if (from.Tint)
  {
    node.extras = Value(Value::Object{ { "tint", NumbersOf(*from.Tint) } });
  }
  if (from.Instances >= 0)
  {
    Value::Object attributes;
    for (const auto& [name, accessor] : this->Places[from.Instances])
    {
      if (from.IsTinted || name != "_TINT")
      {
        attributes[name] = Value(accessor);
      }
    }
    node.extensions[Instancing] = Value(Value::Object{ { "attributes", Value(std::move(attributes)) } });
    this->Used[Instancing] = true;
  }
  if (!from.CoarserLevels.empty())
  {
    SetLevels(node, from.CoarserLevels);
    this->Used[LevelsOfDetail] = true;
  }
  this->Model.nodes.push_back(std::move(node));
}

//----------------------------------------------------------------------------
void ModelMaker::AddCamera(const SceneCamera& from, std::vector<int>& nodes)
{
  constexpr double near = 0.1; // [m]
  constexpr double far = 1e5;  // [m]
  tinygltf::Camera camera;
  camera.type = "perspective";
  camera.name = "Camera";
  camera.perspective.yfov = from.ViewAngle * Pi / 180.0;
  camera.perspective.znear = near;
  camera.perspective.zfar = far;
  this->Model.cameras.push_back(camera);
  tinygltf::Node node;
  node.name = camera.name;
  node.camera = 0;
  node.translation.assign(from.Position.begin(), from.Position.end());
  const std::array<double, 4> rotation = ViewRotation(from.Position, from.FocalPoint, from.ViewUp);
  node.rotation.assign(rotation.begin(), rotation.end());
  nodes.push_back(static_cast<int>(this->Model.nodes.size()));
  this->Model.nodes.push_back(node);
}

//----------------------------------------------------------------------------
void ModelMaker::AddSun(const SceneSun& from, std::vector<int>& nodes)
{
  tinygltf::Light light;
  light.name = "Sun";
  light.type = "directional";
  light.intensity = from.Illuminance;
  light.color.assign(from.Color.begin(), from.Color.end());
  this->Model.lights.push_back(light);
  tinygltf::Node node;
  node.name = light.name;
  const std::array<double, 4> rotation = ViewRotation(from.Direction, { { 0.0, 0.0, 0.0 } }, { { 0.0, 0.0, 1.0 } });
  node.rotation.assign(rotation.begin(), rotation.end());
  SetLight(node, 0);
  this->Used[Lights] = true;
  nodes.push_back(static_cast<int>(this->Model.nodes.size()));
  this->Model.nodes.push_back(node);
}

//----------------------------------------------------------------------------
const tinygltf::Model& ModelMaker::Make()
{
  this->Model.asset.generator = "Littoral";
  this->AddPictures();
  this->AddMaterials();
  for (const SceneMesh& mesh : this->From.Meshes)
  {
    this->AddMesh(mesh);
  }
  for (const SceneInstances& instances : this->From.Instances)
  {
    this->AddInstances(instances);
  }
  this->AddSkins();
  for (const SceneNode& node : this->From.Nodes)
  {
    this->AddNode(node);
  }
  // The root turns z up into y up: by -90 degrees about x.
  tinygltf::Node root;
  root.name = this->From.Name;
  root.rotation = { -std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5) };
  root.children = this->From.Sources;
  if (this->From.Camera)
  {
    this->AddCamera(*this->From.Camera, root.children);
  }
  if (this->From.Sun)
  {
    this->AddSun(*this->From.Sun, root.children);
  }
  tinygltf::Scene scene;
  scene.name = this->From.Name;
  scene.nodes = { static_cast<int>(this->Model.nodes.size()) };
  this->Model.nodes.push_back(root);
  scene.nodes.insert(scene.nodes.end(), this->From.Skinned.begin(), this->From.Skinned.end());
  this->AddAnimation();
  if (!this->From.Extras.empty())
  {
    scene.extras = ObjectOf(this->From.Extras);
  }
  this->Model.scenes.push_back(scene);
  this->Model.defaultScene = 0;
  for (const auto& [name, isUsed] : this->Used)
  {
    this->Model.extensionsUsed.push_back(name);
  }
  return this->Model;
}

}

//----------------------------------------------------------------------------
void RequireExtras(const std::string& json)
{
  ObjectOf(json);
}

//----------------------------------------------------------------------------
FileOutcome WriteScene(const std::string& path, const Scene& scene, const SceneProgress& progress)
{
  return WriteFile(path, [&](ReplacedFile& file) {
    ModelMaker maker(scene);
    const tinygltf::Model& model = maker.Make();
    const double bytes = model.buffers.empty() ? 1.0 : static_cast<double>(model.buffers[0].data.size());
    file.OnWrite([&](std::size_t written) {
      if (!progress(std::min(1.0, static_cast<double>(written) / bytes)))
      {
        throw WriteStopped();
      }
    });
    if (!progress(0.0))
    {
      throw WriteStopped();
    }
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, file.Stream(), false, true);
    return file.Close() && file.Commit();
  });
}

//----------------------------------------------------------------------------
std::string SceneBytes(const Scene& scene)
{
  ModelMaker maker(scene);
  std::ostringstream bytes;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&maker.Make(), bytes, false, true);
  return bytes.str();
}

}
