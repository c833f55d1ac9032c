// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportScatterInstances_h
#define LittoralSupportScatterInstances_h

// A scattered forest as points with prototypes, for mappers of glyphs. Private: never installed, never wrapped.

#include "Data/ScatterPrototypes.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace littoral
{

/// Memory of the points [bytes]; with girths they have scales along three axes.
double InstanceBytes(std::size_t plants, bool hasGirths);

/// A vertex for each shown plant, with the arrays that place its prototype; with girths, if any plant has one.
vtkSmartPointer<vtkPolyData> InstancesOf(
  const std::vector<PlantPlace>& places, const std::vector<ShownPlant>& shown, bool hasGirths);

/// The blocks of a prototype that are drawn, each level a block of its own. Those of the first species come first,
/// behind the block of the instances.
void AddLevels(const PrototypeBlocks& parts, vtkMultiBlockDataSet* blocks);

/// Polygons of all instances.
double PolygonsOf(
  vtkMultiBlockDataSet* blocks, const std::vector<PlantPlace>& places, const std::vector<ShownPlant>& shown);

}

#endif
