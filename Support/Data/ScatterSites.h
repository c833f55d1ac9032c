// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportScatterSites_h
#define LittoralSupportScatterSites_h

// The sites of a scattered forest. Private: never installed, never wrapped.

#include "Plants/PlantScatter.h"
#include "Plants/StemShape.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkPointSet;

namespace littoral
{

/// Names of point arrays of the sites that hold heights and diameters at breast height [m]; empty: not used.
struct DimensionArrays
{
  std::string Height;
  std::string Diameter;
};

/// The plants at all sites, on the ground if there is a terrain; `stems` are those of the prototypes. Throws
/// InvalidInput if they cannot stand there.
std::vector<PlantPlace> PlacePlants(vtkPointSet* sites, vtkImageData* terrain, const ScatterOptions& options,
  const GroundLimits& limits, const DimensionArrays& dimensions = {}, const std::vector<StemShape>& stems = {});

/// The same plants in a level of detail with other stems, where sites have dimensions; none where they have not.
std::vector<PlantPlace> PlacesInLevel(vtkPointSet* sites, const DimensionArrays& dimensions,
  const std::vector<StemShape>& stems, const std::vector<PlantPlace>& places);

}

#endif
