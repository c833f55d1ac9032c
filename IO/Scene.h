// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralScene_h
#define LittoralScene_h

// Scene between VTK and a file of glTF: meshes, materials, images, nodes, skins and animations. Lengths in metres, z
// up. Private: never installed.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace littoral
{

/// Kinds of surfaces, for renderers that have materials of their own.
enum class SceneKind
{
  Automatic, ///< told by the data
  Bark,
  Leaf,
  Grass,
  Blade, ///< of a seaweed
  Ground,
  Water,
  Particle,
  Sky,
  Plain
};

inline constexpr const char* SceneKindNames[] = { "automatic", "bark", "leaf", "grass", "blade", "ground", "water",
  "particle", "sky", "plain" };

/// Image as a file in memory.
struct ScenePicture
{
  std::vector<unsigned char> Png;
};

struct SceneMaterial
{
  std::string Name;
  SceneKind Kind = SceneKind::Plain;
  int Picture = -1;     ///< index of the base color image, a mask where its alpha is below 1/2; -1: none
  bool Blended = false; ///< alpha mode BLEND: colors have an opacity
};

/// Attributes of vertices, one tuple a vertex in each array that is not empty, and the indices of the primitives.
struct SceneMesh
{
  std::string Name;
  int Material = -1;
  std::vector<float> Positions;          ///< [m]
  std::vector<float> Normals;            ///< of unit length
  std::vector<float> TextureCoordinates; ///< v from the upper edge of the picture
  std::vector<float> Colors;             ///< linear; of ColorParts parts
  int ColorParts = 3;                    ///< 4 with an opacity
  std::vector<float> Velocities;         ///< [m/s]
  std::vector<float> Radii;              ///< of particles [m]
  std::vector<std::uint32_t> Triangles;
  std::vector<std::uint32_t> Lines; ///< pairs
  std::vector<std::uint32_t> Points;
  std::vector<std::uint16_t> JointIds; ///< four of the skin's joints
  std::vector<float> JointWeights;     ///< four, with the sum 1

  /// Morph target: differences of positions [m] and normals.
  struct Target
  {
    std::vector<float> Positions;
    std::vector<float> Normals;
  };
  std::vector<Target> Targets;
  std::vector<SceneMesh> More; ///< further primitives, with vertices and materials of their own
  bool SharesVertices = false; ///< whether it has none and draws those of the scene's first mesh

  std::size_t GetNumberOfVertices() const { return this->Positions.size() / 3; }
};

/// Skin: joints that move a mesh.
struct SceneSkin
{
  std::vector<int> Joints; ///< nodes
  int Binding = -1;        ///< index of the inverse bind matrices
};

/// Bind pose: positions of joints at rest, without rotations, in the space of the mesh [m].
struct SceneBinding
{
  std::vector<float> Rests;
};

/// Animation of a node; empty channels do not move.
struct SceneTrack
{
  int Node = -1;
  int Stride = 1; ///< keyframes: every so many times of the scene, and the last one
  bool IsSmooth =
    false; ///< cubic curves: three entries a sample, the slope [1/s] before it, its value, the slope after
  std::vector<std::int16_t> Rotations; ///< quaternions x, y, z, w times 32767
  std::vector<float> Translations;     ///< [m]
  std::vector<float> Weights;          ///< one for each target of the mesh
};

/// Instances of a mesh (EXT_mesh_gpu_instancing), one tuple each.
struct SceneInstances
{
  std::vector<float> Translations; ///< [m]
  std::vector<float> Rotations;    ///< quaternions x, y, z, w
  std::vector<float> Scales;       ///< along x, y and z
  std::vector<float> Tints;        ///< factors of the linear color
};

struct SceneNode
{
  std::string Name;
  std::array<double, 3> Translation{ { 0.0, 0.0, 0.0 } };
  std::array<double, 4> Rotation{ { 0.0, 0.0, 0.0, 1.0 } }; ///< quaternion x, y, z, w
  std::array<double, 3> Scale{ { 1.0, 1.0, 1.0 } };
  int Mesh = -1;
  int Skin = -1;
  int Instances = -1;    ///< index of the instances; -1: one, at the node
  bool IsTinted = false; ///< whether the tints of the instances apply
  std::optional<std::array<double, 3>> Tint;
  std::vector<int> Children;
  std::vector<int> CoarserLevels; ///< nodes of coarser levels of detail (MSFT_lod), which are no children
};

struct SceneCamera
{
  std::array<double, 3> Position{ { 0.0, 0.0, 1.0 } };
  std::array<double, 3> FocalPoint{ { 0.0, 0.0, 0.0 } };
  std::array<double, 3> ViewUp{ { 0.0, 1.0, 0.0 } };
  double ViewAngle = 30.0; ///< vertical [degrees]
};

struct SceneSun
{
  std::array<double, 3> Direction{ { 0.0, 0.0, 1.0 } }; ///< towards the sun
  std::array<double, 3> Color{ { 1.0, 1.0, 1.0 } };     ///< linear
  double Illuminance = 0.0;                             ///< [lx]
};

struct Scene
{
  std::string Name;
  std::vector<ScenePicture> Pictures;
  std::vector<SceneMaterial> Materials;
  std::vector<SceneMesh> Meshes;
  std::vector<SceneInstances> Instances;
  std::vector<SceneNode> Nodes;
  std::vector<int> Sources; ///< nodes of the sources, below the root
  std::vector<int> Skinned; ///< nodes of skinned meshes, beside the root, placed by their joints
  std::vector<SceneBinding> Bindings;
  std::vector<SceneSkin> Skins;
  std::vector<float> Times; ///< [s]
  std::vector<SceneTrack> Tracks;
  std::optional<SceneCamera> Camera;
  std::optional<SceneSun> Sun;
  std::string Extras; ///< a JSON object, or empty
};

}

#endif
