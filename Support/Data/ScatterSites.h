// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportScatterSites_h
#define LittoralSupportScatterSites_h

// The sites of a scattered forest. Private: never installed, never wrapped.

#include "Geometry/SceneCells.h"
#include "Plants/PlantScatter.h"
#include "Plants/StemShape.h"

#include <array>
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

/// The sites of one of several parts: those in some of the cells over all of them.
struct SitePart
{
  CellGrid Grid;              ///< over all sites
  std::array<int, 2> Cells{}; ///< the first one of the part, and the one behind its last
  std::vector<int> Indices;   ///< of the sites that are here; increasing
  bool IsFirst = true;
  int FirstSite = 0;           ///< number of the first one here among all sites
  std::vector<int> FirstCells; ///< of each part, and the number of all cells
};

/// A part of the sites, as many in each part as whole cells allow.
SitePart MakeSitePart(vtkPointSet* sites, double sitesPerCell, int part, int parts);

/// The sites that are here, of sites that processes share, each having those behind the last one's. Their plants are to
/// be dealt out to the parts of MakeSitePart(), one a process.
SitePart ShareSites(vtkPointSet* sites, double sitesPerCell, const WorkShare& share);

/// The plants at the sites of a part, on the ground if there is a terrain; `stems` are those of the prototypes. Throws
/// InvalidInput if they cannot stand there; the first part looks at all sites, and of sites that are shared each
/// process at its own.
std::vector<PlantPlace> PlacePlants(vtkPointSet* sites, const SitePart& part, vtkImageData* terrain,
  const ScatterOptions& options, const GroundLimits& limits, const DimensionArrays& dimensions = {},
  const std::vector<StemShape>& stems = {}, const WorkShare& share = {});

/// The same plants in a level of detail with other stems, where sites have dimensions; none where they have not.
std::vector<PlantPlace> PlacesInLevel(vtkPointSet* sites, const SitePart& part, const DimensionArrays& dimensions,
  const std::vector<StemShape>& stems, const std::vector<PlantPlace>& places);

}

#endif
