// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSeaweedSceneBlocks_h
#define LittoralSupportSeaweedSceneBlocks_h

// Scenes of seaweeds between blocks and the numerics. Private: never installed, never wrapped.

#include "Data/FrameArrays.h"
#include "Numerics/VectorRange.h"
#include "Pipeline/Ranges.h"
#include "Plants/RigidSkinning.h"
#include "Plants/SkinBinding.h"
#include "Seaweed/SeaweedScene.h"
#include "Seaweed/SeaweedSkin.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkMultiBlockDataSet;

namespace littoral
{

/// Ranges of points and normals of a plant after a Show().
struct PlantRange
{
  std::array<VectorRange, 2> Ranges;
  long long Show = 0;
};

/// A block of vertices that follow the skeleton.
struct SeaweedSkinBlock
{
  const char* Name;
  vtkSmartPointer<vtkPolyData> Rest; ///< a shallow copy of the same arrays may come in its place
  SeaweedSkin Skin;
  SkinBinding Binding;
  RigidBinding Rigid;
  RigidBinding Far; ///< to the carriers of joints
  /// Indices of the runs in Rigid, in Far and in Binding where those of Skin begin: to search them would take as long
  /// as to move some vertices.
  std::array<std::vector<std::uint32_t>, 3> FirstRuns;
  std::array<TupleRanges, 2> FixedRanges; ///< of points and normals that never move, once they were written
  std::vector<PlantRange> PlantRanges;    ///< of those that stay as they are for some pictures; empty: none did so far
};

/// Arrays and joints that the frames of a scene take in turn.
struct SeaweedFrames
{
  FrameArrays Arrays;
  std::vector<JointChange> Changes; ///< of nodes; zero where they are fixed to the ground
};

/// Reads plants into a scene, and their skins. Throws InvalidInput.
void ReadSeaweeds(vtkMultiBlockDataSet* plants, const SeaweedOptions& options, const SeaState& sea, SeaweedScene& scene,
  std::vector<SeaweedSkinBlock>& skins);

/// Writes the plants of a scene as shown, one of the frames of the same skins; `output` is a shallow copy of `plants`.
void WriteSeaweeds(const SeaweedScene& scene, std::vector<SeaweedSkinBlock>& skins, SeaweedFrames& frames,
  vtkMultiBlockDataSet* plants, vtkMultiBlockDataSet* output);

/// Adds the block of the joints as shown.
void AddSeaweedJoints(const SeaweedScene& scene, vtkMultiBlockDataSet* output);

}

#endif
