// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneInput_h
#define LittoralSceneInput_h

// Sources and options of a scene. Private: never installed.

#include "Scene.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace littoral
{

/// Source of a scene: data with their name.
struct SceneSource
{
  std::string Name;
  SceneKind Kind = SceneKind::Automatic;
  vtkDataObject* Data = nullptr;
};

/// Forms of instances.
enum class SceneInstanceForm
{
  GpuInstancing, ///< a node for all instances of a mesh
  Nodes          ///< a node for each instance
};

/// Levels of detail that are written.
enum class SceneLevelForm
{
  Switched, ///< all levels, as coarser ones of a node
  AsShown,  ///< instances at the level that they have in the input, single plants at High
  High,
  Medium,
  Low
};

struct SceneOptions
{
  SceneInstanceForm Instances = SceneInstanceForm::GpuInstancing;
  SceneLevelForm Levels = SceneLevelForm::Switched;
  bool HasVelocity = false;
  bool HasMotion = false;
  double JointTolerance = 0.0; ///< largest error of skins [m]
};

/// Throws InvalidInput if a scene with a name and sources cannot be written. Nothing is copied yet.
void RequireScene(const Scene& scene, const std::vector<SceneSource>& sources, const SceneOptions& options);

/// Why a scene that was read is too large for a file, or for the memory; empty if it is not.
std::string WhyTooLarge(const Scene& scene);

}

#endif
