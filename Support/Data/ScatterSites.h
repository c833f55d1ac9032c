// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportScatterSites_h
#define LittoralSupportScatterSites_h

// The sites of a scattered forest. Private: never installed, never wrapped.

#include "Plants/PlantScatter.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkPointSet;

namespace littoral
{

/// The plants at all sites, on the ground if there is a terrain. Why they cannot stand there, or nothing.
std::string PlacePlants(vtkPointSet* sites, vtkImageData* terrain, const ScatterOptions& options,
  const GroundLimits& limits, std::vector<PlantPlace>& places);

}

#endif
