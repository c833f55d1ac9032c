// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSeaweedSceneBlocks_h
#define LittoralSupportSeaweedSceneBlocks_h

// Scenes of seaweeds between blocks and the numerics. Private: never installed, never wrapped.

#include "Data/FrameArrays.h"
#include "Plants/SkinBinding.h"
#include "Seaweed/SeaweedScene.h"
#include "Seaweed/SeaweedSkin.h"

#include <string>
#include <vector>

class vtkMultiBlockDataSet;
class vtkPolyData;

namespace littoral
{

/// A block of vertices that follow the skeleton. It is not kept alive.
struct SeaweedSkinBlock
{
  const char* Name;
  vtkPolyData* Rest;
  SeaweedSkin Skin;
  SkinBinding Binding;
};

/// Reads plants into a scene, and their skins. Throws InvalidInput.
void ReadSeaweeds(vtkMultiBlockDataSet* plants, const SeaweedOptions& options, const SeaState& sea, SeaweedScene& scene,
  std::vector<SeaweedSkinBlock>& skins);

/// Writes the plants of a scene as shown, a frame of `arrays`; `output` is a shallow copy of `plants`.
void WriteSeaweeds(const SeaweedScene& scene, const std::vector<SeaweedSkinBlock>& skins, FrameArrays& arrays,
  vtkMultiBlockDataSet* plants, vtkMultiBlockDataSet* output);

/// Adds the block of the joints as shown.
void AddSeaweedJoints(const SeaweedScene& scene, vtkMultiBlockDataSet* output);

}

#endif
