// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSwayKinds_h
#define LittoralSupportSwayKinds_h

// Kinds of swaying plants, whichever are shown. Private: never installed, never wrapped.

#include "Data/ScatterPrototypes.h"
#include "Sway/SwaySpecies.h"
#include "Wind/FrozenWind.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

class vtkAlgorithm;
class vtkMultiBlockDataSet;

namespace littoral
{

/// Throws InvalidInput if there are not so many bytes.
void RequireMemoryToSway(double bytes);

/// Kinds of plants in a wind. A forest that follows the camera changes its plants, and has these for as long as its
/// prototypes, its wind and the properties stay.
struct SwayKinds
{
  std::shared_ptr<const FrozenWind> Wind;
  std::vector<SwaySpecies> Species;
  std::vector<AtlasArea> Areas; ///< of the pictures of crowns in their atlas
  /// Pictures of the crowns, all of a species one above the other, then the next species.
  vtkSmartPointer<vtkImageData> PictureImage;
  vtkSmartPointer<vtkPolyData> PictureFields; ///< the same as field data

  /// Reads prototypes of a scattered forest, or a plant that is its own. Throws InvalidInput.
  void Read(const std::vector<vtkMultiBlockDataSet*>& prototypes, bool areScattered, vtkImageData* wind,
    const SwaySettings& settings, vtkAlgorithm* progress);

  /// The prototypes, to make surfaces of scattered plants that are passed without. Throws InvalidInput.
  const ScatterPrototypes& SurfacesOf(const std::vector<vtkMultiBlockDataSet*>& prototypes);

private:
  ScatterPrototypes Surfaces;
};

}

#endif
