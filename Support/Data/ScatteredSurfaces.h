// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportScatteredSurfaces_h
#define LittoralSupportScatteredSurfaces_h

// Surfaces of scattered plants that are not passed with them. Private: never installed, never wrapped.

#include "Data/PlantTable.h"
#include "Data/ScatterPrototypes.h"
#include "Data/StandAtRest.h"
#include "Numerics/Parallel.h"

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkMultiBlockDataSet;

namespace littoral
{

/// Plants with the surfaces that they would have been passed with, and these as they can be had again.
struct ScatteredSurfaces
{
  vtkSmartPointer<vtkMultiBlockDataSet> Plants; ///< null: there are none
  std::array<StandAtRest, NumberOfParts> AtRest;

  /// Makes the surfaces of plants whose table has tints. Throws InvalidInput.
  void Make(vtkMultiBlockDataSet* plants, const PlantTable& table, const ScatterPrototypes& species,
    const ParallelFor& parallel);

  /// Takes points and normals at rest from a surface of a part, and returns what is left of it.
  vtkSmartPointer<vtkPolyData> Bare(int part);
};

}

#endif
