// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneReader_h
#define LittoralSceneReader_h

#include "SceneInput.h"
#include "SceneMotion.h"

#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <string>
#include <tuple>
#include <vector>

class vtkAbstractArray;
class vtkMultiBlockDataSet;
class vtkPolyData;

namespace littoral
{

/// Reader of valid sources into a scene, with the samples of those that move.
class SceneReader
{
public:
  SceneReader(const SceneOptions& options, Scene& scene)
    : Options(options)
    , To(scene)
  {
  }

  /// Adds the sources as they are at the first time.
  void Add(const std::vector<SceneSource>& sources);

  /// Notes where things are at a time [s] since the first one. Why that failed, in words for a user.
  void Follow(const std::vector<SceneSource>& sources, double time);

  /// Adds the meshes of the prototypes of instances: those of each species by levels, High first.
  std::map<int, std::array<std::vector<int>, 3>> AddPrototypes(vtkMultiBlockDataSet* blocks);

  /// Adds the animations to the scene.
  void Finish();

private:
  /// Properties that a block inherits from those around it.
  struct Surroundings
  {
    SceneKind Kind = SceneKind::Automatic; ///< as the caller says
    bool IsPlant = false;
    bool IsSeaweed = false;
  };
  /// A part of a prototype.
  struct Part
  {
    std::string Name;
    int Mesh;
    bool IsTinted;
  };
  /// A level of a prototype.
  struct Level
  {
    std::string Name;
    int Prototype;
    std::vector<Part> Parts;
  };

  const SceneOptions Options;
  Scene& To;
  std::map<vtkAbstractArray*, int> Pictures;             // by texels
  std::vector<vtkSmartPointer<vtkAbstractArray>> Texels; // held, so that no other array gets their addresses
  std::map<std::tuple<SceneKind, int, bool>, int> Materials;
  SceneAddress Address; // of what is read
  std::vector<MovingSurface> Surfaces;
  std::vector<MovingPlants> Plants;

  int AddNode(const std::string& name, std::vector<int> children = {});
  int AddData(vtkDataObject* data, const std::string& name, const Surroundings& around);
  int AddBlock(const struct NamedBlock& block, const Surroundings& around);
  int AddBlocks(vtkMultiBlockDataSet* blocks, const std::string& name, const Surroundings& around);
  int AddMovingPlants(vtkMultiBlockDataSet* plants, const std::string& name, const Surroundings& around);
  int AddSurface(vtkPolyData* data, const std::string& name, const Surroundings& around);
  int AddLevels(vtkMultiBlockDataSet* plant, const std::string& name, const Surroundings& around);
  int AddInstances(
    vtkMultiBlockDataSet* blocks, vtkPolyData* points, const std::string& name, const Surroundings& around);
  SceneMesh MeshFor(
    vtkPolyData* data, const std::string& name, const Surroundings& around, std::array<double, 3>& place);
  int AddMesh(vtkPolyData* data, const std::string& name, const Surroundings& around, std::array<double, 3>& place);
  int MaterialOf(vtkPolyData* data, SceneKind kind, bool isBlended);
  std::vector<Level> LevelsOf(vtkMultiBlockDataSet* blocks, const Surroundings& around);
  int AddInstancedLevel(const Level& level, int instances);
  std::vector<int> AddPlantNodes(const Level& level, const SceneInstances& places);
  void Switch(const std::vector<int>& nodes);
};

}

#endif
