// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneMotion_h
#define LittoralSceneMotion_h

// Animations of a scene: surfaces by morph targets, plants by joints. Private: never installed.

#include "Data/PlantTable.h"
#include "Plants/JointReduction.h"
#include "SceneInput.h"

#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkIntArray;
class vtkMultiBlockDataSet;
class vtkPolyData;

namespace littoral
{

/// Place of data in the input: the index of the source, and those of blocks within it.
struct SceneAddress
{
  std::size_t Source = 0;
  std::vector<unsigned int> Blocks;
};

/// Surface whose points move, as a mesh with morph targets; its cells stay.
class MovingSurface
{
public:
  MovingSurface(SceneAddress address, std::string name, int node, int mesh, const std::array<double, 3>& place)
    : Address(std::move(address))
    , Name(std::move(name))
    , Node(node)
    , Mesh(mesh)
    , Place(place)
  {
  }

  /// Notes the points at a time [s]. Why that failed, in words for a user.
  void Follow(const std::vector<SceneSource>& sources, double time);

  /// Adds morph targets to the mesh and weights to the node, if any point has moved.
  void Finish(Scene& scene);

private:
  SceneAddress Address;
  std::string Name;
  int Node;
  int Mesh;
  std::array<double, 3> Place;
  std::vector<SceneMesh::Target> Frames; ///< positions and normals
};

/// Plants with joints, as skinned meshes.
class MovingPlants
{
public:
  /// Plants below a node.
  MovingPlants(SceneAddress address, std::string name, int node, vtkMultiBlockDataSet* plants);

  /// A block at the first time, with its mesh.
  void AddPart(const std::string& level, vtkPolyData* data, SceneMesh mesh);

  /// Notes the joints at a time [s]. Why that failed, in words for a user.
  void Follow(const std::vector<SceneSource>& sources, double time);

  /// Adds skins and tracks with as few joints as the tolerance [m] allows.
  void Finish(double tolerance, Scene& scene);

private:
  /// A block, of all plants.
  struct Part
  {
    std::string Level;
    vtkSmartPointer<vtkPolyData> Data; ///< as at the first time
    SceneMesh Mesh;
  };
  /// All joints at a time.
  struct Frame
  {
    std::vector<float> Rotations; ///< quaternions w, x, y, z
    std::vector<float> Positions;
  };
  /// A plant among them.
  struct Plant
  {
    int Id = 0;       ///< PlantId
    int Species = -1; ///< -1: not told
    PlantPlace Place;
    std::string Level;
    std::vector<int> Joints;                          ///< parents first
    std::vector<std::vector<std::uint32_t>> Vertices; ///< of each part
  };

  SceneAddress Address;
  std::string Name;
  int Node;
  PlantTable Table;
  std::vector<int> Parents;
  std::vector<float> Rests;
  std::vector<Part> Parts;
  std::vector<Frame> Frames;
  std::vector<int> LocalJoints; ///< the number of a joint in its plant, of the group that is added

  std::vector<Plant> FindPlants() const;
  JointTree TreeOf(const Plant& plant);
  SceneMesh RestOf(const Plant& plant, std::size_t part, JointTree& tree) const;
  void AddHolds(const Plant& plant, std::size_t part, const ReducedJoints& reduced, SceneMesh& mesh) const;
  std::vector<JointFrame> MotionOf(const Plant& plant) const;
  std::optional<std::array<double, 3>> TintOf(const Plant& plant, const Plant& other) const;
  void AddGroup(const std::vector<const Plant*>& group, double tolerance, Scene& scene);
  void AddSkinned(const Plant& plant, const Plant& first, const JointTree& tree, const ReducedJoints& reduced,
    const std::vector<JointTrack>& tracks, Scene& scene) const;
};

}

#endif
