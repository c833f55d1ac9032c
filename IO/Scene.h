// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralScene_h
#define LittoralScene_h

// A scene between VTK and a file: meshes, materials, pictures and nodes. Lengths in metres, z up. Private: never
// installed.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace littoral
{

/// What a surface is made of, for renderers that have materials of their own.
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

/// A file in memory.
struct ScenePicture
{
  std::vector<unsigned char> Png;
};

struct SceneMaterial
{
  std::string Name;
  SceneKind Kind = SceneKind::Plain;
  int Picture = -1;     ///< whose alpha below 1/2 is a hole; -1: none
  bool Blended = false; ///< colors have an opacity
};

/// Vertices, one tuple a vertex in each array that is not empty, and what is drawn of them.
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

  /// Where the vertices go: differences of positions [m] and normals.
  struct Target
  {
    std::vector<float> Positions;
    std::vector<float> Normals;
  };
  std::vector<Target> Targets;
  std::vector<SceneMesh> More; ///< parts with vertices and materials of their own

  std::size_t GetNumberOfVertices() const { return this->Positions.size() / 3; }
};

/// Joints that move a mesh.
struct SceneSkin
{
  std::vector<int> Joints; ///< nodes
  int Binding = -1;
};

/// Positions of joints at rest, where they are not rotated, in the space of the mesh [m].
struct SceneBinding
{
  std::vector<float> Rests;
};

/// How a node moves; what is empty does not move.
struct SceneTrack
{
  int Node = -1;
  int Stride = 1; ///< times of the scene from a sample to the next one; the last time has one in any case
  bool IsSmooth =
    false; ///< cubic curves: three entries a sample, the slope [1/s] before it, its value, the slope after
  std::vector<std::int16_t> Rotations; ///< quaternions x, y, z, w times 32767
  std::vector<float> Translations;     ///< [m]
  std::vector<float> Weights;          ///< one for each target of the mesh
};

/// Places of a mesh, one tuple an instance.
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
  int Instances = -1;    ///< places of the mesh; -1: one, at the node
  bool IsTinted = false; ///< whether the tints of the instances hold
  std::optional<std::array<double, 3>> Tint;
  std::vector<int> Children;
  std::vector<int> CoarserLevels; ///< nodes that stand for this one from afar, and are no children
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
  std::vector<int> Sources; ///< nodes below the root
  std::vector<int> Skinned; ///< nodes beside the root: meshes with a skin, whose place is that of their joints
  std::vector<SceneBinding> Bindings;
  std::vector<SceneSkin> Skins;
  std::vector<float> Times; ///< [s]
  std::vector<SceneTrack> Tracks;
  std::optional<SceneCamera> Camera;
  std::optional<SceneSun> Sun;
  std::string Extras; ///< an object as JSON, or nothing
};

}

#endif
